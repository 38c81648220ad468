# SPDX-License-Identifier: LGPL-2.1-or-later
"""What cycles that make holes share: canned cycles put into the table, and the shape of what they remove."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.canned_cycle_expansion import DWELL, FEED, OWN_WORD, Canned
from CNCStepper.cycles.cycle import Setup
from CNCStepper.cycles.holes.hole_patterns import Hole
from CNCStepper.cycles.moves import Point
from CNCStepper.errors import CycleError, Text
from CNCStepper.toolpath import TableBuilder

ROUND_ERROR_MM = 0.0002  # of the polygons that stand for circles


def cut_canned(table: TableBuilder, setup: Setup, cycle: Canned, places: Sequence[Point]) -> None:
    """Append the cycle at each place, a span a hole, from clearance height and back to it.

    The span's words are those of its block: X Y Z R, P or Q, and G (98 or 99); lengths in mm.
    """
    at = (*places[0], setup.clearance_mm)
    table.rapid(at)
    for (x, y), strokes in zip(places, cycle.holes(at[2], at[2], places), strict=True):
        own = {OWN_WORD[cycle.name]: cycle.own} if OWN_WORD[cycle.name] else {}
        retract = 98.0 if cycle.to_initial else 99.0
        table.open_span("cycle", cycle.name, X=x, Y=y, Z=cycle.z, R=cycle.r, **own, G=retract)
        for kind, end, seconds in strokes:
            if kind == DWELL:
                table.event("dwell", seconds)
            elif kind == FEED:
                table.feed(end, setup.tool.plunge_mm_min)
            elif end != at:
                table.rapid(end)
            at = end
        table.close_span()
    if at[2] < setup.clearance_mm:
        table.rapid((*at[:2], setup.clearance_mm))


def widened(holes: Sequence[Hole], diameter_mm: float, key: str) -> list[Hole]:
    """Return the holes with the diameter given, or the drawing's own where that is 0; raises CycleError without one."""
    if diameter_mm:
        return [hole._replace(diameter_mm=diameter_mm) for hole in holes]
    if any(not hole.diameter_mm for hole in holes):
        raise CycleError(
            "diameter-missing",
            Text("{key} is missing, and only the circles of a drawing have one of their own", key=key),
            advice=Text("give {key}, or a pattern of circles", key=key),
        )
    return list(holes)


def rings(holes: Sequence[Hole], inner_mm: Callable[[Hole], float], outer_mm: Callable[[Hole], float]) -> BaseGeometry:
    """Return the union of rings about the holes, between two radii; without an inner one a disc."""
    return shapely.union_all([_ring(hole, max(inner_mm(hole), 0.0), outer_mm(hole)) for hole in holes])


def _ring(hole: Hole, inner_mm: float, outer_mm: float) -> BaseGeometry:
    disc = discs([hole[:2]], outer_mm)
    return disc.difference(discs([hole[:2]], inner_mm)) if inner_mm > 0 else disc


def discs(places: Sequence[Point], radius_mm: float) -> BaseGeometry:
    """Return the union of circles about the places, within ROUND_ERROR_MM of the true ones."""
    quarter = math.ceil(math.pi / 2.0 / math.sqrt(8.0 * ROUND_ERROR_MM / radius_mm)) if radius_mm > 0 else 1
    points = shapely.points(places)
    circles = shapely.buffer(points, radius_mm, quad_segs=quarter)
    near = shapely.STRtree(points).query(points, predicate="dwithin", distance=2.0 * radius_mm)
    alone = near.shape[1] == len(places)  # each is near to itself only; a union of thousands takes seconds
    return shapely.MultiPolygon(circles.tolist()) if alone else shapely.union_all(circles)
