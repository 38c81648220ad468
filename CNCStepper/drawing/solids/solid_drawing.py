# SPDX-License-Identifier: LGPL-2.1-or-later
"""The chains of a solid as a drawing: one layer, named after the height or the outline."""

from __future__ import annotations

from collections.abc import Sequence

from CNCStepper.drawing.drawing import Attributes, Chain, Drawing
from CNCStepper.drawing.read_drawing import ReadOptions
from CNCStepper.errors import JobError, Place
from CNCStepper.geometry.curve import Curve

OUTLINE = "outline"


def solid_drawing(
    curves: Sequence[Curve], options: ReadOptions, name: str, place: Place, unit_mm: float = 1.0
) -> Drawing:
    """Return the drawing of chains; raises JobError where there are none."""
    if not curves:
        raise _empty(options.height_mm, place)
    layer = OUTLINE if options.height_mm is None else f"height {options.height_mm:g}"
    attributes = Attributes(layer=layer, name=name)
    return Drawing(tuple(Chain(curve, attributes) for curve in curves), unit_mm=unit_mm)


def _empty(height_mm: float | None, place: Place) -> JobError:
    if height_mm is None:
        advice = "export the body itself, as STEP, BREP or STL"
        return JobError("solid-empty", "the file holds no solid and no face", advice=advice, place=place)
    what, advice = "the solid has nothing at that height", "give a height_mm within the solid, or none for its outline"
    return JobError("solid-empty", what, value=f"{height_mm:g} mm", advice=advice, place=place)
