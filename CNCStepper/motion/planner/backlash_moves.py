# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the moves of the tool to those of motors whose axes have play, and back.

    tool     A ──► B ◄── C           the axis turns back at B
    motors   A ──► B ─► B' ──► C'    B to B': taken up at the move's feed while the tool stands still; then beside it

Arcs are cut where an axis turns back, so that on every row each motor goes one way. `tool_moves` knows nothing of
how the rows were made: it moves the tool only where a side of its gap pushes it, so that it is a proof of the rows.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import pairwise

import numpy as np

from CNCStepper.gcode.wire.monotonic_split import Piece, arc_pieces, straight_pieces
from CNCStepper.kernels import njit
from CNCStepper.machine.backlash import Backlash, Motors
from CNCStepper.machine.profile import Machine
from CNCStepper.motion.planner.chunk_window import ChunkWindow
from CNCStepper.motion.planner.plan import duration_s, times_s
from CNCStepper.tolerances import SAME_SUM_MM
from CNCStepper.toolpath import (
    CHUNK_ROWS,
    COLUMNS,
    LINE,
    RAPID,
    XY,
    Chunk,
    Event,
    Toolpath,
    begins_of,
    chunk_of_rows,
    join_chunks,
)

LEAST_RUN = 32  # straight rows in a run from which on the compiled way is the faster one

Row = tuple[int, tuple[float, ...], tuple[float, ...], int, int, float, int, int]  # the columns of a chunk


def motor_moves(path: Toolpath, play: Backlash) -> Toolpath:
    """Return the moves of the motors that lead the tool along `path`: three axes, with rows that take up play.

    Rows name the state and the line of the row that they come from; events and spans go with it. A path of machines
    without play is returned as it is.
    """
    return _motor_moves(path, play)[0] if play else path


def row_times_s(path: Toolpath, machine: Machine, play: Backlash | None = None) -> np.ndarray:
    """Return the time in s at which every row of the tool's path ends, float64[n], with all backlash moves."""
    if not play:
        return times_s(path, machine)
    motors, firsts = _motor_moves(path, play)
    ends_s = np.concatenate([[0.0], times_s(motors, machine)])
    return ends_s[firsts[1:] - firsts[0]]


def way_duration_s(path: Toolpath, chunks: Iterable[Chunk], machine: Machine, play: Backlash | None = None) -> float:
    """Return the time in s of the tool's path, with dwells and all backlash moves.

    path, chunks: as of `motor_chunks`; no more than two of the chunks are kept.
    """
    if play:
        path, chunks = motor_chunks(path, chunks, play)
    return duration_s(replace(path, chunks=ChunkWindow(chunks)), machine)  # type: ignore[arg-type]


def motor_chunks(path: Toolpath, chunks: Iterable[Chunk], play: Backlash) -> tuple[Toolpath, Iterator[Chunk]]:
    """Return the motors' table, still without rows, and its chunks, made as those of a table that is being read come.

    path: that table, whose events grow while it is read; those of the motors' table do so with its chunks.
    """
    events: list[Event] = []

    def coming() -> Iterator[Chunk]:
        seen = last = 0
        for first, firsts, motors in _folded(chunks, path.start.position_mm, play):
            last, end = int(firsts[-1]), first + len(firsts) - 1
            while seen < len(path.events) and path.events[seen].index < end:
                event = path.events[seen]
                events.append(replace(event, index=int(firsts[event.index - first])))
                seen += 1
            yield from motors
        events.extend(replace(event, index=last) for event in path.events[seen:])

    return Toolpath(path.start, [], path.states, events), coming()


def _motor_moves(path: Toolpath, play: Backlash) -> tuple[Toolpath, np.ndarray]:
    """Return the motors' moves, and for each row of the tool's the first of them; one more is where they end."""
    chunks: list[Chunk] = []
    begin = path.chunks[0].first if path.chunks else 0
    firsts = np.full(len(path) + 1, begin, np.int64)
    for first, some, motors in _folded(path.chunks, path.start.position_mm, play):
        firsts[first - begin :][: len(some)] = some
        chunks += motors
    moved = {index: int(firsts[index - begin]) for index in _named(path)}
    events = [replace(event, index=moved[event.index]) for event in path.events]
    spans = [replace(span, first=moved[span.first], last=moved[span.last]) for span in path.spans]
    return Toolpath(path.start, chunks, path.states, events, spans), firsts


def _folded(
    chunks: Iterable[Chunk], start_mm: tuple[float, ...], play: Backlash
) -> Iterator[tuple[int, np.ndarray, list[Chunk]]]:
    """Yield for each chunk the index of its first row, of each row the motors' first and one more, and their chunks."""
    motors, begin = Motors(play, start_mm), np.array(start_mm, float)
    count: int | None = None
    for chunk in chunks:
        count = chunk.first if count is None else count
        rows, firsts = _rows_of_chunk(motors, chunk, begin)
        yield chunk.first, count + firsts, list(_chunks(rows, count))
        count += len(rows)
        begin = chunk.end[-1] if len(chunk) else begin


