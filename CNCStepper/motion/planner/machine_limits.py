# SPDX-License-Identifier: LGPL-2.1-or-later
"""The planner's limits of a machine: steps, speeds, accelerations, tolerances."""

from __future__ import annotations

from dataclasses import dataclass

from CNCStepper.machine.profile import LOOK_AHEAD_BLOCKS, Machine
from CNCStepper.units import mm_s_from_mm_min

STEP_IDLE_DELAY_S = 0.025


@dataclass(frozen=True)
class Limits:
    """The planner's settings, one value an axis in the tuples.

    idle_delay_s: how long the drivers stay under current after the last step ($1 of grbl). The
    firmware waits it out inside its step interrupt, so no motion can follow sooner.
    look_ahead_blocks: how many blocks are planned ahead at most, any number.
    ramp: how speeds change: "trapezoid", "s_curve" (needs jerk_mm_s3) or "table" (needs waits_s, the times before the
    first, second ... step of a ramp). pull_in_s: the time from step to step at which motors start and stop at once, the
    table's first when left out. rapid_mm_min: the speed of rapids along their way, None: as fast as the axes allow.
    """

    steps_per_mm: tuple[float, ...]
    max_rate_mm_min: tuple[float, ...]
    acceleration_mm_s2: tuple[float, ...]
    junction_deviation_mm: float
    arc_tolerance_mm: float
    laser: bool = False
    idle_delay_s: float = STEP_IDLE_DELAY_S
    look_ahead_blocks: int = LOOK_AHEAD_BLOCKS
    ramp: str = "trapezoid"
    jerk_mm_s3: tuple[float, ...] = ()
    waits_s: tuple[float, ...] = ()
    pull_in_s: float = 0.0
    rapid_mm_min: float | None = None

    @classmethod
    def of(cls, machine: Machine) -> Limits:
        """Return the limits that a machine profile states."""
        axes, waits = machine.axes, machine.planner.waits
        return cls(
            tuple(axis.steps_per_mm for axis in axes),
            tuple(axis.max_rate_mm_min for axis in axes),
            tuple(axis.acceleration_mm_s2 for axis in axes),
            machine.planner.junction_deviation_mm,
            machine.planner.arc_tolerance_mm,
            machine.spindle.laser,
            look_ahead_blocks=machine.planner.look_ahead_blocks,
            ramp=machine.planner.ramp,
            jerk_mm_s3=tuple(axis.jerk_mm_s3 or 0.0 for axis in axes),
            waits_s=waits.waits_s if waits else (),
            pull_in_s=waits.pull_in_s if waits else 0.0,
            rapid_mm_min=machine.rapid_limit_mm_min,
        )

    @property
    def axes(self) -> int:
        """The number of axes."""
        return len(self.steps_per_mm)

    @property
    def max_speed_mm_s(self) -> tuple[float, ...]:
        """The greatest speed of each axis."""
        return tuple(mm_s_from_mm_min(rate) for rate in self.max_rate_mm_min)
