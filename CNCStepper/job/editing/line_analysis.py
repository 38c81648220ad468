# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program as an editor needs it: every line that is refused, and the modal state after each line of the others.

A refused line changes nothing, so reading goes on after it. Plain programs go through the compiled path; where a
program has O-words its lines are read in the order in which they are run, and of a line that is run again the last
time counts.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.dialects import dialect_named
from CNCStepper.gcode.interpreter.fast_path.compiled_reader import CompiledReader
from CNCStepper.gcode.interpreter.flow.flow_line_parser import has_profile, is_plain
from CNCStepper.gcode.interpreter.flow.run_with_subroutines import Flow, Limits
from CNCStepper.gcode.interpreter.flow.subprogram_files import library_of
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.interpreter.state.interpreter_state import Point
from CNCStepper.gcode.syntax.words import is_percent_mark, split_line, words_of
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.gcode.wire.expansion import is_expanded
from CNCStepper.state import Start, State
from CNCStepper.toolpath import Toolpath
from CNCStepper.units import MM_PER_INCH

LINES_AT_ONCE = 4096
SHORT = 2000
MOST_TOLD = 1000  # refusals that are listed; all are counted
MOST_ITERATIONS = 100_000  # refusals of lines that are run again and again
_FEED = re.compile(r"[ \t]*(?:N[0-9]+[ \t]*)?F", re.IGNORECASE)


class Abandoned(Exception):
    """Raised when the answer is no longer wanted."""


class Note(NamedTuple):
    """What held after a line: the modal state, and how many rows the table had."""

    state: State
    rows: int


class After(NamedTuple):
    """What holds after a line. work_mm: where the tool is, NaN where not known; row: the last move, -1 for none."""

    state: State
    work_mm: Point
    row: int


@dataclass
class Reading:
    """What was read of a program: its lines, the table of moves, and why lines are refused, in the order of the lines.

    refused: how many lines are, of which at most MOST_TOLD are listed.
    """

    lines: list[str]
    toolpath: Toolpath
    refusals: list[ProgramError]
    refused: int
    in_order: bool
    notes: dict[int, Note]
    _note_lines: list[int] = field(init=False)
    _row_lines: np.ndarray = field(init=False)
    _row_order: np.ndarray = field(init=False)

    def __post_init__(self) -> None:
        self.table = self.toolpath.table()
        self._note_lines = sorted(self.notes)
        self._row_order = np.argsort(self.table.line, kind="stable")
        self._row_lines = self.table.line[self._row_order]

    def rows_of(self, line: int) -> np.ndarray:
        """Return the rows that a line makes, in the order in which they are run."""
        first, last = np.searchsorted(self._row_lines, [line, line + 1])
        return self._row_order[first:last]

    def after(self, line: int) -> After | None:
        """Return what holds after a line; None for one that is not run."""
        note = self._note_before(line)
        row = self._row_before(line)
        if not self.in_order and line not in self.notes:
            return None
        if note is None or (self.in_order and row >= note.rows):
            state = self.toolpath.states[int(self.table.state[row])] if row >= 0 else self.toolpath.states[0]
        else:
            state, row = note.state, note.rows - 1
        return After(self._with_feed(state, line, row), self._work_mm(state, row), row)

    def _note_before(self, line: int) -> Note | None:
        at = bisect_right(self._note_lines, line)
        return self.notes[self._note_lines[at - 1]] if at else None

    def _row_before(self, line: int) -> int:
        at = int(np.searchsorted(self._row_lines, line, side="right"))
        return int(self._row_order[at - 1]) if at else -1

    def _with_feed(self, state: State, line: int, row: int) -> State:
        """Return the state with the feed of lines that hold nothing else, after the last move."""
        moved = int(self.table.line[row]) if row >= 0 else 0
        for number in range(line, max(moved, line - LINES_AT_ONCE), -1):
            if number in self.notes:
                break
            text = self.lines[number - 1] if number <= len(self.lines) else ""
            if _FEED.match(text):
                scale = MM_PER_INCH if state.units == "inch" else 1.0
                feeds = [float(word.number) for word in words_of(split_line(text).code) if word.letter == "F"]
                return replace(state, feed_mm_min=feeds[-1] * scale)
        return state

    def _work_mm(self, state: State, row: int) -> Point:
        """Return where the tool is after a row, in work coordinates."""
        place = self.table.end[row] if row >= 0 else np.asarray(self.toolpath.start.position_mm, float)
        x, y, z = (float(place[axis]) - state.offset_mm[axis] for axis in range(3))
        if state.rotation_deg:
            turned = complex(x, y) * np.exp(-1j * np.radians(state.rotation_deg))
            x, y = turned.real, turned.imag
        return x, y, z


