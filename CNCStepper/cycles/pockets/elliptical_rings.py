# SPDX-License-Identifier: LGPL-2.1-or-later
"""The closed curves that clear an ellipse from its centre outwards, equally far apart, and leave no island.

    parallel   true parallel curves of the wall, as arcs; the step is the same all around
    similar    similar ellipses, point by point, as published; the step grows along the longer axis

A point between two curves lies at most one step (along the longer axis) inside the outer one. So steps
up to the tool's radius, less what the curves themselves are off, cannot leave islands; larger ones can,
on the long axis, and are tried.
"""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from itertools import accumulate

import numpy as np
import shapely
from shapely import Point, Polygon

from CNCStepper.cycles.passes import equal_passes, require_few_blocks, whole_passes
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.shapes.ellipse import Ellipse
from CNCStepper.geometry.shapes.ellipse_dda import ellipse_by_dda

OUTLINE_ERROR_MM = 0.0002  # of the wanted region's polygon
ROUNDING_MM = 0.002  # what writing three decimals may add to a fitted arc, end and centre together
ISLAND_ERROR_MM = 0.001  # flattening where passes are tested for islands
ISLAND_MM2 = 1e-6


@dataclass(frozen=True)
class Way:
    """One family of curves from the centre out to the wall's pass.

    reach_mm: from the centre to the wall's pass, where steps are counted. stretch: the step along the longer
    axis is that many times larger. error_mm: how far a curve, and wall_error_mm the last one, may be off its place.
    ring: the curve at a distance from the centre; the second argument says that it is the wall's.
    """

    reach_mm: float
    stretch: float
    error_mm: float
    wall_error_mm: float
    ring: Callable[[float, bool], Curve]


@dataclass(frozen=True)
class Rings:
    """The curves from the centre outwards, the last one on the wall, and their recalculated step (the larger one)."""

    curves: list[Curve]
    stepover_mm: float


def parallel_way(ellipse: Ellipse, tool_mm: float, stepover_mm: float, finish_mm: float, tolerance_mm: float) -> Way:
    """Return the true parallel curves of the wall; `tool_mm` is the tool's radius.

    Only the wall's keeps to the tolerance. The others stay clear of it by four fifths of the finishing step; without
    one they step unevenly by a fiftieth.
    """
    reach_mm = ellipse.minor_mm - tool_mm
    fit_mm = min(0.8 * (tolerance_mm - ROUNDING_MM), tool_mm / 4.0)
    rough_mm = max(fit_mm, 0.2 * finish_mm if finish_mm else 0.02 * min(stepover_mm, reach_mm))

    def ring(out_mm: float, is_wall: bool) -> Curve:
        if is_wall:
            return ellipse.parallel(tool_mm, fit_mm)
        return ellipse.parallel(ellipse.minor_mm - out_mm, rough_mm)

    return Way(reach_mm, 1.0, rough_mm, fit_mm, ring)


def similar_way(
    centre: tuple[float, float],
    radii_mm: tuple[float, float],
    rotation_deg: float,
    tool_mm: float,
    resolution_mm: float,
    error_mm: float,
) -> Way:
    """Return similar ellipses about `centre`, each within `error_mm` of its own; steps are counted along Y."""
    wide_mm, high_mm = radii_mm[0] - tool_mm, radii_mm[1] - tool_mm
    stretch = max(wide_mm / high_mm, 1.0)

    def ring(out_mm: float, is_wall: bool) -> Curve:
        share = 1.0 if is_wall else out_mm / high_mm
        curve = ellipse_by_dda(wide_mm * share, high_mm * share, resolution_mm, error_mm)
        return curve.rotated(rotation_deg).moved(*centre)

    return Way(high_mm, stretch, error_mm, error_mm, ring)


def rings_along(
    way: Way, centre: tuple[float, float], tool_mm: float, stepover_mm: float, finish_mm: float, levels: int
) -> Rings:
    """Return the fewest equally spaced curves of `way` that leave no island, `stepover_mm` apart at most.

    Raises CycleError for a finishing step that would leave some, and for more blocks in all levels than allowed.
    """
    most_mm = (tool_mm - way.wall_error_mm) / way.stretch
    if finish_mm > most_mm:
        raise CycleError(
            "finish-wide",
            "finish_stepover_mm (ae_acab) is larger than the tool's radius allows",
            value=f"{finish_mm:g} mm",
            limit=f"{most_mm:.4g} mm",
            advice="leave less for the finishing pass, or islands remain",
        )
    few = len(whole_passes(way.reach_mm, stepover_mm / way.stretch, finish_mm, "stepover_mm")) - bool(finish_mm)
    rough_mm = way.reach_mm - finish_mm
    enough = math.ceil(rough_mm * way.stretch / (tool_mm - way.error_mm))

    def rings(count: int) -> Iterator[Curve]:
        return _rings(way, equal_passes(rough_mm, count, finish_mm), levels)

    more = bisect_left(range(few, enough), True, key=lambda count: not leaves_islands(rings(count), centre, tool_mm))
    return Rings(list(rings(few + more)), rough_mm / (few + more) * way.stretch)


def leaves_islands(rings: Iterable[Curve], centre: tuple[float, float], tool_mm: float) -> bool:
    """Return whether a tool that runs along `rings` and has been at `centre` leaves something between two of them.

    Each ring stands for its convex hull, and the tool is taken smaller by what the ring dents it.
    """
    reached = Point(centre).buffer(tool_mm)
    for ring in rings:
        points = ring.points(ISLAND_ERROR_MM)
        hull = Polygon(points).convex_hull
        shapely.prepare(hull.exterior)
        width_mm = tool_mm - float(shapely.distance(hull.exterior, shapely.points(points)).max())
        if hull.buffer(ISLAND_ERROR_MM - width_mm).difference(reached).area > ISLAND_MM2:
            return True
        reached = hull.buffer(width_mm, quad_segs=32)
    return False


def offset_deviation_mm(ellipse: Ellipse, tool_mm: float) -> float:
    """Return how far the ellipse with both radii smaller by the tool leaves the true path of the tool's centre."""
    t = np.linspace(0.0, math.pi / 2.0, 721)
    own = np.column_stack([(ellipse.major_mm - tool_mm) * np.cos(t), (ellipse.minor_mm - tool_mm) * np.sin(t)])
    wall = Ellipse((0.0, 0.0), ellipse.major_mm, ellipse.minor_mm, 0.0).points(OUTLINE_ERROR_MM)
    tree = shapely.STRtree(shapely.linestrings(np.stack([wall[:-1], wall[1:]], axis=1)))
    _, distances_mm = tree.query_nearest(shapely.points(own), all_matches=False, return_distance=True)
    return float(np.abs(distances_mm - tool_mm).max())


def _rings(way: Way, steps: list[float], levels: int) -> Iterator[Curve]:
    blocks = 0
    for number, out_mm in enumerate(accumulate(steps), start=1):
        ring = way.ring(out_mm, number == len(steps))
        blocks += len(ring) * levels
        require_few_blocks(blocks)
        yield ring
