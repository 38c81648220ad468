# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the text of a whole program to its table of moves."""

from __future__ import annotations

from collections.abc import Callable

from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.interpreter.flow.run_with_subroutines import run_whole
from CNCStepper.gcode.interpreter.flow.subprogram_files import library_of
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath


def interpret(
    text: str,
    start: Start | None = None,
    dialect: str | Dialect = "grbl",
    file: str = "",
    progress: Callable[[float], None] = lambda share: None,
) -> Toolpath:
    """Return the table of moves of a whole program, in machine coordinates.

    start: the machine's position and modal state; None is a machine whose position and zero are unknown.
    The table's lines are those of the text: a row of a subroutine in another file has the line of its call.
    progress: called with the share of the lines that is reached, from 0 to 1. Raises ProgramError naming file, line,
    column and word.
    """
    interpreter = Interpreter(start, dialect, file)
    run_whole(interpreter, text, library_of(file, start), progress)
    return interpreter.toolpath()
