# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sheet of an SVG drawing: its height in mm, and the transform from the root's user units to mm with Y up.

width="160mm" viewBox="0 0 160 80"   the file says the size
style="width:160mm" viewBox=…        it does too, where width says none in mm or inches
width="160"   viewBox="0 0 160 80"   pixels: 90 a inch in Inkscape before 0.92, 72 in Illustrator, else 96 of CSS
no width, no viewBox                 no sheet: Y up, and zero is the upper left corner
"""

from __future__ import annotations

import math
import re

from CNCStepper.drawing.svg.document import Document
from CNCStepper.drawing.svg.matrices import CSS_DPI, Matrix, fitted, length, length_mm, view_box
from CNCStepper.drawing.svg.styles import Style
from CNCStepper.errors import Text

OLD_INKSCAPE_DPI, ILLUSTRATOR_DPI = 90.0, 72.0
VERSION = re.compile(r"(\d+)\.(\d+)")
MM_OF_INCH = 25.4


def dpi_of(document: Document) -> float:
    """Return how many pixels the program that wrote the file has to an inch."""
    version = VERSION.match(document.root.get("inkscape:version")[:40])
    if version and (int(version[1]), int(version[2])) < (0, 92):
        return OLD_INKSCAPE_DPI
    return ILLUSTRATOR_DPI if is_illustrator(document) else CSS_DPI


def is_illustrator(document: Document) -> bool:
    """Return whether Adobe Illustrator wrote the file."""
    return document.adobe or "Adobe Illustrator" in document.comments


def sheet_of(document: Document, style: Style, unit_mm: float | None) -> tuple[Matrix, tuple[float, float], float, str]:
    """Return the transform to mm, the viewport in user units, the length of one in mm, and a warning, "" for none.

    `style` is the root's, `unit_mm` the length of the root's user unit where the file does not say it or is wrong.
    """
    root, dpi = document.root, dpi_of(document)
    box, how = view_box(root.get("viewBox")), root.get("preserveAspectRatio")
    sizes = [_said(root.get(key), style.geometry.get(key, "")) for key in ("width", "height")]
    pixel_mm = MM_OF_INCH / dpi
    known = any(length_mm(size) is not None for size in sizes)
    if unit_mm is not None:
        box = box or _plain_box(sizes, dpi)
        inner = (
            Matrix.of(unit_mm, 0.0, 0.0, unit_mm, -box[0] * unit_mm, -box[1] * unit_mm) if box else Matrix(unit_mm + 0j)
        )
        height_mm = box[3] * unit_mm if box else 0.0
        viewport = (box[2], box[3]) if box else (0.0, 0.0)
        return _upright(height_mm) @ inner, viewport, unit_mm, "" if box else _no_sheet()
    width, height = (
        _size_mm(size, whole, pixel_mm) for size, whole in zip(sizes, box[2:] if box else (0.0, 0.0), strict=True)
    )
    if box:
        width = width or (height * box[2] / box[3] if height else box[2] * pixel_mm)
        height = height or width * box[3] / box[2]
        inner = fitted(box, width, height, how)
        viewport = box[2], box[3]
    else:
        inner = Matrix(pixel_mm + 0j)
        viewport = width / pixel_mm, height / pixel_mm
    warning = (
        "" if known else Text("the file gives no size in mm or inches: {dpi:g} pixels an inch are assumed", dpi=dpi)
    )
    if not (height > 0.0 and math.isfinite(height)):
        height, warning = 0.0, _no_sheet()
    return _upright(height) @ inner, viewport, inner.scale, warning


def _said(attribute: str, styled: str) -> str:
    """Return the attribute, or what a style says in mm or inches where that does not: pixels there are a browser's."""
    return styled if length_mm(attribute) is None and length_mm(styled) is not None else attribute


def _size_mm(size: str, whole: float, pixel_mm: float) -> float:
    """Return width or height in mm, 0 where the file does not say it; a percentage is one of the viewBox."""
    absolute = length_mm(size)
    found = absolute if absolute is not None else length(size, whole, 0.0) * pixel_mm
    return found if found > 0.0 else 0.0


def _plain_box(sizes: list[str], dpi: float) -> tuple[float, float, float, float] | None:
    width, height = (length(size, 0.0, 0.0, dpi=dpi) for size in sizes)
    return (0.0, 0.0, width, height) if width > 0.0 and height > 0.0 else None


def _upright(height_mm: float) -> Matrix:
    return Matrix.of(1.0, 0.0, 0.0, -1.0, 0.0, height_mm)


def _no_sheet() -> str:
    return Text("the file gives no size of its sheet: zero is the upper left corner")
