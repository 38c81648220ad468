# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a table of moves takes and where the axes are meanwhile, as grbl 1.1 would run it.

Everything here folds over `segments()`, which streams through a table in constant memory. Time 0 is
the moment at which the first move begins.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from CNCStepper.machine.profile import Machine
from CNCStepper.motion.limits import Limits
from CNCStepper.motion.memory import EIGHTHS, TICKS_PER_S, new_planner, new_segments
from CNCStepper.motion.rows import Course, Rows, new_course, run_empty, run_rows, stand_still
from CNCStepper.motion.timeline import positions_at, step_table
from CNCStepper.state import State
from CNCStepper.toolpath import Chunk, Event, Toolpath
from CNCStepper.units import S_PER_MIN

SEGMENT_ROWS = 4096
DWELL_STEP_S = 0.05
RUNNING_EVENTS = ("message", "comment", "tool_select", "optional_pause")  # the rest stop the motion


def times_s(toolpath: Toolpath, machine: Machine | Limits) -> np.ndarray:
    """Return the time in s at which every row ends, float64[n]; dwells before a row are included."""
    return Run(toolpath, machine).times_s()


def duration_s(toolpath: Toolpath, machine: Machine | Limits) -> float:
    """Return the time in s that the whole table takes, dwells included."""
    run = Run(toolpath, machine)
    for _ in run.segments():
        pass
    return run.clock / TICKS_PER_S


def top_speeds_mm_s(toolpath: Toolpath, machine: Machine | Limits) -> np.ndarray:
    """Return the greatest speed that each axis reaches on every row, float64[n, axes]."""
    run = Run(toolpath, machine)
    steps_per_mm = np.array(run.limits.steps_per_mm)
    fastest = np.zeros((len(toolpath), run.limits.axes))
    for segments in run.segments():
        events_per_s = segments.unit / EIGHTHS * TICKS_PER_S / segments.cycles
        share = np.abs(segments.steps) / np.maximum(segments.events, 1)[:, None]
        np.maximum.at(fastest, segments.tag - run.first, share * events_per_s[:, None] / steps_per_mm)
    return fastest


def sample(toolpath: Toolpath, machine: Machine | Limits, times_s: np.ndarray) -> np.ndarray:
    """Return the position in steps at each of `times_s` (any order), int64[k, axes], machine coordinates."""
    clocks = np.rint(np.asarray(times_s, float) * TICKS_PER_S).astype(np.int64)
    order = np.argsort(clocks, kind="stable")
    rising = clocks[order]
    run = Run(toolpath, machine)
    positions = np.tile(run.course.planner.position, (len(clocks), 1))
    done = 0
    for segments in run.segments():
        done += int(np.searchsorted(rising[done:], segments.start[0]))
        positions_at(segments, rising[done:], positions[done:])
    answer = np.empty_like(positions)
    answer[order] = positions
    return answer


