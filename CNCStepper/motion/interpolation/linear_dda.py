# SPDX-License-Identifier: LGPL-2.1-or-later
"""Straight lines by the digital differential analyser (DDA), as the PC control of stepper tables published it (A2).

    limit = int(sqrt(x² + y² + ...)),  the sums begin at x, y, ...
    each round:  sum += x;  if sum > limit:  sum -= limit, pulse           the same for y, ...

A round is a unit of length, so the vector speed is the same in every direction. After round k an axis has made
ceil((k + 1) x / limit) - 1 pulses: all arrive together, in round `limit`, and never before.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from CNCStepper.kernels import njit
from CNCStepper.motion.interpolation.iteration_stream import iteration_stream
from CNCStepper.motion.signals.pulse_stream import PULSE_ROWS, PulseStream


def linear_dda(steps: Sequence[int], begin_steps: Sequence[int] | None = None, rows: int = PULSE_ROWS) -> PulseStream:
    """Return the pulses of a straight move of so many steps of each axis; it ends exactly there.

    No position is farther from the true line than 1 step in two axes, sqrt(n - 1) steps in n. Ticks are rounds.
    """
    counts = np.abs(np.array(steps, np.int64))
    back = sum(1 << axis for axis, count in enumerate(steps) if count < 0)
    limit = math.isqrt(sum(int(count) ** 2 for count in counts))
    sums, done = counts.copy(), np.zeros(1, np.int64)
    return iteration_stream(
        lambda *columns: _write(counts, back, limit, sums, done, *columns), begin_steps or (0,) * len(counts), rows
    )


@njit
def _write(counts, reverse, limit, sums, done, ticks, step, back):
    """Write rounds from `done` on until the columns are full or all is sent; returns the rows written."""
    written = 0
    while done[0] < limit and written < len(ticks):
        done[0] += 1
        bits = 0
        for axis in range(len(counts)):
            sums[axis] += counts[axis]
            if sums[axis] > limit:
                sums[axis] -= limit
                bits |= 1 << axis
        if bits:
            ticks[written] = done[0]
            step[written] = bits
            back[written] = bits & reverse
            written += 1
    return written
