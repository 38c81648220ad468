# SPDX-License-Identifier: LGPL-2.1-or-later
"""The memory of planner and step generator, laid out as arrays so that compiled kernels share it.

    line ──► Blocks: a ring of 16, 15 usable ──► Ramp: the block being cut ──► Segments ──► steps
             tail = block being cut               into pieces of about 10 ms
             head = next free place

Lengths are mm, times s, speeds mm/s; `_sqr` is a speed squared. Step counts are integers, time on the
controller is counted in ticks of its 16 MHz clock.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from CNCStepper.motion.limits import Limits

TICKS_PER_S = 16_000_000
BLOCKS = 16  # places in the ring; one stays free, so that full and empty differ
EIGHTHS = 8  # parts of one step event: the finest that slow moves are smoothed to
SEGMENT_PLACES = 5  # segments ready at most, the running one included

_SETTINGS = np.dtype([("junction_deviation", "f8"), ("arc_tolerance", "f8")])

_QUEUE = np.dtype(
    [
        ("head", "i8"),  # next free place
        ("tail", "i8"),  # block being cut into segments
        ("planned", "i8"),  # up to here the plan can no longer improve
        ("previous_nominal", "f8"),  # speed of the newest block
        ("feed_override", "f8"),  # 1.0 = as programmed
        ("rapid_override", "f8"),
    ]
)

_RAMP = np.dtype(
    [
        ("loaded", "?"),  # a block is being cut, its profile is valid
        ("replan", "?"),  # its profile must be computed again from where it is
        ("over_speed", "?"),  # too fast for a lowered override: the next block must go on slowing down
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
    ]
)


class Blocks(NamedTuple):
    """The look-ahead ring: straight moves, as columns of BLOCKS places."""

    begin: np.ndarray  # int64[BLOCKS, axes], position in steps
    steps: np.ndarray  # int64[BLOCKS, axes], signed
    events: np.ndarray  # int64, the steps of the axis that goes farthest
    length: np.ndarray  # float64, mm not yet cut into segments
    acceleration: np.ndarray
    rapid_speed: np.ndarray  # the greatest that the axes allow along the block
    programmed_speed: np.ndarray
    rapid: np.ndarray  # bool
    entry_sqr: np.ndarray
    max_entry_sqr: np.ndarray
    max_junction_sqr: np.ndarray
    tag: np.ndarray  # int64, the caller's own number of the line


class Segments(NamedTuple):
    """Pieces of blocks with one pace, as columns; `ticks` ticks, each `cycles` of the clock long.

    Within its block a segment starts after `eighths` of step events, and each tick adds `unit` of them.
    """

    start: np.ndarray  # int64, clock at the first tick's begin
    ticks: np.ndarray
    cycles: np.ndarray
    unit: np.ndarray
    eighths: np.ndarray
    events: np.ndarray  # of the whole block
    steps: np.ndarray  # int64[n, axes], of the whole block
    begin: np.ndarray  # int64[n, axes], position where the block begins
    tag: np.ndarray

    def first(self, count: int) -> Segments:
        """Return the first `count` rows as views."""
        return Segments(*(column[:count] for column in self))

    def copied(self, count: int) -> Segments:
        """Return copies of the first `count` rows."""
        return Segments(*(column[:count].copy() for column in self))


class Planner(NamedTuple):
    """All that planning and segment making remember."""

    steps_per_mm: np.ndarray
    max_speed: np.ndarray
    max_acceleration: np.ndarray
    settings: np.ndarray
    blocks: Blocks
    queue: np.ndarray
    ramp: np.ndarray
    position: np.ndarray  # int64[axes], where the newest block ends
    known: np.ndarray  # bool[axes], false until the axis' position is known
    previous_unit: np.ndarray  # direction of the newest block
    unit: np.ndarray  # direction of the block in the making


def new_segments(rows: int, axes: int) -> Segments:
    """Return room for `rows` segments."""
    start, ticks, cycles, unit, eighths, events, tag = (np.zeros(rows, np.int64) for _ in range(7))
    steps, begin = (np.zeros((rows, axes), np.int64) for _ in range(2))
    return Segments(start, ticks, cycles, unit, eighths, events, steps, begin, tag)


def new_planner(limits: Limits, position_mm: tuple[float, ...]) -> Planner:
    """Return an empty planner that stands at `position_mm` (NaN where unknown)."""
    axes = limits.axes
    steps_per_mm = np.array(limits.steps_per_mm, float)
    known = ~np.isnan(np.array(position_mm, float))
    position = np.rint(np.nan_to_num(np.array(position_mm, float)) * steps_per_mm).astype(np.int64)
    settings, queue, ramp = (np.zeros(1, kind).view(np.recarray) for kind in (_SETTINGS, _QUEUE, _RAMP))
    settings[0] = (limits.junction_deviation_mm, limits.arc_tolerance_mm)
    queue.feed_override = queue.rapid_override = 1.0
    return Planner(
        steps_per_mm,
        np.array(limits.max_speed_mm_s, float),
        np.array(limits.acceleration_mm_s2, float),
        settings,
        _new_blocks(axes),
        queue,
        ramp,
        position,
        known,
        np.zeros(axes),
        np.zeros(axes),
    )


def _new_blocks(axes: int) -> Blocks:
    floats = [np.zeros(BLOCKS) for _ in range(7)]
    length, acceleration, rapid_speed, programmed_speed, entry, max_entry, junction = floats
    return Blocks(
        np.zeros((BLOCKS, axes), np.int64),
        np.zeros((BLOCKS, axes), np.int64),
        np.zeros(BLOCKS, np.int64),
        length,
        acceleration,
        rapid_speed,
        programmed_speed,
        np.zeros(BLOCKS, np.bool_),
        entry,
        max_entry,
        junction,
        np.zeros(BLOCKS, np.int64),
    )
