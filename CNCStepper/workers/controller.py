# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process of a controller of ours: `... CNCStepper.workers.controller MACHINE PORT`.

MACHINE is a profile's name or file. Once the machine can move it says {"ready": {}} or {"error": {...}} in a line of
its own; from then on standard input and output are the serial line of a grbl. It ends when its input closes: it brakes
whatever moves and switches all outputs off. SIGTERM and SIGINT do the same.
"""

from __future__ import annotations

import gc
import json
import os
import signal
import sys
import threading
import time
from contextlib import suppress
from pathlib import Path

from CNCStepper.control.processes.thread_priority import go_first
from CNCStepper.control.session.status import error_to_json
from CNCStepper.controllers.families import ServedBoard, open_board
from CNCStepper.errors import CNCStepperError
from CNCStepper.machine.profile import load_machine

SWITCH_S = 0.0005  # a hold must not wait for this thread's turn of 5 ms
MOVING_S, QUIET_S = 0.0015, 0.025  # between two looks at the board, its inputs and its output
BRAKES_S = 30.0  # the longest ramp that is waited for at the end
READ_BYTES = 4096
STOPS = ("SIGTERM", "SIGINT", "SIGHUP", "SIGBREAK")


class Inbox:
    """The bytes of standard input, read by a thread of their own: no system waits for a pipe as for a clock."""

    def __init__(self, descriptor: int):
        self._descriptor = descriptor
        self._arrived = threading.Event()
        self._bytes = bytearray()
        self._lock = threading.Lock()
        self.closed = False
        threading.Thread(target=self._read, name="input", daemon=True).start()

    def take(self, wait_s: float) -> bytes:
        """Return what has come, waiting up to `wait_s` for it."""
        self._arrived.wait(wait_s)
        self._arrived.clear()
        with self._lock:
            data = bytes(self._bytes)
            self._bytes.clear()
        return data

    def close(self) -> None:
        """Behave as if the far end had closed, which the next look finds; nothing is locked, so signals may call it."""
        self.closed = True

    def _read(self) -> None:
        go_first()
        with suppress(OSError):
            while data := os.read(self._descriptor, READ_BYTES):
                with self._lock:
                    self._bytes += data
                self._arrived.set()
        self.close()


def main(arguments: list[str]) -> int:
    """Run the controller of a machine; return the exit status."""
    sys.setswitchinterval(SWITCH_S)
    output = os.dup(sys.stdout.fileno())
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())  # what anything prints is no line of the controller
    try:
        board = open_board(load_machine(_name(arguments[0])), arguments[1])
    except CNCStepperError as error:
        _write(output, json.dumps({"error": error_to_json(error)}).encode("ascii") + b"\n")
        return 1
    inbox = Inbox(sys.stdin.fileno())
    for name in filter(lambda name: hasattr(signal, name), STOPS):
        signal.signal(getattr(signal, name), lambda *_: inbox.close())
    gc.freeze()
    go_first()
    try:
        if _write(output, json.dumps({"ready": {}}).encode("ascii") + b"\n"):
            serve(board, inbox, output)
    finally:
        board.close()
    return 0


def serve(board: ServedBoard, inbox: Inbox, output: int) -> None:
    """Let a board speak and move until its input closes, and then until it is at rest."""
    last_s, end_s = time.monotonic(), None
    while end_s is None or (not board.at_rest and time.monotonic() < end_s):
        data = inbox.take(QUIET_S if board.quiet else MOVING_S)
        now_s = time.monotonic()
        if data:
            board.receive(data)
        board.advance(now_s - last_s)
        last_s = now_s
        heard = _write(output, board.take_output())
        if end_s is None and (inbox.closed or not heard):
            end_s = now_s + BRAKES_S
            board.come_to_rest()


def _write(output: int, data: bytes) -> bool:
    """Write all of `data`; return whether somebody reads it."""
    try:
        while data:
            data = data[os.write(output, data) :]
    except OSError:
        return False
    return True


def _name(argument: str) -> str | Path:
    return Path(argument) if argument.endswith((".toml", ".json")) else argument


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
