# SPDX-License-Identifier: LGPL-2.1-or-later
"""A controller behind a pseudo-terminal or a socket, for benchmarks: it answers, stands at 0 while it says that it
moves, and notes when each `!` would have come out of a line of a given rate.

Neither has a rate of its own. So each byte leaves the line 10/baud after the one before it, the first of them after it
was written. A controller is hardware, which no program keeps from its work: so where the system permits it this process
goes before all others. What is written to a pseudo-terminal is handed over by a worker of Linux, which waits for a core
as any program does; what is written to a socket, or to a USB adapter, is not.
"""

from __future__ import annotations

import os
import select
import socket
import time
import tty
from collections import deque
from contextlib import suppress
from multiprocessing.connection import Connection

BITS_PER_BYTE = 10
READ_BYTES = 4096
FRAME_S = 0.001  # how often an adapter hands on what has come
BUFFER_BYTES = 1024
REALTIME = b"!~?\x18"
GREETING = b"\r\nGrbl 1.1h ['$' for help]\r\n"
ANSWERS = {
    b"$I": b"[VER:1.1h.20190830:]\r\n[OPT:V,35,%d]\r\n" % BUFFER_BYTES,
    b"$$": b"$13=0\r\n$22=0\r\n",
    b"$#": b"[G54:0.000,0.000,0.000]\r\n[G92:0.000,0.000,0.000]\r\n",
    b"$G": b"[GC:G0 G54 G17 G21 G90 G94 M5 M9 T0 F0 S0]\r\n",
}


def serve(notes: Connection, baud: int, over: str) -> None:
    """Be the controller's process: tell the port and whether this process goes first, then when each `!` came, in s.

    over: "terminal" or "socket".
    """
    with suppress(OSError):  # the client has left
        PacedController(notes, baud).serve(TerminalEnd() if over == "terminal" else SocketEnd())


class TerminalEnd:
    """A pseudo-terminal's end; `name` is the other one's."""

    def __init__(self) -> None:
        self._own, self._client = os.openpty()
        tty.setraw(self._client)
        self.name = os.ttyname(self._client)

    def opened(self) -> tuple[int, bytes]:
        """Wait for a client; return the number to read from and write to, and what came first.

        A pseudo-terminal tells of its first bytes only. From then on reading fails when the client closes it.
        """
        data = os.read(self._own, READ_BYTES)
        os.close(self._client)
        return self._own, data


class SocketEnd:
    """A socket on this computer; `name` is its address."""

    def __init__(self) -> None:
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.name = "socket://{}:{}".format(*self._listener.getsockname())

    def opened(self) -> tuple[int, bytes]:
        """Wait for a client; return the number to read from and write to, and what came first."""
        connection, _ = self._listener.accept()
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        return connection.detach(), b""


class PacedController:
    """Takes each line as soon as the serial line has carried it, so that this one is what limits the rate."""

    def __init__(self, notes: Connection, baud: int):
        self._notes = notes
        self._byte_s = BITS_PER_BYTE / baud
        self._state = b"Idle"
        self._tail = b""
        self._free_s = 0.0  # when the line has carried all that was written
        self._coming: deque[tuple[float, bytes]] = deque()  # lines and real-time bytes, with when they come
        self._buffer: deque[bytes] = deque()  # lines that have come
        self._port = -1

    def serve(self, end: TerminalEnd | SocketEnd) -> None:
        """Serve one client; raises OSError when it has left."""
        self._notes.send((end.name, _goes_first()))
        self._port, data = end.opened()
        self._take(data)
        self._say(GREETING)
        while True:
            wait_s = max(self._coming[0][0] - time.monotonic(), FRAME_S) if self._coming else None
            self._take(self._read(wait_s))
            self._act_on_what_came()

    def _read(self, wait_s: float | None) -> bytes:
        ready, _, _ = select.select([self._port], [], [], wait_s)
        data = os.read(self._port, READ_BYTES) if ready else b""
        if ready and not data:
            raise ConnectionError("the client has left")
        return data

    def _take(self, data: bytes) -> None:
        """Put bytes on the line that were written now."""
        self._free_s = max(self._free_s, time.monotonic())
        for number in data:
            byte = bytes([number])
            self._free_s += self._byte_s
            if byte == b"!":
                self._notes.send(self._free_s)
            if byte in REALTIME:
                self._coming.append((self._free_s, byte))
            elif byte == b"\n":
                self._coming.append((self._free_s, self._tail))
                self._tail = b""
            else:
                self._tail += byte

    def _act_on_what_came(self) -> None:
        now_s = time.monotonic()
        while self._coming and self._coming[0][0] <= now_s:
            _, what = self._coming.popleft()
            if what in (b"!", b"~", b"?", b"\x18"):
                self._act(what)
            else:
                self._buffer.append(what)
        if self._state != b"Hold:0":
            self._obey_lines()

    def _act(self, byte: bytes) -> None:
        self._state = {b"!": b"Hold:0", b"~": b"Run", b"\x18": b"Idle"}.get(byte, self._state)
        if byte == b"?":
            self._say(b"<%s|MPos:0.000,0.000,0.000|FS:0,0>\r\n" % self._state)
        elif byte == b"\x18":
            self._buffer.clear()
            self._say(GREETING)

    def _obey_lines(self) -> None:
        """Answer all lines that have come."""
        answers = [ANSWERS.get(line, b"") + b"ok\r\n" for line in self._buffer]
        if any(line.startswith(b"G1X") for line in self._buffer):
            self._state = b"Run"
        self._buffer.clear()
        if answers:
            self._say(b"".join(answers))

    def _say(self, text: bytes) -> None:
        os.write(self._port, text)


def _goes_first() -> bool:
    """Let this process go before all others; return whether the system permits it."""
    try:
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(1))
    except (AttributeError, OSError):
        return False
    return True
