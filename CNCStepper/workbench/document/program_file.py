# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program text inside the document: an included file, saved with it byte for byte; no bytes mean no program."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

NAME = "program.nc"


def store(job: Any, text: str) -> None:
    """Let `text` be the job's program."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / NAME
        path.write_bytes(text.encode("utf-8"))
        job.Program = str(path)


def load(job: Any) -> str:
    """Return the job's program, "" when it has none."""
    return Path(job.Program).read_bytes().decode("utf-8") if job.Program else ""
