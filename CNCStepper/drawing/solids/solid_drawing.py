# SPDX-License-Identifier: LGPL-2.1-or-later
"""The chains of a solid as a drawing: one layer, named after the height or the outline."""

from __future__ import annotations

from collections.abc import Sequence

from CNCStepper.drawing.drawing import Attributes, Chain, Drawing
from CNCStepper.drawing.read_drawing import ReadOptions
from CNCStepper.errors import JobError, Place, Text
from CNCStepper.geometry.curve import Curve

OUTLINE = "outline"


def solid_drawing(
    curves: Sequence[Curve], options: ReadOptions, name: str, place: Place, unit_mm: float = 1.0
) -> Drawing:
    """Return the drawing of chains; raises JobError where there are none."""
    if not curves:
        height = "" if options.height_mm is None else f"{options.height_mm:g} mm"
        advice = Text("give a height_mm within the solid, or none for its whole outline")
        raise JobError("solid-empty", "the solid has nothing at that height", value=height, advice=advice, place=place)
    layer = OUTLINE if options.height_mm is None else f"height {options.height_mm:g}"
    attributes = Attributes(layer=layer, name=name)
    return Drawing(tuple(Chain(curve, attributes) for curve in curves), unit_mm=unit_mm)
