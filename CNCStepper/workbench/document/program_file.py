# SPDX-License-Identifier: LGPL-2.1-or-later
"""The text of a program: a file inside the document, saved with it byte for byte; or a G-code file."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from CNCStepper.gcode.syntax.text_format import FileForm

NAME = "program.nc"
LARGEST_BYTES = 256_000_000


def store(job: Any, text: str) -> None:
    """Let `text` be the job's program."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / NAME
        path.write_bytes(text.encode("utf-8"))
        job.Program = str(path)


def load(job: Any) -> str:
    """Return the job's program, "" when it has none."""
    return Path(job.Program).read_bytes().decode("utf-8") if job.Program else ""


def read(path: Path) -> tuple[str, FileForm]:
    """Return the text of a G-code file, each line with its end, and how the file writes it; raises JobError."""
    from CNCStepper.gcode.syntax.text_format import decoded  # not loaded with each document that is opened
    from CNCStepper.input_file import read_input

    text, form = decoded(read_input(path, LARGEST_BYTES))
    return ended(text), form


def ended(text: str) -> str:
    """Return a text whose lines all end with a line feed, the last one too."""
    from CNCStepper.gcode.syntax.words import with_line_feeds

    text = with_line_feeds(text)
    return f"{text}\n" if text and not text.endswith("\n") else text
