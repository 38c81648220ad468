# SPDX-License-Identifier: LGPL-2.1-or-later
"""The order of cuts: inside before outside, then short rapids.

What lies inside a closed outline is cut before it, because the outline may set the part free. Within
that order, and any other that the caller asks for, the rapids are made short; see tour_kernels.py.
The same items in the same order always give the same tour.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.cut_order import tour_kernels

MOST_STARTS = 24  # of the vertices of a closed curve
CHORDS = 1e-3  # of a curve's size: how closely its outline is followed to see what lies inside
TWINS = 1e-9  # a closed curve holds only what is smaller by this share; twins do not hold each other


@dataclass(frozen=True)
class Stop:
    """One thing to cut: where it may begin and where it then ends, float64[k, 2] each; `turns`: or from there back."""

    begins: np.ndarray
    ends: np.ndarray
    turns: bool

    @classmethod
    def at_point(cls, x_mm: float, y_mm: float) -> Stop:
        """Return the stop of a hole."""
        place = np.array([(x_mm, y_mm)], float)
        return cls(place, place, True)

    @classmethod
    def of_curve(cls, curve: Curve, *, turns: bool = False, starts: Sequence[int] | None = None) -> Stop:
        """Return the stop of a curve.

        An open one runs from its begin to its end, or back when it `turns`. A closed one may start at each of the
        vertices `starts`; without, at any of up to MOST_STARTS spread over it.
        """
        if not curve.closed:
            return cls(curve.xy[:1], curve.xy[-1:], turns)
        if starts is None:
            starts = spread(len(curve))
        places = curve.xy[list(starts)]
        return cls(places, places, True)


@dataclass(frozen=True)
class Visit:
    """The item to cut next: from its begin number `start`, or turned round from where that one ends."""

    item: int
    start: int
    turned: bool


def spread(count: int) -> list[int]:
    """Return up to MOST_STARTS of the numbers below `count`, evenly spread."""
    return (
        sorted({index * count // MOST_STARTS for index in range(MOST_STARTS)})
        if count > MOST_STARTS
        else [*range(count)]
    )


def ordered(
    stops: Sequence[Stop],
    from_mm: tuple[float, float] = (0.0, 0.0),
    *,
    before: Iterable[tuple[int, int]] = (),
    locks: Iterable[Sequence[int]] = (),
) -> list[Visit]:
    """Return the stops in an order with short rapids from `from_mm` on.

    before: pairs of items, the first to be cut before the second. locks: items that are cut in the order given,
    others perhaps between them. Where the stops may be made as they are given, that is never shorter. Raises
    GeometryError when the orders contradict each other.
    """
    pairs = _pairs([*before, *(pair for lock in locks for pair in itertools.pairwise(lock))], len(stops))
    if not stops:
        return []
    begin, end, back, first = _ways(stops)
    x, y = map(float, from_mm)
    order, way = tour_kernels.nearest_first(begin, end, first, pairs, x, y)
    if len(order) < len(stops):
        stuck = sorted(set(range(len(stops))) - set(order.tolist()))
        raise GeometryError("order-circle", "the locks of the order contradict each other", value=f"items {stuck[:8]}")

    def improved(order: np.ndarray, way: np.ndarray) -> list[Visit]:
        tour_kernels.improve(begin, end, back, first, pairs, x, y, order, way)
        return [_visit(stops[item], int(item), int(way[item] - first[item])) for item in order]

    found, given = improved(order, way), [Visit(item, 0, False) for item in range(len(stops))]
    allowed = bool((pairs[:, 0] < pairs[:, 1]).all())
    if allowed and rapids_mm(stops, given, from_mm) < rapids_mm(stops, found, from_mm):
        return improved(np.arange(len(stops)), first[:-1].copy())
    return found


def rapids_mm(stops: Sequence[Stop], visits: Iterable[Visit], from_mm: tuple[float, float] = (0.0, 0.0)) -> float:
    """Return the length of all rapids between the cuts."""
    total, here = 0.0, np.array(from_mm, float)
    for visit in visits:
        ends = stops[visit.item].begins[visit.start], stops[visit.item].ends[visit.start]
        begin, end = reversed(ends) if visit.turned else ends
        total, here = total + float(np.hypot(*(begin - here))), end
    return total


def inside_before_outside(curves: Sequence[Curve]) -> list[tuple[int, int]]:
    """Return pairs (inner, outer) of indices: each curve and the smallest closed one that holds all of it."""
    return [(inner, outer) for inner, outer in enumerate(parents(curves)) if outer >= 0]


def parents(curves: Sequence[Curve]) -> list[int]:
    """Return for each curve the index of the smallest closed one around it, -1 where there is none.

    Curves that cross hold neither each other. Outlines are followed to CHORDS of their size.
    """
    closed = [index for index, curve in enumerate(curves) if curve.closed]
    if not closed:
        return [-1] * len(curves)
    lines = [shapely.linestrings(_chords(curve)) for curve in curves]
    areas = np.array([abs(curve.area_mm2) if curve.closed else 0.0 for curve in curves])
    outlines = shapely.make_valid(shapely.polygons([shapely.linearrings(lines[index].coords) for index in closed]))
    found = [-1] * len(curves)
    for outer, inner in shapely.STRtree(lines).query(outlines, predicate="contains").T:
        holder = closed[outer]
        larger = areas[holder] > areas[inner] * (1.0 + TWINS)
        if holder != inner and larger and (found[inner] < 0 or areas[holder] < areas[found[inner]]):
            found[inner] = holder
    return found


def _chords(curve: Curve) -> np.ndarray:
    """Return points along the curve; a closed one that is a mere stroke is given once more, for a ring has three."""
    points = curve.points(max(CHORDS * float(np.ptp(curve.xy, axis=0).max()), 1e-6))
    return points if len(points) > 3 or not curve.closed else np.vstack([points[0], points])


def _pairs(pairs: Iterable[tuple[int, int]], count: int) -> np.ndarray:
    table = np.array(sorted(set(pairs)), np.int64).reshape(-1, 2)
    if len(table) and not (table.min() >= 0 and table.max() < count):
        raise GeometryError("order-item", "an order names an item that is not there", limit=f"{count} items")
    return table


def _ways(stops: Sequence[Stop]) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return the tables of tour_kernels.py; the ways of a stop are its begins in turn and then, where it turns, its
    ends."""
    begins: list[np.ndarray] = []
    ends: list[np.ndarray] = []
    backs: list[np.ndarray] = []
    first = [0]
    for stop in stops:
        count, offset = len(stop.begins), first[-1]
        straight = offset + np.arange(count)
        round_ = np.array_equal(stop.begins, stop.ends)
        doubled = stop.turns and not round_
        begins += [stop.begins, stop.ends] if doubled else [stop.begins]
        ends += [stop.ends, stop.begins] if doubled else [stop.ends]
        backs += [straight + count, straight] if doubled else [straight if stop.turns else np.full(count, -1)]
        first.append(offset + (2 * count if doubled else count))
    return np.vstack(begins), np.vstack(ends), np.concatenate(backs), np.array(first)


def _visit(stop: Stop, item: int, way: int) -> Visit:
    return Visit(item, way % len(stop.begins), way >= len(stop.begins))
