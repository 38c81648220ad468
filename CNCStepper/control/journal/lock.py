# SPDX-License-Identifier: LGPL-2.1-or-later
"""A lock on an open file that lasts as long as its process: the system takes it back however that ends."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

FAR_BYTE = 1 << 30  # Windows keeps others from reading what is locked: a byte that no journal has


def take_lock(file: Any) -> None:
    """Lock an open binary file for this process; raises OSError at once when another holds it."""
    if sys.platform == "win32":
        import msvcrt

        before = file.tell()
        file.seek(FAR_BYTE)
        try:
            msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
        finally:
            file.seek(before)
    else:
        import fcntl

        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)


def is_locked(path: Path) -> bool:
    """Return whether a process holds the lock of a file; raises OSError when there is no such file."""
    with path.open("rb") as file:
        try:
            take_lock(file)
        except OSError:
            return True
    return False
