# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path of a program's tool, row after row, and places on it.

row      0          1      2                3
|-------------|--------|------|-----+----------------|
                                    Place(3, 0.3)

The moves along a stretch of the way, in either sense: each with the part of the way that it is.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property, lru_cache
from math import ceil, inf, isnan, tau
from typing import NamedTuple

import numpy as np

from CNCStepper.errors import ProgramError
from CNCStepper.recovery.retract.move_curve import Move, Point
from CNCStepper.tolerances import SAME_MM
from CNCStepper.toolpath import LINE, RAPID, Toolpath

KEPT_MOVES = 4096
BARRIERS = ("tool_change", "probe")  # events that no retract crosses


class Place(NamedTuple):
    """A place on a way: its row, and how much of that lies behind it, 0 to 1."""

    row: int
    share: float


class RetractPath:
    """The rows of a table of moves as curves; made when they are asked for, so that long programs cost nothing."""

    def __init__(self, toolpath: Toolpath):
        self.toolpath = toolpath
        self._table = toolpath.table()
        self.move = lru_cache(KEPT_MOVES)(self._move)

    def __len__(self) -> int:
        return len(self._table)

    @cached_property
    def lines(self) -> np.ndarray:
        """The line of the text of each row, int32[n], rising."""
        return self._table.line

    @property
    def top_mm(self) -> float:
        """The greatest height of Z that it leads to, in mm; -inf where none is known."""
        return float(np.nanmax(self._table.end[:, 2], initial=-inf))

    @cached_property
    def _barriers(self) -> np.ndarray:
        """The rows, rising, that no retract leaves at their begin: the rows before are unknown or cannot be undone."""
        unknown = np.flatnonzero(np.isnan(self._table.end[:, :3]).any(axis=1)) + 2
        starts = [1] if any(map(isnan, self.toolpath.start.position_mm[:3])) else [0]
        events = [event.index for event in self.toolpath.events if event.kind in BARRIERS]
        return np.unique([*starts, *unknown.tolist(), *events])

    def rows_of(self, line: int) -> range:
        """Return the rows that a line of the text has made."""
        return range(int(np.searchsorted(self.lines, line)), int(np.searchsorted(self.lines, line, side="right")))

    def length_mm(self, begin: Place, end: Place) -> float:
        """Return the length of the path from one place to another."""
        return sum(self.move(row).length_mm * abs(to - since) for row, since, to in self.stretch(begin, end))

    def back_by(self, place: Place, length_mm: float) -> Place:
        """Return the place that lies `length_mm` before another, or the begin of what can be retraced."""
        for row, move in self._backwards(place):
            behind_mm = move.length_mm * (place.share if row == place.row else 1.0)
            if behind_mm >= length_mm:
                return Place(row, (behind_mm - length_mm) / move.length_mm if behind_mm else 0.0)
            length_mm -= behind_mm
        return Place(self.begin_before(place), 0.0)

    def forward_by(self, place: Place, length_mm: float, last: Place) -> Place:
        """Return the place that lies `length_mm` behind another, `last` at most."""
        for row in range(place.row, last.row + 1):
            move, share = self.move(row), place.share if row == place.row else 0.0
            end = last.share if row == last.row else 1.0
            if move.length_mm * (end - share) >= length_mm:
                return Place(row, share + length_mm / move.length_mm if length_mm else share)
            length_mm -= move.length_mm * (end - share)
        return last

    def back_to_row(self, place: Place, row: int) -> Place:
        """Return the begin of a row before a place; raises ProgramError where no retract reaches it."""
        if not self.begin_before(place) <= row <= place.row:
            raise ProgramError(
                "retreat-far",
                "the retract does not lead to that place",
                advice="choose a line that was cut after the last tool change and before this one",
            )
        return Place(row, 0.0)

    def last_entry(self, place: Place) -> Place:
        """Return where the last way down into the work begins, or the end of the last rapid where none leads down."""
        descended = False
        for row, move in self._backwards(place):
            if move.is_still:
                continue
            share = place.share if row == place.row else 1.0
            down = move.kind != RAPID and move.at(share)[2] < move.begin[2] - SAME_MM
            if move.kind == RAPID or (descended and not down):
                return Place(row, share) if row == place.row else Place(row + 1, 0.0)
            descended = descended or down
        return Place(self.begin_before(place), 0.0)

    def begin_before(self, place: Place) -> int:
        """Return the first row that a retract from a place runs through; raises ProgramError for none."""
        behind = self._barriers[self._barriers <= place.row]
        if not len(behind):
            what = "where this move began is not known, so there is no way back along it"
            raise ProgramError("retreat-unknown", what, advice="resume, and hold at a later move")
        return int(behind[-1])

    def stretch(self, begin: Place, end: Place) -> Iterator[tuple[int, float, float]]:
        """Yield (row, from share, to share) of the path from one place to another, backwards where `end` is before."""
        forward = tuple(begin) <= tuple(end)
        for row in range(begin.row, end.row + 1) if forward else range(begin.row, end.row - 1, -1):
            near, far = (0.0, 1.0) if forward else (1.0, 0.0)
            part = (row, begin.share if row == begin.row else near, end.share if row == end.row else far)
            if part[1] != part[2]:
                yield part

    def times_s(self, first: int, last: int, rapid_mm_min: float = inf) -> np.ndarray:
        """Return the shortest time to the begin of each row of [first, last), in s from `first` on, float64[n + 1]."""
        moves = [self.move(row) for row in range(first, last)]
        return np.cumsum([0.0, *(60.0 * move.length_mm / (move.feed_mm_min or rapid_mm_min) for move in moves)])

    def _backwards(self, place: Place) -> Iterator[tuple[int, Move]]:
        return ((row, self.move(row)) for row in range(place.row, self.begin_before(place) - 1, -1))

    def _move(self, row: int) -> Move:
        table = self._table
        begin = table.end[row - 1] if row else np.asarray(self.toolpath.start.position_mm, float)
        begin_mm, end_mm, centre_mm = (_point(values) for values in (begin, table.end[row], table.centre[row]))
        arc = int(table.plane[row]), int(table.turns[row])
        return Move(int(table.kind[row]), begin_mm, end_mm, centre_mm, *arc, float(table.feed[row]))


