# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reader of pictures: dark areas become closed curves of few lines and arcs, with their holes.

    PNG, JPEG ──► greys ──► threshold ──► contours in pixels ──► mm ──► lines and arcs within a tolerance

The picture's lower left corner is the drawing's zero.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from CNCStepper.cancellation import checkpoint
from CNCStepper.drawing.drawing import Attributes, Chain, Drawing, Share
from CNCStepper.drawing.read_drawing import ReadOptions
from CNCStepper.drawing.trace.options import TraceOptions
from CNCStepper.drawing.trace.picture_file import Greys, otsu_threshold, read_greys
from CNCStepper.errors import JobError, Place, Text, placed
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.fitting.point_fit import refitted
from CNCStepper.geometry.grid_contours import contours_of
from CNCStepper.units import MM_PER_INCH

USUAL_DPI = 96.0
SIMPLIFY_PX, SPECK_PX2 = 0.5, 4.0
TRACED = Attributes("trace", "#000000", "", (), True)
READ, FOUND = 0.2, 0.4  # of the time, when the greys are there, and when the contours are


def read(path: Path, options: ReadOptions, share: Share) -> Drawing:
    """Return the contours of a picture, as `read_drawing` wants them; raises JobError as `read_greys` does."""
    trace = options.trace
    greys = read_greys(path, trace.blur_px)
    share(READ)
    pixel_mm, warnings = _pixel_mm(greys, trace, options.unit_mm)
    values = 255 - greys.values if trace.invert else greys.values
    threshold = trace.threshold or otsu_threshold(values)
    with placed(Place(str(path))):
        contours = contours_of(values, threshold - 0.5)
    share(FOUND)
    curves = _curves(contours, pixel_mm, trace, share)
    if not curves:
        raise JobError(
            "picture-empty",
            "the picture has no dark areas",
            value=Text("threshold {threshold}", threshold=threshold),
            advice="choose another threshold, or invert it",
            place=Place(str(path)),
        )
    return Drawing(tuple(Chain(curve, TRACED) for curve in curves), unit_mm=pixel_mm, warnings=warnings)


def _pixel_mm(greys: Greys, trace: TraceOptions, unit_mm: float | None) -> tuple[float, tuple[str, ...]]:
    """Return the length of a pixel, and a warning where nothing says it."""
    if trace.width_mm:
        return trace.width_mm / greys.values.shape[1], ()
    if unit_mm and not trace.dpi:
        return unit_mm, ()
    dpi = trace.dpi or greys.dpi
    if dpi:
        return MM_PER_INCH / dpi, ()
    text = Text("the picture has no size: {dpi:g} dpi are assumed; give its width", dpi=USUAL_DPI)
    return MM_PER_INCH / USUAL_DPI, (text,)


def _curves(contours: list[np.ndarray], pixel_mm: float, trace: TraceOptions, share: Share) -> list[Curve]:
    """Return the contours as curves in mm, those of specks left out."""
    simplify_mm = trace.simplify_mm or SIMPLIFY_PX * pixel_mm
    speck_mm2 = SPECK_PX2 * pixel_mm**2 if trace.speck_mm2 is None else trace.speck_mm2
    curves = []
    for number, contour in enumerate(contours):
        checkpoint()
        share(FOUND + (1.0 - FOUND) * number / len(contours))
        xy = (np.vstack([contour, contour[:1]]) + 0.5) * pixel_mm
        outline = Curve(xy, np.zeros(len(contour)))
        if len(contour) > 2 and abs(outline.area_mm2) > speck_mm2:
            curves.append(_begun_at_corner(outline, simplify_mm))
    return curves


def _begun_at_corner(outline: Curve, simplify_mm: float) -> Curve:
    """Return a contour fitted from its sharpest place on, where a vertex does no harm."""
    fitted = refitted(outline, simplify_mm)
    turns = np.abs(np.angle((fitted.begin_directions @ (1, 1j)) * np.conj(np.roll(fitted.end_directions @ (1, 1j), 1))))
    sharpest = fitted.xy[int(turns.argmax())]
    vertex = int(np.hypot(*(outline.xy[:-1] - sharpest).T).argmin())
    again = refitted(outline.started_at(vertex), simplify_mm) if vertex else fitted
    return again if len(again) < len(fitted) else fitted
