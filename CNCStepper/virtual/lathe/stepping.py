# SPDX-License-Identifier: LGPL-2.1-or-later
"""Steps and their times: Bresenham on the longer axis, waits in ticks of the controller's timer.

rapid   101 42 32 27 24 22 20 ... 5 4 4 4 ... 5 ... 42 101     the pull-out ramp, the same list backwards to stop
feed     93 93 93 93 93 ...                                    one wait, the feed on the longer axis; no ramp

A wait lies before its step. A short rapid turns back in the list.
"""

from __future__ import annotations

import numpy as np

TICK_S = 135e-6
PULL_OUT_TICKS = np.array(
    (101, 42, 32, 27, 24, 22, 20, 19, 18, 17, 16, 15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4), np.int64
)


def rapid_ticks(steps: int) -> np.ndarray:
    """Return the waits of a rapid over so many steps, int64[steps]."""
    from_begin = np.arange(steps)
    return PULL_OUT_TICKS[np.minimum(np.minimum(from_begin, from_begin[::-1]), len(PULL_OUT_TICKS) - 1)]


def braking_ticks(steps_made: int) -> np.ndarray:
    """Return the waits with which a rapid stops that has made so many steps of its begin."""
    return PULL_OUT_TICKS[: min(steps_made, len(PULL_OUT_TICKS))][::-1]


def feed_wait_ticks(feed_mm_s: float, steps_per_mm: float) -> int:
    """Return the wait between two steps at a feed: whole ticks, one at least."""
    return max(1, round(1.0 / (feed_mm_s * steps_per_mm * TICK_S)))


def line(x: int, z: int) -> np.ndarray:
    """Return the places of X and Z after each step of the longer axis, int64[k, 2], from 0."""
    longest = max(abs(x), abs(z))
    count = np.arange(1, longest + 1, dtype=np.int64)
    columns = [np.sign(way) * ((2 * abs(way) * count + longest) // (2 * longest)) for way in (x, z)]
    return np.stack(columns, axis=1) if longest else np.empty((0, 2), np.int64)
