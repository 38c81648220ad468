# SPDX-License-Identifier: LGPL-2.1-or-later
"""The published tables of times between steps: waits before the first, second ... step of a ramp, in s.

pull-out      a mini-lathe's list (USP, 2006)                101 42 32 27 ... 4 ticks of 135 µs
counted down  each wait shorter by the same (UFSM, 2010)     first, first - change, ... least
accelerated   what a constant acceleration gives             step n comes at sqrt(2 n / (a steps_per_mm))
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Annotated

from pydantic import BaseModel, Field, model_validator

from CNCStepper.errors import Text
from CNCStepper.quantities import QUANTITIES, Bounds

MOST_WAITS = 100_000
LEAST_MS, MOST_MS = QUANTITIES["wait"].least, QUANTITIES["wait"].most
Ms = Annotated[float, Bounds("wait")]

PULL_OUT_TICK_S = 135e-6
PULL_OUT = (101, 42, 32, 27, 24, 22, 20, 19, 18, 17, 16, 15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4)


def pull_out_s() -> tuple[float, ...]:
    """Return the mini-lathe's pull-out table."""
    return tuple(ticks * PULL_OUT_TICK_S for ticks in PULL_OUT)


def counted_down_s(first_s: float, change_s: float, least_s: float) -> tuple[float, ...]:
    """Return the waits from the first one on, each shorter by `change_s` (above 0), down to the least."""
    count = math.ceil(round((first_s - least_s) / change_s, 9))
    return (*(first_s - k * change_s for k in range(count)), least_s)


def accelerated_s(acceleration_steps_s2: float, steps: int) -> tuple[float, ...]:
    """Return the waits of so many steps of a constant acceleration from rest."""
    times = [math.sqrt(2.0 * n / acceleration_steps_s2) for n in range(steps + 1)]
    return tuple(after - before for before, after in pairwise(times))


class Waits(BaseModel, extra="forbid", frozen=True, allow_inf_nan=False, defer_build=True):
    """A profile's table of waits, in one of three forms; times count from step to step of the axis that goes farthest.

    table_ms: the waits themselves, none longer than the one before it. first_ms, change_ms, least_ms: counted down.
    acceleration_steps_s2, steps: as a constant acceleration gives them for so many steps. pull_in_ms: the wait at
    which the motors start and stop at once, without a ramp; the first of the table when left out.
    """

    table_ms: tuple[Ms, ...] = Field(default=(), max_length=MOST_WAITS)
    first_ms: Ms | None = None
    change_ms: Annotated[float, Bounds("wait", 1e-8)] | None = None
    least_ms: Ms | None = None
    acceleration_steps_s2: Annotated[float, Bounds("steps_acceleration")] | None = None
    steps: Annotated[int, Bounds("count", most=MOST_WAITS)] | None = None
    pull_in_ms: Ms | None = None

    @model_validator(mode="after")
    def _has_one_form(self) -> Waits:
        counted = (self.first_ms, self.change_ms, self.least_ms)
        accelerated = (self.acceleration_steps_s2, self.steps)
        forms = [keys for keys in (self.table_ms, counted, accelerated) if any(key is not None for key in keys)]
        if len(forms) != 1 or any(key is None for key in forms[0]):
            raise ValueError(
                "waits need table_ms, or first_ms, change_ms and least_ms, or acceleration_steps_s2 and steps"
            )
        return self

    @model_validator(mode="after")
    def _falls(self) -> Waits:
        if any(one < after for one, after in pairwise(self.table_ms)):
            raise ValueError("table_ms may hold no wait that is longer than the one before it")
        if self.first_ms is not None and self.least_ms is not None and self.change_ms is not None:
            if self.least_ms > self.first_ms:
                raise ValueError("least_ms must not be above first_ms")
            if self.first_ms - self.least_ms > MOST_WAITS * self.change_ms:
                raise ValueError(
                    Text("change_ms is so small that there are more than {most_waits} waits", most_waits=MOST_WAITS)
                )
        return self

    @model_validator(mode="after")
    def _accelerates_within_bounds(self) -> Waits:
        if self.acceleration_steps_s2 is None or self.steps is None:
            return self
        longest_ms, shortest_ms = (
            1000.0
            * (math.sqrt(2.0 * n / self.acceleration_steps_s2) - math.sqrt(2.0 * (n - 1) / self.acceleration_steps_s2))
            for n in (1, self.steps)
        )
        if longest_ms > MOST_MS or shortest_ms < LEAST_MS:
            raise ValueError(
                Text(
                    "the waits lie from {shortest_ms:g} to {longest_ms:g} ms, beyond {least_ms:g} to {most_ms:g}",
                    shortest_ms=shortest_ms,
                    longest_ms=longest_ms,
                    least_ms=LEAST_MS,
                    most_ms=MOST_MS,
                )
            )
        return self

    @property
    def waits_s(self) -> tuple[float, ...]:
        """The waits before the first, second ... step."""
        if self.first_ms is not None and self.change_ms is not None and self.least_ms is not None:
            return counted_down_s(*(time_ms / 1000.0 for time_ms in (self.first_ms, self.change_ms, self.least_ms)))
        if self.acceleration_steps_s2 is not None and self.steps is not None:
            return accelerated_s(self.acceleration_steps_s2, self.steps)
        return tuple(time_ms / 1000.0 for time_ms in self.table_ms)

    @property
    def pull_in_s(self) -> float:
        """The wait at which the motors start and stop at once."""
        return self.waits_s[0] if self.pull_in_ms is None else self.pull_in_ms / 1000.0
