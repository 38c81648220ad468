# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jerk-limited profiles of blocks, from any present speed and acceleration of the axes.

    speed │        ______ middle                 let go:  the acceleration falls to 0 at once
          │      /        \\                      lead:    the way that a change in progress has behind it,
          │    /            \\____ exit                    counted from where its acceleration was 0
          │ __/ from (speed, acceleration)
          └──────────────────────────► time

A profile is a change to a middle speed, a cruise and a change to the exit speed. It ends at the entry of a later
block, of those ahead the one that allows the greatest middle speed; between, no entry may be exceeded, and the least
acceleration and jerk of the blocks hold. So chords of an arc do not stop the acceleration. A change that goes on in
the sense of the present acceleration is the rest of a whole one that began earlier, at another speed; one in the
other sense first lets go. Invariants: at the end of a profile the acceleration is 0; what one block has begun the
next can go on with; a hold brakes as hard as the block may, and over its end if need be. After an override a block
may be too short to slow down in: it is then left with the acceleration that it has, as far as the next may have it.
"""

from __future__ import annotations

import math

from CNCStepper.kernels import njit_in_place
from CNCStepper.motion.planner.buffers import PHASES, next_place
from CNCStepper.motion.planner.look_ahead import nominal_speed
from CNCStepper.motion.planner.s_curve_look_ahead import change_length, plan_when_due

HALVINGS = 50
CRUMB_S = 1e-4  # of a profile's end, which takes hardly any way
CRUMB = 1e-9  # of the length, and mm: rounding
CRUMB_MM_S = 1e-6


@njit_in_place
def take_up(planner):
    """Begin the oldest block with the speed that the axes have, and with as much of their acceleration as it may."""
    ramp = planner.ramp[0]
    block = planner.blocks[planner.queue[0].tail]
    ramp.acceleration = max(-block.acceleration, min(block.acceleration, ramp.acceleration))


@njit_in_place
def shape(planner):
    """Choose the profile from what remains of the block to an entry ahead, the one that allows the greatest speed."""
    ramp = planner.ramp[0]
    queue = planner.queue[0]
    block = planner.blocks[queue.tail]
    ramp.stop_at = 0.0
    _begin_span(ramp, block)
    if ramp.hold:
        ramp.stop_at = max(0.0, block.length - _change_from(ramp, 0.0))
        _lay_phases(planner, 0.0, 0.0)
        return
    plan_when_due(planner)
    nominal = nominal_speed(block, queue)
    exit_speed = _reachable_exit(ramp, _entry_speed(planner, next_place(planner, queue.tail)))
    middle = _middle_speed(ramp, nominal, exit_speed)
    _lay_phases(planner, middle, exit_speed)
    if not _fits(ramp, exit_speed):
        middle = -1.0
    _look_farther(planner, nominal, middle)


@njit_in_place
def _look_farther(planner, nominal, best):
    """Take a later entry for the profile's end where that allows a middle speed above `best`."""
    ramp = planner.ramp[0]
    queue = planner.queue[0]
    least = max(ramp.speed, _let_go_speed(ramp))
    place = next_place(planner, queue.tail)
    limit = nominal
    while place != queue.head:
        block = planner.blocks[place]
        limit = min(limit, math.sqrt(block.max_entry_sqr))
        if limit <= best or limit < least - CRUMB_MM_S:
            return
        ramp.span += block.length
        ramp.span_acceleration = min(ramp.span_acceleration, block.acceleration)
        ramp.span_jerk = min(ramp.span_jerk, block.jerk)
        if abs(ramp.acceleration) > ramp.span_acceleration:
            return
        place = next_place(planner, place)
        exit_speed = _reachable_exit(ramp, _entry_speed(planner, place))
        beaten = best > exit_speed and _room_left(ramp, best, exit_speed) < 0.0
        if beaten or not _fits(ramp, exit_speed):
            continue
        middle = _middle_speed(ramp, limit, exit_speed)
        if middle > best:
            best = middle
            _lay_phases(planner, middle, exit_speed)


