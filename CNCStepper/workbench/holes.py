# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a drawing wants holes: its whole circles with their diameters, and its points.

Circles about one centre (the two rims of a hole, a counterbore) are one hole with the smallest of their diameters.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from CNCStepper.errors import GeometryError
from CNCStepper.workbench.shapes import parts_of

SAME_MM = 1e-4
UPRIGHT = 1e-6  # sine of the tilt that a circle's axis may have against Z
PLACE = tuple[float, float]


@dataclass(frozen=True)
class Hole:
    """A wanted hole in the document's coordinates; the diameter of a point is 0."""

    centre_mm: PLACE
    diameter_mm: float


def holes_of(drawing: Any, picked: Sequence[str] = ()) -> list[Hole]:
    """Return the holes that a drawing, or what is picked of it, wants, in its order; raises GeometryError for none."""
    parts = parts_of(drawing, picked)
    circles = [hole for part in parts for hole in _circles(part.Edges)]
    points = [point for part in parts for point in _loose_points(part)] + ([] if picked else _sketched(drawing))
    found: dict[PLACE, Hole] = {}
    for hole in [*circles, *(Hole(point, 0.0) for point in points)]:
        place = _near(found, hole.centre_mm)
        known = found.get(place)
        if known is None or 0 < hole.diameter_mm < known.diameter_mm:
            found[place] = Hole(place, hole.diameter_mm)
    if not found:
        raise GeometryError(
            "holes-missing",
            f"the drawing '{drawing.Label}' holds no circles and no points",
            advice="draw circles or points where holes are wanted, or give the places by numbers",
        )
    return list(found.values())


def _near(found: dict[PLACE, Hole], centre: PLACE) -> PLACE:
    return next((place for place in found if math.dist(place, centre) < SAME_MM), centre)


def _circles(edges: list[Any]) -> list[Hole]:
    """Return the upright whole circles among edges; several arcs may make up one."""
    import Part

    swept: dict[tuple[float, ...], float] = {}
    for edge in edges:
        if edge.Degenerated or not isinstance(edge.Curve, Part.Circle) or abs(edge.Curve.Axis.z) < 1.0 - UPRIGHT:
            continue
        centre, radius = edge.Curve.Center, edge.Curve.Radius
        key = tuple(round(number, 5) for number in (centre.x, centre.y, centre.z, radius))
        swept[key] = swept.get(key, 0.0) + edge.LastParameter - edge.FirstParameter
    return [Hole((x, y), 2.0 * radius) for (x, y, _, radius), sweep in swept.items() if sweep > math.tau - UPRIGHT]


def _loose_points(part: Any) -> list[PLACE]:
    """Return the points that end no line."""
    ends = {vertex.hashCode() for edge in part.Edges for vertex in edge.Vertexes}
    return [(vertex.X, vertex.Y) for vertex in part.Vertexes if vertex.hashCode() not in ends]


def _sketched(drawing: Any) -> list[PLACE]:
    """Return the points of a sketch, construction left out: FreeCAD's shape of a sketch does not hold them."""
    import Part

    if not drawing.isDerivedFrom("Sketcher::SketchObject"):
        return []
    where = drawing.getGlobalPlacement()
    drawn = [drawing.Geometry[n] for n in range(len(drawing.Geometry)) if not drawing.getConstruction(n)]
    placed = [where.multVec(point.toShape().Point) for point in drawn if isinstance(point, Part.Point)]
    return [(place.x, place.y) for place in placed]
