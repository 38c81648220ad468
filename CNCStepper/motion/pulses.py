# SPDX-License-Identifier: LGPL-2.1-or-later
"""Single pulses of the motors around any moment of a program, without making those far from it.

pass      |----m----m----m----m----|      m: a mark, from which the planner goes on again; laid as far as
moment                  ^                    moments are asked for, a few kB each, some 40 s of motion apart
                   |---------|               the piece whose segments are made, and of these the steps of one
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from CNCStepper.machine.profile import Machine
from CNCStepper.motion.limits import Limits
from CNCStepper.motion.memory import TICKS_PER_S
from CNCStepper.motion.plan import Mark, Run
from CNCStepper.motion.timeline import step_table
from CNCStepper.toolpath import Toolpath


class Pulse(NamedTuple):
    """A moment at which some motor steps, and where the axes stand after it, in steps from machine zero."""

    time_s: float
    position_steps: tuple[int, ...]


class Pulses:
    """The pulses of a table of moves; its positions must be known, as `plan.begun` leaves them."""

    def __init__(self, toolpath: Toolpath, machine: Machine | Limits):
        self._run = Run(toolpath, machine)
        self._marks: list[Mark] = []
        self._begins_s: list[float] = []  # of the first segment behind each mark
        self._frontier = self._run.mark()
        self._ended = False
        self._held: tuple[int, np.recarray] | None = None  # a piece and its number

    def after(self, time_s: float) -> Pulse | None:
        """Return the first pulse later than a moment, None behind the last."""
        self._lay_marks(time_s)
        number = self._number(time_s)
        for segments in self._pieces_from(number):
            for row in range(_row_at(segments, time_s), len(segments)):
                times_s, positions = _steps(segments, row)
                place = int(np.searchsorted(times_s, time_s, side="right"))
                if place < len(times_s):
                    return _pulse(times_s, positions, place)
        return None

    def before(self, time_s: float) -> Pulse | None:
        """Return the last pulse earlier than a moment, None before the first."""
        self._lay_marks(time_s)
        for number in range(self._number(time_s), -1, -1) if self._marks else ():
            segments = self._piece(number)
            for row in range(_row_at(segments, time_s), -1, -1):
                times_s, positions = _steps(segments, row)
                place = int(np.searchsorted(times_s, time_s, side="left")) - 1
                if place >= 0:
                    return _pulse(times_s, positions, place)
        return None

    def _number(self, time_s: float) -> int:
        """Return the number of the piece in which a moment lies, the first one before the begin."""
        return max(bisect_right(self._begins_s, time_s) - 1, 0)

    def _pieces_from(self, number: int) -> Iterator[np.recarray]:
        while number < len(self._marks) or self._lay_mark():
            yield self._piece(number)
            number += 1

    def _piece(self, number: int) -> np.recarray:
        """Return the segments behind a mark."""
        if self._held is None or self._held[0] != number:
            self._run.back_to(self._marks[number])
            self._held = number, self._run.piece().copy().view(np.recarray)
        return self._held[1]

    def _lay_marks(self, time_s: float) -> None:
        """Lay marks until one lies behind a moment."""
        while (not self._begins_s or self._begins_s[-1] <= time_s) and self._lay_mark():
            pass

    def _lay_mark(self) -> bool:
        """Lay the next mark; returns False when no piece follows."""
        if self._ended:
            return False
        self._run.back_to(self._frontier)
        piece = self._run.piece()
        if not len(piece):
            self._ended = True
            return False
        self._marks.append(self._frontier)
        self._begins_s.append(float(piece.start[0]) / TICKS_PER_S)
        self._held = len(self._marks) - 1, piece.copy().view(np.recarray)
        self._frontier = self._run.mark()
        return True


def _row_at(segments: np.recarray, time_s: float) -> int:
    """Return the row of the last segment that begins at a moment or before, the first one before the begin."""
    return max(int(np.searchsorted(segments.start / TICKS_PER_S, time_s, side="right")) - 1, 0)


def _steps(segments: np.recarray, row: int) -> tuple[np.ndarray, np.ndarray]:
    clocks, positions = step_table(segments[row : row + 1].view(np.recarray))
    return clocks / TICKS_PER_S, positions


def _pulse(times_s: np.ndarray, positions: np.ndarray, place: int) -> Pulse:
    return Pulse(float(times_s[place]), tuple(positions[place].tolist()))
