# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lathe's serial line and its receive buffer: 9600 baud, eight bits, even parity, one stop bit.

computer ──► adapter, 64 bytes ahead ──► line, 11 bits a byte ──► buffer of the controller, its full size unpublished

The lathe sends nothing, so a sender cannot know the fill of the buffer. Bytes for which there is no room are lost.
"""

from __future__ import annotations

from collections import deque

BAUD = 9600
BITS_PER_BYTE = 11  # start bit, eight data bits, parity, stop bit
BYTE_S = BITS_PER_BYTE / BAUD
ADAPTER_BYTES = 64  # what an adapter takes from the computer ahead of the line
BUFFER_BYTES = 256  # the source does not say: so small that a sender that counts on more is found out
CHUNK_END = ord("?")


class SerialLine:
    """Bytes on their way to the controller, each with the time at which it is there."""

    def __init__(self, byte_s: float = BYTE_S):
        self._byte_s = byte_s
        self._bytes: deque[tuple[float, int]] = deque()
        self._last_s = 0.0

    @property
    def room(self) -> int:
        """How many bytes the adapter takes now."""
        return max(ADAPTER_BYTES - len(self._bytes), 0)

    @property
    def next_s(self) -> float | None:
        """When the next byte is there; None when none is on its way."""
        return self._bytes[0][0] if self._bytes else None

    def put(self, data: bytes, now_s: float) -> None:
        """Send bytes, one behind the other."""
        for byte in data:
            self._last_s = max(now_s, self._last_s) + self._byte_s
            self._bytes.append((self._last_s, byte))

    def get(self) -> int:
        """Return the next byte."""
        return self._bytes.popleft()[1]

    def clear(self) -> None:
        """Lose what is on its way."""
        self._bytes.clear()


class Buffer:
    """The controller's receive buffer; `lost` counts the bytes that came when it was full."""

    def __init__(self, size: int = BUFFER_BYTES):
        self.size = size
        self.lost = 0
        self._bytes = bytearray()

    def __len__(self) -> int:
        return len(self._bytes)

    @property
    def has_chunk(self) -> bool:
        """Whether a whole piece of a program waits, up to its "?"."""
        return CHUNK_END in self._bytes

    def put(self, byte: int) -> bool:
        """Take a byte; return whether there was room."""
        if len(self._bytes) >= self.size:
            self.lost += 1
            return False
        self._bytes.append(byte)
        return True

    def take_byte(self) -> int:
        """Return the oldest byte, and give its room free."""
        return self._bytes.pop(0)

    def take_record(self) -> tuple[str, bool]:
        """Return the oldest record of a whole chunk, without its "#", and whether the chunk ends with it."""
        end = self._bytes.index(CHUNK_END)
        record, mark, _ = bytes(self._bytes[:end]).partition(b"#")
        taken = len(record) + 1
        ends = not mark
        if mark and not bytes(self._bytes[taken:end]).strip():
            taken, ends = end + 1, True
        del self._bytes[:taken]
        return record.decode("latin-1"), ends

    def clear(self) -> None:
        """Forget all that waits."""
        self._bytes.clear()
