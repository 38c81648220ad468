# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds the one rectangle that a drawing holds, its corners square or all rounded alike."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from CNCStepper.errors import GeometryError, Text
from CNCStepper.tolerances import SAME_SHARE
from CNCStepper.workbench.drawings.shapes import edges_of, require_closed


@dataclass(frozen=True)
class RectangleFound:
    """A rectangle in the document's coordinates.

    corner_mm: about which it is turned by rotation_deg, in (-45, 45], from where it reaches size_mm along X and Y.
    """

    corner_mm: tuple[float, float]
    size_mm: tuple[float, float]
    corner_radius_mm: float
    rotation_deg: float


def rectangle_of(drawing: Any, picked: Sequence[str] = ()) -> RectangleFound:
    """Return the rectangle of a drawing that holds nothing else; raises GeometryError."""
    import FreeCAD
    import Part

    edges = edges_of(drawing, picked)
    require_closed(drawing, picked)
    lines = [edge for edge in edges if isinstance(edge.Curve, Part.Line)]
    arcs = [edge for edge in edges if isinstance(edge.Curve, Part.Circle)]
    if len(lines) != 4 or len(arcs) not in (0, 4) or len(lines) + len(arcs) != len(edges):
        raise _none(drawing)
    along = lines[0].Curve.Direction
    rotation_deg = (math.degrees(math.atan2(along.y, along.x)) + 45.0) % 90.0 - 45.0
    wire = Part.Wire(Part.sortEdges(edges)[0])
    upright = wire.copy()
    upright.rotate(FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), -rotation_deg)
    box = upright.optimalBoundingBox(False)
    radius_mm = arcs[0].Curve.Radius if arcs else 0.0
    area_mm2 = box.XLength * box.YLength - (4.0 - math.pi) * radius_mm**2
    if abs(Part.Face(wire).Area - area_mm2) > SAME_SHARE * max(area_mm2, 1.0):
        raise _none(drawing)
    turn = FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), rotation_deg)
    corner = turn.multVec(FreeCAD.Vector(box.XMin, box.YMin, 0))
    x, y, length, width, radius = map(_clean, (corner.x, corner.y, box.XLength, box.YLength, radius_mm))
    return RectangleFound((x, y), (length, width), radius, _clean(rotation_deg))


def _clean(number: float) -> float:
    """Return a number without the noise of FreeCAD's shapes, which differs from one recompute to the next."""
    return round(number, 9) + 0.0


def _none(drawing: Any) -> GeometryError:
    return GeometryError(
        "rectangle-missing",
        Text("the drawing '{drawing}' holds no single rectangle", drawing=drawing.Label),
        advice="draw one rectangle, its corners rounded alike or not at all, or cut it as a pocket",
    )
