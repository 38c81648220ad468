# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a drawing wants holes: its whole circles with their diameters, and its points.

Circles about one centre (the two rims of a hole, a counterbore) are one hole with the smallest of their diameters.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from CNCStepper.errors import GeometryError, Text
from CNCStepper.tolerances import JOINED_ENDS_MM
from CNCStepper.workbench.drawings.shapes import parts_of, placed_shape

UPRIGHT = 1e-6  # sine of the tilt that a circle's axis may have against Z
PLACE = tuple[float, float]


@dataclass(frozen=True)
class Hole:
    """A wanted hole in the document's coordinates; the diameter of a point is 0."""

    centre_mm: PLACE
    diameter_mm: float


def holes_of(drawing: Any, picked: Sequence[str] = ()) -> list[Hole]:
    """Return the holes that a drawing, or what is picked of it, wants, in its order; raises GeometryError for none."""
    return holes_of_all([(drawing, tuple(picked))])


def holes_of_all(pairs: Sequence[tuple[Any, tuple[str, ...]]]) -> list[Hole]:
    """Return the holes that drawings want, in their order; raises GeometryError for a drawing that wants none."""
    found: dict[PLACE, Hole] = {}
    cells: dict[tuple[int, int], list[PLACE]] = {}
    for drawing, picked in pairs:
        for hole in _wanted(drawing, picked):
            place = _near(cells, hole.centre_mm)
            known = found.get(place)
            if known is None or 0 < hole.diameter_mm < known.diameter_mm:
                found[place] = Hole(place, hole.diameter_mm)
    return list(found.values())


def remarks(pairs: Sequence[tuple[Any, tuple[str, ...]]], holes: Sequence[Hole]) -> list[str]:
    """Return remarks on the holes of drawings: lines without a hole, places that are drawn twice."""
    said: list[str] = []
    for drawing, picked in pairs:
        edges = [edge for part in parts_of(drawing, picked) for edge in part.Edges]
        lines = len(edges) - sum(sum(_whole(part.Edges).values()) for part in parts_of(drawing, picked))
        if lines > 0 and not placed_shape(drawing).Solids:
            said.append(
                Text(
                    "lines of '{drawing}' that are not whole circles, so that no hole is drilled: {lines}",
                    drawing=drawing.Label,
                    lines=lines,
                )
            )
    twice = sum(len(holes_of_all([pair])) for pair in pairs) - len(holes)
    if twice > 0:
        said.append(
            Text(
                "circles and points of several drawings that stand about the same centre, one hole each: {twice}",
                twice=twice,
            )
        )
    return said


def _wanted(drawing: Any, picked: Sequence[str]) -> list[Hole]:
    """Return the circles and points of one drawing, as often as they are drawn; raises GeometryError for none."""
    parts = parts_of(drawing, picked)
    circles = [hole for part in parts for hole in _circles(part.Edges)]
    points = [point for part in parts for point in _loose_points(part)] + ([] if picked else _sketched(drawing))
    found = [*circles, *(Hole(point, 0.0) for point in points)]
    if not found:
        raise GeometryError(
            "holes-missing",
            Text("the drawing '{drawing}' holds no circles and no points", drawing=drawing.Label),
            advice="draw circles or points where holes are wanted, or give the places by numbers",
        )
    return found


def _near(cells: dict[tuple[int, int], list[PLACE]], centre: PLACE) -> PLACE:
    """Return the place of a hole that is known already, or the centre itself, which is known from now on."""
    column, row = (math.floor(value / JOINED_ENDS_MM) for value in centre)
    for step in itertools.product((-1, 0, 1), repeat=2):
        for place in cells.get((column + step[0], row + step[1]), ()):
            if math.dist(place, centre) < JOINED_ENDS_MM:
                return place
    cells.setdefault((column, row), []).append(centre)
    return centre


def _circles(edges: Sequence[Any]) -> list[Hole]:
    """Return the upright whole circles among edges; several arcs may make up one."""
    return [Hole((x, y), 2.0 * radius) for x, y, _, radius in _whole(edges)]


def _whole(edges: Sequence[Any]) -> dict[tuple[float, ...], int]:
    """Return centre and radius of the upright whole circles among edges, and how many edges make up each."""
    import Part

    swept: dict[tuple[float, ...], list[float]] = {}
    for edge in edges:
        if edge.Degenerated or not isinstance(edge.Curve, Part.Circle) or abs(edge.Curve.Axis.z) < 1.0 - UPRIGHT:
            continue
        centre, radius = edge.Curve.Center, edge.Curve.Radius
        key = tuple(round(number, 5) for number in (centre.x, centre.y, centre.z, radius))
        swept.setdefault(key, []).append(edge.LastParameter - edge.FirstParameter)
    return {key: len(sweeps) for key, sweeps in swept.items() if sum(sweeps) > math.tau - UPRIGHT}


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
