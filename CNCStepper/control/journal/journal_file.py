# SPDX-License-Identifier: LGPL-2.1-or-later
"""The file of one journal while it is written: locked, its owner's only, every record on the disk before it counts."""

from __future__ import annotations

import os
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from CNCStepper.control.journal.records import to_line
from CNCStepper.control.processes.file_lock import take_lock_with_retries
from CNCStepper.control.session.files import sync_folder


class JournalFile:
    """A new journal at `path`; raises OSError when it cannot be made."""

    def __init__(self, path: Path):
        self.path = path
        descriptor = os.open(path, os.O_RDWR | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0), 0o600)
        self._file = open(descriptor, "r+b", buffering=0)  # noqa: SIM115 - closed by `close`
        self._count = 0
        self._end = 0  # of what is on the disk
        try:
            take_lock_with_retries(self._file)
            sync_folder(path.parent)
        except OSError:
            self.close()
            path.unlink()
            raise

    def append(self, content: Mapping[str, Any]) -> None:
        """Write one record; when this returns it is on the disk. After an OSError the file is as it was before."""
        line = to_line(self._count, content)
        try:
            self._write(line)
        except OSError:
            with suppress(OSError):  # if not now, the next record is written over what is there
                self._file.truncate(self._end)
            raise
        self._end += len(line)
        self._count += 1

    def close(self) -> None:
        """Close the file, and let its lock go."""
        self._file.close()

    def _write(self, line: bytes) -> None:
        self._file.seek(self._end)
        left = memoryview(line)
        while left:
            left = left[self._file.write(left) or 0 :]
        os.fsync(self._file.fileno())