def step_events(toolpath: Toolpath, machine: Machine | Limits) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Yield every moment at which some axis steps, piece by piece: times in s, and positions in steps after it."""
    for segments in Run(toolpath, machine).segments():
        clocks, positions = step_table(segments)
        yield clocks / TICKS_PER_S, positions


def begun(toolpath: Toolpath) -> Toolpath:
    """Return the table begun at the work zero on the axes whose position is unknown, so that it has a duration."""
    pairs = zip(toolpath.start.position_mm, toolpath.states[0].offset_mm, strict=True)
    position = tuple(zero if math.isnan(known) else known for known, zero in pairs)
    return replace(toolpath, start=replace(toolpath.start, position_mm=position))


class Mark(NamedTuple):
    """A place in a pass through a table from which it can go on again."""

    chunk: int
    stops: tuple[int, int]
    dwell: np.ndarray | None  # of the row in hand, empty at a chunk's end; None where no chunk is in hand
    memory: list[np.ndarray]


class Run:
    """One pass through a table, piece by piece."""

    def __init__(self, toolpath: Toolpath, machine: Machine | Limits):
        self.toolpath = toolpath
        self.limits = machine if isinstance(machine, Limits) else Limits.of(machine)
        start_mm = toolpath.start.position_mm
        idle_ticks = round(self.limits.idle_delay_s * TICKS_PER_S)
        self.course: Course = new_course(new_planner(self.limits, start_mm), start_mm, idle_ticks)
        self.table = new_segments(SEGMENT_ROWS, self.limits.axes)
        self.stops = Stops(toolpath.states, toolpath.events, self.limits.laser)
        self.ends: np.ndarray | None = None  # ticks, kept only where the end of every row is asked for
        self._chunk = 0
        self._rows: Rows | None = None  # of the chunk in hand
        self._stops_before = self.stops.place  # that chunk

    @property
    def clock(self) -> int:
        """Ticks from the begin to the end of what has been yielded."""
        return int(self.course.cursor[0].clock)

    def segments(self) -> Iterator[np.recarray]:
        """Yield all segments, at most SEGMENT_ROWS at a time; each is valid until the next is asked for."""
        while len(piece := self.piece()):
            yield piece
        for dwell in self.stops.last():
            stand_still(self.course, dwell)

    def piece(self) -> np.recarray:
        """Return the next segments, at most SEGMENT_ROWS, valid until the next are asked for; none at the end."""
        cursor = self.course.cursor[0]
        while self._chunk < len(self.toolpath.chunks):
            rows = self._rows_in_hand()
            while cursor.row < len(rows.kind):
                if count := run_rows(self.course, rows, self.table):
                    return self.table[:count].view(np.recarray)
            if self.ends is not None:
                ends = self.ends[rows.first - self.first :][: len(rows.kind)]
                np.maximum(ends, rows.not_before, out=ends)
            self._chunk, self._rows = self._chunk + 1, None
        return self.table[: run_empty(self.course, self.table, 0)].view(np.recarray)

    def mark(self) -> Mark:
        """Return where this pass is, between two pieces."""
        row = int(self.course.cursor[0].row)
        dwell = self._rows.dwell[row : row + 1].copy() if self._rows else None
        place = self.stops.place if self._rows is None else self._stops_before
        return Mark(self._chunk, place, dwell, [memory.copy() for memory in self._memory])

    def back_to(self, mark: Mark) -> None:
        """Go on from a mark of this pass."""
        for memory, kept in zip(self._memory, mark.memory, strict=True):
            memory[:] = kept
        self._chunk, self.stops.place, self._rows = mark.chunk, mark.stops, None
        if mark.dwell is not None:
            row = int(self.course.cursor[0].row)
            self._rows_in_hand().dwell[row : row + 1] = mark.dwell
            self.course.cursor[0].row = row

    def times_s(self) -> np.ndarray:
        """Return the end time of every row in s."""
        self.ends = np.zeros(len(self.toolpath), np.int64)
        for segments in self.segments():
            ends = segments.start + segments.ticks * segments.cycles
            np.maximum.at(self.ends, segments.tag - self.first, ends)
        return np.maximum.accumulate(self.ends) / TICKS_PER_S

    @property
    def first(self) -> int:
        """The execution index of the first row."""
        return self.toolpath.chunks[0].first if self.toolpath.chunks else 0

    @property
    def _memory(self) -> list[np.ndarray]:
        """All arrays that a piece changes."""
        planner, course = self.course.planner, self.course
        known = (planner.blocks, planner.queue, planner.ramp, planner.position, planner.known)
        return [*known, planner.previous_unit, planner.unit, *course[1:]]

    def _rows_in_hand(self) -> Rows:
        """Return the rows of the chunk in hand; a chunk that is taken up is begun at its first row."""
        if self._rows is None:
            self._stops_before = self.stops.place
            self._rows = self._rows_of(self.toolpath.chunks[self._chunk])
            self.course.cursor[0].row = 0
        return self._rows

    def _rows_of(self, chunk: Chunk) -> Rows:
        kind, plane, turns = (column.astype(np.int64) for column in (chunk.kind, chunk.plane, chunk.turns))
        dwell = self.stops.before(chunk)
        speed = chunk.feed / S_PER_MIN
        return Rows(kind, chunk.end, chunk.centre, plane, turns, speed, dwell, np.zeros_like(dwell), chunk.first)


class Stops:
    """Where the firmware lets the axes come to rest: dwells, pauses and changes of spindle, coolant or offset.

    A change of spindle state always waits for the motion to end, in laser mode too; a change of speed alone
    does so unless it is a laser. A change of the work offset waits as well (grbl's
    FORCE_BUFFER_SYNC_DURING_WCO_CHANGE, on as delivered).
    """

    def __init__(self, states: list[State], events: list[Event], laser: bool):
        self.states = states
        self.laser = laser
        self.state = 0
        self.events = [event for event in events if event.kind not in RUNNING_EVENTS]
        self.next_event = 0

    @property
    def place(self) -> tuple[int, int]:
        """How far it has come: the last state and the next event."""
        return self.state, self.next_event

    @place.setter
    def place(self, place: tuple[int, int]) -> None:
        self.state, self.next_event = place

    def before(self, chunk: Chunk) -> np.ndarray:
        """Return the ticks of standstill before each row, int64[n]; -1 where the motion goes on."""
        dwell = np.full(len(chunk), -1, np.int64)
        changes = np.flatnonzero(np.diff(chunk.state, prepend=self.state))
        for change in changes:
            if self._stops(self.state, int(chunk.state[change])):
                dwell[change] = 0
            self.state = int(chunk.state[change])
        while self.next_event < len(self.events) and self.events[self.next_event].index < chunk.first + len(chunk):
            event = self.events[self.next_event]
            row = event.index - chunk.first
            dwell[row] = max(0, dwell[row]) + _dwell_ticks(event)
            self.next_event += 1
        return dwell

    def last(self) -> list[int]:
        """Return the ticks of the standstills after the last row."""
        return [_dwell_ticks(event) for event in self.events[self.next_event :] if event.kind == "dwell"]

    def _stops(self, before: int, after: int) -> bool:
        """Return whether any change of state from `before` to `after` stops the motion."""
        passed = self.states[before : after + 1] if before < after else [self.states[before], self.states[after]]
        return any(self._differ(one, other) for one, other in pairwise(passed))

    def _differ(self, one: State, other: State) -> bool:
        kept = ("spindle", "mist", "flood", "offset_mm")
        if any(getattr(one, name) != getattr(other, name) for name in kept):
            return True
        return one.spindle_rpm != other.spindle_rpm and other.spindle != "off" and not self.laser


def _dwell_ticks(event: Event) -> int:
    """Return how long the firmware waits: a dwell in whole steps of 50 ms, rounded up in 32-bit floats."""
    if event.kind != "dwell":
        return 0
    steps = math.ceil(np.float32(1.0 / DWELL_STEP_S) * np.float32(event.value))
    return round(steps * DWELL_STEP_S * TICKS_PER_S)
