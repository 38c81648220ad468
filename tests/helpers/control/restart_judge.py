# SPDX-License-Identifier: LGPL-2.1-or-later
"""Judges a part that was cut in two goes: is all of it cut, nothing else, and nothing twice beyond the overlap?

    program   |----------- contour ------------|----------- contour -----------|
    first go  ================================X                                     followed up to `reached`
    interval                          [ not certain ]                               as the journal states it
    restart                           ====================================          followed from `entered` on

The overlap is what the journal leaves open: the lines from the first that is not certainly cut up to the last that may
have been sent, begun earlier only where the restart says so, by the lines of one way into the cut. A place is cut
beyond it when both goes cut it and it lies outside of these lines. All is measured along the program's path, in its
order, so that a second pass over the same place is another place.

A cut is where the tool goes with its spindle on below the stock's top; straight up or down in what is cut already, as
an entry goes, it cuts nothing twice. Allowed is the path itself; before it is met,
straight up from where the tool stood, anywhere above the top within the program's bounds, and straight down on to
the place at which the path is entered.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise
from math import dist

from helpers.control.fault_judge import NEAR_STEPS, Place, Reference, Row, distance, reached, spot

NEAR_CUT_STEPS = 4 * NEAR_STEPS  # along the path: where its corners are passed, and a machine stopped dead coasts
ENTRY_LINES = 5  # of one way into the cut: over it, down, and a lead-in of three moves


@dataclass(frozen=True)
class Interval:
    """What journal and restart state, in lines of the program from 0: [first, last) is not certain.

    entrance: the line at which the restart says to enter; `first` or before it.
    """

    first: int
    last: int
    entrance: int


def judge_restart(program: Reference, first: Sequence[Row], second: Sequence[Row], said: Interval) -> str:
    """Return what is wrong with a part cut in two goes, "" where nothing is.

    first, second: the traces of the goes; `second` is empty where nothing was left to cut. The first may have left
    the path, which is judged elsewhere: it counts up to there.
    """
    path = _Path(program)
    if said.first - said.entrance > ENTRY_LINES and path.contour_steps(path.line(said.entrance), path.line(said.first)):
        return f"the restart enters line {said.entrance + 1}, far before line {said.first + 1}"
    ends = path.followed(first)
    if not second:
        left = min(path.cut_steps(end, path.length) for end in ends)
        return f"{left:.0f} steps are left uncut" if left > NEAR_CUT_STEPS else ""
    entered, entry = path.entered(second)
    if not entered:
        return "the restart does not end as the program does"
    wrongs = [_wrong(path, end, begin, said) for end in ends for begin in entered]
    return _wrong_entry(path, entry) if "" in wrongs else wrongs[0]


def _wrong(path: _Path, end: float, begin: float, said: Interval) -> str:
    """Return what is wrong when the first go ends and the second begins at places along the path."""
    if (gap := path.cut_steps(end, begin)) > NEAR_CUT_STEPS:
        return f"{gap:.0f} steps are cut by neither go"
    if (early := path.contour_steps(begin, min(path.line(said.entrance), end))) > NEAR_CUT_STEPS:
        return f"{early:.0f} steps before the overlap are cut twice"
    if (late := path.contour_steps(max(path.line(said.last), begin), end)) > NEAR_CUT_STEPS:
        return f"{late:.0f} steps behind the overlap are cut twice"
    return ""


class _Path:
    """A program's path with the way along it, in steps."""

    def __init__(self, program: Reference):
        self.rows, self._ends = program.rows, program.ends
        self._ways = list(accumulate((dist(a.place, b.place) for a, b in pairwise(self.rows)), initial=0.0))
        self.top_steps = program.top_steps
        self.length = self._ways[-1]
        cuts = [self._cuts(a, b) * dist(a.place, b.place) for a, b in pairwise(self.rows)]
        level = (cut * (a.place[:2] != b.place[:2]) for cut, (a, b) in zip(cuts, pairwise(self.rows), strict=True))
        self._cut, self._contour = (list(accumulate(steps, initial=0.0)) for steps in (cuts, level))
        self.low = [min(row.place[axis] for row in self.rows) - NEAR_STEPS for axis in range(3)]
        self.high = [max(row.place[axis] for row in self.rows) + NEAR_STEPS for axis in range(3)]

    def line(self, number: int) -> float:
        """Return where a line begins."""
        return self._ways[self._ends[number - 1]] if number else 0.0

    def cut_steps(self, begin: float, end: float) -> float:
        """Return how much is cut between two places, 0 where the second is not behind the first."""
        return max(self._sum(self._cut, end) - self._sum(self._cut, begin), 0.0)

    def contour_steps(self, begin: float, end: float) -> float:
        """Return the same without what is cut straight down."""
        return max(self._sum(self._contour, end) - self._sum(self._contour, begin), 0.0)

    def followed(self, rows: Sequence[Row]) -> list[float]:
        """Return up to where a trace may have followed the path from its begin; nowhere where that was not reached."""
        count, stretches = reached(self.rows, rows)
        return self._places(self.rows, stretches, rows[count].place) or [0.0]

    def entered(self, rows: Sequence[Row]) -> tuple[list[float], Sequence[Row]]:
        """Return from where on a trace may have followed the path to its end, and its rows up to there."""
        back = _backwards(self.rows)
        count, stretches = reached(back, _backwards(rows))
        last = len(rows) - 1 - count
        places = [self.length - way for way in self._places(back, stretches, rows[last].place)]
        return places, rows[: last + 1]

    def _places(self, rows: Sequence[Row], stretches: set[int], place: Place) -> list[float]:
        ways = self._ways if rows is self.rows else [self.length - way for way in reversed(self._ways)]
        return [ways[one] + spot(place, rows[one].place, rows[one + 1].place) for one in sorted(stretches)]

    def _cuts(self, before: Row, row: Row) -> bool:
        return row.spindle[1] > 0 and max(before.place[2], row.place[2]) < self.top_steps - NEAR_STEPS

    def _sum(self, sums: list[float], way: float) -> float:
        row = min(max(bisect_right(self._ways, way) - 1, 0), len(self._ways) - 2)
        return min(sums[row] + max(way - self._ways[row], 0.0), sums[row + 1])


