# SPDX-License-Identifier: LGPL-2.1-or-later
"""The memory of planner and step generator, laid out as arrays so that compiled kernels share it.

    line ──► Blocks: a ring, grbl's of 15   ──► Ramp: the block being cut ──► Segments ──► steps
             tail = block being cut               into pieces of about 10 ms
             head = next free place

Lengths are mm, times s, speeds mm/s; `_sqr` is a speed squared. Step counts are integers, time on the
controller is counted in ticks of its 16 MHz clock.

The ring of queued blocks: places that follow one another, the last by the first.

. . T b b P b b H . .      T tail: being cut   P planned: up to here final   H head: the next free place
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from CNCStepper.kernels import njit_inline
from CNCStepper.motion.planner.machine_limits import Limits

TICKS_PER_S = 16_000_000
EIGHTHS = 8  # parts of one step event: the finest that slow moves are smoothed to
SEGMENT_PLACES = 5  # segments ready at most, the running one included

TRAPEZOID, S_CURVE, TABLE = 0, 1, 2  # ramps
RAMPS = ("trapezoid", "s_curve", "table")  # their names in `Limits`
UNLIMITED = 1e38  # more than any speed, acceleration or jerk
PHASES = 8  # of a jerk-limited profile at most

_SETTINGS = np.dtype(
    [
        ("junction_deviation", "f8"),
        ("arc_tolerance", "f8"),
        ("ramp", "i8"),
        ("exact_stop", "?"),  # the blocks that come now begin at rest
        ("pull_in", "i8"),  # ticks from step to step: at this pace and slower the motors start and stop at once
    ]
)

_QUEUE = np.dtype(
    [
        ("head", "i8"),  # next free place
        ("tail", "i8"),  # block being cut into segments
        ("planned", "i8"),  # up to here the plan can no longer improve
        ("fresh", "i8"),  # S-curves: the first place whose entry is not planned yet
        ("previous_nominal", "f8"),  # speed of the newest block
        ("feed_override", "f8"),  # 1.0 = as programmed
        ("rapid_override", "f8"),
    ]
)

_RAMP = np.dtype(
    [
        ("loaded", "?"),  # a block is being cut, its profile is valid
        ("replan", "?"),  # its profile must be computed again from where it is
        ("over_speed", "?"),  # too fast for a lowered override: the next block must keep slowing down
        ("hold", "?"),  # decelerate to a stop
        ("ended", "?"),  # the hold has reached its stop
        ("kind", "i8"),
        ("speed", "f8"),  # at the end of the last segment
        ("cruise_speed", "f8"),
        ("exit_speed", "f8"),
        ("accelerate_until", "f8"),  # these three as mm left to the end of the block
        ("decelerate_after", "f8"),
        ("stop_at", "f8"),
        ("remaining", "f8"),  # mm left when the segment in the making ends
        ("steps_left", "f8"),  # whole step events not yet in a segment
        ("steps_per_mm", "f8"),  # along the block
        ("least_mm", "f8"),  # a segment holds at least this much, so that it has a step
        ("time_left", "f8"),  # s, of a step that the last segment began and did not finish
        ("eighths", "i8"),  # of step events already in segments
        ("acceleration", "f8"),  # S-curves: at the end of the last segment, negative while it brakes
        ("phase", "i8"),  # S-curves: the one that the profile is in
        ("span", "f8"),  # S-curves: mm from here to the end of the profile, which may lie some blocks ahead
        ("span_acceleration", "f8"),  # the least of those blocks
        ("span_jerk", "f8"),
        ("place", "i8"),  # tables: entry of the last wait, -1 at rest
    ]
)


def _block(axes: int) -> np.dtype:
    """One straight move in the look-ahead ring."""
    return np.dtype(
        [
            ("begin", "i8", (axes,)),  # position in steps
            ("steps", "i8", (axes,)),  # signed
            ("events", "i8"),  # the steps of the axis that goes farthest
            ("tag", "i8"),  # the caller's own number of the line
            ("length", "f8"),  # mm not yet cut into segments
            ("acceleration", "f8"),
            ("jerk", "f8"),
            ("rapid_speed", "f8"),  # the greatest that the axes allow along the block
            ("programmed_speed", "f8"),
            ("entry_sqr", "f8"),
            ("max_entry_sqr", "f8"),
            ("max_junction_sqr", "f8"),
            ("rapid", "i8"),  # 1 or 0
            ("best_from", "i8"),  # S-curves: the place whose entry gives its own
            ("looks_to", "i8"),  # S-curves: the last place whose entry its own follows from
            ("farthest", "i8"),  # S-curves: the last place to which it or any block before it looks
        ]
    )


def _segment(axes: int) -> np.dtype:
    """A piece of a block with one pace: `ticks` ticks, each `cycles` of the clock long.

    Within its block it starts after `eighths` of step events, and each tick adds `unit` of them.
    """
    return np.dtype(
        [
            ("start", "i8"),  # clock at the first tick's begin
            ("ticks", "i8"),
            ("cycles", "i8"),
            ("unit", "i8"),
            ("eighths", "i8"),
            ("events", "i8"),  # of the whole block
            ("steps", "i8", (axes,)),  # of the whole block
            ("begin", "i8", (axes,)),  # position where the block begins
            ("tag", "i8"),
        ]
    )


class Planner(NamedTuple):
    """All that planning and segment making remember."""

    steps_per_mm: np.ndarray
    max_speed: np.ndarray
    max_acceleration: np.ndarray
    settings: np.ndarray
    blocks: np.recarray  # the ring; one place stays free, so that full and empty differ
    queue: np.ndarray
    ramp: np.ndarray
    position: np.ndarray  # int64[axes], where the newest block ends
    known: np.ndarray  # bool[axes], false until the axis' position is known
    previous_unit: np.ndarray  # direction of the newest block
    unit: np.ndarray  # direction of the block in the making
    turn: np.ndarray  # from the newest block's direction into it
    max_jerk: np.ndarray  # float64[axes], mm/s³, for S-curves
    phases: np.ndarray  # float64[PHASES, 2]: jerk along the path and duration of each phase of an S-curve
    waits: np.ndarray  # int64[n]: ticks before the first, second ... step of a ramp by table


def new_segments(rows: int, axes: int) -> np.recarray:
    """Return room for `rows` segments."""
    return np.zeros(rows, _segment(axes)).view(np.recarray)


def new_planner(limits: Limits, position_mm: tuple[float, ...]) -> Planner:
    """Return an empty planner at `position_mm` (NaN where unknown)."""
    axes = limits.axes
    steps_per_mm = np.array(limits.steps_per_mm, float)
    known = ~np.isnan(np.array(position_mm, float))
    position = np.rint(np.nan_to_num(np.array(position_mm, float)) * steps_per_mm).astype(np.int64)
    settings, queue, ramp = (np.zeros(1, kind).view(np.recarray) for kind in (_SETTINGS, _QUEUE, _RAMP))
    kind = RAMPS.index(limits.ramp)
    pull_in = round((limits.pull_in_s or max(limits.waits_s, default=0.0)) * TICKS_PER_S)
    settings[0] = (limits.junction_deviation_mm, limits.arc_tolerance_mm, kind, False, pull_in)
    ramp.place = -1
    queue.feed_override = queue.rapid_override = 1.0
    return Planner(
        steps_per_mm,
        np.array(limits.max_speed_mm_s, float),
        np.array(limits.acceleration_mm_s2, float),
        settings,
        np.zeros(limits.look_ahead_blocks + 1, _block(axes)).view(np.recarray),
        queue,
        ramp,
        position,
        known,
        np.zeros(axes),
        np.zeros(axes),
        np.zeros(axes),
        np.array(limits.jerk_mm_s3 or (0.0,) * axes, float),
        np.zeros((PHASES, 2)),
        np.rint(np.array(limits.waits_s) * TICKS_PER_S).astype(np.int64),
    )


@njit_inline
def copy_axes(source, target):
    """Write the values of all axes from `source` to `target`; a slice would make an array of its own."""
    for axis in range(len(target)):
        target[axis] = source[axis]


@njit_inline
def next_place(planner, place):
    """Return the ring's place after `place`."""
    after = place + 1
    return after if after < len(planner.blocks) else 0


@njit_inline
def place_before(planner, place):
    """Return the ring's place before `place`."""
    return place - 1 if place > 0 else len(planner.blocks) - 1


@njit_inline
def places_from(planner, first, last):
    """Return how many places lie from place `first` to place `last`."""
    count = last - first
    return count if count >= 0 else count + len(planner.blocks)


@njit_inline
def is_full(planner):
    """Return whether no further block can be queued."""
    queue = planner.queue[0]
    return next_place(planner, queue.head) == queue.tail


@njit_inline
def count_blocks(planner):
    """Return how many blocks are queued, the one being cut included."""
    queue = planner.queue[0]
    return places_from(planner, queue.tail, queue.head)


@njit_inline
def discard_block(planner):
    """Free the place of the block that has been cut up."""
    queue = planner.queue[0]
    after = next_place(planner, queue.tail)
    if queue.planned == queue.tail:
        queue.planned = after
    if queue.fresh == queue.tail:
        queue.fresh = after
    queue.tail = after
