# SPDX-License-Identifier: LGPL-2.1-or-later
"""The look-ahead planner: entry speeds of the queued blocks, from junctions, limits and overrides.

    speed │      ┌─ nominal ─┐
          │     /│           │\\        ┌────┐          junction: greatest speed at a corner so that a circle
          │    / │           │ \\______/      \\         of the junction deviation's sagitta stays within the
          │   /  │           │ entry           \\        acceleration (S. K. Jeon, "Improving grbl: cornering
          └──/───┴───────────┴──────────────────\\─►     algorithm", 2011)

Invariants: the newest block always ends at rest; no entry speed is above its junction's, nor above what
the block behind it can reach by accelerating, nor above what the block itself can brake from. Blocks
before `planned` are already optimal and are not planned again.
"""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.kernels import njit_inline
from CNCStepper.motion.planner.buffers import S_CURVE, TABLE, UNLIMITED, copy_axes, next_place, place_before
from CNCStepper.motion.planner.s_curve_look_ahead import plan_when_due

MINIMUM_FEED_MM_S = 1.0 / 60.0
STRAIGHT_ON = 0.999999  # cosine beyond which two directions count as the same, or as opposite


@njit_inline
def limit_along(unit, axis_limits):
    """Return the greatest value along direction `unit` that keeps every axis within its own limit."""
    limit = UNLIMITED
    for axis in range(len(unit)):
        if unit[axis] != 0.0:
            limit = min(limit, abs(axis_limits[axis] / unit[axis]))
    return limit


@njit_inline
def push_line(planner, target_mm, speed_mm_s, rapid, tag):
    """Queue a straight move to `target_mm`; returns whether it has any step. The ring must have room."""
    queue = planner.queue[0]
    block = planner.blocks[queue.head]
    if not _set_course(planner, target_mm, block):
        return False
    unit = planner.unit
    block.acceleration = limit_along(unit, planner.max_acceleration)
    block.jerk = limit_along(unit, planner.max_jerk)
    block.rapid_speed = limit_along(unit, planner.max_speed)
    block.programmed_speed = block.rapid_speed if rapid else speed_mm_s
    block.rapid = rapid
    block.tag = tag
    block.entry_sqr = 0.0
    at_rest = queue.head == queue.tail or planner.settings[0].exact_stop
    block.max_junction_sqr = 0.0 if at_rest else _junction_sqr(planner)
    queue.previous_nominal = _limit_entry(block, queue, queue.previous_nominal)
    copy_axes(unit, planner.previous_unit)
    queue.head = next_place(planner, queue.head)
    recalculate(planner)
    return True


@njit_inline
def _set_course(planner, target_mm, block):
    """Set steps, length and direction of the move; an axis whose place is unknown does not move."""
    events = 0
    length_sqr = 0.0
    for axis in range(len(target_mm)):
        known = planner.known[axis]
        planner.known[axis] = not math.isnan(target_mm[axis])
        before = planner.position[axis]
        if planner.known[axis]:
            planner.position[axis] = _nearest_step(target_mm[axis], planner.steps_per_mm[axis])
        steps = planner.position[axis] - before if known else 0
        block.steps[axis] = steps
        block.begin[axis] = planner.position[axis] - steps
        events = max(events, abs(steps))
        planner.unit[axis] = steps / planner.steps_per_mm[axis]
        length_sqr += planner.unit[axis] ** 2
    if events == 0:
        return False
    block.events = events
    block.length = math.sqrt(length_sqr)
    for axis in range(len(target_mm)):
        planner.unit[axis] /= block.length
    return True


@njit_inline
def _nearest_step(place_mm, steps_per_mm):
    """Return the nearest step, halves away from zero, as the firmware's 32-bit floats round it."""
    exact = float(np.float32(place_mm) * np.float32(steps_per_mm))
    nearest = math.floor(abs(exact) + 0.5)
    return nearest if exact >= 0.0 else -nearest


@njit_inline
def _junction_sqr(planner):
    """Return the greatest speed squared from the newest block's direction into `planner.unit`."""
    cosine = 0.0  # of the angle between the two edges: -1 straight on, +1 straight back
    square = 0.0
    turn = planner.turn
    for axis in range(len(turn)):
        before, after = planner.previous_unit[axis], planner.unit[axis]
        cosine -= before * after
        turn[axis] = after - before
        square += turn[axis] ** 2
    if cosine > STRAIGHT_ON:
        return 0.0
    if cosine < -STRAIGHT_ON:
        return UNLIMITED
    size = math.sqrt(square)
    for axis in range(len(turn)):
        turn[axis] /= size
    acceleration = limit_along(turn, planner.max_acceleration)
    sine_half = math.sqrt(0.5 * (1.0 - cosine))
    return acceleration * planner.settings[0].junction_deviation * sine_half / (1.0 - sine_half)


