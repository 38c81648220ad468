# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ramps by a table of the times between steps, as small controllers make them (`machine/step_wait_tables.py`).

    wait │0                     0      a move begins with the table's first wait and ends with it: its steps wait
         │ 1                   1       for entry 0, 1, 2 ... K, K ... K, ... 2, 1, 0, where K is the first that is
         │   2               2         as short as the move's own pace; a short move turns about before it, and
         │     K  K  K  K  K           beyond the table's end its last wait stays
         └──────────────────────► step

Every move begins and ends at rest, so that a reversal passes through the first waits. A move whose pace is the
pull-in pace or slower starts and stops at once. A hold goes back through the table from where it is, and so does
a lowered override. Paces are ticks from step to step of the axis that goes farthest. Invariant: from one step to
the next the place in the table changes by one at most.
"""

from __future__ import annotations

import math

from CNCStepper.kernels import njit_in_place
from CNCStepper.motion.planner.block_ring import discard_block
from CNCStepper.motion.planner.buffers import EIGHTHS, TICKS_PER_S
from CNCStepper.motion.planner.look_ahead import nominal_speed, write_course

AT_REST = -1
LONGEST_TICKS = round(0.01 * TICKS_PER_S)  # of a segment with many steps at one pace, so that a hold is soon felt


@njit_in_place
def next_wait(planner, segment):
    """Write the next step, or a few with the same wait, to `segment`; returns False in a completed hold."""
    ramp = planner.ramp[0]
    block = planner.blocks[planner.queue[0].tail]
    if ramp.hold and ramp.place <= 0:
        ramp.ended = True
        ramp.place = AT_REST
        return False
    pace = math.ceil(TICKS_PER_S / (nominal_speed(block, planner.queue[0]) * ramp.steps_per_mm))
    top = _top(planner, pace)
    left = int(ramp.steps_left)
    place = ramp.place - 1
    if not ramp.hold:
        place = max(place, min(ramp.place + 1, left - 1, top))
    wait = _wait(planner.waits, place, top, pace)
    steps = 1
    if place == ramp.place == top:
        steps = max(1, min(left - max(top, 0), LONGEST_TICKS // wait))
    ramp.place = place
    _write(planner, segment, steps, wait)
    return True


@njit_in_place
def _top(planner, pace):
    """Return the entry at which a move of this pace cruises."""
    if pace >= planner.settings[0].pull_in:
        return AT_REST
    top = 0
    while top < len(planner.waits) - 1 and planner.waits[top] > pace:
        top += 1
    return top


@njit_in_place
def _wait(waits, place, top, pace):
    """Return the ticks before a step at this place of the table."""
    if place == AT_REST:
        return pace
    return waits[place] if place > top else max(waits[place], pace)


@njit_in_place
def _write(planner, segment, steps, wait):
    """Write the segment, and free the block's place when nothing of it is left."""
    ramp = planner.ramp[0]
    block = planner.blocks[planner.queue[0].tail]
    segment.ticks = steps
    segment.cycles = wait
    segment.unit = EIGHTHS
    segment.eighths = ramp.eighths
    write_course(segment, block)
    ramp.eighths += steps * EIGHTHS
    ramp.steps_left -= steps
    ramp.speed = TICKS_PER_S / (wait * ramp.steps_per_mm)
    block.length = ramp.steps_left / ramp.steps_per_mm
    if ramp.steps_left == 0.0:
        ramp.loaded = False
        ramp.place = AT_REST
        ramp.speed = 0.0
        discard_block(planner)
