# SPDX-License-Identifier: LGPL-2.1-or-later
"""The order of cuts: inside before outside, then short rapids.

What lies inside a closed outline is cut before it, because the outline may set the part free. Within
that order, and any other that the caller asks for, the rapids are made short.
The same items in the same order always give the same tour.

Kernels of the order of cuts: a first tour by the nearest next cut, made shorter by 2-opt and Or-opt moves.

    begin, end   float64[m, 2]       where each way of cutting an item begins and ends
    back         int64[m]            the reversed way; -1 where there is none
    first        int64[n + 1]        the ways of item i are first[i] to first[i + 1]
    pairs        int64[p, 2]         item, and an item that may only come after it
    tour         int64[n]            the items in their order
    way          int64[n]            for each item the way chosen
    at, to       float64[n + 1, 2]   the rapid before each place of the tour: from at[i] to to[i]

Croes 1958 (2-opt) and Or 1976 (Or-opt); with a partial order a move is allowed as long as no item passes one that
it must precede. As the tour at hand keeps the order, looking at direct pairs is enough.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve
from CNCStepper.kernels import njit

GAIN_MM = 1e-7  # less is noise, and the search might never end
LONGEST = 3  # items that an Or-opt move takes along


@njit
def nearest_first(begin, end, first, pairs, x, y):
    """Return tour and way by always going to the nearest begin allowed; the tour is shorter if pairs run in circles."""
    count = len(first) - 1
    waits = np.zeros(count, np.int64)
    for pair in range(len(pairs)):
        waits[pairs[pair, 1]] += 1
    tour, way, done = np.empty(count, np.int64), np.full(count, -1), 0
    while done < count:
        best, chosen, least = -1, -1, np.inf
        for item in range(count):
            if way[item] >= 0 or waits[item] > 0:
                continue
            for one in range(first[item], first[item + 1]):
                square = (begin[one, 0] - x) ** 2 + (begin[one, 1] - y) ** 2
                if square < least:
                    best, chosen, least = item, one, square
        if best < 0:
            return tour[:done], way
        tour[done], way[best] = best, chosen
        done += 1
        x, y = end[chosen, 0], end[chosen, 1]
        for pair in range(len(pairs)):
            if pairs[pair, 0] == best:
                waits[pairs[pair, 1]] -= 1
    return tour, way


@njit
def improve(begin, end, back, first, pairs, x, y, tour, way):
    """Shorten the tour in place until no move of the three kinds gains."""
    at, to = np.empty((len(tour) + 1, 2)), np.empty((len(tour) + 1, 2))
    at[0, 0], at[0, 1] = x, y
    _lay(begin, end, tour, way, at, to, 0, len(tour))
    gained = True
    while gained:
        gained = _turn_stretches(begin, end, back, pairs, tour, way, at, to)
        gained |= _move_stretches(begin, end, back, pairs, tour, way, at, to)
        gained |= _choose_ways(begin, end, first, tour, way, at, to)


@njit
def _lay(begin, end, tour, way, at, to, low, high):
    """Write the rapids around the places [low, high) of the tour; after the last place the tool stays."""
    for place in range(low, high):
        one = way[tour[place]]
        to[place, 0], to[place, 1] = begin[one, 0], begin[one, 1]
        at[place + 1, 0], at[place + 1, 1] = end[one, 0], end[one, 1]
    to[len(tour), 0], to[len(tour), 1] = at[len(tour), 0], at[len(tour), 1]


@njit
def _square(a, i, b, j):
    x, y = a[i, 0] - b[j, 0], a[i, 1] - b[j, 1]
    return x * x + y * y


@njit
def _bounds(pairs, tour):
    """Return for each place of the tour the last place that must precede it and the first that must follow."""
    low, high = np.full(len(tour), -1), np.full(len(tour), len(tour))
    if len(pairs) == 0:
        return low, high
    place = np.empty(len(tour), np.int64)
    for index in range(len(tour)):
        place[tour[index]] = index
    for pair in range(len(pairs)):
        a, b = place[pairs[pair, 0]], place[pairs[pair, 1]]
        low[b], high[a] = max(low[b], a), min(high[a], b)
    return low, high


@njit
def _turn_stretches(begin, end, back, pairs, tour, way, at, to):
    """Turn round each stretch of the tour that becomes shorter by it; return whether there was one."""
    gained, count = False, len(tour)
    low, _ = _bounds(pairs, tour)
    for i in range(count):
        j = i
        while j < count and low[j] < i and back[way[tour[j]]] >= 0:
            last = j + 1 == count  # nothing follows: only the rapid before the stretch changes
            enters, before = _square(at, i, at, j + 1), _square(at, i, to, i)
            leaves, after = _square(to, i, to, j + 1), _square(at, j + 1, to, j + 1)
            if enters < before or (leaves < after and not last):  # one of both must become shorter
                gain = math.sqrt(before) - math.sqrt(enters)
                if not last:
                    gain += math.sqrt(after) - math.sqrt(leaves)
                if gain > GAIN_MM:
                    _turn(back, tour, way, i, j)
                    _lay(begin, end, tour, way, at, to, i, j + 1)
                    low, _ = _bounds(pairs, tour)
                    gained = True
            j += 1
    return gained


@njit
def _turn(back, tour, way, i, j):
    for place in range(i, j + 1):
        way[tour[place]] = back[way[tour[place]]]
    tour[i : j + 1] = tour[i : j + 1][::-1].copy()


@njit
def _move_stretches(begin, end, back, pairs, tour, way, at, to):
    """Move stretches of up to LONGEST items to where they cost less, turned round where that is better still."""
    gained, count = False, len(tour)
    low, high = _bounds(pairs, tour)
    for length in range(1, min(LONGEST, count - 1) + 1):
        for i in range(count - length + 1):
            goal, turned = _best_place(back, tour, way, at, to, low, high, i, length)
            if goal >= 0:
                _move(back, tour, way, i, length, goal, turned)
                _lay(begin, end, tour, way, at, to, min(i, goal), max(i + length, goal))
                low, high = _bounds(pairs, tour)
                gained = True
    return gained


@njit
def _best_place(back, tour, way, at, to, low, high, i, length):
    """Return before which place the stretch of `length` from i would cost least, and whether turned; -1 to leave it."""
    past, count = i + length, len(tour)
    earliest, latest, turns = 0, count, True
    for place in range(i, past):  # an item bound to one in the stretch hides what else it is bound to: it stays there
        turns = turns and back[way[tour[place]]] >= 0 and low[place] < i
        earliest = max(earliest, low[place] + 1 if low[place] < i else past)
        latest = min(latest, high[place] if high[place] >= past else i)
    saved = math.sqrt(_square(at, i, to, i))
    if past < count:
        saved += math.sqrt(_square(at, past, to, past)) - math.sqrt(_square(at, i, to, past))
    best, best_turned, most = -1, False, GAIN_MM
    for goal in range(earliest, latest + 1):
        if i <= goal <= past:
            continue
        here = saved + math.sqrt(_square(at, goal, to, goal))
        straight, turned = _square(at, goal, to, i), _square(at, goal, at, past)
        if min(straight, turned) >= here * here:
            continue
        straight, turned = here - math.sqrt(straight), here - math.sqrt(turned)
        if goal < count:
            straight -= math.sqrt(_square(at, past, to, goal))
            turned -= math.sqrt(_square(to, i, to, goal))
        if straight > most:
            best, best_turned, most = goal, False, straight
        if turns and turned > most:
            best, best_turned, most = goal, True, turned
    return best, best_turned


@njit
def _move(back, tour, way, i, length, goal, turned):
    """Put the stretch of `length` from i before the place `goal` of the tour."""
    if turned:
        _turn(back, tour, way, i, i + length - 1)
    stretch = tour[i : i + length].copy()
    if goal < i:
        tour[goal + length : i + length] = tour[goal:i].copy()
        tour[goal : goal + length] = stretch
    else:
        tour[i : goal - length] = tour[i + length : goal].copy()
        tour[goal - length : goal] = stretch


@njit
def _choose_ways(begin, end, first, tour, way, at, to):
    """Choose for each item, its neighbours as they are, the way with the shortest rapids; return whether it gained."""
    gained, count = False, len(tour)
    for place in range(count):
        item = tour[place]
        best, least = way[item], np.inf
        for one in range(first[item], first[item + 1]):
            here = math.sqrt(_square(at, place, begin, one))
            if place + 1 < count:
                here += math.sqrt(_square(end, one, to, place + 1))
            if here < least - GAIN_MM or (one == way[item] and here <= least + GAIN_MM):
                best, least = one, here
        if best != way[item]:
            way[item] = best
            _lay(begin, end, tour, way, at, to, place, place + 1)
            gained = True
    return gained


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
    order, way = nearest_first(begin, end, first, pairs, x, y)
    if len(order) < len(stops):
        stuck = sorted(set(range(len(stops))) - set(order.tolist()))
        what, advice = "the locks of the order contradict each other", "take a lock out"
        raise GeometryError("order-circle", what, value=f"items {stuck[:8]}", advice=advice)

    def improved(order: np.ndarray, way: np.ndarray) -> list[Visit]:
        improve(begin, end, back, first, pairs, x, y, order, way)
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
        what, advice = "an order names an item that is not there", "name each by its place, from 0 on"
        raise GeometryError("order-item", what, limit=f"{count} items", advice=advice)
    return table


def _ways(stops: Sequence[Stop]) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return the tables of the kernels; the ways of a stop are its begins in turn and then, where it turns, its
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
