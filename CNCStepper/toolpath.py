# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one table of moves: a stream of chunks of columns, with states, events and spans beside it.

    chunk 0            chunk 1            ...      each at most CHUNK_ROWS rows
    +----------------+ +----------------+
    | kind           | | kind           |         states: in their order, row -> chunk.state[row]
    | end            | | end            |         events: what happens BEFORE row `index` is run
    | centre ...     | | centre ...     |         spans:  rows [first, last) that belong together
    +----------------+ +----------------+

A row is one move: from the end of the row before (the first from `start.position_mm`) to `end`.
Lengths are mm in machine coordinates (`state.py` says how they relate to work coordinates).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import accumulate, chain
from typing import Any, Protocol

import numpy as np

from CNCStepper.cancellation import checkpoint
from CNCStepper.errors import Place, ProgramError
from CNCStepper.state import Start, State, States

CHUNK_ROWS = 65_536
XYZ = 3  # axes

RAPID, LINE, ARC_CW, ARC_CCW = 0, 1, 2, 3  # kinds; the sense of an arc is seen from the positive normal
XY, ZX, YZ = 0, 1, 2  # planes: G17, G18, G19
COLUMNS = ("kind", "end", "centre", "plane", "turns", "feed", "state", "line")  # of a chunk
PLANE_NAMES = ("XY", "ZX", "YZ")
PLANE_AXES = ((0, 1, 2), (2, 0, 1), (1, 2, 0))  # first and second axis of the plane, then the normal


@dataclass(frozen=True)
class Chunk:
    """At most CHUNK_ROWS moves as columns of equal length n.

    first: execution index of row 0. kind: uint8[n]. end: float64[n, axes], mm; three axes, or X Y Z A B C U V W
    (A B C in degrees) once a row has named one of the last six. centre: float64[n, 3], mm, absolute,
    0 on rows that are no arcs (the normal axis' value is not used). plane: uint8[n].
    turns: uint16[n], 0 on lines, else the number of times the arc passes or reaches its end angle
    (P word; 1 for a plain arc and for one full circle). feed: float64[n], mm/min, 0 on rapids.
    state: int32[n], index into the states. line: int32[n], source line from 1, 0 where there is none.
    """

    first: int
    kind: np.ndarray
    end: np.ndarray
    centre: np.ndarray
    plane: np.ndarray
    turns: np.ndarray
    feed: np.ndarray
    state: np.ndarray
    line: np.ndarray

    def __len__(self) -> int:
        return len(self.kind)


@dataclass(frozen=True)
class Event:
    """Something that happens before the row with execution index `index` is run.

    kind: "dwell" (value in s), "message", "comment", "pause" (M0), "optional_pause" (M1),
    "tool_change" (value: the tool), "tool_select", "end" (M2, M30), "probe", "output",
    "material" (value: its feed in mm/min, 0 where it is not known; text: M190 and P, or its comment).
    state: index of the state in force at that moment. line: source line from 1, 0 where there is none.
    """

    index: int
    kind: str
    value: float = 0.0
    text: str = ""
    state: int = 0
    line: int = 0


@dataclass(frozen=True)
class Span:
    """Rows [first, last) that belong together: an operation, contour, pass, entry or canned cycle."""

    kind: str  # "operation", "level", "pass", "entry", "link", "contour", "cycle"
    name: str
    first: int
    last: int
    words: dict[str, float] = field(default_factory=dict)


