# SPDX-License-Identifier: LGPL-2.1-or-later
r"""The order of the cuts and the rapids between them, round the pieces that are already free.

x-----.   +------+     A piece that was cut free may tip up. A rapid that would cross one goes round it by way of
      |   | free |     the corners of its box; where no way past all of them is found it goes straight, and is
      '---+------+-->  counted.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import permutations

import numpy as np
import shapely

from CNCStepper.errors import CycleError, GeometryError
from CNCStepper.geometry.cut_order.cut_order import Stop, ordered

ONE = np.array(list(permutations(range(4), 1)))  # of the corners of a box
TWO = np.array(list(permutations(range(4), 2)))
SHY_MM = 1.0  # a rapid keeps so far off the box of a piece that it goes round
WITHIN_MM = 0.05  # a rapid along the edge of a piece does not cross it


@dataclass(frozen=True)
class Ways:
    """Rapids in their order, float64[k, 2] each, from the end of the cut before; crossing: those over free pieces."""

    ways: list[np.ndarray]
    crossing: list[int]

    @property
    def length_mm(self) -> float:
        """The length of all rapids between the cuts."""
        return float(sum(np.hypot(*np.diff(way, axis=0).T).sum() for way in self.ways[1:]))


def cut_order(
    begins: np.ndarray, ends: np.ndarray, turns: Sequence[bool], before: Sequence[tuple[int, int]]
) -> list[tuple[int, bool]]:
    """Return the cuts in an order with short rapids, each with whether it is run backwards.

    begins, ends: float64[n, 2]. turns: whether a cut may be run backwards. before: pairs, the first cut before the
    second. Raises CycleError where these contradict each other.
    """
    stops = [Stop(begin[None, :], end[None, :], turn) for begin, end, turn in zip(begins, ends, turns, strict=True)]
    try:
        visits = ordered(stops, before=before)
    except GeometryError as error:
        raise CycleError(error.code, error.what, value=error.value, advice="cut some of the curves in an operation of "
                         "their own") from error  # fmt: skip
    return [(visit.item, visit.turned) for visit in visits]


def rapid_ways(
    begins: np.ndarray, ends: np.ndarray, pieces: Sequence[shapely.Polygon | None], kerf_mm: float, round_them: bool
) -> Ways:
    """Return the rapid to each cut, begins float64[n, 2], from the end of the one before, ends float64[n, 2].


    pieces: the area that each cut encloses, free but for the kerf afterwards; None for nothing.
    round_them: whether rapids go round free pieces.
    """
    starts = np.vstack([begins[:1], ends[:-1]])
    ways = [np.array([start, begin]) for start, begin in zip(starts, begins, strict=True)]
    known = [(number, piece) for number, piece in enumerate(pieces) if piece is not None]
    if not round_them or not known:
        return Ways(ways, [])
    free = _Free(np.array([number for number, _ in known]), np.array([piece for _, piece in known], object), kerf_mm)
    crossing = []
    for number in free.hit(shapely.linestrings(ways), np.arange(len(ways))):
        way = free.past(ways[number], number)
        if way is None:
            crossing.append(number)
        else:
            ways[number] = way
    return Ways(ways, crossing)


class _Free:
    """Pieces with the number of the cut that frees each."""

    def __init__(self, freed: np.ndarray, pieces: np.ndarray, kerf_mm: float):
        self._freed, self._pieces = freed, shapely.buffer(pieces, -kerf_mm / 2.0 - WITHIN_MM, quad_segs=2)
        self._tree = shapely.STRtree(self._pieces)

    def hit(self, lines: np.ndarray, numbers: np.ndarray) -> list[int]:
        """Return which lines, run before the cut with their number, cross a piece that is free then."""
        line, piece = self._tree.query(lines, predicate="intersects")
        return sorted(set(line[self._freed[piece] < numbers[line]].tolist()))

    def past(self, way: np.ndarray, number: int) -> np.ndarray | None:
        """Return the shortest way round the pieces that the straight one crosses, over corners of their box."""
        crossed = self._tree.query(shapely.LineString(way), predicate="intersects")
        boxes = shapely.bounds(self._pieces[crossed[self._freed[crossed] < number]])
        low, high = boxes[:, :2].min(axis=0) - SHY_MM, boxes[:, 2:].max(axis=0) + SHY_MM
        corners = np.array([(x, y) for x in (low[0], high[0]) for y in (low[1], high[1])])
        one = self._shortest(way, corners[ONE], number)
        return one if one is not None else self._shortest(way, corners[TWO], number)

    def _shortest(self, way: np.ndarray, over: np.ndarray, number: int) -> np.ndarray | None:
        """Return the shortest of the ways over some corners, float64[k, c, 2], that crosses nothing free."""
        begin, end = np.tile(way[0], (len(over), 1, 1)), np.tile(way[1], (len(over), 1, 1))
        ways = np.concatenate([begin, over, end], axis=1)
        length_mm = np.hypot(*np.moveaxis(np.diff(ways, axis=1), 2, 0)).sum(axis=1)
        length_mm[self.hit(shapely.linestrings(ways), np.full(len(ways), number))] = np.inf
        best = int(length_mm.argmin())
        return ways[best] if np.isfinite(length_mm[best]) else None
