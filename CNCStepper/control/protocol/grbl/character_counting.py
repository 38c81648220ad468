# SPDX-License-Identifier: LGPL-2.1-or-later
"""Character counting: lines that the controller has not answered, and the room in its receive buffer.

The controller keeps `window` bytes of lines that it has not read. Every line sent is remembered with its length until
its answer comes; answers come in the order of the lines.

    unanswered   | G1X10 | G1X20Y5 | G1X30 |            sum of (length + 1) <= window
                   ^ the next answer is for this one
                             `--- to_write: counted, but still in this computer
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

WINDOW_BYTES = 127  # of grbl's 128 one stays free; larger buffers say so themselves ($I, Bf)


@dataclass(slots=True)
class Sent:
    """A line under way; index: its place in the job from 0, or -1."""

    text: str
    index: int


class CharacterCounting:
    """The lines under way to one controller.

    window: bytes of its receive buffer, of which one stays free. bytes_under_way: of all unanswered lines with their
    line ends. to_write: the end of these, which the link has not taken yet.
    """

    def __init__(self) -> None:
        self.window = WINDOW_BYTES
        self.unanswered: deque[Sent] = deque()
        self.bytes_under_way = 0
        self.to_write = bytearray()
        self._free_bytes = 0  # with nothing under way: the controller's report of its whole buffer

    def fits(self, text: str) -> bool:
        """Return whether the receive buffer has room for one more line."""
        return self.bytes_under_way + len(text) + 1 <= self.window

    def add(self, text: str, index: int) -> None:
        """Count a line and queue its bytes; the caller has asked `fits`."""
        self.unanswered.append(Sent(text, index))
        self.bytes_under_way += len(text) + 1
        self.to_write += text.encode("ascii") + b"\n"

    def written(self) -> int:
        """Return how many bytes of unanswered lines the link has taken."""
        return self.bytes_under_way - len(self.to_write)

    def answered(self) -> Sent:
        """Return the line of the answer that just came, which the controller has read; there must be one."""
        sent = self.unanswered.popleft()
        self.bytes_under_way -= len(sent.text) + 1
        return sent

    def forget(self) -> None:
        """Drop all lines, as a controller does that is reset."""
        self.unanswered.clear()
        self.to_write.clear()
        self.bytes_under_way = 0

    def see_free_bytes(self, free_bytes: int, keeps_window: bool) -> None:
        """Take the free bytes of a status (`Bf`): with nothing under way that is the whole buffer.

        keeps_window: the buffer may be larger than this, but is never smaller than what was known.
        """
        if not self.unanswered:
            self._free_bytes = free_bytes
            self.window = max(self.window if keeps_window else 0, free_bytes - 1)

    def see_size(self, size_bytes: int) -> None:
        """Take the size of the receive buffer from `$I`; one that is not said changes nothing."""
        if size_bytes > 1:
            self.window = max(size_bytes, self._free_bytes) - 1
