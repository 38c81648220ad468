# SPDX-License-Identifier: LGPL-2.1-or-later
"""The backlash of the axes: how far a motor is ahead of its axis, and when it is crossed.

    motor   -->|#####|        going +: the motor stands `ahead` of the tool's place
    tool        |   |
    motor     |#####|<--      going -: the motor first crosses the gap, then the tool comes along

A zero is true in one sense of travel: away from the axis' homing switch, since that is how homing ends; without a
switch in the negative one, as a tool is brought down onto the work. In that sense the motor stands where the tool
does, in the other one the backlash ahead of it.

    invariant, for each axis that has moved in `sense`:   motor = tool + ahead_mm(axis, sense)
"""

from __future__ import annotations

import math
from collections.abc import Container, Sequence
from dataclasses import dataclass, replace

from CNCStepper.machine.profile import Machine
from CNCStepper.tolerances import SAME_SUM_MM


@dataclass(frozen=True)
class Backlash:
    """What is known of the axes, one value an axis: mm, +1 or -1, steps per mm.

    beam: a laser cuts, which is off in rapids alone; its play is taken up in these.
    """

    backlash_mm: tuple[float, ...]
    true_sense: tuple[int, ...]
    steps_per_mm: tuple[float, ...]
    beam: bool = False

    @classmethod
    def of(cls, machine: Machine) -> Backlash:
        """Return the play that a machine profile states."""
        axes = machine.axes
        return cls(
            tuple(axis.backlash_mm for axis in axes),
            tuple(1 if axis.homing == "min" else -1 for axis in axes),
            tuple(axis.steps_per_mm for axis in axes),
            machine.spindle.laser,
        )

    def __bool__(self) -> bool:
        """Whether any axis has play."""
        return any(self.backlash_mm)

    def ahead_mm(self, axis: int, sense: int) -> float:
        """Return how far the motor of an axis that goes in a sense is ahead of its tool, with its sign."""
        return 0.0 if sense in (0, self.true_sense[axis]) else sense * self.backlash_mm[axis]

    def ahead_after(self, axis: int, ahead_mm: float, way_mm: float) -> float:
        """Return how far a motor is ahead of its tool after an uncompensated move: only one side pushes."""
        low, high = sorted(self.ahead_mm(axis, sense) for sense in (1, -1))
        return min(max(ahead_mm + way_mm, low), high)

    def of_axes(self, axes: Container[int]) -> Backlash:
        """Return the play of some axes alone."""
        return replace(self, backlash_mm=tuple(gap * (axis in axes) for axis, gap in enumerate(self.backlash_mm)))

    def sense(self, axis: int, begin_mm: float, end_mm: float) -> int:
        """Return whether the motor steps forwards (+1), backwards (-1) or not at all (0) between two places."""
        scale = self.steps_per_mm[axis]
        begin, end = math.floor(begin_mm * scale + 0.5), math.floor(end_mm * scale + 0.5)
        return (end > begin) - (end < begin)

    def approach(self, begin_mm: Sequence[float], end_mm: Sequence[float]) -> tuple[float, ...] | None:
        """Return where a move from unknown places goes first, so that it arrives in the true sense; None if none is."""
        first = [
            end - sense * gap if math.isnan(begin) and not math.isnan(end) else end
            for begin, end, sense, gap in zip(begin_mm, end_mm, self.true_sense, self.backlash_mm, strict=True)
        ]
        differs = any(one != end for one, end in zip(first, end_mm, strict=True) if not math.isnan(end))
        return tuple(first) if differs else None


class Motors:
    """The motors' positions during a tool path; NaN where unknown."""

    def __init__(self, play: Backlash, position_mm: Sequence[float]):
        self.play = play
        self.at_mm = list(position_mm)

    def go(self, begin_mm: Sequence[float], end_mm: Sequence[float]) -> tuple[float, ...] | None:
        """Follow a move of the tool, in which no axis turns back; `at_mm` is where the motors end.

        Return the motors' positions before it at which the backlash is crossed, None where they have them.
        """
        before, after = list(self.at_mm), list(self.at_mm)
        for axis, (begin, end) in enumerate(zip(begin_mm, end_mm, strict=True)):
            if math.isnan(end):
                continue
            if math.isnan(begin) or math.isnan(self.at_mm[axis]):
                after[axis] = end
            elif sense := self.play.sense(axis, begin, end):
                ahead = self.play.ahead_mm(axis, sense)
                before[axis], after[axis] = begin + ahead, end + ahead
            else:
                after[axis] = end + (self.at_mm[axis] - begin)
        takes_up = any(abs(one - now) > SAME_SUM_MM for one, now in zip(before, self.at_mm, strict=True))
        self.at_mm = after
        return tuple(before) if takes_up else None
