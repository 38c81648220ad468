# SPDX-License-Identifier: LGPL-2.1-or-later
"""Single pulses of the motors around any moment of a program, without making those far from it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from CNCStepper.machine.profile import Machine
from CNCStepper.motion.planner.buffers import TICKS_PER_S
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.planner.segment_index import SegmentIndex
from CNCStepper.motion.planner.step_timeline import step_table
from CNCStepper.toolpath import Toolpath


class Pulse(NamedTuple):
    """The time of a step of some motor, and the axes' position after it, in steps from machine zero."""

    time_s: float
    position_steps: tuple[int, ...]


class Pulses:
    """The pulses of a table of moves; its positions must be known, as `plan.begun` leaves them."""

    def __init__(self, toolpath: Toolpath, machine: Machine | Limits):
        self._pieces = SegmentIndex(toolpath, machine)

    def after(self, time_s: float) -> Pulse | None:
        """Return the first pulse later than a moment, None behind the last."""
        for segments in self._pieces.since(self._pieces.number_at(time_s)):
            for row in range(_row_at(segments, time_s), len(segments)):
                times_s, positions = _steps(segments, row)
                place = int(np.searchsorted(times_s, time_s, side="right"))
                if place < len(times_s):
                    return _pulse(times_s, positions, place)
        return None

    def before(self, time_s: float) -> Pulse | None:
        """Return the last pulse earlier than a moment, None before the first."""
        for segments in self._pieces.back_from(self._pieces.number_at(time_s)):
            for row in range(_row_at(segments, time_s), -1, -1):
                times_s, positions = _steps(segments, row)
                place = int(np.searchsorted(times_s, time_s, side="left")) - 1
                if place >= 0:
                    return _pulse(times_s, positions, place)
        return None


def _row_at(segments: np.recarray, time_s: float) -> int:
    """Return the row of the last segment that begins at a moment or before, the first one before the begin."""
    return max(int(np.searchsorted(segments.start / TICKS_PER_S, time_s, side="right")) - 1, 0)


def _steps(segments: np.recarray, row: int) -> tuple[np.ndarray, np.ndarray]:
    clocks, positions = step_table(segments[row : row + 1].view(np.recarray))
    return clocks / TICKS_PER_S, positions


def _pulse(times_s: np.ndarray, positions: np.ndarray, place: int) -> Pulse:
    return Pulse(float(times_s[place]), tuple(positions[place].tolist()))
