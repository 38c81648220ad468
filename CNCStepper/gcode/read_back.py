# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of moves that belongs to the wire text, with the file's lines and operations."""

from __future__ import annotations

from collections.abc import Iterator

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.interpret import Interpreter, interpret
from CNCStepper.gcode.prepare import WireText, prepare
from CNCStepper.gcode.words import program_lines
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath

MOST_REFUSALS = 50


def read_back(
    wire: WireText, text: str, start: Start | None = None, dialect_name: str | Dialect = "grbl", file: str = ""
) -> Toolpath:
    """Return the moves of `wire`, which was prepared from `text`; rows name the file's lines.

    Every word comes from the wire text; the lines that it left out bring only their comments (operations).
    Raises ProgramError naming line and column in the file.
    """
    sent = dict(zip(wire.file_lines.tolist(), wire.lines, strict=True))
    reader = Interpreter(start, dialect_name, file)
    try:
        for number, line in enumerate(program_lines(text), start=1):
            reader.line(sent.get(number, line))
        return reader.toolpath()
    except ProgramError:
        interpret(text, start, dialect_name, file)  # refuses the same line, naming the column in the file
        raise


def refused_lines(
    text: str, start: Start | None = None, dialect_name: str | Dialect = "grbl", file: str = ""
) -> Iterator[ProgramError]:
    """Yield why lines of a program are refused, each with its place, at most MOST_REFUSALS; nothing for a good one.

    A refused line changes nothing, so reading goes on after it; what only fails in the wire text comes last.
    """
    reader = Interpreter(start, dialect_name, file)
    count = 0
    for line in program_lines(text):
        try:
            reader.line(line)
        except ProgramError as error:
            count += 1
            yield error
            if count == MOST_REFUSALS:
                return
    if not count:
        try:
            reader.toolpath()
            prepare(text, dialect_name, file)
        except ProgramError as error:
            yield error