def _rows_of_chunk(motors: Motors, chunk: Chunk, begin: np.ndarray) -> tuple[Chunk, np.ndarray]:
    """Return the motors' rows of a chunk that begins at `begin`, and of each of its rows the first; one more is all."""
    parts, counts = [chunk_of_rows([], 0, axes=3)], [np.zeros(1, np.int64)]
    for part, some in _motor_parts(motors, chunk, begins_of(chunk, begin)):
        parts.append(part)
        counts.append(some)
    return join_chunks(parts), np.cumsum(np.concatenate(counts))


def _motor_parts(motors: Motors, chunk: Chunk, begins: np.ndarray) -> Iterator[tuple[Chunk, np.ndarray]]:
    """Yield the motors' rows of some of the chunk's rows after the other, and how many each of them became."""
    in_run = _in_long_run(chunk.kind)
    bounds = [0, *(np.flatnonzero(np.diff(in_run)) + 1).tolist(), len(chunk)]
    for first, stop in pairwise(bounds):
        if not in_run[first:stop].any():
            yield _single_rows(motors, _part(chunk, first, stop), begins[first:stop])
            continue
        while first < stop:
            part, counts = _straight_rows(motors, _part(chunk, first, stop), begins[first:stop])
            yield part, counts
            first += len(counts)
            if first < stop:  # this one comes from an unknown place
                yield _single_rows(motors, _part(chunk, first, first + 1), begins[first : first + 1])
                first += 1


def _in_long_run(kind: np.ndarray) -> np.ndarray:
    """Return for each row whether it is straight and so are LEAST_RUN rows around it, in one run."""
    straight = (kind == RAPID) | (kind == LINE)
    bounds = np.concatenate([[0], np.flatnonzero(np.diff(straight)) + 1, [len(kind)]])
    lengths = np.diff(bounds)
    return np.repeat(lengths >= LEAST_RUN, lengths) & straight


def _part(chunk: Chunk, first: int, stop: int) -> Chunk:
    """Return some rows of a chunk."""
    return Chunk(chunk.first + first, *(getattr(chunk, name)[first:stop] for name in COLUMNS))


def _straight_rows(motors: Motors, chunk: Chunk, begins: np.ndarray) -> tuple[Chunk, np.ndarray]:
    """Return the motors' rows of straight rows up to one from an unknown place, and how many each became."""
    play, at_mm = motors.play, np.array(motors.at_mm)
    before, after, crosses = np.empty_like(chunk.end), np.empty_like(chunk.end), np.zeros(len(chunk), np.bool_)
    limits = np.array(play.backlash_mm, float), np.array(play.true_sense), np.array(play.steps_per_mm, float)
    count = _follow(begins, chunk.end, limits, at_mm, before, after, crosses)
    motors.at_mm = at_mm.tolist()
    counts = 1 + crosses[:count].astype(np.int64)
    rows = _part(replace(chunk, end=after), 0, count)
    every = Chunk(chunk.first, *(np.repeat(getattr(rows, name), counts, axis=0) for name in COLUMNS))
    taking = (np.cumsum(counts) - counts)[crosses[:count]]
    rapid = np.ones(len(taking), np.bool_) if play.beam else every.kind[taking] == RAPID
    every.kind[taking] = np.where(rapid, RAPID, LINE)
    every.end[taking] = before[:count][crosses[:count]]
    every.centre[taking], every.plane[taking] = 0.0, XY
    every.feed[taking] = np.where(rapid, 0.0, every.feed[taking])
    return every, counts


@njit
def _follow(begins, ends, limits, at_mm, before, after, crosses):
    """Do `Motors.go` for straight moves up to one that comes from an unknown place; return how many were done."""
    backlash_mm, true_sense, steps_per_mm = limits
    axes = len(at_mm)
    for row in range(len(ends)):
        for axis in range(axes):
            if np.isnan(begins[row, axis]) and not np.isnan(ends[row, axis]) and backlash_mm[axis] != 0.0:
                return row
        for axis in range(axes):
            begin, end, now = begins[row, axis], ends[row, axis], at_mm[axis]
            before[row, axis] = after[row, axis] = now
            if np.isnan(end):
                continue
            if np.isnan(begin) or np.isnan(now):
                after[row, axis] = end
                continue
            scale = steps_per_mm[axis]
            forwards = np.floor(end * scale + 0.5) - np.floor(begin * scale + 0.5)
            if forwards == 0.0:
                after[row, axis] = end + (now - begin)
                continue
            sense = 1 if forwards > 0.0 else -1
            ahead = 0.0 if sense == true_sense[axis] else sense * backlash_mm[axis]
            before[row, axis], after[row, axis] = begin + ahead, end + ahead
            if abs(before[row, axis] - now) > SAME_SUM_MM:
                crosses[row] = True
        for axis in range(axes):
            at_mm[axis] = after[row, axis]
    return len(ends)


