# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows of a table of moves through the planner, as a sender that is never late would feed it.

The firmware has one processor: while it reads and plans a line it cuts no segments, and when it comes back it
first fills every place that the step interrupt has freed. A block may so be begun while the ring is not full,
which is felt where braking takes the whole of the look-ahead. A ring longer than the firmware's belongs to a faster
processor: it takes no longer to plan again.

    processor  ─ line ─┬ segments ┬─ line ─┬ segments ┬── waits for a free place ──┬ segment ┬─ line ─
    step interrupt     └─ runs up to SEGMENT_PLACES segments behind ──────────────────────────────────

From rest the firmware starts its cycle when a line is done or its buffer is full, not between the chords of an arc:
an arc that begins at rest is queued whole, as far as the buffer holds, before its first step.

The kernel stops wherever the table of segments is full and goes on from there, also from one chunk of
rows to the next; memory does not grow with the job.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from CNCStepper.kernels import njit_in_place, njit_inline
from CNCStepper.machine.profile import LOOK_AHEAD_BLOCKS
from CNCStepper.motion.planner.arc_segments import new_arc, next_point, start_arc
from CNCStepper.motion.planner.buffers import (
    SEGMENT_PLACES,
    TICKS_PER_S,
    Planner,
    copy_axes,
    count_blocks,
    is_full,
    places_from,
)
from CNCStepper.motion.planner.look_ahead import push_line
from CNCStepper.motion.planner.path_control_modes import next_corner_point, start_corner
from CNCStepper.motion.planner.segment_generator import next_segment
from CNCStepper.toolpath import ARC_CW, RAPID

LINE_TICKS = round(0.0031 * TICKS_PER_S)  # to read and queue a line, fitted to the recording with a dwell
CHORD_TICKS = round(0.0016 * TICKS_PER_S)  # to queue one chord of an arc, an estimate: nothing is read
REPLAN_TICKS = round(
    0.00024 * TICKS_PER_S
)  # to look again at one queued block, fitted to a recording bound by look-ahead
INTERRUPT_TICKS = 450  # of the processor's time that each tick of the step interrupt takes

_CURSOR = np.dtype(
    [
        ("row", "i8"),  # of the chunk
        ("inside", "?"),  # an arc is begun
        ("clock", "i8"),  # ticks: end of the last segment or dwell
        ("processor", "i8"),  # ticks: from here on the processor is free
        ("cut", "i8"),  # segments so far
        ("cycles", "i8"),  # ticks from one step interrupt to the next, in the last segment
        ("moved", "?"),  # since the last standstill
        ("idle_delay", "i8"),  # ticks
    ]
)


class Rows(NamedTuple):
    """One chunk's columns, and what happens before each row."""

    kind: np.ndarray
    end: np.ndarray
    centre: np.ndarray
    plane: np.ndarray
    turns: np.ndarray
    speed: np.ndarray  # float64, mm/s
    dwell: np.ndarray  # int64, ticks of standstill before the row; -1: none, 0: stop and continue
    not_before: np.ndarray  # int64, written: the clock after that standstill
    first: int
    exact: np.ndarray  # bool, the row begins at rest
    reach: np.ndarray  # float64, mm of the row's end, and of the next row's begin, that a corner's arc takes; 0: none
    after: np.ndarray  # float64[n, axes], end of the next row, where reach is above 0


class Course(NamedTuple):
    """Where in the rows the planner is being fed from."""

    planner: Planner
    cursor: np.ndarray
    arc: np.ndarray
    place: np.ndarray  # float64[axes], mm: end of the last row
    point: np.ndarray  # float64[axes], mm: end of the next chord
    ends: np.ndarray  # int64[SEGMENT_PLACES], ticks: when the last segments end, and so their places are free


def new_course(planner: Planner, position_mm: tuple[float, ...], idle_delay_ticks: int) -> Course:
    """Return a course that begins at `position_mm`."""
    cursor = np.zeros(1, _CURSOR).view(np.recarray)
    cursor[0].idle_delay = idle_delay_ticks
    place = np.array(position_mm, float)
    return Course(planner, cursor, new_arc(), place, np.zeros(len(place)), np.zeros(SEGMENT_PLACES, np.int64))


