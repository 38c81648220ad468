# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many bytes wait in this computer before they go out over the line.

    write ──► operating system's queue ──► adapter, socket ──► line at baud/10 bytes a second
              what it says waits, or what the line cannot have carried yet: the more of the two

Where the system says nothing (a pseudo-terminal), or cannot know (an adapter, a far end), the line's rate tells.
"""

from __future__ import annotations

import struct
import sys
from collections.abc import Callable
from math import ceil
from typing import Any

QUEUE_BYTES = 40  # that a real-time byte may find before it: 3.5 ms at 115 200 baud
QUEUE_S = 0.002  # where 40 last less: the line would be empty before a sleeping sender is awake
LATE_S = 0.0005  # that a sender may be awake after it meant to: so much of the line still waits then
BITS_PER_BYTE = 10  # start bit, eight data bits, stop bit
SIOCOUTQNSD = 0x894B  # Linux: bytes of a socket that were not sent yet
ROUNDING = 1e-3  # of the clock, in bytes


class WireQueue:
    """Counts the bytes between a program and the line; the caller reports its writes.

    most_bytes: how many may wait, so that a real-time byte goes out at once. filling_bytes: how many of these have left
    when it is time to fill them up.
    """

    def __init__(self, port: Any, baud: int, clock: Callable[[], float]):
        self._said_bytes = _what_says(port)
        self._bytes_per_s = baud / BITS_PER_BYTE
        self.most_bytes = max(QUEUE_BYTES, int(QUEUE_S * self._bytes_per_s))
        self.filling_bytes = self.most_bytes - ceil(LATE_S * self._bytes_per_s) - 1  # which has begun to leave
        self._clock = clock
        self._empty_s = float("-inf")  # when the line will have carried all that was written

    def take(self, count: int) -> None:
        """Count bytes that are written now."""
        self._empty_s = max(self._empty_s, self._clock()) + self.leaving_s(count)

    def leaving_s(self, count: int) -> float:
        """Return how long the line takes for so many bytes, in s."""
        return count / self._bytes_per_s

    def waiting_bytes(self) -> int:
        """Return how many bytes wait; raises OSError when the port has disappeared."""
        left_s = max(self._empty_s - self._clock(), 0.0)
        return max(ceil(left_s * self._bytes_per_s - ROUNDING), self._said_bytes())


def _what_says(port: Any) -> Callable[[], int]:
    """Return a function that asks the operating system, where that is possible."""
    if hasattr(type(port), "out_waiting"):
        return lambda: int(port.out_waiting)
    connection = getattr(port, "_socket", None)
    if connection is not None and sys.platform == "linux":
        return lambda: _unsent_bytes(connection.fileno())
    return lambda: 0


def _unsent_bytes(descriptor: int) -> int:
    import fcntl

    return struct.unpack("i", fcntl.ioctl(descriptor, SIOCOUTQNSD, bytes(4)))[0]
