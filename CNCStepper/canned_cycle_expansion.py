# SPDX-License-Identifier: LGPL-2.1-or-later
"""The canned drilling cycles: what a block of each means, move by move; one definition for cycles, reader and writer.

    clear  ----.  .---   G98: the height before the first block of a run, or R where that is higher
               |  ^      rapid
    R      ----v--|---   G99: back to here
               |  |      feed down to Z, in pecks of Q from R on; between them G83 goes up to R and back,
    Z      ----v--'      G73 only up by a little; at the bottom G82 waits P seconds

It is that of LinuxCNC 2.9, as its interpreter expands it. All values are in one unit; nothing here knows which.
Only how far rounding carries a sum of pecks is the reader's own matter: `Canned.levels`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import count, takewhile
from typing import NamedTuple

PECK_BACK_MM = 0.254  # how far above the last peck a rapid ends: LinuxCNC's .010 inch
OWN_WORD = {"G81": "", "G82": "P", "G83": "Q", "G73": "Q"}
CYCLE_NAMES = tuple(OWN_WORD)
ROUNDING = 1e-9  # of a peck: what is left below this is none
RAPID, FEED, DWELL = "rapid", "feed", "dwell"
Place = tuple[float, float, float]  # in the plane, first and second axis, then along its normal


class Stroke(NamedTuple):
    """One move of a cycle: rapid or feed to `end`, or a dwell of `seconds` there."""

    kind: str
    end: Place
    seconds: float = 0.0


@dataclass(frozen=True)
class Canned:
    """A cycle with its words: z is the bottom, r the retract plane, own its P (seconds) or Q (peck).

    to_initial: G98. back: how far above the last peck a rapid ends.
    """

    name: str
    z: float
    r: float
    own: float = 0.0
    to_initial: bool = False
    back: float = PECK_BACK_MM

    @property
    def pecks(self) -> float:
        """About how many times the tool goes down for a hole."""
        return (self.r - self.z) / self.own + 1.0 if OWN_WORD[self.name] == "Q" else 1.0

    def clear(self, initial: float) -> float:
        """Return the height at which a hole ends; `initial`: that before the first block of the run."""
        return max(initial, self.r) if self.to_initial else self.r

    def lift(self, begin: Place, initial: float) -> list[Stroke]:
        """Return the rapid straight up with which a block begins when the run began below R."""
        return [Stroke(RAPID, (*begin[:2], self.r))] if initial < self.r else []

    def holes(self, height: float, initial: float, places: Iterable[tuple[float, float]]) -> Iterator[list[Stroke]]:
        """Yield the strokes of each hole, one after the other from `height`."""
        clear = self.clear(initial)
        for place in places:
            over = height if height > self.r else clear
            way_in = [Stroke(RAPID, (*place, over))] + [Stroke(RAPID, (*place, self.r))] * (over > self.r)
            yield way_in + [Stroke(kind, (*place, level), seconds) for kind, level, seconds in self._strokes(clear)]
            height = clear

    def _strokes(self, clear: float) -> Iterator[tuple[str, float, float]]:
        if OWN_WORD[self.name] == "Q":
            yield from self._pecks()
        yield FEED, self.z, 0.0
        if self.name == "G82":
            yield DWELL, self.z, self.own
        yield RAPID, clear, 0.0

    def levels(self) -> Iterator[float]:
        """Yield where the pecks but the last end."""
        bottom = self.z + ROUNDING * self.own
        return takewhile(lambda level: level > bottom, (self.r - k * self.own for k in count(1)))

    def _pecks(self) -> Iterator[tuple[str, float, float]]:
        """Yield all pecks but the last, which ends at the bottom."""
        for level in self.levels():
            yield FEED, level, 0.0
            if self.name == "G83":
                yield RAPID, self.r, 0.0
            yield RAPID, level + self.back, 0.0
