# SPDX-License-Identifier: LGPL-2.1-or-later
"""Releases a jog of the mini-lathe whose controller was killed: a process that holds the port too, and waits for that.

    controller ──"J" a jog begins, "-" it is released──► pipe ──► workers/lathe_guard.py ──it ends behind "J"──► P

Nothing else ends such a jog: the lathe moves on until it hears P, and a killed process sends nothing. There is no guard
on Windows, where a process cannot hand a port on.
"""

from __future__ import annotations

import os
import subprocess
import sys
from contextlib import suppress

from CNCStepper.control.processes.python_finder import command, environment

MODULE = "CNCStepper.workers.lathe_guard"
BEGINS, RELEASED = b"J", b"-"
STOP = b"P"
JOGS = b"ABCDEFGH"
END_S = 5.0


class JogGuard:
    """The guard of one port, by its descriptor; it ends with this process or by `close`."""

    def __init__(self, descriptor: int):
        self._jogs = False
        self._process = subprocess.Popen(
            command(sys.executable, MODULE, str(descriptor)),
            stdin=subprocess.PIPE,
            bufsize=0,
            pass_fds=(descriptor,),
            env=environment(),
            start_new_session=True,
        )

    def before(self, data: bytes) -> None:
        """Take note of bytes that are about to be written: a jog may begin with them."""
        if data[-1:] in JOGS and data:
            self._tell(BEGINS)
            self._jogs = True

    def after(self, data: bytes) -> None:
        """Take note of bytes that were written: a jog may be over."""
        if self._jogs and data[-1:] not in JOGS:
            self._tell(RELEASED)
            self._jogs = False

    def close(self) -> None:
        """Let the guard end; it releases a jog that is not."""
        assert self._process.stdin
        with suppress(OSError):
            self._process.stdin.close()
        try:
            self._process.wait(END_S)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()

    def _tell(self, what: bytes) -> None:
        assert self._process.stdin
        with suppress(OSError):  # an ended guard is no reason to stop a watched jog
            self._process.stdin.write(what)


def guard_of(descriptor: int | None) -> JogGuard | None:
    """Return the guard of a port, None where there can be none."""
    return None if os.name != "posix" or descriptor is None else JogGuard(descriptor)
