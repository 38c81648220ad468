# SPDX-License-Identifier: LGPL-2.1-or-later
"""Times of a table of moves and positions of the axes, as grbl 1.1 would run it.

Everything here folds over `segments()`, which streams through a table in constant memory. Time 0 is
the time at which the first move begins.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from functools import partial
from itertools import chain, islice
from typing import NamedTuple

import numpy as np

from CNCStepper.machine.profile import Machine
from CNCStepper.motion.planner.buffers import EIGHTHS, TICKS_PER_S, new_planner, new_segments
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.planner.path_control_modes import path_modes, reaches
from CNCStepper.motion.planner.standstills import Stops
from CNCStepper.motion.planner.step_timeline import positions_at, step_table
from CNCStepper.motion.planner.table_planning import (
    Course,
    Rows,
    new_course,
    run_empty,
    run_rows,
    stand_still,
    take_ends,
)
from CNCStepper.toolpath import LINE, RAPID, Chunk, Toolpath, require_straight_axes
from CNCStepper.units import S_PER_MIN

SEGMENT_ROWS = 4096


def times_s(
    toolpath: Toolpath, machine: Machine | Limits, progress: Callable[[float], None] = lambda share: None
) -> np.ndarray:
    """Return the time in s at which every row ends, float64[n]; dwells before a row are included.

    progress: called with the share that is planned, from 0 to 1.
    """
    return times_and_whole_s(toolpath, machine, progress)[0]


def times_and_whole_s(
    toolpath: Toolpath, machine: Machine | Limits, progress: Callable[[float], None] = lambda share: None
) -> tuple[np.ndarray, float]:
    """Return what `times_s` and what `duration_s` do, from one pass: the dwells behind the last row are in the second.

    progress: called with the share that is planned, from 0 to 1.
    """
    run = Run(toolpath, machine)
    return run.times_s(progress), run.clock / TICKS_PER_S


def duration_s(
    toolpath: Toolpath, machine: Machine | Limits, progress: Callable[[float], None] = lambda share: None
) -> float:
    """Return the time in s that the whole table takes, dwells included.

    progress: called with the share that is planned, from 0 to 1.
    """
    run = Run(toolpath, machine)
    for _ in run.segments():
        progress(run.share)
    return run.clock / TICKS_PER_S


def top_speeds_mm_s(toolpath: Toolpath, machine: Machine | Limits) -> np.ndarray:
    """Return the greatest speed that each axis reaches on every row, float64[n, axes]."""
    run = Run(toolpath, machine)
    return np.concatenate([np.zeros((0, run.limits.axes)), *run.row_speeds_mm_s()])


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
    """Yield every time at which some axis steps, piece by piece: times in s, and positions in steps after it."""
    for segments in Run(toolpath, machine).segments():
        clocks, positions = step_table(segments)
        yield clocks / TICKS_PER_S, positions


def begun(toolpath: Toolpath) -> Toolpath:
    """Return the table begun at the work zero on the axes whose position is unknown, so that it has a duration.

    Such an axis rests there until its first move, which is planned like any other.
    """
    path, chunks = begun_chunks(require_straight_axes(toolpath), toolpath.chunks)
    return replace(path, chunks=list(chunks))


def begun_chunks(path: Toolpath, chunks: Iterable[Chunk]) -> tuple[Toolpath, Iterator[Chunk]]:
    """Return a table that is being read, and its chunks as they come, both as `begun` makes them of a whole one."""
    coming, before_mm = iter(chunks), path.start.position_mm
    first = list(islice(coming, 1))  # with it comes the first state
    zeros_mm = path.states[0].offset_mm if path.states else (0.0,) * len(before_mm)
    pairs = zip(before_mm, zeros_mm, strict=True)
    position_mm = tuple(zero if math.isnan(known) else known for known, zero in pairs)
    unknown = [axis for axis, place_mm in enumerate(before_mm) if math.isnan(place_mm)]
    start = replace(path.start, position_mm=position_mm)
    return Toolpath(start, [], path.states, path.events, path.spans), _known_chunks(
        chain(first, coming), unknown, position_mm
    )


def _known_chunks(chunks: Iterable[Chunk], unknown: list[int], position_mm: tuple[float, ...]) -> Iterator[Chunk]:
    """Yield chunks in which the axes that are unknown before them stand at `position_mm` until they are known."""
    for chunk in chunks:
        if unknown:
            end = chunk.end.copy()
            counts = {axis: int(np.logical_and.accumulate(np.isnan(end[:, axis])).sum()) for axis in unknown}
            for axis, count in counts.items():
                end[:count, axis] = position_mm[axis]
            unknown = [axis for axis in unknown if counts[axis] == len(chunk)]
            chunk = replace(chunk, end=end)
        yield chunk


def _without_empty_chunks(toolpath: Toolpath) -> Toolpath:
    """Return the table without chunks that hold no row: a corner looks to the first row of the next chunk."""
    chunks = toolpath.chunks
    if not isinstance(chunks, list) or all(map(len, chunks)):
        return toolpath
    return replace(toolpath, chunks=[chunk for chunk in chunks if len(chunk)])


class Mark(NamedTuple):
    """A place in a pass through a table from which the pass can resume."""

    chunk: int
    stops: tuple[int, int]
    dwell: np.ndarray | None  # of the row in hand, empty at a chunk's end; None where no chunk is in hand
    memory: list[np.ndarray]


class _RowValues:
    """A value for each row of a chunk: the greatest of its segments' so far.

    not_before: ticks, the standstill before each row, once all of them are planned.
    """

    def __init__(self, rows: Rows, shape: tuple[int, ...]):
        self.first = rows.first
        self.greatest = np.zeros((len(rows.kind), *shape), np.float64 if shape else np.int64)
        self.not_before = rows.not_before


def _take_speeds(segments: np.ndarray, first: int, greatest: np.ndarray, steps_per_mm: np.ndarray) -> None:
    """Raise the speed of each axis on the rows from `first` on, float64[n, axes] in mm/s, to that of their segments."""
    low, high = np.searchsorted(segments["tag"], (first, first + len(greatest)))
    own = segments[low:high]
    events_per_s = own["unit"] / EIGHTHS * TICKS_PER_S / own["cycles"]
    share = np.abs(own["steps"]) / np.maximum(own["events"], 1)[:, None]
    np.maximum.at(greatest, own["tag"] - first, share * events_per_s[:, None] / steps_per_mm)


class Run:
    """One pass through a table, piece by piece."""

    def __init__(self, toolpath: Toolpath, machine: Machine | Limits, forgets: bool = False):
        """forgets: the events of the table as they are passed; then the pass cannot go back to a mark."""
        self.toolpath = _without_empty_chunks(toolpath)
        self.limits = machine if isinstance(machine, Limits) else Limits.of(machine)
        start_mm = toolpath.start.position_mm
        idle_ticks = round(self.limits.idle_delay_s * TICKS_PER_S)
        self.course: Course = new_course(new_planner(self.limits, start_mm), start_mm, idle_ticks)
        self.table = new_segments(SEGMENT_ROWS, self.limits.axes)
        self.stops = Stops(toolpath.states, toolpath.events, self.limits.laser, forgets)
        self._waiting: deque[_RowValues] | None = None  # chunks whose rows are not all planned, where that is asked for
        self._value_shape: tuple[int, ...] = ()  # of each of those rows' values
        self._chunk = 0
        self._rows: Rows | None = None  # of the chunk in hand
        self._stops_before = self.stops.place  # that chunk

    @property
    def clock(self) -> int:
        """Ticks from the begin to the end of what has been yielded."""
        return int(self.course.cursor[0].clock)

    @property
    def share(self) -> float:
        """The share of the chunks that is planned, from 0 to 1."""
        return self._chunk / max(1, len(self.toolpath.chunks))

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

    def times_s(self, progress: Callable[[float], None] = lambda share: None) -> np.ndarray:
        """Return the end time of every row in s; progress: called with the share that is planned."""
        return np.concatenate([np.zeros(0), *self.row_ends_s(progress)])

    def row_ends_s(self, progress: Callable[[float], None] = lambda share: None) -> Iterator[np.ndarray]:
        """Yield the end times in s of each chunk's rows, float64[n], once no later move can change them."""
        latest = 0
        for ended in self._by_row(take_ends, (), progress):
            ends = np.maximum.accumulate(np.maximum(ended.greatest, ended.not_before))
            np.maximum(ends, latest, out=ends)
            latest = int(ends[-1])
            yield ends / TICKS_PER_S

    def row_speeds_mm_s(self) -> Iterator[np.ndarray]:
        """Yield the greatest speed of each axis on each chunk's rows, float64[n, axes], as `row_ends_s` does."""
        steps_per_mm = np.array(self.limits.steps_per_mm)
        for ended in self._by_row(partial(_take_speeds, steps_per_mm=steps_per_mm), (self.limits.axes,)):
            yield ended.greatest

    def _by_row(
        self,
        take: Callable[[np.ndarray, int, np.ndarray], None],
        shape: tuple[int, ...],
        progress: Callable[[float], None] = lambda share: None,
    ) -> Iterator[_RowValues]:
        """Yield for each chunk the greatest value that its rows' segments have; `take` takes those of further segments.

        A chunk is done once a segment of a later chunk was planned: segments come in the order of the rows.
        """
        waiting = self._waiting = deque()
        self._value_shape = shape
        for segments in self.segments():
            plain = segments.view(np.ndarray)  # its fields are found in a tenth of the time
            for one in waiting:
                take(plain, one.first, one.greatest)
            while waiting[0].first + len(waiting[0].greatest) <= plain["tag"][-1]:
                yield waiting.popleft()
            progress(self.share)
        yield from waiting

    @property
    def _memory(self) -> list[np.ndarray]:
        """All arrays that a piece changes."""
        planner, course = self.course.planner, self.course
        known = (planner.blocks, planner.queue, planner.ramp, planner.position, planner.known)
        return [*known, planner.previous_unit, planner.unit, planner.phases, *course[1:]]

    def _rows_in_hand(self) -> Rows:
        """Return the rows of the present chunk; a new chunk begins at its first row."""
        if self._rows is None:
            self._stops_before = self.stops.place
            self._rows = self._rows_of(self.toolpath.chunks[self._chunk])
            self.course.cursor[0].row = 0
            if self._waiting is not None:
                self._waiting.append(_RowValues(self._rows, self._value_shape))
        return self._rows

    def _rows_of(self, chunk: Chunk) -> Rows:
        kind, plane, turns = (column.astype(np.int64) for column in (chunk.kind, chunk.plane, chunk.turns))
        exact, allowed_mm = path_modes(self.toolpath.states, np.append(self.stops.state, chunk.state))
        dwell = self.stops.before(chunk)
        speed = chunk.feed / S_PER_MIN
        if self.limits.rapid_mm_min is not None:  # the language leaves their speed to the machine
            speed = np.where(kind == RAPID, self.limits.rapid_mm_min / S_PER_MIN, speed)
            kind = np.where(kind == RAPID, LINE, kind)
        reach, after = self._corners_of(chunk, dwell, allowed_mm[1:])
        columns = kind, chunk.end, chunk.centre, plane, turns, speed, dwell, np.zeros_like(dwell)
        return Rows(*columns, chunk.first, exact[:-1], reach, after)

    def _corners_of(self, chunk: Chunk, dwell: np.ndarray, allowed_mm: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return how far the arcs of the rows' corners reach, and where the row behind each ends."""
        if not allowed_mm.any():
            return allowed_mm, chunk.end
        begin = self.toolpath.chunks[self._chunk - 1].end[-1] if self._chunk else self.toolpath.start.position_mm
        free = np.append((chunk.kind[1:] == LINE) & (dwell[1:] < 0) & (allowed_mm[1:] > 0), False)
        after = np.vstack([chunk.end[1:], chunk.end[-1:]])
        if self._chunk + 1 < len(self.toolpath.chunks):
            follows = self.toolpath.chunks[self._chunk + 1]
            _, allowed_next_mm = path_modes(self.toolpath.states, follows.state[:1])
            free[-1] = follows.kind[0] == LINE and allowed_next_mm[0] > 0 and not self.stops.stop_before(follows)
            after[-1] = follows.end[0]
        return reaches(chunk, np.array(begin, float), after, allowed_mm, free, self.limits), after
