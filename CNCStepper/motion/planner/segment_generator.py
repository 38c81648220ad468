# SPDX-License-Identifier: LGPL-2.1-or-later
"""From planned blocks to segments: about 10 ms each, with whole steps at one pace.

A block's speed over the mm that remain has one of these shapes; a segment takes as much of it as fits
into its time, and may reach over a bend:

    ┌───────┐ SLOW_DOWN (override lowered), ACCELERATE, CRUISE, DECELERATE
   /         \\      all but CRUISE at the block's acceleration
  /           \\
  accelerate_until   decelerate_after   stop_at     (mm remaining; falling from left to right)

Invariants: a segment has at least one step; the step that it leaves unfinished is carried over in
`steps_left` and `time_left`, so that the pace has no jump and the block ends on its exact step count.
What is in a segment is decided: later blocks, holds and overrides only change what follows.

Ramps by a table of the times between steps, as small controllers make them (`machine/step_wait_tables.py`).

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

from CNCStepper.kernels import njit_in_place, njit_inline
from CNCStepper.motion.planner import s_curve
from CNCStepper.motion.planner.buffers import EIGHTHS, S_CURVE, TABLE, TICKS_PER_S, TRAPEZOID, discard_block, next_place
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


SEGMENT_S = 0.01  # a hundredth: the firmware changes its speed a hundred times a second
LEAST_STEPS = 1.25  # in a segment
SLOW_DOWN, ACCELERATE, CRUISE, DECELERATE = 0, 1, 2, 3
SMOOTH_CYCLES = (2000, 4000, 8000)  # from these paces on a step is cut into 2, 4, 8 ticks
CRUMB_SQR = 1e-6  # (mm/s)²: below it rounding, above it a speed that the block cannot shed
MAX_CYCLES = 65_535  # the timer's 16 bits: the slowest pace there is
TIMER_RESTART = 1  # the timer counts from 0 up to its limit: every tick is one cycle longer than was asked for


@njit_inline
def next_segment(planner, segment):
    """Cut the next segment into `segment`; returns whether there was one."""
    queue = planner.queue[0]
    ramp = planner.ramp[0]
    if ramp.ended or (not ramp.loaded and queue.head == queue.tail):
        return False
    kind = planner.settings[0].ramp
    if not ramp.loaded:
        _load_block(planner)
        if kind == S_CURVE:
            s_curve.shape(planner)
        elif kind == TRAPEZOID:
            _shape_trapezoid(planner)
    if kind == TABLE:
        return next_wait(planner, segment)
    duration = s_curve.advance(planner, SEGMENT_S) if kind == S_CURVE else _advance_ramp(planner)
    if not _emit(planner, segment, duration):
        ramp.ended = True
        return False
    _close(planner)
    return True


@njit_inline
def _load_block(planner):
    """Take the oldest block, or continue it when only its profile must be made again."""
    ramp = planner.ramp[0]
    block = planner.blocks[planner.queue[0].tail]
    ramp.loaded = True
    if ramp.replan:
        ramp.replan = False
        return
    ramp.steps_left = block.events
    ramp.steps_per_mm = block.events / block.length
    ramp.least_mm = LEAST_STEPS / ramp.steps_per_mm
    ramp.time_left = 0.0
    ramp.eighths = 0
    if planner.settings[0].ramp == S_CURVE:
        s_curve.take_up(planner)
        return
    if ramp.hold or ramp.over_speed:
        block.entry_sqr = ramp.exit_speed**2
        ramp.over_speed = False
    ramp.speed = math.sqrt(block.entry_sqr)


@njit_inline
def _shape_trapezoid(planner):
    """Choose the shape of what remains of the block."""
    if planner.ramp[0].hold:
        _shape_hold(planner)
    else:
        _shape_profile(planner)


@njit_inline
def _shape_hold(planner):
    """Brake from the start of what remains, to a stop or into the next block."""
    ramp = planner.ramp[0]
    block = planner.blocks[planner.queue[0].tail]
    length, entry_sqr = block.length, block.entry_sqr
    ramp.kind = DECELERATE
    ramp.stop_at = max(0.0, length - 0.5 * entry_sqr / block.acceleration)
    ramp.exit_speed = 0.0
    if ramp.stop_at == 0.0:
        ramp.exit_speed = math.sqrt(max(0.0, entry_sqr - 2.0 * block.acceleration * length))


@njit_inline
def _shape_profile(planner):
    """Choose the shape of what remains of the block, from its entry speed to the next block's."""
    ramp = planner.ramp[0]
    queue = planner.queue[0]
    block = planner.blocks[queue.tail]
    length, entry_sqr = block.length, block.entry_sqr
    acceleration = block.acceleration
    after = next_place(planner, queue.tail)
    exit_sqr = 0.0 if after == queue.head else planner.blocks[after].entry_sqr
    nominal = nominal_speed(block, queue)
    brake_sqr = entry_sqr - 2.0 * acceleration * length  # speed squared at the end after full braking
    ramp.over_speed = brake_sqr > exit_sqr + CRUMB_SQR
    if ramp.over_speed:
        exit_sqr = brake_sqr
    ramp.stop_at = 0.0
    ramp.exit_speed = math.sqrt(exit_sqr)
    ramp.cruise_speed = nominal
    ramp.accelerate_until = length
    ramp.decelerate_after = max(0.0, 0.5 * (nominal**2 - exit_sqr) / acceleration)
    crossing = 0.5 * (length + 0.5 * (entry_sqr - exit_sqr) / acceleration)  # where both ramps meet
    if crossing >= length:
        ramp.kind = DECELERATE
    elif entry_sqr > nominal**2:
        ramp.kind = SLOW_DOWN
        ramp.accelerate_until = max(0.0, length - 0.5 * (entry_sqr - nominal**2) / acceleration)
    elif entry_sqr == nominal**2 and ramp.decelerate_after < crossing:
        ramp.kind = CRUISE
    else:
        ramp.kind = ACCELERATE
        _meet_ramps(ramp, crossing, entry_sqr, exit_sqr, acceleration)


