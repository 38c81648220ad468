# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pieces of a jog for as long as a button is held: always a little ahead of the machine, never much."""

from __future__ import annotations

from collections.abc import Iterator

from CNCStepper.units import S_PER_MIN

PIECE_S = 0.1
AHEAD = 3  # pieces that the controller has before it needs the next: enough to keep its speed


class Held:
    """One direction held down; every piece is as long as its feed goes in `PIECE_S`."""

    def __init__(self, axis: str, sign: int, feed_mm_min: float):
        self.feed_mm_min = feed_mm_min
        self._moves = {f"{axis}_mm": sign * feed_mm_min / S_PER_MIN * PIECE_S}
        self._given = 0

    def pieces(self, since_s: float) -> Iterator[dict[str, float]]:
        """Yield what is due `since_s` after the button went down; after a pause only what a moment is worth."""
        due = int(since_s / PIECE_S) + AHEAD
        self._given = max(self._given, due - AHEAD)
        while self._given < due:
            self._given += 1
            yield dict(self._moves)
