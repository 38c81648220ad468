# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program that is read while it is planned, so that memory stays flat however long it is."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from CNCStepper.cli.common.options import read_program
from CNCStepper.cli.common.progress import Progress

if TYPE_CHECKING:
    from CNCStepper.state import Start
    from CNCStepper.toolpath import Chunk, Toolpath


def program_chunks(
    program: Path, start: Start, language: str, progress: Progress, text: str | None = None
) -> tuple[Toolpath, Iterator[Chunk]]:
    """Return the table of a program of X, Y and Z, still without rows, and its chunks as they are read.

    text: of a program that can be read only once, where it was read already. The table's states and events grow with
    the chunks. Raises ProgramError, with the chunks, where it cannot be read or moves other axes.
    """
    from CNCStepper.gcode.interpreter.interpret import interpret
    from CNCStepper.gcode.interpreter.program_file import FileReading
    from CNCStepper.toolpath import Toolpath, straight_chunks

    if text is not None or not program.is_file():  # a pipe can be read only once
        path = interpret(read_program(program) if text is None else text, start, language, str(program))
        return path, straight_chunks(path.chunks, path, str(program))
    reading = FileReading(program, start, language, progress=progress.share)
    table = reading.interpreter.table
    path = Toolpath(table.start, [], table.states, table.events)
    return path, straight_chunks(reading.chunks(), table, str(program))
