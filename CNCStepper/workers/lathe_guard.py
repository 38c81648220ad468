# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that releases a jog of the mini-lathe when its controller was killed: `... lathe_guard DESCRIPTOR`.

DESCRIPTOR is the lathe's port, handed on open. Standard input says "J" before a jog and "-" behind it
(`control/protocol/lathe/jog_guard.py`). Where it ends behind a "J", the port gets a P.
"""

from __future__ import annotations

import os
import signal
import sys
from contextlib import suppress

from CNCStepper.control.protocol.lathe.jog_guard import BEGINS, STOP

READ_BYTES = 64
OUTLIVED = ("SIGINT", "SIGHUP", "SIGTERM")  # it ends with the controller, and not before


def main(arguments: list[str]) -> int:
    """Wait for the controller's end; return the exit status."""
    for name in filter(lambda name: hasattr(signal, name), OUTLIVED):
        signal.signal(getattr(signal, name), signal.SIG_IGN)
    last = b""
    while data := os.read(sys.stdin.fileno(), READ_BYTES):
        last = data[-1:]
    if last == BEGINS:
        with suppress(OSError):  # the port may be gone with the controller
            os.write(int(arguments[0]), STOP)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
