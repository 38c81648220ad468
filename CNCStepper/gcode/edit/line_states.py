# SPDX-License-Identifier: LGPL-2.1-or-later
"""The state at each executed line of a program: the modes in force and the tool's position."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from CNCStepper.errors import Place, ProgramError
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.dialects.codes import MOTION_NAMES
from CNCStepper.gcode.edit.edit_result import Lines
from CNCStepper.gcode.edit.line_tokens import Token, tokens_of
from CNCStepper.gcode.interpreter.flow.flow_line_parser import is_plain, leads, names_blocks
from CNCStepper.gcode.interpreter.flow.run_with_subroutines import Flow, Limits
from CNCStepper.gcode.interpreter.flow.subprogram_files import library_of
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.syntax.words import is_percent_mark, program_lines, split_line
from CNCStepper.state import UNKNOWN, Start
from CNCStepper.toolpath import Toolpath

WITHOUT_CYCLES = "write its passes as moves: make the program again with canned = false"
EXPAND = "expand it first: cncstepper convert"
_READS_PLACE = re.compile(r"#\s*(?:5[0-9]{3}(?![0-9])|<\s*_)")


class Meaning(NamedTuple):
    """The modes after a line's own codes, and the place before it.

    units, feed_units: of lengths and of F. motion: by name, "G80" for none. begin: work coordinates in mm, NaN where
    unknown. compensated: whether a compensation of the tool's radius is on. diameter: whether X words are diameters.
    """

    units: str
    feed_units: str
    absolute: bool
    absolute_centres: bool
    plane: str
    motion: str
    inverse_time: bool
    compensated: bool
    diameter: bool
    begin: tuple[float, ...]

    @property
    def modes(self) -> tuple:
        """All but the place."""
        return self[:-1]


IN_OTHER_BLOCKS = "the profile of this cycle is in other blocks, which are not rewritten with it"


class Source:
    """A program that is to be edited: its lines, what each means, and its table of moves.

    meanings: None for lines that are not executed. firsts: the row that each line makes first, and one more; empty for
    a program with O-words. doubtful: lines that are executed in different modes. Raises ProgramError for a text that
    the interpreter refuses.
    """

    def __init__(self, text: str, dialect: str | Dialect = "grbl", start: Start | None = None, file: str = ""):
        self.dialect = dialect_named(dialect)
        self.start = start
        self.file = file
        self.lines = Lines(text)
        self.meanings: list[Meaning | None] = [None] * len(self.lines.lines)
        self.doubtful: set[int] = set()
        self.firsts: list[int] = []
        self.toolpath = self._read(text)

    def __iter__(self) -> Iterator[tuple[int, str, Meaning | None]]:
        """Yield (line number from 1, text, meaning or None where the line is not executed)."""
        yield from zip(range(1, len(self.meanings) + 1), self.lines.lines, self.meanings, strict=True)

    def tokens(self, number: int) -> list[Token]:
        """Return the words of a line; raises ProgramError where there is more than words."""
        try:
            return tokens_of(self.lines.lines[number - 1])
        except ProgramError as error:
            raise self.refusal(
                number, error.code, error.what, error.place.column if error.place else 0, advice=error.advice
            ) from None

    def refusal(
        self, number: int, code: str, what: str, column: int = 1, value: str = "", *, advice: str
    ) -> ProgramError:
        """Return the error that names a line and column."""
        return ProgramError(code, what, value=value, advice=advice, place=Place(self.file, number, column))

    def _read(self, text: str) -> Toolpath:
        reader = Interpreter(self.start, self.dialect, self.file)
        for number, line in enumerate(self.lines.lines, start=1):
            self._check(number, line)
        if has_flow(text, self.dialect):
            self._follow(reader)
        else:
            self._go_straight(reader)
        return reader.toolpath()

    def _go_straight(self, reader: Interpreter) -> None:
        """Read line after line."""
        for number, line in enumerate(self.lines.lines, start=1):
            units, begin, runs = reader.model.state.units, work_place(reader), not reader.ended
            self.firsts.append(reader.table.index)
            reader.line(line)
            skipped = is_percent_mark(line) or (self.dialect.skips_deleted and split_line(line).deleted)
            if runs and not skipped:
                self.meanings[number - 1] = self._meaning(reader, units, begin)
        self.firsts.append(reader.table.index)

    def _follow(self, reader: Interpreter) -> None:
        """Read the lines in the order of their O-words; moves in other files are refused."""
        flow = Flow(reader, self.lines.lines, library_of(self.file, self.start), Limits())
        steps = flow.run()
        while True:
            source, number = flow.source, flow.index + 1
            units, begin, ended = reader.model.state.units, work_place(reader), reader.ended
            row, reader.line_number = reader.table.index, 0
            if next(steps, reader) is reader:
                reader.line_number = number - 1  # the last line: a program without an end lacks it there
                break
            if not reader.line_number or ended:
                continue  # skipped
            if source is not flow.main and reader.table.index > row:
                what = "a subroutine in another file moves: it is not edited with the program"
                raise self.refusal(reader.line_number, "edit-flow", what, value=source.file, advice=EXPAND)
            if source is flow.main:
                self._note(number, self._meaning(reader, units, begin))

    def _note(self, number: int, meaning: Meaning) -> None:
        """Store a line's state; a line that is executed again with another position gets an unknown one."""
        before = self.meanings[number - 1]
        if before is not None:
            if before.modes != meaning.modes:
                self.doubtful.add(number)
            begin = tuple(a if a == b else UNKNOWN for a, b in zip(before.begin, meaning.begin, strict=True))
            meaning = meaning._replace(begin=begin)
        self.meanings[number - 1] = meaning

    def _meaning(self, reader: Interpreter, units_before: str, begin: tuple[float, ...]) -> Meaning:
        state = reader.model.state
        return Meaning(
            units=state.units,
            feed_units=state.units if self.dialect.feed_in_new_units else units_before,
            absolute=state.distance == "absolute",
            absolute_centres=state.arc_centres == "absolute",
            plane=state.plane,
            motion=MOTION_NAMES[reader.model.motion],
            inverse_time=state.feed_mode == "inverse_time",
            compensated=is_compensated(reader),
            diameter=reader.model.diameter,
            begin=begin,
        )

    def _check(self, number: int, line: str) -> None:
        if self.dialect.two_block_cycles and names_blocks(line):
            raise self.refusal(number, "edit-flow", IN_OTHER_BLOCKS, value=line.strip()[:40], advice=WITHOUT_CYCLES)
        if "#" in line and _READS_PLACE.search(split_line(line).code):
            what = "the line reads the machine's position, which the edit would change"
            raise self.refusal(number, "edit-parameter", what, value="#", advice=EXPAND)


