# SPDX-License-Identifier: LGPL-2.1-or-later
"""The serial side of the firmware: a ring of bytes, 128 of grbl, and lines read out of it.

      wire ──► RxRing (a full ring loses bytes) ──► LineReader (grbl: 79 characters; no blanks, no comments)

Real-time bytes never reach the ring: the machine picks them out wherever they stand.
"""

from __future__ import annotations

import re

from CNCStepper.virtual.grbl.firmware import GRBL, Firmware

LINE_ENDS = b"\r\n"
PARENTHESES, SEMICOLON, OVERFLOW = ord("("), ord(";"), -1
_LINE = re.compile(rb"[^\r\n]*[\r\n]?")
_PLAIN = re.compile(rb"[!-'*-.0-:<-~]*")  # no blanks, comments, `/`


class RxRing:
    """The receive buffer; `lost` counts the bytes that arrived when it was full."""

    def __init__(self, size: int = GRBL.receive_bytes) -> None:
        self._size = size
        self._bytes = b""
        self.lost = 0

    @property
    def free(self) -> int:
        """How many bytes still fit, as the status report says it."""
        return self._size - len(self._bytes)

    @property
    def empty(self) -> bool:
        """Whether nothing waits in it."""
        return not self._bytes

    def put(self, data: bytes) -> None:
        """Take bytes from the wire, or lose those for which there is no room."""
        self.lost += max(len(data) - self.free, 0)
        self._bytes += data[: self.free]

    def take(self) -> bytes:
        """Return the oldest bytes: a line with one byte of its end, or all when there is no end."""
        line = _LINE.match(self._bytes)
        assert line  # the pattern matches nothing, too
        self._bytes = self._bytes[line.end() :]
        return line[0]

    def swap(self, data: bytes) -> bytes:
        """Let other bytes wait in it, and return those that did."""
        self._bytes, before = data, self._bytes
        return before

    def clear(self) -> None:
        """Forget all that waits."""
        self._bytes = b""


class LineReader:
    """Makes lines of bytes: capitals, no blanks, no comments, no `/`; unfinished lines wait for more."""

    def __init__(self, firmware: Firmware = GRBL) -> None:
        self._firmware = firmware
        self.clear()

    def clear(self) -> None:
        """Forget the line begun."""
        self._line = bytearray()
        self._blanks = 0  # of those that count
        self._skipping = 0  # PARENTHESES or SEMICOLON in a comment, OVERFLOW in a line too long

    def next_line(self, ring: RxRing) -> str | None:
        """Return the next whole line, or None when the ring is empty; a line too long is `TOO_LONG`."""
        taken = ring.take()
        text = taken.rstrip(LINE_ENDS)
        if self._is_new and len(text) <= self._firmware.line_characters and _PLAIN.fullmatch(text):
            self._line += text.upper()
        else:
            for byte in text:
                self._add(byte)
        if len(text) == len(taken):
            return None
        line = TOO_LONG if self._skipping == OVERFLOW else self._line.decode("ascii")
        self.clear()
        return line

    @property
    def _is_new(self) -> bool:
        return not (self._line or self._blanks or self._skipping)

    def _add(self, byte: int) -> None:
        if self._skipping:
            if byte == ord(")") and self._skipping == PARENTHESES:
                self._skipping = 0
        elif byte <= ord(" ") or byte == ord("/"):
            self._blanks += self._firmware.blanks_count
            if len(self._line) + self._blanks > self._firmware.line_characters:
                self._skipping = OVERFLOW
        elif byte in (PARENTHESES, SEMICOLON):
            self._skipping = byte
        elif len(self._line) + self._blanks >= self._firmware.line_characters:
            self._skipping = OVERFLOW
        else:
            self._line.append(byte - 32 if ord("a") <= byte <= ord("z") else byte)


TOO_LONG = "\x00"  # never a line of its own: control characters are dropped
