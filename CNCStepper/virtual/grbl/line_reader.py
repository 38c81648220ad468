# SPDX-License-Identifier: LGPL-2.1-or-later
"""The serial side of the firmware: a ring of 128 bytes, and lines read out of it.

      wire ──► RxRing (128, a full ring loses bytes) ──► LineReader (79 characters, no blanks, no comments)

Real-time bytes never reach the ring: the machine picks them out wherever they stand.
"""

from __future__ import annotations

from collections import deque

RX_BYTES = 128
LINE_CHARACTERS = 79  # a buffer of 80 with its closing zero
LINE_ENDS = b"\r\n"
PARENTHESES, SEMICOLON, OVERFLOW = ord("("), ord(";"), -1


class RxRing:
    """The receive buffer; `lost` counts the bytes that arrived when it was full."""

    def __init__(self) -> None:
        self._bytes: deque[int] = deque()
        self.lost = 0

    @property
    def free(self) -> int:
        """How many bytes still fit, as the status report says it."""
        return RX_BYTES - len(self._bytes)

    def put(self, byte: int) -> None:
        """Take a byte from the wire, or lose it."""
        if self.free:
            self._bytes.append(byte)
        else:
            self.lost += 1

    def take(self) -> int | None:
        """Return the oldest byte, or None."""
        return self._bytes.popleft() if self._bytes else None

    def clear(self) -> None:
        """Forget all that waits."""
        self._bytes.clear()


class LineReader:
    """Makes lines of bytes: capitals, no blanks, no comments, no `/`; unfinished lines wait for more."""

    def __init__(self) -> None:
        self.clear()

    def clear(self) -> None:
        """Forget the line begun."""
        self._line = bytearray()
        self._skipping = 0  # PARENTHESES or SEMICOLON in a comment, OVERFLOW in a line too long

    def next_line(self, ring: RxRing) -> str | None:
        """Return the next whole line, or None when the ring is empty; a line too long is `TOO_LONG`."""
        while (byte := ring.take()) is not None:
            if byte in LINE_ENDS:
                line = TOO_LONG if self._skipping == OVERFLOW else self._line.decode("ascii")
                self.clear()
                return line
            self._add(byte)
        return None

    def _add(self, byte: int) -> None:
        if self._skipping:
            if byte == ord(")") and self._skipping == PARENTHESES:
                self._skipping = 0
        elif byte <= ord(" ") or byte == ord("/"):
            return
        elif byte in (PARENTHESES, SEMICOLON):
            self._skipping = byte
        elif len(self._line) >= LINE_CHARACTERS:
            self._skipping = OVERFLOW
        else:
            self._line.append(byte - 32 if ord("a") <= byte <= ord("z") else byte)


TOO_LONG = "\x00"  # never a line of its own: control characters are dropped
