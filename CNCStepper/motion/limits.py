# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the planner must know of a machine: steps, greatest speeds and accelerations, tolerances."""

from __future__ import annotations

from dataclasses import dataclass

from CNCStepper.machine.profile import Machine
from CNCStepper.units import mm_s_from_mm_min

STEP_IDLE_DELAY_S = 0.025


@dataclass(frozen=True)
class Limits:
    """The planner's settings, one value an axis in the tuples.

    idle_delay_s: how long the drivers stay under current after the last step ($1 of grbl). The
    firmware waits it out inside its step interrupt, so no motion can follow sooner.
    """

    steps_per_mm: tuple[float, ...]
    max_rate_mm_min: tuple[float, ...]
    acceleration_mm_s2: tuple[float, ...]
    junction_deviation_mm: float
    arc_tolerance_mm: float
    laser: bool = False
    idle_delay_s: float = STEP_IDLE_DELAY_S

    @classmethod
    def of(cls, machine: Machine) -> Limits:
        """Return the limits that a machine profile states."""
        axes = machine.axes
        return cls(
            tuple(axis.steps_per_mm for axis in axes),
            tuple(axis.max_rate_mm_min for axis in axes),
            tuple(axis.acceleration_mm_s2 for axis in axes),
            machine.planner.junction_deviation_mm,
            machine.planner.arc_tolerance_mm,
            machine.spindle.laser,
        )

    @property
    def axes(self) -> int:
        """The number of axes."""
        return len(self.steps_per_mm)

    @property
    def max_speed_mm_s(self) -> tuple[float, ...]:
        """The greatest speed of each axis."""
        return tuple(mm_s_from_mm_min(rate) for rate in self.max_rate_mm_min)
