# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines typed at a terminal during other work.

A thread reads them, since that is the one way that works with terminals, pipes and the consoles of Windows alike.
"""

from __future__ import annotations

import os
import signal
import sys
import time
from collections.abc import Callable
from queue import Empty, SimpleQueue
from threading import Thread

LINE_BYTES = 4096


class TerminalInput:
    """Reads lines from a file descriptor while it waits, in the thread that waits.

    hear: gets each line without its end. fd: standard input when left out; nothing else may read from it any more.
    """

    def __init__(self, on_message: Callable[[str], None], fd: int | None = None):
        self._on_message = on_message
        self._lines: SimpleQueue[str] = SimpleQueue()
        fd = _standard_input() if fd is None else fd
        if hasattr(signal, "SIGTTIN"):  # reading behind a shell's back fails then, instead of stopping the process
            signal.signal(signal.SIGTTIN, signal.SIG_IGN)
        if fd is not None:
            Thread(target=self._read, args=(fd,), name="typed", daemon=True).start()

    def wait(self, seconds: float) -> None:
        """Wait, and read what is typed meanwhile; lines that have come are read even where there is no time."""
        until_s = time.monotonic() + seconds
        while True:
            try:
                line = self._lines.get(timeout=max(0.0, until_s - time.monotonic()))
            except Empty:
                return
            self._on_message(line)

    def _read(self, fd: int) -> None:
        """Read to the end; not by sys.stdin, whose lock would keep a process from ending while this thread waits."""
        left = b""
        while came := _came(fd):
            *lines, left = (left + came).split(b"\n")
            for line in lines:
                self._lines.put(line.decode("utf-8", "replace").strip())


def _came(fd: int) -> bytes:
    try:
        return os.read(fd, LINE_BYTES)
    except OSError:  # the terminal is closed, or another process has it
        return b""


def _standard_input() -> int | None:
    try:
        return sys.stdin.fileno()
    except (AttributeError, OSError, ValueError):  # there is none, or it is no file
        return None