@njit_in_place
def _begin_span(ramp, block):
    """Let the profile end with the block."""
    ramp.span = block.length
    ramp.span_acceleration = block.acceleration
    ramp.span_jerk = block.jerk


@njit_in_place
def _entry_speed(planner, place):
    """Return the planned entry speed of the block at a place of the ring, none behind the last."""
    return 0.0 if place == planner.queue[0].head else math.sqrt(planner.blocks[place].entry_sqr)


@njit_in_place
def _fits(ramp, exit_speed):
    """Return whether the exit speed can be had within the span."""
    return _change_from(ramp, exit_speed) <= ramp.span * (1.0 + CRUMB) + CRUMB


@njit_in_place
def _let_go_speed(ramp):
    """Return the speed that results when the acceleration falls to 0 at once."""
    return ramp.speed + 0.5 * ramp.acceleration * abs(ramp.acceleration) / ramp.span_jerk


@njit_in_place
def _goes_on(ramp, speed):
    """Return whether a change to `speed` is the rest of the one in progress."""
    return (speed - _let_go_speed(ramp)) * ramp.acceleration >= 0.0


@njit_in_place
def _origin_speed(ramp):
    """Return the speed at which the change in progress would have begun."""
    return ramp.speed - 0.5 * ramp.acceleration * abs(ramp.acceleration) / ramp.span_jerk


@njit_in_place
def _change_from(ramp, speed):
    """Return the distance from the present speed and acceleration to a speed without acceleration, in mm."""
    time = abs(ramp.acceleration) / ramp.span_jerk
    third = ramp.acceleration * time**2 / 3.0
    if _goes_on(ramp, speed):
        lead = ramp.speed * time - third
        return change_length(_origin_speed(ramp), speed, ramp.span_acceleration, ramp.span_jerk) - lead
    let_go = ramp.speed * time + third
    return let_go + change_length(_let_go_speed(ramp), speed, ramp.span_acceleration, ramp.span_jerk)


@njit_in_place
def _reachable_exit(ramp, wanted):
    """Return `wanted`, or the speed nearest to it that a block too short for it can be left with."""
    if _change_from(ramp, wanted) <= ramp.span:
        return wanted
    low = max(0.0, _let_go_speed(ramp))
    if low >= wanted:
        return wanted
    high = wanted
    for _ in range(HALVINGS):
        speed = 0.5 * (low + high)
        if _change_from(ramp, speed) <= ramp.span:
            low = speed
        else:
            high = speed
    return low


@njit_in_place
def _middle_speed(ramp, nominal, exit_speed):
    """Return the greatest speed found, at most nominal, to which and from which to the exit there is room."""
    low, high = exit_speed, max(nominal, exit_speed)
    if _room_left(ramp, high, exit_speed) >= 0.0:
        return high
    while high - low > CRUMB * high:
        speed = 0.5 * (low + high)
        if _room_left(ramp, speed, exit_speed) >= 0.0:
            low = speed
        else:
            high = speed
    return low


@njit_in_place
def _room_left(ramp, middle, exit_speed):
    """Return the distance that is left for the cruise, in mm."""
    down = change_length(middle, exit_speed, ramp.span_acceleration, ramp.span_jerk)
    return ramp.span - _change_from(ramp, middle) - down


