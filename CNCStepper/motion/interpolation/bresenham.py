# SPDX-License-Identifier: LGPL-2.1-or-later
"""Straight lines by Bresenham's algorithm in n axes, as the mini-lathe (B) and grbl's step interrupt have it.

    events = steps of the longest axis;  the sums begin at events / 2
    each event:  sum += steps of the axis;  if sum > events:  sum -= events, step

The longest axis steps at every event, so its speed is what is kept: a diagonal of two axes is sqrt(2) times as fast
as a line along one (`linear_dda` keeps the vector speed). After event k an axis has made
(events + 2 k steps - 1) // (2 events) steps. grbl's slow segments make these events in parts (`step_timeline.py`).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from CNCStepper.kernels import njit
from CNCStepper.motion.interpolation.iteration_stream import iteration_stream
from CNCStepper.motion.signals.pulse_stream import PULSE_ROWS, PulseStream


def bresenham(steps: Sequence[int], begin_steps: Sequence[int] | None = None, rows: int = PULSE_ROWS) -> PulseStream:
    """Return the pulses of a straight move of so many steps of each axis; it ends exactly there.

    At every event each axis is at most half a step from its place on the true line: no position is farther from it
    than 0.5 steps in two axes, 0.5 sqrt(n - 1) in n. Ticks are events.
    """
    counts = np.abs(np.array(steps, np.int64))
    back = sum(1 << axis for axis, count in enumerate(steps) if count < 0)
    sums, done = np.full(len(counts), counts.max(), np.int64), np.zeros(1, np.int64)
    return iteration_stream(
        lambda *columns: _write(counts, back, sums, done, *columns), begin_steps or (0,) * len(counts), rows
    )


@njit
def _write(counts, reverse, sums, done, ticks, step, back):
    """Write events from `done` on until the columns are full or all is sent; the sums are kept twice as large."""
    events = counts.max()
    written = 0
    while done[0] < events and written < len(ticks):
        done[0] += 1
        bits = 0
        for axis in range(len(counts)):
            sums[axis] += 2 * counts[axis]
            if sums[axis] > 2 * events:
                sums[axis] -= 2 * events
                bits |= 1 << axis
        ticks[written] = done[0]
        step[written] = bits
        back[written] = bits & reverse
        written += 1
    return written
