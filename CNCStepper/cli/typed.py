# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines that a person types while pulses are being sent; where nobody types there is nothing to hear."""

from __future__ import annotations

import os
import select
import signal
import sys
import time
from collections.abc import Callable

LINE_BYTES = 4096


class Typed:
    """Hears lines from a file descriptor while it waits, in the thread that waits.

    hear: gets each line without its end. fd: standard input when left out.
    """

    def __init__(self, hear: Callable[[str], None], fd: int | None = None):
        self._hear = hear
        self._fd = _standard_input() if fd is None else fd
        self._left = b""
        if hasattr(signal, "SIGTTIN"):  # reading behind a shell's back fails then, instead of stopping the pulses
            signal.signal(signal.SIGTTIN, signal.SIG_IGN)

    def wait(self, seconds: float) -> None:
        """Wait, and hear what is typed meanwhile; lines that have come are heard even where there is no time."""
        until_s = time.monotonic() + seconds
        while self._readable(max(0.0, until_s - time.monotonic())):
            self._read()

    def _readable(self, seconds: float) -> bool:
        """Wait until something is there; return False when there is nothing in time."""
        if self._fd is None or os.name == "nt":  # Windows selects among sockets only
            time.sleep(seconds)
            return False
        return bool(select.select([self._fd], [], [], seconds)[0])

    def _read(self) -> None:
        try:
            came = os.read(self._fd, LINE_BYTES)  # type: ignore[arg-type]
        except OSError:  # the terminal is gone, or another process has it
            came = b""
        *lines, self._left = (self._left + came).split(b"\n")
        if not came:
            self._fd = None
        for line in lines:
            self._hear(line.decode("utf-8", "replace").strip())


def _standard_input() -> int | None:
    try:
        return sys.stdin.fileno()
    except (AttributeError, OSError, ValueError):  # there is none, or it is no file
        return None
