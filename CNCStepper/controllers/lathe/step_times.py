# SPDX-License-Identifier: LGPL-2.1-or-later
"""When the lathe makes its steps: Bresenham on the longer axis, waits of the published tables.

    rapid   101 42 32 27 ... 4 4 4 ... 27 32 42 101 ticks      the pull-out list, backwards to stop
    feed    one wait from the first step to the last           no ramp
    by hand as a rapid or a feed, until P; a rapid then stops by its ramp

A wait comes before its step. X is the radius.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from CNCStepper.machine.step_wait_tables import PULL_OUT, PULL_OUT_TICK_S

Steps = tuple[int, int]  # of X and Z
WAITS = np.array(PULL_OUT, np.int64)
NO_STEPS: Steps = (0, 0)


@dataclass(frozen=True)
class Move:
    """A straight move in steps; times_s: float64[k], when each step of the longer axis is made, from its begin."""

    steps: Steps
    times_s: np.ndarray

    @property
    def lasts_s(self) -> float:
        """Its duration."""
        return float(self.times_s[-1]) if len(self.times_s) else 0.0

    def done(self, after_s: float) -> Steps:
        """Return the steps that are made so long after its begin."""
        events = len(self.times_s)
        made = int(np.searchsorted(self.times_s, after_s, side="right"))
        x, z = (_share(way, made, events) for way in self.steps)
        return x, z

    def speed_mm_s(self, after_s: float, steps_per_mm: Steps | tuple[float, float]) -> float:
        """Return the speed along the path so long after its begin."""
        if not len(self.times_s):
            return 0.0
        made = min(int(np.searchsorted(self.times_s, after_s, side="right")), len(self.times_s) - 1)
        wait_s = float(self.times_s[made]) - (float(self.times_s[made - 1]) if made else 0.0)
        x_mm, z_mm = (abs(way) / per_mm for way, per_mm in zip(self.steps, steps_per_mm, strict=True))
        return float(np.hypot(x_mm, z_mm)) / len(self.times_s) / wait_s


def _share(way: int, made: int, events: int) -> int:
    """Return the steps of an axis after `made` of the events of Bresenham's line."""
    if not events:
        return 0
    steps = (events + 2 * made * abs(way) - 1) // (2 * events) if made else 0
    return steps if way >= 0 else -steps


def rapid(steps: Steps) -> Move:
    """Return a rapid of a program."""
    count = max(map(abs, steps))
    from_begin = np.arange(count)
    places = np.minimum(np.minimum(from_begin, from_begin[::-1]), len(WAITS) - 1)
    return Move(steps, np.cumsum(WAITS[places]) * PULL_OUT_TICK_S)


def feed(steps: Steps, feed_mm_s: float, steps_per_mm: tuple[float, float]) -> Move:
    """Return a feed move: the longer axis goes at the feed."""
    longest = 0 if abs(steps[0]) >= abs(steps[1]) else 1
    wait_s = feed_wait_s(feed_mm_s, steps_per_mm[longest])
    return Move(steps, np.arange(1, abs(steps[longest]) + 1) * wait_s)


def feed_wait_s(feed_mm_s: float, steps_per_mm: float) -> float:
    """Return the wait between two steps at a feed, whole ticks and one at least."""
    return max(1, round(1.0 / (feed_mm_s * steps_per_mm * PULL_OUT_TICK_S))) * PULL_OUT_TICK_S


def rapid_wait_s(made: int) -> float:
    """Return the wait of a rapid by hand behind so many steps."""
    return int(WAITS[min(made, len(WAITS) - 1)]) * PULL_OUT_TICK_S


def rapid_times_s(count: int) -> np.ndarray:
    """Return when each of so many steps of a rapid by hand is made, without its end: float64[count]."""
    places = np.minimum(np.arange(count), len(WAITS) - 1)
    return np.cumsum(WAITS[places]) * PULL_OUT_TICK_S


def braking_steps(made: int) -> int:
    """Return how many steps a rapid makes to stop, behind so many steps."""
    return min(made, len(WAITS))


def braking_s(made: int) -> float:
    """Return how long that takes."""
    return int(WAITS[: braking_steps(made)].sum()) * PULL_OUT_TICK_S
