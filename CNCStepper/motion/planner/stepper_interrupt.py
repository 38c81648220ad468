# SPDX-License-Identifier: LGPL-2.1-or-later
"""The step interrupt of the live controller: runs segments against a clock, one after the other.

    planner ──next_segment──► ring of SEGMENT_PLACES ──► running segment ──► position, record

A segment that is in the ring is run to its end whatever happens to the plan behind it; only a reset cuts
one short. When the ring runs empty the axes stand, and the drivers' idle delay passes before the next move.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from CNCStepper.kernels import njit_inline
from CNCStepper.motion.planner.buffers import SEGMENT_PLACES, Planner, new_segments
from CNCStepper.motion.planner.look_ahead import empty_planner, plan_again, reload_running_block
from CNCStepper.motion.planner.segment_generator import next_segment
from CNCStepper.motion.planner.step_timeline import place_in

_CLOCKWORK = np.dtype(
    [
        ("clock", "i8"),  # ticks: now
        ("ready_at", "i8"),  # ticks: no move can begin sooner
        ("idle_delay", "i8"),  # ticks
        ("running", "?"),  # the oldest segment has begun
        ("held", "?"),
        ("oldest", "i8"),  # place in the ring
        ("waiting", "i8"),  # segments in the ring, the running one included
        ("recorded", "i8"),  # rows of the record that are filled
    ]
)


class Runner(NamedTuple):
    """A planner, the ring of segments behind it, and what has been run."""

    planner: Planner
    ring: np.recarray  # segments
    clockwork: np.ndarray
    position: np.ndarray  # int64[axes], where the axes are
    record: np.recarray  # the segments that were run; no rows when nothing is recorded


def new_runner(planner: Planner, idle_delay_ticks: int, record_rows: int) -> Runner:
    """Return a runner at clock 0 at the planner's position."""
    axes = len(planner.position)
    clockwork = np.zeros(1, _CLOCKWORK).view(np.recarray)
    clockwork[0].idle_delay = idle_delay_ticks
    ring, record = new_segments(SEGMENT_PLACES, axes), new_segments(record_rows, axes)
    return Runner(planner, ring, clockwork, planner.position.copy(), record)


@njit_inline
def run_until(runner, until):
    """Run to clock `until`; stops short, at the end of a segment, when the record is full."""
    clockwork = runner.clockwork[0]
    while clockwork.clock < until and not record_full(runner):
        _refill(runner)
        segment = runner.ring[clockwork.oldest]
        if clockwork.waiting == 0:
            _stand(runner, until)
            break
        if not clockwork.running:
            segment.start = max(clockwork.clock, clockwork.ready_at)
            clockwork.running = segment.start < until
        end = segment.start + segment.ticks * segment.cycles
        clockwork.clock = min(end, until)
        if end <= until:
            _finish(runner, segment.ticks)
    if clockwork.running:
        segment = runner.ring[clockwork.oldest]
        place_in(segment, _ticks_done(clockwork, segment), runner.position)


@njit_inline
def _ticks_done(clockwork, segment):
    """Return how many ticks of the running segment are over."""
    return (clockwork.clock - segment.start) // segment.cycles


@njit_inline
def record_full(runner):
    """Return whether the record must be emptied before anything more is run."""
    rows = len(runner.record)
    return rows > 0 and runner.clockwork[0].recorded == rows


@njit_inline
def _refill(runner):
    """Cut segments into the free places of the ring."""
    clockwork = runner.clockwork[0]
    while clockwork.waiting < SEGMENT_PLACES:
        place = (clockwork.oldest + clockwork.waiting) % SEGMENT_PLACES
        if clockwork.held or not next_segment(runner.planner, runner.ring[place]):
            break
        clockwork.waiting += 1


@njit_inline
def _finish(runner, ticks):
    """Take the running segment out of the ring after `ticks` of it, and record it."""
    clockwork = runner.clockwork[0]
    segment = runner.ring[clockwork.oldest]
    segment.ticks = ticks
    place_in(segment, ticks, runner.position)
    if len(runner.record) > 0:
        runner.record[clockwork.recorded] = segment
        clockwork.recorded += 1
    clockwork.oldest = (clockwork.oldest + 1) % SEGMENT_PLACES
    clockwork.waiting -= 1
    clockwork.running = False
    _refill(runner)
    if clockwork.waiting == 0:
        clockwork.ready_at = clockwork.clock + clockwork.idle_delay


@njit_inline
def _stand(runner, until):
    """Let the time pass without a move; a hold is complete once the drivers' idle delay is over."""
    clockwork = runner.clockwork[0]
    if runner.planner.ramp[0].hold and not clockwork.held and clockwork.ready_at <= until:
        clockwork.held = True
        plan_again(runner.planner)
    clockwork.clock = until


@njit_inline
def hold(runner):
    """Begin to brake behind the segments that are already cut; at once held when nothing moves."""
    planner = runner.planner
    clockwork = runner.clockwork[0]
    ramp = planner.ramp[0]
    if ramp.hold:
        return
    reload_running_block(planner)
    ramp.hold = True
    clockwork.held = clockwork.waiting == 0 and clockwork.ready_at <= clockwork.clock
    if clockwork.held:
        ramp.ended = True
        plan_again(planner)


@njit_inline
def resume(runner):
    """Go on after a completed hold; returns False, and changes nothing, while there is none."""
    clockwork = runner.clockwork[0]
    ramp = runner.planner.ramp[0]
    if not clockwork.held:
        return False
    clockwork.held = ramp.hold = ramp.ended = False
    return True


@njit_inline
def stop_dead(runner):
    """Forget segments, blocks and hold at once; returns whether the axes were moving."""
    clockwork = runner.clockwork[0]
    moving = clockwork.running
    if moving:
        clockwork.waiting = 1
        empty_planner(runner.planner, runner.position)
        _finish(runner, _ticks_done(clockwork, runner.ring[clockwork.oldest]))
    clockwork.waiting = 0
    clockwork.held = False
    empty_planner(runner.planner, runner.position)
    return moving