def has_flow(text: str, dialect: Dialect) -> bool:
    """Whether a program has lines that lead elsewhere: O-words, M98."""
    return dialect.o_words and not is_plain(text) and any(leads(line) for line in program_lines(text))


def require_straight(text: str, dialect: Dialect, file: str) -> None:
    """Raise ProgramError, naming the first, for a program with lines that lead elsewhere."""
    for number, line in enumerate(program_lines(text) if dialect.two_block_cycles else (), start=1):
        if names_blocks(line):
            place = Place(file, number, 1)
            raise ProgramError(
                "edit-flow", IN_OTHER_BLOCKS, value=line.strip()[:40], advice=WITHOUT_CYCLES, place=place
            )
    for number, line in enumerate(program_lines(text) if has_flow(text, dialect) else (), start=1):
        if leads(line):
            what = "a program with subroutines, loops or branches is not rewritten"
            place = Place(file, number, 1)
            raise ProgramError("edit-flow", what, value=line.strip()[:40], advice=EXPAND, place=place)


def is_compensated(reader: Interpreter) -> bool:
    """Whether cutter compensation is on (G41, G42), so that moves end beside their words' values."""
    return reader.model.compensation is not None


def work_place(reader: Interpreter) -> tuple[float, ...]:
    """Return the tool's position in work coordinates, mm."""
    model = reader.model
    return tuple(value - zero for value, zero in zip(model.position, model.offset, strict=False))