@njit_in_place
def _lay_phases(planner, middle, exit_speed):
    """Write jerk and duration of every phase of the profile."""
    ramp = planner.ramp[0]
    phases = planner.phases
    for phase in range(PHASES):
        phases[phase, 0] = phases[phase, 1] = 0.0
    ramp.phase = 0
    ramp.exit_speed = exit_speed
    time = abs(ramp.acceleration) / ramp.span_jerk
    if _goes_on(ramp, middle):
        _lay_change(phases, 1, middle - _origin_speed(ramp), ramp)
        phases[1, 1] = max(0.0, phases[1, 1] - time)
    else:
        phases[0, 0] = -math.copysign(ramp.span_jerk, ramp.acceleration)
        phases[0, 1] = time
        _lay_change(phases, 1, middle - _let_go_speed(ramp), ramp)
    room = ramp.span - ramp.stop_at - _change_from(ramp, middle)
    room -= change_length(middle, exit_speed, ramp.span_acceleration, ramp.span_jerk)
    if room > 0.0 and middle > 0.0:
        phases[4, 1] = room / middle
    _lay_change(phases, 5, exit_speed - middle, ramp)


@njit_in_place
def _lay_change(phases, first, change, ramp):
    """Write the three phases of a whole change of speed from phase `first` on."""
    jerk = math.copysign(ramp.span_jerk, change)
    rise = min(math.sqrt(abs(change) / ramp.span_jerk), ramp.span_acceleration / ramp.span_jerk)
    phases[first, 0], phases[first, 1] = jerk, rise
    phases[first + 1, 1] = max(0.0, abs(change) / ramp.span_acceleration - rise) if rise > 0.0 else 0.0
    phases[first + 2, 0], phases[first + 2, 1] = -jerk, rise


@njit_in_place
def advance(planner, segment_s):
    """Move speed and `ramp.remaining` on by one segment of at least a step; returns its duration in s."""
    ramp = planner.ramp[0]
    block = planner.blocks[planner.queue[0].tail]
    ramp.remaining = block.length
    enough = max(0.0, block.length - ramp.least_mm)
    duration, longest = 0.0, segment_s
    while ramp.remaining > ramp.stop_at and (duration < longest or ramp.remaining > enough):
        if duration >= longest:
            longest += segment_s
        if ramp.phase == PHASES:
            _end_profile(ramp)
        else:
            duration += _advance_phase(planner, longest - duration)
    return duration


@njit_in_place
def _advance_phase(planner, span):
    """Advance by `span` s, or to the end of the phase or of the block if that is sooner; return the time taken."""
    ramp = planner.ramp[0]
    jerk, left = planner.phases[ramp.phase, 0], planner.phases[ramp.phase, 1]
    time = min(span, left)
    way = ramp.remaining - ramp.stop_at
    ends = _way(ramp, jerk, time) >= way
    if ends:
        time = _time_of(ramp, jerk, way, time)
    ramp.remaining = ramp.stop_at if ends else ramp.remaining - _way(ramp, jerk, time)
    ramp.speed += ramp.acceleration * time + 0.5 * jerk * time**2
    ramp.acceleration += jerk * time
    planner.phases[ramp.phase, 1] = left - time
    if left - time <= 0.0:
        ramp.phase += 1
    if ends and _time_left(planner) < CRUMB_S:
        _end_profile(ramp)
    return time


@njit_in_place
def _time_left(planner):
    """Return how long the rest of the profile takes, in s."""
    time = 0.0
    for phase in range(planner.ramp[0].phase, PHASES):
        time += planner.phases[phase, 1]
    return time


@njit_in_place
def _way(ramp, jerk, time):
    """Return the distance in `time` s at this jerk."""
    return time * (ramp.speed + time * (0.5 * ramp.acceleration + time * jerk / 6.0))


@njit_in_place
def _time_of(ramp, jerk, way, longest):
    """Return the time that a way takes which is done in `longest` s at most."""
    low, high = 0.0, longest
    for _ in range(HALVINGS):
        time = 0.5 * (low + high)
        if _way(ramp, jerk, time) < way:
            low = time
        else:
            high = time
    return high


@njit_in_place
def _end_profile(ramp):
    """Stand exactly where the profile ends: rounding has left a crumb of way, or of speed."""
    ramp.remaining = ramp.stop_at
    ramp.speed = ramp.exit_speed
    ramp.acceleration = 0.0
