# SPDX-License-Identifier: LGPL-2.1-or-later
"""The file by which a process is found: locked by that process for its lifetime, repaired where it is damaged.

Whether the process lives is what the lock says, and nothing else: neither a time stamp, which a suspended laptop or a
changed clock makes old, nor a process number, which another process may have got since. Of a file that this user may
not open (`is_closed`), as one of the administrator's, Linux's list of locks says it, or a socket that nobody serves.
"""

from __future__ import annotations

import json
import os
import threading
import time
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any, BinaryIO

from CNCStepper.control.processes.file_lock import is_listed, is_locked, take_lock_with_retries
from CNCStepper.control.session.local_socket import is_abandoned, socket_paths

LOOK_EVERY_S = 1.0
REMOVE_LIMIT_S = 1.0  # while clients look at the file: Windows lets none remove what another has open
_TRY_EVERY_S = 0.02
_CLOSED_TRIES = 10 if os.name == "nt" else 1  # a virus scanner of Windows locks a file briefly


def is_alive(path: Path) -> bool:
    """Return whether the process that owns this file lives; True for a closed file without evidence."""
    try:
        return is_locked(path)
    except FileNotFoundError:
        return False
    except PermissionError:  # perhaps of a session that the administrator began here
        return _seems_alive(path)
    except OSError:
        return path.is_file()


def is_closed(path: Path) -> bool:
    """Return whether a file is there that this user may not open, as one that another user has left."""
    for _ in range(_CLOSED_TRIES):
        try:
            os.close(os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0)))
        except PermissionError:
            time.sleep(_TRY_EVERY_S if _CLOSED_TRIES > 1 else 0.0)
        except OSError:
            return False
        else:
            return False
    return path.is_file()


def owner(path: Path) -> str:
    """Return the name of the user whose file it is, in words where the system has none."""
    try:
        return path.owner()
    except KeyError:  # a user of another computer, as on a network's disk
        return f"user {path.stat().st_uid}"
    except (OSError, NotImplementedError):  # removed meanwhile; Windows names no process
        return "its owner"


def unlink_with_retries(path: Path) -> None:
    """Remove a file as soon as nobody else has it open; left there when that takes longer than REMOVE_LIMIT_S."""
    end_s = time.monotonic() + REMOVE_LIMIT_S
    while True:
        try:
            path.unlink(missing_ok=True)
            return
        except OSError:
            if time.monotonic() > end_s:
                return
        time.sleep(_TRY_EVERY_S)


def _seems_alive(path: Path) -> bool:
    listed = is_listed(path)
    if listed is None:
        return path.is_file() and not any(map(is_abandoned, socket_paths(path)))
    return listed


class ProcessFile:
    """The file in the hands of its own process; `keep` and the others may be called from several threads."""

    def __init__(self, path: Path):
        self._path = path
        self._content = b""
        self._file: BinaryIO | None = None
        self._written: tuple[int, int] = (0, 0)  # size, and time of the last change, ns
        self._looked_s = 0.0
        self._lock = threading.Lock()

    def write(self, content: Mapping[str, Any]) -> None:
        """Make and lock the file, readable by its owner only; raises OSError when it cannot be made."""
        with self._lock:
            self._content = json.dumps(content).encode("utf-8")
            self._looked_s = time.monotonic()
            self._make()

    def keep(self) -> None:
        """Write the file again where another program changed, replaced or removed it; checks once in LOOK_EVERY_S."""
        with self._lock:
            if self._file is None or time.monotonic() - self._looked_s < LOOK_EVERY_S:
                return
            self._looked_s = time.monotonic()
            with suppress(OSError):  # the disk is full, or a folder has its name: tried again the next time
                self._mend(self._file)

    def remove(self) -> None:
        """Remove it at the end of the process. Never fails: a file without a lock also means an ended process."""
        with self._lock:
            if self._file is None:
                return
            with suppress(OSError):  # Windows wants it closed before
                self._path.unlink(missing_ok=True)
            self._file.close()
            self._file = None
        unlink_with_retries(self._path)

    def _mend(self, file: BinaryIO) -> None:
        try:
            there = os.lstat(self._path)
        except FileNotFoundError:
            there = None
        if there is None or not os.path.samestat(there, os.fstat(file.fileno())):
            self._path.unlink(missing_ok=True)
            self._make()
            file.close()
        elif (there.st_size, there.st_mtime_ns) != self._written:
            self._fill(file)

    def _make(self) -> None:
        flags = os.O_RDWR | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0)
        file = open(os.open(self._path, flags, 0o600), "r+b", buffering=0)  # noqa: SIM115 - closed by `remove`
        take_lock_with_retries(file)
        self._fill(file)
        self._file = file

    def _fill(self, file: BinaryIO) -> None:
        file.seek(0)
        file.truncate()
        file.write(self._content)
        found = os.fstat(file.fileno())
        self._written = (found.st_size, found.st_mtime_ns)