@dataclass
class Toolpath:
    """The table of moves kept whole, for analysis; streams hand on `chunks` one by one instead.

    frame: the state whose work zero is the stock's; None: that of the first row. A part of a longer table names the
    state of that table's first row.
    """

    start: Start
    chunks: list[Chunk]
    states: Sequence[State]
    events: list[Event] = field(default_factory=list)
    spans: list[Span] = field(default_factory=list)
    frame: State | None = None
    _joined: Chunk | None = field(default=None, init=False, repr=False, compare=False)

    def __len__(self) -> int:
        return sum(len(chunk) for chunk in self.chunks)

    def table(self) -> Chunk:
        """Return all rows as one chunk, joined once; the chunks are parts of it then, so that nothing is held twice."""
        if len(self.chunks) == 1:
            return self.chunks[0]
        if self._joined is None:
            self._joined = self._join()
        return self._joined

    def _join(self) -> Chunk:
        """Join column after column, and let the chunks look into each at once: no two are held twice at any time."""
        ends = list(accumulate(map(len, self.chunks)))[:-1]
        joined = join_chunks(self.chunks[:0])
        for name in COLUMNS if self.chunks else ():
            column = np.concatenate([getattr(chunk, name) for chunk in self.chunks])
            parts = np.split(column, ends)
            self.chunks = [_with(chunk, name, part) for chunk, part in zip(self.chunks, parts, strict=True)]
            joined = _with(replace(joined, first=self.chunks[0].first), name, column)
        return joined

    def begins(self) -> np.ndarray:
        """Return the start point of every row, float64[n, axes]."""
        return begins_of(self.table(), np.asarray(self.start.position_mm, float))

    def offsets_mm(self) -> np.ndarray:
        """Return the work offset in force on every row, float64[n, 3]: work = machine - offset."""
        per_state = np.array([state.offset_mm for state in self.states], float).reshape(-1, 3)
        return per_state[self.table().state]


def chunk_of_rows(rows: list[tuple], first: int, axes: int) -> Chunk:
    """Return the chunk of rows (kind, end, centre, plane, turns, feed, state, line), each end of `axes` numbers in mm.

    first: index of the first row in the table.
    """
    kind, end, centre, plane, turns, feed, state, line = zip(*rows, strict=True) if rows else ((),) * 8
    return Chunk(
        first,
        np.array(kind, np.uint8),
        np.array(end, float).reshape(-1, axes),
        np.array(centre, float).reshape(-1, 3),
        np.array(plane, np.uint8),
        np.array(turns, np.uint16),
        np.array(feed, float),
        np.array(state, np.int32),
        np.array(line, np.int32),
    )


def join_chunks(chunks: list[Chunk]) -> Chunk:
    """Return consecutive chunks as one."""
    if not chunks:
        return TableBuilder(Start()).empty()
    return Chunk(chunks[0].first, *(np.concatenate([getattr(c, name) for c in chunks]) for name in COLUMNS))


def _with(chunk: Chunk, name: str, column: np.ndarray) -> Chunk:
    """Return a chunk with another column."""
    columns: dict[str, Any] = {name: column}
    return replace(chunk, **columns)


def begins_of(chunk: Chunk, before: np.ndarray) -> np.ndarray:
    """Return the start points of a chunk's rows, given the position `before` its first row."""
    return np.vstack([before[None, :], chunk.end[:-1]]) if len(chunk) else chunk.end.copy()


def distinct(numbers: np.ndarray) -> np.ndarray:
    """Return each number of an array once, ascending; np.unique would load masked arrays, for 6 ms."""
    ordered = np.sort(numbers)
    return ordered[np.append(True, ordered[1:] != ordered[:-1])[: len(ordered)]]


def require_straight_axes(path: Toolpath, file: str = "") -> Toolpath:
    """Return a table that can be proven, simulated and timed: of X, Y and Z, in work systems that are not turned.

    Raises ProgramError naming the line of the first row that is something else.
    """
    table = path.table()
    further = table.end.shape[1] > XYZ
    turned = np.isin(table.state, [one for one in distinct(table.state) if path.states[one].rotation_deg])
    if not further and not turned.any():
        return path
    if further:
        what = "moves of A B C U V W are read, but cannot be proven, simulated or timed"
        others = (table.end[:, 3:] != np.asarray(path.start.position_mm[3:], float)).any(axis=1)
    else:
        what = "a work system that is turned (G10 L2 R) is read, but its moves cannot be judged"
        others = turned
    line = int(table.line[np.argmax(others)]) if len(table) else 0
    advice = "leave those axes out" if further else "turn the program instead"
    raise ProgramError("axes", what, advice=advice, place=Place(file, line))


class Growing(Protocol):
    """A table that grows, as far as it says where it begins and which states it has."""

    @property
    def start(self) -> Start:
        """The start state."""

    @property
    def states(self) -> Sequence[State]:
        """The states so far."""


