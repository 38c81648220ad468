# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program's segments around any time, without storing those far from it.

pass      |----m----m----m----m----|      m: a mark, from which the planner goes on again; laid as far as
moment                  ^                    moments are asked for, a few kB each, some 40 s of motion apart
                   |---------|               the piece whose segments are made

Single pulses of the motors around any time of a program, without making those far from it.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from CNCStepper.machine.profile import Machine
from CNCStepper.motion.planner.buffers import TICKS_PER_S
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.planner.plan import Mark, Run
from CNCStepper.motion.planner.step_timeline import step_table
from CNCStepper.toolpath import Toolpath


class SegmentIndex:
    """The pieces of a table of moves by number; its positions must be known, as `plan.begun` leaves them."""

    def __init__(self, toolpath: Toolpath, machine: Machine | Limits):
        self._run = Run(toolpath, machine)
        self.axes = self._run.limits.axes
        self.begin_steps = tuple(self._run.course.planner.position.tolist())
        self._marks: list[Mark] = []
        self._begins_s: list[float] = []  # of the first segment behind each mark
        self._frontier = self._run.mark()
        self._ended = False
        self._held: tuple[int, np.recarray] | None = None  # a piece and its number

    def __len__(self) -> int:
        """The pieces that are known so far."""
        return len(self._marks)

    def number_at(self, time_s: float) -> int:
        """Return the number of the piece that contains a time, the first one before the begin; sets its mark."""
        while (not self._begins_s or self._begins_s[-1] <= time_s) and self._lay_mark():
            pass
        return max(bisect_right(self._begins_s, time_s) - 1, 0)

    def since(self, number: int) -> Iterator[np.recarray]:
        """Yield the pieces from a number on."""
        while number < len(self._marks) or self._lay_mark():
            yield self.piece(number)
            number += 1

    def back_from(self, number: int) -> Iterator[np.recarray]:
        """Yield the pieces from a number back to the first."""
        for earlier in range(number, -1, -1) if self._marks else ():
            yield self.piece(earlier)

    def piece(self, number: int) -> np.recarray:
        """Return the segments behind a mark that is laid."""
        if self._held is None or self._held[0] != number:
            self._run.back_to(self._marks[number])
            self._held = number, self._run.piece().copy().view(np.recarray)
        return self._held[1]

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


class Pulse(NamedTuple):
    """The time of a step of some motor, and the axes' position after it, in steps from machine zero."""

    time_s: float
    position_steps: tuple[int, ...]


class Pulses:
    """The pulses of a table of moves; its positions must be known, as `plan.begun` leaves them."""

    def __init__(self, toolpath: Toolpath, machine: Machine | Limits):
        self._pieces = SegmentIndex(toolpath, machine)

    def after(self, time_s: float) -> Pulse | None:
        """Return the first pulse later than a time, None after the last."""
        for segments in self._pieces.since(self._pieces.number_at(time_s)):
            for row in range(_row_at(segments, time_s), len(segments)):
                times_s, positions = _steps(segments, row)
                place = int(np.searchsorted(times_s, time_s, side="right"))
                if place < len(times_s):
                    return _pulse(times_s, positions, place)
        return None

    def before(self, time_s: float) -> Pulse | None:
        """Return the last pulse earlier than a time, None before the first."""
        for segments in self._pieces.back_from(self._pieces.number_at(time_s)):
            for row in range(_row_at(segments, time_s), -1, -1):
                times_s, positions = _steps(segments, row)
                place = int(np.searchsorted(times_s, time_s, side="left")) - 1
                if place >= 0:
                    return _pulse(times_s, positions, place)
        return None


def _row_at(segments: np.recarray, time_s: float) -> int:
    """Return the row of the last segment that begins at a time or before, the first one before the begin."""
    return max(int(np.searchsorted(segments.start / TICKS_PER_S, time_s, side="right")) - 1, 0)


def _steps(segments: np.recarray, row: int) -> tuple[np.ndarray, np.ndarray]:
    clocks, positions = step_table(segments[row : row + 1].view(np.recarray))
    return clocks / TICKS_PER_S, positions


def _pulse(times_s: np.ndarray, positions: np.ndarray, place: int) -> Pulse:
    return Pulse(float(times_s[place]), tuple(positions[place].tolist()))
