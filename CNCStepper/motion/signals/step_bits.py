# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which axes step on each tick of a segment, without a branch for each tick.

    0 ┬───────────┬───┬─────► tick     each tick adds an axis' share to what its sum lacks of a whole; where
      │      /|   │  /│  /             nothing is lacking, the axis steps and a whole is lacking again: the floor
    - │   /|/ |  /│/| │/|              of `step_timeline.place_in`, kept as its remainder less the whole
      │_/__│__│/__│_│_│_│

First the bits of all ticks are made, AXES_AT_ONCE axes in one loop so that their sums stay in registers; where ticks
are many and steps few, each axis goes from step to step instead. Then the ticks without a step are left out. Bit n
belongs to axis n.
"""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.kernels import njit_inline
from CNCStepper.motion.planner.buffers import EIGHTHS

AXES_AT_ONCE = 4
SLOW_UNIT = 2  # eighths of an event a tick: up to here steps are so seldom that they are sought one by one
SIGN_BIT = 63  # of an int64


@njit_inline
def write_bits(segment, first, last, bits):
    """Write which axes step on ticks (first, last] of a segment to `bits`, uint8[at least last - first]."""
    for tick in range(last - first):
        bits[tick] = 0
    if segment.unit <= SLOW_UNIT:
        for axis in range(len(segment.steps)):
            _add_seldom(segment, first, last, bits, axis)
    else:
        for axis in range(0, len(segment.steps), AXES_AT_ONCE):
            _add_bits(segment, first, last, bits, axis)


@njit_inline
def _add_seldom(segment, first, last, bits, axis):
    """Add the bits of an axis that steps on few of the ticks: the tick of each of its steps, by division.

    Exact though in floats: the numbers are below 2**53, so no quotient is rounded over a whole number.
    """
    if segment.steps[axis] == 0:
        return
    lack, add = _lack_of(segment, axis, first)
    due = -lack
    tick = math.ceil(due / add)
    while tick <= last - first:
        bits[tick - 1] |= 1 << axis
        due += EIGHTHS * segment.events
        tick = math.ceil(due / add)


@njit_inline
def _add_bits(segment, first, last, bits, axis):
    """Add the bits of AXES_AT_ONCE axes from `axis` on."""
    whole = EIGHTHS * segment.events
    lack_0, add_0 = _lack_of(segment, axis, first)
    lack_1, add_1 = _lack_of(segment, axis + 1, first)
    lack_2, add_2 = _lack_of(segment, axis + 2, first)
    lack_3, add_3 = _lack_of(segment, axis + 3, first)
    for tick in range(last - first):
        lack_0, lack_1, lack_2, lack_3 = lack_0 + add_0, lack_1 + add_1, lack_2 + add_2, lack_3 + add_3
        on_0, on_1, on_2, on_3 = _reached(lack_0), _reached(lack_1), _reached(lack_2), _reached(lack_3)
        lack_0, lack_1 = lack_0 - (whole & on_0), lack_1 - (whole & on_1)
        lack_2, lack_3 = lack_2 - (whole & on_2), lack_3 - (whole & on_3)
        bits[tick] |= (on_0 & 1 | on_1 & 2 | on_2 & 4 | on_3 & 8) << axis


@njit_inline
def _reached(lack):
    """Return all ones where the whole is reached, else 0."""
    return ~(lack >> SIGN_BIT)


@njit_inline
def _lack_of(segment, axis, first):
    """Return what an axis' sum lacks after `first` ticks, and what each tick adds; nothing beyond the last axis."""
    if axis >= len(segment.steps):
        return -1, 0
    steps = abs(segment.steps[axis])
    whole = EIGHTHS * segment.events
    done = segment.eighths + first * segment.unit
    return (EIGHTHS // 2 * segment.events + done * steps - 1) % whole - whole, steps * segment.unit


@njit_inline
def reverse_bits(segment):
    """Return the bits of the axes that go backwards."""
    reverse = 0
    for axis in range(len(segment.steps)):
        reverse |= (segment.steps[axis] < 0) << axis
    return reverse


@njit_inline
def keep_steps(segment, first, last, bits, ticks, step, back, count):
    """Write a row for every tick of (first, last] with a step; returns the rows written so far.

    There must be room for a row on each of these ticks.
    """
    reverse = np.uint8(reverse_bits(segment))
    cycles = segment.cycles
    clock = segment.start + first * cycles
    for tick in range(last - first):
        clock += cycles
        on = bits[tick]
        ticks[count] = clock
        step[count] = on
        back[count] = on & reverse
        count += on != 0
    return count