@njit_inline
def nominal_speed(block, queue):
    """Return the block's cruising speed under the overrides in force."""
    if block.rapid:
        return max(MINIMUM_FEED_MM_S, block.rapid_speed * queue.rapid_override)
    speed = min(block.programmed_speed * queue.feed_override, block.rapid_speed)
    return max(MINIMUM_FEED_MM_S, speed)


@njit_inline
def _limit_entry(block, queue, previous_nominal):
    """Limit the entry by both nominal speeds and the junction; returns the block's own nominal speed."""
    nominal = nominal_speed(block, queue)
    slower = min(nominal, previous_nominal)
    block.max_entry_sqr = min(slower**2, block.max_junction_sqr)
    return nominal


@njit_inline
def recalculate(planner):
    """Improve the entry speeds: backwards by braking distance, then forwards by what can be reached."""
    queue = planner.queue[0]
    ramp = planner.settings[0].ramp
    if ramp == S_CURVE:
        reload_running_block(planner)
        plan_when_due(planner)
        queue.planned = place_before(planner, queue.head)
    elif ramp == TABLE:  # every block begins and ends at rest
        queue.planned = place_before(planner, queue.head)
    elif place_before(planner, queue.head) != queue.planned:
        _reverse_pass(planner)
        _forward_pass(planner)


@njit_inline
def _reverse_pass(planner):
    queue = planner.queue[0]
    place = place_before(planner, queue.head)
    exit_sqr = 0.0
    while place != queue.planned:
        block = planner.blocks[place]
        block.entry_sqr = min(block.max_entry_sqr, exit_sqr + 2.0 * block.acceleration * block.length)
        exit_sqr = block.entry_sqr
        place = place_before(planner, place)
        if place == queue.tail:
            reload_running_block(planner)


@njit_inline
def _forward_pass(planner):
    queue = planner.queue[0]
    place = queue.planned
    after = next_place(planner, place)
    while after != queue.head:
        block, next_block = planner.blocks[place], planner.blocks[after]
        reachable = block.entry_sqr + 2.0 * block.acceleration * block.length
        if reachable < next_block.entry_sqr:
            next_block.entry_sqr = reachable
            queue.planned = after
        if next_block.entry_sqr == next_block.max_entry_sqr:
            queue.planned = after
        place = after
        after = next_place(planner, after)


@njit_inline
def reload_running_block(planner):
    """Continue the running block with a new profile, from the speed that its segments already fix."""
    ramp = planner.ramp[0]
    if ramp.loaded:
        ramp.replan = True
        ramp.loaded = False
        planner.blocks.entry_sqr[planner.queue[0].tail] = ramp.speed**2


@njit_inline
def plan_again(planner):
    """Plan all queued blocks again from the present speed of the running block."""
    queue = planner.queue[0]
    reload_running_block(planner)
    queue.planned = queue.fresh = queue.tail
    if queue.head != queue.tail:
        recalculate(planner)


@njit_inline
def set_overrides(planner, feed, rapid):
    """Let all queued and coming blocks run at these factors of their programmed speeds."""
    queue = planner.queue[0]
    queue.feed_override = feed
    queue.rapid_override = rapid
    previous = UNLIMITED
    place = queue.tail
    while place != queue.head:
        previous = _limit_entry(planner.blocks[place], queue, previous)
        place = next_place(planner, place)
    queue.previous_nominal = previous
    plan_again(planner)


@njit_inline
def write_course(segment, block):
    """Write to a segment of the block where it goes."""
    segment.events = block.events
    copy_axes(block.steps, segment.steps)
    copy_axes(block.begin, segment.begin)
    segment.tag = block.tag


@njit_inline
def empty_planner(planner, position_steps):
    """Drop all blocks and any hold, and rest at `position_steps`; overrides stay."""
    queue = planner.queue[0]
    ramp = planner.ramp[0]
    queue.head = queue.tail = queue.planned = queue.fresh = 0
    ramp.loaded = ramp.replan = ramp.over_speed = ramp.hold = ramp.ended = False
    ramp.speed = ramp.acceleration = 0.0
    ramp.place = -1
    copy_axes(position_steps, planner.position)
    for axis in range(len(planner.known)):
        planner.known[axis] = True
