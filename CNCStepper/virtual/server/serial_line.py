# SPDX-License-Identifier: LGPL-2.1-or-later
"""The serial line: bytes reach the board and leave it one after another, at baud/10 a second.

Both queues are the whole byte path between a client and the board; faults of real cables are injected here.
"""

from __future__ import annotations

from CNCStepper.virtual.grbl.machine import Grbl

BITS_PER_BYTE = 10  # start bit, eight data bits, stop bit
ADAPTER_BYTES = 64  # what a USB adapter takes from the computer ahead of the wire, at least
ADAPTER_S = 0.002  # and of a quick line: two of the frames in which USB hands it bytes


class _Wire:
    """One direction: a queue that empties at a steady rate."""

    def __init__(self, bytes_per_s: float):
        self._rate = bytes_per_s
        self._credit = 0.0
        self.waiting = bytearray()

    def advance(self, dt_s: float) -> bytes:
        """Return the bytes that come out at the far end within `dt_s`."""
        if not self.waiting:
            self._credit = 0.0
            return b""
        self._credit += dt_s * self._rate
        count = int(self._credit)
        self._credit -= count
        arrived = bytes(self.waiting[:count])
        del self.waiting[:count]
        return arrived


class Link:
    """A board at the end of a serial line, both in simulated time."""

    def __init__(self, board: Grbl, baud: int = 115200):
        self.board = board
        self._in = _Wire(baud / BITS_PER_BYTE)
        self._out = _Wire(baud / BITS_PER_BYTE)
        self._received = bytearray()
        self._adapter_bytes = max(ADAPTER_BYTES, round(ADAPTER_S * baud / BITS_PER_BYTE))

    @property
    def room(self) -> int:
        """How many bytes the line takes now; a client's further bytes wait on its own side."""
        return max(self._adapter_bytes - len(self._in.waiting), 0)

    @property
    def quiet(self) -> bool:
        """Whether nothing is under way: no byte on the line, and a board that waits for one."""
        return self.board.quiet and not self._in.waiting and not self._out.waiting

    def send(self, data: bytes) -> None:
        """Put bytes on the line to the board."""
        self._in.waiting += data

    def receive(self) -> bytes:
        """Return the bytes that have come from the board."""
        data = bytes(self._received)
        self._received.clear()
        return data

    def advance(self, dt_s: float) -> None:
        """Let time pass; a few milliseconds at most while anything is under way."""
        arrived = self._in.advance(dt_s)
        if arrived:
            self.board.receive(arrived)
        self.board.advance(dt_s)
        self._out.waiting += self.board.take_output()
        self._received += self._out.advance(dt_s)
