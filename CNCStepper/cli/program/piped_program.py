# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program that comes through a pipe, put into a file: what is checked is read more than once, but not held whole."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from CNCStepper.cli.common.progress import Progress
from CNCStepper.gcode.interpreter.file_chunks import byte_pieces
from CNCStepper.input_file import MB


@contextmanager
def regular_file(program: Path) -> Iterator[Path]:
    """Give the regular file of a program: its own, or for a pipe one that is removed when the block ends.

    Raises ProgramError, naming the program, for a line that is longer than any program's, and OSError on a full disk.
    """
    if program.is_file():
        yield program
        return
    with TemporaryDirectory(prefix="cncstepper-pipe-") as folder:
        file = Path(folder) / "program.nc"
        with Progress(f"reading {program.name}") as progress, file.open("wb") as copy:
            read = 0
            for piece in byte_pieces(program):
                read += copy.write(piece)
                progress.doing(f"reading {program.name}, {read / MB:.0f} MB so far")
        yield file
