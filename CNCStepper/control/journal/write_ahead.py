# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many lines a journal records ahead of the lines sent: never so few that the stream waits.

A slow line after slow ones says nothing of the next, which may be one of many short ones: so never fewer are allowed
than the line can carry while a slow disk writes.
"""

from __future__ import annotations

from CNCStepper.control.transport.output_queue import BITS_PER_BYTE

LEAST, MOST = 16, 8192  # lines, whatever the baud rate
DISK_S = 0.4  # of lines as quick as the line carries them: for half of that a write may take
LINE_BYTES = 12  # of a short line with its end
AHEAD_S = 2.0  # of lines at the present rate
REFILL = 0.5  # of them left: time to write the next
WINDOW_S = 1.0  # over which the rate is taken


def least_lines(baud: int) -> int:
    """Return how many lines are always allowed ahead on a line of so many bits a second."""
    return min(max(round(DISK_S * baud / (BITS_PER_BYTE * LINE_BYTES)), LEAST), MOST)


class WriteAhead:
    """Follows the rate at which lines go out; a disk that was too slow for it once gets twice the time."""

    def __init__(self, now_s: float, baud: int):
        self.lines = self._least = least_lines(baud)
        self._rate = 0.0  # of the window before
        self._sent, self._since_s = 0, now_s

    def is_short(self, sent: int, permitted: int) -> bool:
        """Return whether the next range is due."""
        return permitted - sent <= self.lines * REFILL

    def next_range(self, sent: int, permitted: int, now_s: float) -> int:
        """Return how many lines may be sent in all from now on; called once for each group."""
        least = 2 * self.lines if sent >= permitted else self._least
        self.lines = round(min(max(self._rate_now(sent, now_s) * AHEAD_S, least), MOST))
        return sent + self.lines

    def _rate_now(self, sent: int, now_s: float) -> float:
        """Return lines a second, of this window or of the one before, whichever is more."""
        elapsed_s = now_s - self._since_s
        rate = (sent - self._sent) / max(elapsed_s, WINDOW_S)
        more = max(rate, self._rate)
        if elapsed_s >= WINDOW_S:
            self._rate, self._sent, self._since_s = rate, sent, now_s
        return more