def _single_rows(motors: Motors, chunk: Chunk, begins: np.ndarray) -> tuple[Chunk, np.ndarray]:
    """Return the motors' rows of rows of any kind, and how many each became."""
    rows: list[Row] = []
    counts = np.empty(len(chunk), np.int64)
    names = ("kind", "centre", "plane", "turns", "feed", "state", "line")
    columns = (getattr(chunk, name).tolist() for name in names)
    places = (map(tuple, column.tolist()) for column in (begins, chunk.end))
    for number, row in enumerate(zip(*places, *columns, strict=True)):
        before = len(rows)
        rows += _rows_of(motors, *row)
        counts[number] = len(rows) - before
    return chunk_of_rows(rows, 0, axes=3), counts


def _named(path: Toolpath) -> set[int]:
    """Return the rows that events and spans name."""
    return {event.index for event in path.events} | {row for span in path.spans for row in (span.first, span.last)}


def _rows_of(motors: Motors, begin, end, kind, centre, plane, turns, feed, state, line) -> Iterator[Row]:
    """Yield the motors' rows of one of the tool's."""
    straight = kind in (RAPID, LINE)
    pieces = (
        straight_pieces(motors.play, begin, end)
        if straight
        else arc_pieces(motors.play, begin, end, centre, kind, plane, turns)
    )
    for piece in pieces:
        before = motors.go(piece.begin_mm, piece.end_mm)
        if before is not None:
            as_rapid = kind == RAPID or motors.play.beam
            yield RAPID if as_rapid else LINE, before, (0.0, 0.0, 0.0), XY, 0, 0.0 if as_rapid else feed, state, line
        place = tuple(centre) if straight else _beside(centre, piece, motors.at_mm)
        yield kind, tuple(motors.at_mm), place, plane, piece.turns, feed, state, line


def _beside(centre, piece: Piece, motors_mm: list[float]) -> tuple[float, ...]:
    """Return the centre about which the motors turn: as far from the tool's as they are from the tool."""
    return tuple(
        place if motor != motor else place + motor - end  # the place of an axis beside the plane may be unknown
        for place, motor, end in zip(centre, motors_mm, piece.end_mm, strict=True)
    )


def _chunks(rows: Chunk, first: int) -> Iterator[Chunk]:
    """Yield rows as chunks of which the first begins with row `first` of the table."""
    for begin in range(0, max(len(rows), 1), CHUNK_ROWS):
        yield replace(_part(rows, begin, begin + CHUNK_ROWS), first=first + begin)


def tool_moves(path: Toolpath, play: Backlash) -> Toolpath:
    """Return where the tool goes while the motors go along `path`: the same rows, of which some do not move it.

    An axis' tool stands from `motor - ahead(+)` to `motor - ahead(-)`, and where neither side pushes it, it stays. At
    the begin, and where it comes from an unknown place, it is taken to stand where the motor does.
    """
    if not play:
        return path
    tool = ToolMoves(play, path.start.position_mm)
    return replace(path, chunks=[tool.moved(chunk) for chunk in path.chunks])


class ToolMoves:
    """Where the tool goes while the motors go along chunks, one after the other; as `tool_moves` has it."""

    def __init__(self, play: Backlash, start_mm: tuple[float, ...]):
        self._pushed_up, self._pushed_down = (
            np.array([play.ahead_mm(axis, sense) for axis in range(len(play.backlash_mm))]) for sense in (1, -1)
        )
        self._tool = np.array(start_mm, float)

    def moved(self, chunk: Chunk) -> Chunk:
        """Return the tool's rows of the motors' next chunk."""
        end = np.empty_like(chunk.end)
        _push(chunk.end, self._pushed_up, self._pushed_down, self._tool, end)
        shift = np.nan_to_num(end - chunk.end)
        centre = chunk.centre + np.where((chunk.kind > LINE)[:, None], shift, 0.0)
        return replace(chunk, end=end, centre=centre)


@njit
def _push(motors, pushed_up, pushed_down, tool, ends):
    """Write the tool's position after each row; `tool` is its position before the first, and then after all."""
    for row in range(len(motors)):
        for axis in range(len(tool)):
            low, high = motors[row, axis] - pushed_up[axis], motors[row, axis] - pushed_down[axis]
            if np.isnan(tool[axis]):
                tool[axis] = motors[row, axis]
            elif np.isnan(low) or tool[axis] < low:
                tool[axis] = low
            elif tool[axis] > high:
                tool[axis] = high
            ends[row, axis] = tool[axis]
