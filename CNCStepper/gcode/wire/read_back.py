# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of moves that belongs to the wire text, with the file's lines and operations."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import repeat

import numpy as np

from CNCStepper.errors import Place, ProgramError
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.dialects.dialect_options import as_sent
from CNCStepper.gcode.interpreter.flow.run_with_subroutines import refusals, run_whole
from CNCStepper.gcode.interpreter.flow.subprogram_files import library_of
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.syntax.words import program_lines
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.gcode.wire.expansion import Block, expanded, is_expanded
from CNCStepper.gcode.wire.wire_text import WireText
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath

MOST_REFUSALS = 50


def read_back(
    wire: WireText,
    text: str,
    start: Start | None = None,
    dialect_name: str | Dialect = "grbl",
    file: str = "",
    progress: Callable[[float], None] = lambda share: None,
) -> Toolpath:
    """Return the moves of `wire`, which was prepared from `text`; rows name the file's lines.

    Every word comes from the wire text; the lines that it left out bring only their comments (operations).
    progress: called with the share of the lines that is reached, from 0 to 1. Raises ProgramError naming line and
    column in the file.
    """
    dialect_name = as_sent(dialect_named(dialect_name))
    reader = Interpreter(start, dialect_name, file)
    library = library_of(file, start)
    try:
        if is_expanded(text, reader.dialect):
            _read_expanded(reader, wire, text, start)
        elif wire.leads is not None:
            numbers, joined = _joined(wire, text, file)
            run_whole(reader, joined, library, progress)
            return _with_lines_of(reader.toolpath(), numbers)
        else:
            run_whole(reader, _with_wire_lines(wire, text, file), library, progress)
        return reader.toolpath()
    except ProgramError:
        interpret(text, start, dialect_name, file)  # refuses the same line, naming the column in the file
        raise


def _read_expanded(reader: Interpreter, wire: WireText, text: str, start: Start | None) -> None:
    """Read the lines that are sent, in their order, and the comments between them."""
    sent = groups_of(wire)
    for block in expanded(text, reader.dialect, start, reader.file):
        read_block(reader, block, sent)
    if next(sent, None) is not None:
        raise _of_another_program(Place(reader.file))


def read_block(reader: Interpreter, block: Block, sent: Iterator[list[str]]) -> None:
    """Read the comments of a block that was written out, and the next lines that are sent, which are its own."""
    place = Place(reader.file, block.line)
    for comment in block.comments:
        reader.line_at(f"({'MSG,' * comment.message}{comment.text})", block.line, place)
    if any(word.letter != "N" for word in block.words):
        group = next(sent, None)
        if group is None:
            raise _of_another_program(place)
        for one in group:
            reader.line_at(one, block.line, place)


def groups_of(wire: WireText) -> Iterator[list[str]]:
    """Yield the lines that are sent for each line of the program, nearly always one."""
    group: list[str] = []
    leads = repeat(False) if wire.leads is None else iter(wire.leads.tolist())
    for line, leads_on in zip(wire.lines, leads, strict=False):
        group.append(line)
        if not leads_on:
            yield group
            group = []


def _joined(wire: WireText, text: str, file: str) -> tuple[np.ndarray, str]:
    """Return a program some of whose lines are several on the wire, and the file's line of each of them, from 1."""
    lines = program_lines(text)
    if wire.file_lines.max(initial=0) > len(lines):
        raise _of_another_program(Place(file))
    numbers, joined = joined_lines(wire, lines)
    return np.append(np.int32(0), numbers), "".join(f"{line}\n" for line in joined)


def joined_lines(wire: WireText, lines: list[str], first: int = 1) -> tuple[np.ndarray, list[str]]:
    """Return a program with the lines that are sent in place of those that they were made from, and the number of each.

    lines: of the program from its line `first` on, which became all of `wire`. The numbers are int32[n].
    """
    instead: dict[int, list[str]] = {}
    for number, line in zip(wire.file_lines.tolist(), wire.lines, strict=True):
        instead.setdefault(number, []).append(line)
    joined = [(number, line) for number, raw in enumerate(lines, first) for line in instead.get(number, [raw])]
    return np.array([number for number, _ in joined], np.int32), [line for _, line in joined]


def _with_lines_of(path: Toolpath, numbers: np.ndarray) -> Toolpath:
    """Return a table with other numbers for its lines."""
    path.chunks = [replace(chunk, line=numbers[chunk.line]) for chunk in path.chunks]
    path.events = [replace(event, line=int(numbers[event.line])) for event in path.events]
    return path


def _of_another_program(place: Place) -> ProgramError:
    what = "the lines to send were made from another program"
    return ProgramError("other-program", what, advice="prepare this program's own", place=place)


def _with_wire_lines(wire: WireText, text: str, file: str) -> str:
    """Return the program with the lines that are sent in place of those that they were made from."""
    lines = program_lines(text)
    if len(wire.file_lines) and wire.file_lines.max() > len(lines):
        raise _of_another_program(Place(file))
    for number, line in zip(wire.file_lines.tolist(), wire.lines, strict=True):
        lines[number - 1] = line
    return "".join(f"{line}\n" for line in lines)


def refused_lines(
    text: str, start: Start | None = None, dialect_name: str | Dialect = "grbl", file: str = ""
) -> Iterator[ProgramError]:
    """Yield why lines of a program are refused, each with its place, at most MOST_REFUSALS; nothing for a good one.

    A refused line changes nothing, so reading goes on after it, up to the first that leads elsewhere; what only fails
    in the wire text comes last.
    """
    dialect_name = as_sent(dialect_named(dialect_name))
    reader = Interpreter(start, dialect_name, file)
    count = 0
    for error in refusals(reader, text, library_of(file, start)):
        count += 1
        yield error
        if count == MOST_REFUSALS:
            return
    if not count:
        try:
            reader.toolpath()
            prepare(text, dialect_name, file, start)
        except ProgramError as error:
            yield error