def _backwards(rows: Sequence[Row]) -> list[Row]:
    """Return a path from its end to its begin; what the spindle does belongs to the way before a row."""
    spindles = [row.spindle for row in rows[1:]] + [rows[-1].spindle]
    return [Row(-row.time_s, row.place, spindle) for row, spindle in zip(rows, spindles, strict=True)][::-1]


def _wrong_entry(path: _Path, rows: Sequence[Row]) -> str:
    """Return what is wrong with the moves before the path is met."""
    stood, met = rows[0].place, rows[-1].place
    for before, row in pairwise(rows):
        above = min(before.place[2], row.place[2]) >= path.top_steps - NEAR_STEPS
        lifted = _upright(before.place, row.place, stood) and row.place[2] >= before.place[2]
        lowered = _upright(before.place, row.place, met) and min(before.place[2], row.place[2]) >= met[2] - NEAR_STEPS
        if not (lifted or lowered or (above and _within(path, stood, row.place))):
            return f"the entry leaves the allowed region at {row.place}"
    return ""


def _upright(begin: Place, end: Place, at: Place) -> bool:
    return all(distance((*place[:2], 0.0), (*at[:2], 0.0), (*at[:2], 0.0)) <= NEAR_STEPS for place in (begin, end))


def _within(path: _Path, stood: Place, place: Place) -> bool:
    """Return whether a place lies within the bounds of the program and of where the tool stood."""
    pairs = zip(place, path.low, path.high, stood, strict=True)
    return all(min(low, at - NEAR_STEPS) <= here <= max(high, at + NEAR_STEPS) for here, low, high, at in pairs)
