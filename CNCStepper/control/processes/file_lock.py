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
LISTED = Path("/proc/locks")
ALL_PROCESSES = "pid:[4026531836]"  # PROC_PID_INIT_INO of Linux: inside a container locks from outside are not listed


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


def take_lock_with_retries(file: Any) -> None:
    """Lock a file of this process, which a reader may lock briefly; raises OSError when the lock stays."""
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


def is_listed(path: Path) -> bool | None:
    """Return whether Linux lists a lock on a file, which takes no right to open it; None where nothing can say that."""
    try:
        if os.stat(path).st_ino in _listed():
            return True
        return False if _lists_all(path.parent) else None
    except OSError:
        return None


def _listed() -> set[int]:
    """Return the inodes of the list, without their devices: for some file systems it names others than `stat` does."""
    rows = (line.split() for line in LISTED.read_text("ascii").splitlines())
    return {int(field.rpartition(":")[2]) for row in rows if "FLOCK" in row for field in row if field.count(":") == 2}


def _lists_all(folder: Path) -> bool:
    """Return whether the list has the locks of every process in a folder: one of our own is looked for there."""
    if os.readlink("/proc/self/ns/pid") != ALL_PROCESSES:
        return False
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        take_lock(descriptor, shared=True)
        return os.fstat(descriptor).st_ino in _listed()
    finally:
        os.close(descriptor)


def _is_taken(descriptor: int) -> bool:
    with open(descriptor, "rb", buffering=0, closefd=False) as file:
        try:
            take_lock(file, shared=True)
        except OSError:
            return True
    return False
