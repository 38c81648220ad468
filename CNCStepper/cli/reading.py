# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program that is read while it is planned, so that memory stays flat however long it is."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from CNCStepper.cli.options import read_program
from CNCStepper.cli.progress import Progress

if TYPE_CHECKING:
    from CNCStepper.state import Start
    from CNCStepper.toolpath import Chunk, TableBuilder, Toolpath


XYZ = 3  # axes


def straight_chunks(program: Path, start: Start, language: str, progress: Progress) -> tuple[Toolpath, Iterator[Chunk]]:
    """Return the table of a program of X, Y and Z, still without rows, and its chunks as they are read.

    Its states and events grow with the chunks. Raises ProgramError, with the chunks, where it cannot be read or moves
    other axes.
    """
    from CNCStepper.gcode.interpret import interpret
    from CNCStepper.gcode.read_file import FileReading
    from CNCStepper.toolpath import Toolpath

    if not program.is_file():  # a pipe can be read only once
        path = interpret(read_program(program), start, language, str(program))
        return path, _straight(path.chunks, path, str(program))
    reading = FileReading(program, start, language, progress=progress.share)
    table = reading.interpreter.table
    path = Toolpath(table.start, [], table.states, table.events)
    return path, _straight(reading.chunks(), table, str(program))


def _straight(chunks: Iterable[Chunk], table: Toolpath | TableBuilder, file: str) -> Iterator[Chunk]:
    """Yield chunks of which each is checked to move X, Y and Z alone; the table's start grows with its axes."""
    from CNCStepper.toolpath import Toolpath, require_straight_axes

    coming = iter(chunks)
    for chunk in coming:
        further = chunk.end.shape[1] > XYZ
        seen = [chunk, *coming] if further else [chunk]  # the row that moves a further axis may be in a later chunk
        require_straight_axes(Toolpath(table.start, seen, table.states), file)
        yield chunk