@njit_inline
def run_rows(course, rows, segments):
    """Plan rows until the chunk is queued or `segments` is full; returns the segments written.

    The chunk is done when `cursor.row` has reached its length.
    """
    cursor = course.cursor[0]
    count = 0
    while cursor.row < len(rows.kind):
        row = cursor.row
        if rows.dwell[row] >= 0 and not cursor.inside:
            count = run_empty(course, segments, count)
            if count == len(segments):
                return count
            stand_still(course, rows.dwell[row])
            rows.not_before[row] = cursor.clock
            rows.dwell[row] = -1
        if rows.kind[row] >= ARC_CW and not cursor.inside:
            tolerance = course.planner.settings[0].arc_tolerance
            kind, plane, turns = rows.kind[row], rows.plane[row], rows.turns[row]
            start_arc(course.arc[0], course.place, rows.end[row], rows.centre[row], kind, plane, turns, tolerance)
            cursor.inside = True
        if rows.reach[row] > 0.0 and not cursor.inside:
            start_corner(course, rows, row)
            cursor.inside = True
        if not (cursor.inside and _awaits_cycle_start(course, rows, row)):
            count = _make_room(course, segments, count)
        if is_full(course.planner) or count == len(segments):
            return count
        _queue_next(course, rows, row)
    return count


@njit_inline
def _awaits_cycle_start(course, rows, row):
    """Return whether the axes stand until more of the arc in hand is queued; corners are no arcs of the program."""
    cursor = course.cursor[0]
    if course.arc[0].done == 0 or rows.reach[row] > 0.0 or (cursor.moved and cursor.clock >= cursor.processor):
        return False
    return not is_full(course.planner) and count_blocks(course.planner) < LOOK_AHEAD_BLOCKS


@njit_inline
def _make_room(course, segments, count):
    """Cut segments as their places fall free, until a block can be queued or `segments` is full."""
    cursor = course.cursor[0]
    while True:
        while count < len(segments) and course.ends[cursor.cut % SEGMENT_PLACES] <= cursor.processor:
            if not _cut(course, segments, count):
                break
            count += 1
        if count == len(segments) or not is_full(course.planner):
            return count
        cursor.processor = course.ends[cursor.cut % SEGMENT_PLACES]


@njit_inline
def _queue_next(course, rows, row):
    """Queue the next straight piece of the row, and step to the next row after the last piece."""
    cursor = course.cursor[0]
    arc = course.arc[0]
    end = rows.end[row]
    begins = not cursor.inside or arc.done == 0
    speed = rows.speed[row]
    _work(course, LINE_TICKS if begins else CHORD_TICKS)
    if rows.reach[row] > 0.0:
        speed = next_corner_point(course, rows, row)
        cursor.inside = arc.done < arc.chords
    elif cursor.inside:
        next_point(arc, course.place, end, course.point)
        cursor.inside = arc.done < arc.chords
    else:
        copy_axes(end, course.point)
    course.planner.settings[0].exact_stop = begins and rows.exact[row]
    push_line(course.planner, course.point, speed, rows.kind[row] == RAPID, rows.first + row)
    if not cursor.inside:
        copy_axes(course.point, course.place)
        cursor.row += 1


@njit_inline
def _work(course, ticks):
    """Let the processor read and plan, `ticks` of its own time, between the step interrupts."""
    cursor = course.cursor[0]
    queue = course.planner.queue[0]
    ticks += REPLAN_TICKS * min(LOOK_AHEAD_BLOCKS, places_from(course.planner, queue.planned, queue.head))
    if cursor.clock > cursor.processor:
        ticks = ticks * cursor.cycles // (cursor.cycles - INTERRUPT_TICKS)
    cursor.processor += ticks


@njit_inline
def run_empty(course, segments, count):
    """Cut all that is queued, from row `count` of `segments` on; full before the end when all rows are used."""
    while count < len(segments) and _cut(course, segments, count):
        count += 1
    return count


@njit_inline
def stand_still(course, ticks):
    """Let the axes come to rest, the drivers' idle delay pass, and then `ticks`."""
    cursor = course.cursor[0]
    if cursor.moved:
        cursor.clock += cursor.idle_delay
        cursor.moved = False
    cursor.clock = max(cursor.clock, cursor.processor) + ticks
    cursor.processor = cursor.clock


@njit_inline
def _cut(course, segments, row):
    """Cut one segment and set it on the clock; a segment that comes too late finds the drivers idle."""
    cursor = course.cursor[0]
    segment = segments[row]
    if not next_segment(course.planner, segment):
        return False
    if cursor.clock < cursor.processor:
        stand_still(course, 0)
    segment.start = cursor.clock
    cursor.clock += segment.ticks * segment.cycles
    course.ends[cursor.cut % SEGMENT_PLACES] = cursor.clock
    cursor.cut += 1
    cursor.cycles = max(segment.cycles, 2 * INTERRUPT_TICKS)
    cursor.moved = True
    return True


@njit_in_place
def take_ends(segments, first, latest):
    """Raise the ends of the rows from `first` on, int64[n] in ticks, to those of their segments."""
    for k in range(len(segments)):
        row = segments[k]["tag"] - first
        if 0 <= row < len(latest):
            latest[row] = max(latest[row], segments[k]["start"] + segments[k]["ticks"] * segments[k]["cycles"])
