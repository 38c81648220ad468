# SPDX-License-Identifier: LGPL-2.1-or-later
"""The USB FIFO and the four latches behind it: which byte changes the coils of which motor, and when.

    computer ──USB──► FIFO, 384 bytes ──1 MB/s──► high nibble: motor 0 to 3     a change of it clocks that motor's latch
                                                  low nibble: coils L1 L2 L3 L4   the latch takes these in

A byte with the motor that is selected already is no clock edge: nothing changes. One that selects another motor is one
for that motor: with no coils it leaves it without current, which is why a null pulse wants a motor that is not there.
Without supply nothing is read from the FIFO: it fills, and the computer's writes wait.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator

MOTORS = 4
FIFO_BYTES = 384  # from the computer; of the 128 towards it none is used: the board says nothing
BYTE_S = 1e-6  # 1 MB/s
NONE_SELECTED = -1  # after power-up


class Fifo:
    """Bytes on their way through the FIFO, each with the time at which it came."""

    def __init__(self, size: int = FIFO_BYTES, byte_s: float = BYTE_S):
        self._size = size
        self._byte_s = byte_s
        self._bytes: deque[tuple[float, int]] = deque()
        self._free_s = 0.0  # when the next byte may be read out

    @property
    def room(self) -> int:
        """How many bytes it takes now."""
        return self._size - len(self._bytes)

    @property
    def empty(self) -> bool:
        """Whether nothing waits in it."""
        return not self._bytes

    def put(self, at_s: float, byte: int) -> None:
        """Take a byte; the caller keeps to the room."""
        self._bytes.append((at_s, byte))

    def read(self, until_s: float) -> Iterator[tuple[float, int]]:
        """Yield the bytes that are read out by a time, each with its own."""
        while self._bytes:
            at_s = max(self._bytes[0][0], self._free_s)
            if at_s > until_s:
                return
            self._free_s = at_s + self._byte_s
            yield at_s, self._bytes.popleft()[1]

    def wait(self, until_s: float) -> None:
        """Read nothing out before a time."""
        self._free_s = max(self._free_s, until_s)


class Latches:
    """The selected motor, and the coils of each motor.

    coils: the low nibble of each motor's latch. unclocked: bytes with coils that no change of the selection took in.
    """

    def __init__(self) -> None:
        self.selected = NONE_SELECTED
        self.coils = [0] * MOTORS
        self.unclocked = 0

    def clock(self, byte: int) -> int | None:
        """Take a byte; return the motor whose latch took its coils in, None where there is no clock edge or motor."""
        motor, coils = byte >> 4, byte & 0x0F
        if motor == self.selected:
            self.unclocked += coils != 0
            return None
        self.selected = motor
        if motor >= MOTORS:
            return None
        self.coils[motor] = coils
        return motor
