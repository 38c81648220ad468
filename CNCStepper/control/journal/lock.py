# SPDX-License-Identifier: LGPL-2.1-or-later
"""A lock on an open file that lasts as long as its process: the system takes it back however that ends."""

from __future__ import annotations

import os
import stat
import sys
import time
from pathlib import Path
from typing import Any

FAR_BYTE = 1 << 30  # Windows keeps others from reading what is locked: a byte that no journal has
LOCK_TRIES, LOCK_PAUSE_S = 100, 0.01  # a reader may be looking whether it is locked


def take_lock(file: Any, shared: bool = False) -> None:
    """Lock an open binary file for this process; raises BlockingIOError or PermissionError when another holds it.

    shared: beside others that lock it so, where the system knows such locks.
    """
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

        fcntl.flock(file, (fcntl.LOCK_SH if shared else fcntl.LOCK_EX) | fcntl.LOCK_NB)


def take_lock_soon(file: Any) -> None:
    """Lock a file of one's own, which at most a reader has locked for a moment; raises OSError when it stays so."""
    for _ in range(LOCK_TRIES - 1):
        try:
            take_lock(file)
        except (BlockingIOError, PermissionError):
            time.sleep(LOCK_PAUSE_S)
        else:
            return
    take_lock(file)


def is_locked(path: Path) -> bool:
    """Return whether a process holds the lock of a file; raises OSError when there is no such file.

    What is no regular file has no owner, and is not waited for as one waits at a pipe.
    """
    descriptor = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
    try:
        return stat.S_ISREG(os.fstat(descriptor).st_mode) and _is_taken(descriptor)
    finally:
        os.close(descriptor)


def _is_taken(descriptor: int) -> bool:
    with open(descriptor, "rb", buffering=0, closefd=False) as file:
        try:
            take_lock(file, shared=True)
        except OSError:
            return True
    return False