def straight_chunks(chunks: Iterable[Chunk], table: Growing, file: str = "") -> Iterator[Chunk]:
    """Yield the chunks of a table that grows with them, each checked as `require_straight_axes` does."""
    coming = iter(chunks)
    for chunk in coming:
        if chunk.end.shape[1] > XYZ:
            stood = np.asarray(table.start.position_mm[XYZ:], float)
            moved = (one for one in chain([chunk], coming) if (one.end[:, XYZ:] != stood).any())
            chunk = next(moved, chunk)  # the row that moves a further axis may be in a later chunk
        require_straight_axes(Toolpath(table.start, [chunk], table.states), file)
        yield chunk


class TableBuilder:
    """Grows a table row by row: the one way in which cycles and the interpreter make moves.

    `take()` hands out what is complete and forgets it, so that a stream stays flat in memory;
    `toolpath()` ends the building and returns the whole.
    """

    def __init__(self, start: Start, state: State | None = None):
        self.start = start
        self.axes = len(start.position_mm)
        self.states = States([state or State()])
        self.events: list[Event] = []
        self.spans: list[Span] = []
        self.index = 0  # execution index of the next row
        self._open_spans: list[tuple[str, str, int, dict[str, float]]] = []
        self._rows: list[tuple] = []  # of the chunk being made, after its pieces
        self._pieces: list[Chunk] = []
        self._begin = 0  # index of that chunk's first row
        self._chunks: list[Chunk] = []

    @property
    def state(self) -> State:
        """The state that the next row will name."""
        return self.states[-1]

    @property
    def position_mm(self) -> tuple[float, ...]:
        """Where the last row that is not taken yet ended; the start's position where there is none."""
        if self._rows:
            return tuple(map(float, self._rows[-1][1]))
        chunks = self._pieces or self._chunks
        return tuple(chunks[-1].end[-1].tolist()) if chunks else tuple(self.start.position_mm)

    def set_state(self, state: State) -> None:
        """Let the rows from here on name `state`; nothing happens when it is the one in force."""
        if state != self.states[-1]:
            self.states.append(state)

    def rapid(self, end_mm: Iterable[float], line: int = 0) -> None:
        """Add a rapid to `end_mm` (all axes)."""
        self._row(RAPID, end_mm, (0.0, 0.0, 0.0), XY, 0, 0.0, line)

    def feed(self, end_mm: Iterable[float], feed_mm_min: float, line: int = 0) -> None:
        """Add a straight feed move to `end_mm` (all axes)."""
        self._row(LINE, end_mm, (0.0, 0.0, 0.0), XY, 0, feed_mm_min, line)

    def arc(
        self,
        kind: int,
        end_mm: Iterable[float],
        centre_mm: Iterable[float],
        feed_mm_min: float,
        plane: int = XY,
        turns: int = 1,
        line: int = 0,
    ) -> None:
        """Add an arc or helix; `kind` is ARC_CW or ARC_CCW, `centre_mm` absolute in all three axes."""
        self._row(kind, end_mm, centre_mm, plane, turns, feed_mm_min, line)

    def event(self, kind: str, value: float = 0.0, text: str = "", line: int = 0) -> None:
        """Note what happens before the next row."""
        self.events.append(Event(self.index, kind, value, text, len(self.states) - 1, line))

    def open_span(self, kind: str, name: str, **words: float) -> None:
        """Begin a span at the next row; spans nest."""
        self._open_spans.append((kind, name, self.index, words))

    def close_span(self) -> None:
        """End the innermost open span."""
        kind, name, first, words = self._open_spans.pop()
        self.spans.append(Span(kind, name, first, self.index, words))

    def span_marks(self, kind: str) -> Iterator[int]:
        """Yield the rows at which spans of a kind begin and end, as far as they have."""
        for span in self.spans:
            if span.kind == kind:
                yield from (span.first, span.last)
        yield from (first for open_kind, _, first, _ in self._open_spans if open_kind == kind)

    def add_span(self, kind: str, name: str, first: int, last: int) -> None:
        """Note a span of rows that are there already."""
        self.spans.append(Span(kind, name, first, last))

    def add_cuts(self, kind: np.ndarray, end: np.ndarray, centre: np.ndarray, feed_mm_min: float | np.ndarray) -> None:
        """Add feed moves and arcs in the XY plane as columns of a chunk; they name the state that is in force here.

        feed_mm_min: of all rows, or of each.
        """
        first, feeds = 0, np.broadcast_to(np.asarray(feed_mm_min, float), len(kind))
        while first < len(kind):
            some = slice(first, first + self.room)
            count = len(kind[some])
            none, state = np.zeros(count, np.uint8), np.full(count, len(self.states) - 1, np.int32)
            turns, feed = (kind[some] != LINE).astype(np.uint16), feeds[some].copy()
            self.extend((kind[some], end[some], centre[some], none, turns, feed, state, none.astype(np.int32)))
            first += count

    def append(self, path: Toolpath) -> None:
        """Add the rows, events and spans of a toolpath; its first state is the one in force here.

        Its other states differ from that one by their spindle alone: a torch, a beam or a wire switched on and off.
        """
        first, places = self.index, self._places_of(path.states)
        self._flush()
        for chunk in path.chunks:
            if len(chunk):
                self._chunks.append(replace(chunk, first=self.index, state=places[chunk.state]))
                self.index = self._begin = self.index + len(chunk)
        self.events += [
            replace(event, index=event.index + first, state=int(places[event.state])) for event in path.events
        ]
        self.spans += [replace(span, first=span.first + first, last=span.last + first) for span in path.spans]

    def _places_of(self, states: Sequence[State]) -> np.ndarray:
        """Add a toolpath's states behind the one in force, and return their numbers here as int32[n]."""
        base, places = self.state, [len(self.states) - 1]
        for state in list(states)[1:]:
            self.set_state(replace(base, spindle=state.spindle, spindle_rpm=state.spindle_rpm))
            places.append(len(self.states) - 1)
        return np.array(places, np.int32)

    @property
    def room(self) -> int:
        """How many rows the chunk that is being made still takes, from 1 to CHUNK_ROWS."""
        return CHUNK_ROWS - (self.index - self._begin)

    def extend(self, columns: tuple[np.ndarray, ...]) -> None:
        """Add at most `room` rows as whole columns in the order of `Chunk`, which keeps the arrays.

        Their states stand in the table already.
        """
        checkpoint()
        if len(columns[0]):
            self._collect()
            self._pieces.append(Chunk(self.index, *columns))
            self.index += len(columns[0])
            if self.index - self._begin == CHUNK_ROWS:
                self._flush()

    def take_whole(self) -> list[Chunk]:
        """Return the whole chunks made since the last call and forget them; the one being made stays."""
        chunks, self._chunks = self._chunks, []
        return chunks

    def take(self) -> list[Chunk]:
        """Return the rows made since the last call, as chunks, and forget them."""
        self._flush()
        return self.take_whole()

    def forget(self) -> None:
        """Forget whole chunks, events and spans, for who only wants to know where the rows lead."""
        self._chunks.clear()
        self.events.clear()
        self.spans.clear()

    def toolpath(self) -> Toolpath:
        """Return all rows not yet taken as a Toolpath."""
        while self._open_spans:
            self.close_span()
        chunks = self.take() or [self.empty()]
        return Toolpath(self.start, chunks, self.states, self.events, self.spans)

    def empty(self) -> Chunk:
        """Return a chunk without rows."""
        return chunk_of_rows([], 0, self.axes)

    def _row(self, kind, end_mm, centre_mm, plane, turns, feed_mm_min, line) -> None:
        checkpoint()
        end = tuple(end_mm)
        if len(end) > self.axes:
            self._widen(len(end))
        self._rows.append((kind, end, tuple(centre_mm), plane, turns, feed_mm_min, len(self.states) - 1, line))
        self.index += 1
        if self.index - self._begin == CHUNK_ROWS:
            self._flush()

    def _widen(self, axes: int) -> None:
        """Let rows have `axes` ends; in the rows not yet taken the new axes stand where they start, at 0."""
        self._flush()
        more = (0.0,) * (axes - self.axes)
        for index, chunk in enumerate(self._chunks):
            self._chunks[index] = replace(chunk, end=np.hstack([chunk.end, np.tile(more, (len(chunk), 1))]))
        self.start = replace(self.start, position_mm=(*self.start.position_mm, *more))
        self.axes = axes

    def _collect(self) -> None:
        """Make a piece of the single rows."""
        if self._rows:
            self._pieces.append(chunk_of_rows(self._rows, self.index - len(self._rows), self.axes))
            self._rows = []

    def _flush(self) -> None:
        self._collect()
        if self._pieces:
            self._chunks.append(self._pieces[0] if len(self._pieces) == 1 else join_chunks(self._pieces))
            self._pieces = []
        self._begin = self.index