def read_program(
    lines: list[str], start: Start | None, dialect: str, file: str = "", go_on: Callable[[], bool] = lambda: True
) -> Reading:
    """Read a program to its end, past all refusals.

    go_on: polled; Abandoned is raised when it returns False.
    """
    reader = _Listener(start, dialect, file)
    refusals = _Refusals(reader, file)
    text = "\n".join(lines)
    in_order = not reader.dialect.o_words or (is_plain(text) and not has_profile(text))
    steps = _in_order(reader, lines, refusals) if in_order else _as_run(reader, lines, refusals)
    for _ in steps:
        if not go_on():
            raise Abandoned
    try:
        toolpath = reader.toolpath()
    except ProgramError as error:
        refusals.add(error)
        toolpath = reader.table.toolpath()
    found = sorted(refusals.found, key=lambda error: error.place.line if error.place else 0)
    return Reading(lines, toolpath, found, refusals.count, in_order, reader.notes)


def unsendable(
    lines: list[str], dialect: str, file: str, start: Start | None, go_on: Callable[[], bool]
) -> list[ProgramError]:
    """Return why lines that can be read cannot be sent, of many bad ones some; raises Abandoned."""
    if is_expanded("\n".join(lines), dialect_named(dialect)):
        return _unsendable(lines, dialect, file, start)
    found: list[ProgramError] = []
    for first in range(0, len(lines), LINES_AT_ONCE):
        if not go_on():
            raise Abandoned
        piece = lines[first : first + LINES_AT_ONCE]
        for error in _unsendable(piece, dialect, file, start):
            place = error.place or Place(file)
            found.append(error.at(replace(place, line=place.line + first)))  # type: ignore[arg-type]
        if first and any(map(is_percent_mark, piece)):
            break  # text after a second "%" is not sent
    return found


def _unsendable(lines: list[str], dialect: str, file: str, start: Start | None) -> list[ProgramError]:
    try:
        prepare("\n".join(lines) + "\n", dialect, file, start)
    except ProgramError as error:
        return [error]
    return []


class _Listener(Interpreter):
    """An interpreter that notes what holds after each line that it reads itself."""

    def __init__(self, start: Start | None, dialect: str, file: str):
        super().__init__(start, dialect, file)
        self.notes: dict[int, Note] = {}

    def line(self, text: str) -> None:
        """Read the next line and note what holds after it."""
        super().line(text)
        self.notes[self.line_number] = Note(self.model.state, self.table.index)


class _Refusals:
    """The refusals so far, those of lines that are run again once."""

    def __init__(self, reader: Interpreter, file: str):
        self._reader, self._file = reader, file
        self.found: list[ProgramError] = []
        self._seen: set[tuple[int, str]] = set()
        self._rounds = 0

    @property
    def count(self) -> int:
        """How many there are."""
        return len(self._seen)

    def add(self, error: ProgramError) -> None:
        """Keep one; raises it where the same lines are refused without end."""
        self._rounds += 1
        error = self._here(error)
        key = (error.place.line if error.place else 0, str(error))
        if key not in self._seen:
            self._seen.add(key)
            if len(self.found) < MOST_TOLD:
                self.found.append(error)
        if self._rounds == MOST_ITERATIONS:
            raise error

    def _here(self, error: ProgramError) -> ProgramError:
        """Return a refusal with a place in this text: one of a subroutine's file is put where it is called."""
        place = error.place
        if place is None or place.file == self._file:
            return error
        what = Text("{place}: {error}", place=place, error=error.what)
        here = Place(self._file, self._reader.line_number, 1)
        words = {"advice": error.advice, "value": error.value, "limit": error.limit}
        return ProgramError(error.code, what, place=here, **words)


def _in_order(reader: Interpreter, lines: list[str], refusals: _Refusals) -> Iterator[None]:
    """Read line after line; few lines without the compiled path, which may have to be compiled first."""
    if len(lines) <= SHORT:
        for line in lines:
            try:
                reader.line(line)
            except ProgramError as refusal:
                refusals.add(refusal)
        yield
        return
    fast = CompiledReader(reader)
    for first in range(0, len(lines), LINES_AT_ONCE):
        piece = "\n".join(lines[first : first + LINES_AT_ONCE]) + "\n"
        for error in fast.refused(piece.encode("utf-8", "surrogatepass")):
            refusals.add(error)
        yield


def _as_run(reader: Interpreter, lines: list[str], refusals: _Refusals) -> Iterator[None]:
    """Read the lines as O-words lead."""
    flow = _Flow(reader, lines, library_of(reader.file, reader.table.start), Limits())
    flow.refuse = refusals.add
    try:
        for count, _ in enumerate(flow.run()):
            if count % LINES_AT_ONCE == 0:
                yield
    except ProgramError as error:
        refusals.add(error)


class _Flow(Flow):
    """The flow through a program that continues after a refused line."""

    refuse: Callable[[ProgramError], None]

    def _line(self, text: str) -> None:
        try:
            super()._line(text)
        except ProgramError as error:
            self.refuse(error)