@njit_inline
def _meet_ramps(ramp, crossing, entry_sqr, exit_sqr, acceleration):
    """Make a profile that accelerates to its nominal speed, to a peak below it, or to the block's end."""
    if crossing <= 0.0:
        ramp.accelerate_until = 0.0
        ramp.decelerate_after = 0.0
        ramp.cruise_speed = math.sqrt(exit_sqr)
    elif ramp.decelerate_after < crossing:
        ramp.accelerate_until -= 0.5 * (ramp.cruise_speed**2 - entry_sqr) / acceleration
    else:
        ramp.accelerate_until = crossing
        ramp.decelerate_after = crossing
        ramp.cruise_speed = math.sqrt(2.0 * acceleration * crossing + exit_sqr)


@njit_inline
def _advance_ramp(planner):
    """Move `ramp.remaining` and `ramp.speed` on by one segment; returns its duration in s."""
    ramp = planner.ramp[0]
    block = planner.blocks[planner.queue[0].tail]
    ramp.remaining = block.length
    enough = max(0.0, block.length - ramp.least_mm)
    duration, longest = 0.0, SEGMENT_S
    span = longest
    while True:
        duration += _advance_piece(ramp, block.acceleration, span)
        if duration < longest:
            span = longest - duration
        elif ramp.remaining > enough:
            longest += SEGMENT_S
            span = longest - duration
        else:
            break
        if ramp.remaining <= ramp.stop_at:
            break
    return duration


@njit_inline
def _advance_piece(ramp, acceleration, span):
    """Move on for `span` s, or to the ramp's next bend if that comes sooner; returns the time taken."""
    change = acceleration * span
    begin = ramp.remaining
    if ramp.kind == SLOW_DOWN and ramp.speed - ramp.cruise_speed > change:
        ramp.remaining -= span * (ramp.speed - 0.5 * change)
        ramp.speed -= change
        return span
    if ramp.kind == ACCELERATE:
        ahead = begin - span * (ramp.speed + 0.5 * change)
        if ahead >= ramp.accelerate_until:
            ramp.remaining = ahead
            ramp.speed += change
            return span
    if ramp.kind == CRUISE:
        ahead = begin - span * ramp.cruise_speed
        if ahead >= ramp.decelerate_after:
            ramp.remaining = ahead
            return span
        ramp.remaining = ramp.decelerate_after
        ramp.kind = DECELERATE
        return (begin - ramp.remaining) / ramp.cruise_speed
    if ramp.kind == DECELERATE:
        return _decelerate_piece(ramp, change, span)
    span = 2.0 * (begin - ramp.accelerate_until) / (ramp.speed + ramp.cruise_speed)
    at_peak = ramp.kind == ACCELERATE and ramp.accelerate_until == ramp.decelerate_after
    ramp.remaining = ramp.accelerate_until
    ramp.kind = DECELERATE if at_peak else CRUISE
    ramp.speed = ramp.cruise_speed
    return span


@njit_inline
def _decelerate_piece(ramp, change, span):
    """Brake for `span` s, or to the end of the ramp."""
    begin = ramp.remaining
    longest = span
    if ramp.speed > change:
        ahead = begin - span * (ramp.speed - 0.5 * change)
        if ahead > ramp.stop_at:
            ramp.remaining = ahead
            ramp.speed -= change
            return span
        longest = 2.0 * span
    both = ramp.speed + ramp.exit_speed
    ramp.remaining = ramp.stop_at
    ramp.speed = ramp.exit_speed
    # rounding leaves a last crumb of path at hardly any speed: it must not take long
    return min(longest, 2.0 * (begin - ramp.stop_at) / both) if both > 0.0 else 0.0


@njit_inline
def _emit(planner, segment, duration):
    """Write the segment with the whole steps that were passed; returns False when there are none."""
    ramp = planner.ramp[0]
    block = planner.blocks[planner.queue[0].tail]
    steps_to_go = ramp.steps_per_mm * ramp.remaining
    whole_to_go = math.ceil(steps_to_go)
    steps = int(ramp.steps_left - whole_to_go)
    if steps <= 0:  # below 0 where the length, in steps again, is a crumb more than the steps
        return False
    s_per_step = (duration + ramp.time_left) / (ramp.steps_left - steps_to_go)
    cycles = math.ceil(TICKS_PER_S * s_per_step)
    level = 0
    for limit in SMOOTH_CYCLES:
        level += cycles >= limit
    segment.ticks = steps << level
    segment.cycles = min(cycles >> level, MAX_CYCLES) + TIMER_RESTART
    segment.unit = EIGHTHS >> level
    segment.eighths = ramp.eighths
    write_course(segment, block)
    ramp.eighths += steps * EIGHTHS
    ramp.steps_left = whole_to_go
    ramp.time_left = (whole_to_go - steps_to_go) * s_per_step
    return True


@njit_inline
def _close(planner):
    """Note the rest of the block; free its place when nothing is left."""
    ramp = planner.ramp[0]
    planner.blocks[planner.queue[0].tail].length = ramp.remaining
    if ramp.remaining == 0.0:
        ramp.loaded = False
        discard_block(planner)
    elif ramp.remaining == ramp.stop_at:
        ramp.ended = True
