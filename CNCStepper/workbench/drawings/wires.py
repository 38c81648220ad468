# SPDX-License-Identifier: LGPL-2.1-or-later
"""A curve as FreeCAD's wire: each line and arc exactly as an edge."""

from __future__ import annotations

import math
from typing import Any

from CNCStepper.geometry.curve import Curve
from CNCStepper.workbench.drawings.curves import SHORTEST_MM


def wire_of(curve: Curve, height_mm: float) -> Any:
    """Return the wire of a curve in mm, which lies at `height_mm`."""
    import Part
    from FreeCAD import Vector

    ends = [Vector(x, y, height_mm) for x, y in curve.xy.tolist()]
    return Part.Wire([_edge(*piece) for piece in zip(ends[:-1], ends[1:], curve.bulge.tolist(), strict=True)])


def _edge(start: Any, end: Any, bulge: float) -> Any:
    """Return a line or an arc as an edge; `bulge` is the tangent of a quarter of its angle, above 0 anticlockwise."""
    import Part
    from FreeCAD import Vector

    if math.dist(start, end) * abs(bulge) < SHORTEST_MM:
        return Part.makeLine(start, end)
    chord = end - start
    middle = (start + end) * 0.5 + Vector(chord.y, -chord.x, 0.0) * (bulge / 2.0)
    return Part.Arc(start, middle, end).toShape()
