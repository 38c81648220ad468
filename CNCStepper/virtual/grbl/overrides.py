# SPDX-License-Identifier: LGPL-2.1-or-later
"""The overrides that real-time bytes set: feed, rapid and spindle in percent."""

from __future__ import annotations

from dataclasses import dataclass

LOWEST, HIGHEST, NORMAL = 10, 200, 100
FEED_CHANGES = {0x91: 10, 0x92: -10, 0x93: 1, 0x94: -1}
RAPID_VALUES = {0x95: 100, 0x96: 50, 0x97: 25}
SPINDLE_CHANGES = {0x9A: 10, 0x9B: -10, 0x9C: 1, 0x9D: -1}
FEED_NORMAL, SPINDLE_NORMAL = 0x90, 0x99


@dataclass
class Overrides:
    """Percentages; a change that would leave 10 to 200 stops there."""

    feed: int = NORMAL
    rapid: int = NORMAL
    spindle: int = NORMAL

    def normalize(self) -> None:
        """Go back to 100 %, as the end of a program does."""
        self.feed = self.rapid = self.spindle = NORMAL

    def apply(self, byte: int) -> bool:
        """Apply a real-time byte; return whether a value changed."""
        before = (self.feed, self.rapid, self.spindle)
        if byte == FEED_NORMAL:
            self.feed = NORMAL
        elif byte in FEED_CHANGES:
            self.feed = _within(self.feed + FEED_CHANGES[byte])
        elif byte in RAPID_VALUES:
            self.rapid = RAPID_VALUES[byte]
        elif byte == SPINDLE_NORMAL:
            self.spindle = NORMAL
        elif byte in SPINDLE_CHANGES:
            self.spindle = _within(self.spindle + SPINDLE_CHANGES[byte])
        return before != (self.feed, self.rapid, self.spindle)


def _within(percent: int) -> int:
    return min(max(percent, LOWEST), HIGHEST)