def _point(values: np.ndarray) -> Point:
    return float(values[0]), float(values[1]), float(values[2])


SHORT_MM = 0.01  # shorter arcs become lines: their rounded ends would give another angle
MOST_SWEEP_RAD = 0.75 * tau  # of one move: beyond it rounded ends could make a whole circle of it, or none

Part = tuple[int, float, float]  # row, from share, to share


def stretch_moves(way: RetractPath, begin: Place, end: Place) -> Iterator[tuple[Move, Part]]:
    """Yield the moves between two places, the first from the machine's position, less than a step away.

    Rows that lead nowhere are left out.
    """
    row = min(max(begin.row, 0), len(way) - 1)
    move = way.move(row)
    there_mm = move.at(begin.share)
    yield Move(_straight(move), there_mm, there_mm, feed_mm_min=move.feed_mm_min), (row, begin.share, begin.share)
    for row, first, last in way.stretch(begin, end):
        if not way.move(row).is_still:
            for one, part in _pieces(way.move(row), first, last):
                yield one, (row, *part)


def _pieces(move: Move, first: float, last: float) -> Iterator[tuple[Move, tuple[float, float]]]:
    """Yield a part of a move in pieces that rounding cannot turn into something else."""
    share = last - first
    if not move.is_arc or move.length_mm * abs(share) < SHORT_MM:
        yield Move(_straight(move), move.at(first), move.at(last), feed_mm_min=move.feed_mm_min), (first, last)
        return
    count = ceil(abs(move.sweep_rad * share) / MOST_SWEEP_RAD)
    for number in range(count):
        ends = first + share * number / count, first + share * (number + 1) / count
        yield move.part(*ends), ends


def _straight(move: Move) -> int:
    """Return the kind of the straight move that goes as fast."""
    return RAPID if move.kind == RAPID else LINE
