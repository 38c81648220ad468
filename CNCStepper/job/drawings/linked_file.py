# SPDX-License-Identifier: LGPL-2.1-or-later
"""A drawing and the file that it was read from: whether the file has changed since.

Size and time of change are looked at first; the content is hashed only where one of them differs.
"""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from pathlib import Path

from CNCStepper.drawing.drawing import Drawing, Share
from CNCStepper.drawing.read_drawing import ReadOptions
from CNCStepper.input_file import Unchanged, read_input
from CNCStepper.job.drawings.read_any import read_any_drawing

MOST_BYTES = 200_000_000


@dataclass(frozen=True)
class FileState:
    """Size in bytes, time of the last change in ns, and SHA-256 of a file as it was read."""

    size_bytes: int
    changed_ns: int
    sha256: str


def read_linked(path: Path, options: ReadOptions, share: Share = lambda share: None) -> tuple[Drawing, FileState]:
    """Return the drawing in a file and the state of the file; raises JobError where it changes meanwhile."""
    unchanged = Unchanged(path)
    state = file_state(path)
    drawing = read_any_drawing(path, options, share)
    unchanged.check()
    return drawing, state


def file_state(path: Path) -> FileState:
    """Return the state of a file; raises JobError for one that cannot be read."""
    content = read_input(path, MOST_BYTES)
    found = path.stat()
    return FileState(found.st_size, found.st_mtime_ns, hashlib.sha256(content).hexdigest())


def has_changed(path: Path, state: FileState) -> bool:
    """Return whether a file has another content than it had; raises JobError for one that cannot be read now."""
    try:
        found = path.stat()
    except OSError:
        return file_state(path) != state
    if (found.st_size, found.st_mtime_ns) == (state.size_bytes, state.changed_ns):
        return False
    return found.st_size != state.size_bytes or file_state(path).sha256 != state.sha256
