# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of moves that belongs to the wire text, with the file's lines and operations."""

from __future__ import annotations

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.interpret import Interpreter, interpret
from CNCStepper.gcode.prepare import WireText
from CNCStepper.gcode.words import program_lines
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath


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
