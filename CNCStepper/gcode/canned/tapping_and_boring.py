# SPDX-License-Identifier: LGPL-2.1-or-later
"""The canned cycles that need the spindle: tapping (G74, G84) and boring (G85 to G89), as LinuxCNC 2.9.

G84, G74  down, turn the other way, wait P, up, turn as before         G85  down, up to R (both at the feed)
G86       down, wait P, stop, rapid up, turn                           G88  down, wait P, stop, pause, turn
G89       down, wait P, up (both at the feed)
G87       stopped, beside the hole: down; to its axis, turn, up to the middle, down; stopped: beside it, up
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from CNCStepper.canned_drilling import DWELL, FEED, RAPID, Canned, Stroke

TURN, REVERSE, STOP, ORIENT, PAUSE, LOCK, UNLOCK = "turn", "reverse", "stop", "orient", "pause", "lock", "unlock"
OWN = {"G74": "P", "G84": "P", "G85": "", "G86": "P", "G87": "IJK", "G88": "P", "G89": "P"}
SENSE = {"G84": "cw", "G74": "ccw", "G86": "", "G87": "", "G88": ""}  # in which the spindle must turn; "" is any


@dataclass(frozen=True)
class SpindleCycle(Canned):
    """Such a cycle; own: P in seconds. aside: G87's offset in the plane, middle: how far up it bores."""

    aside: tuple[float, float] = (0.0, 0.0)
    middle: float = 0.0

    @property
    def pecks(self) -> float:
        """About how many times the tool goes down for a hole."""
        return 3.0

    def holes(self, height: float, initial: float, places: Iterable[tuple[float, float]]) -> Iterator[list[Stroke]]:
        """Yield the strokes of each hole, one after the other from `height`."""
        clear = self.clear(initial)
        for place in places:
            over = height if height > self.r else clear
            way_in = [Stroke(RAPID, (*place, over))] + [Stroke(RAPID, (*place, self.r))] * (over > self.r)
            yield way_in + list(self._work(place, clear))
            height = clear

    def _work(self, place: tuple[float, float], clear: float) -> Iterator[Stroke]:
        """Yield what is done at a hole, from R on."""
        bottom, top = (*place, self.z), (*place, clear)
        if self.name == "G87":
            yield from self._back_bore(place, clear)
            return
        if self.name in ("G74", "G84"):
            yield Stroke(LOCK, bottom)
            yield from (Stroke(FEED, bottom), Stroke(STOP, bottom), Stroke(REVERSE, bottom))
            yield from (Stroke(DWELL, bottom, self.own), Stroke(FEED, top), Stroke(STOP, top))
            yield from (Stroke(TURN, top), Stroke(UNLOCK, top))
            return
        yield Stroke(FEED, bottom)
        if self.name != "G85":
            yield Stroke(DWELL, bottom, self.own)
        if self.name == "G85":
            yield from (Stroke(FEED, (*place, self.r)), Stroke(RAPID, top))
            return
        if self.name == "G89":
            yield Stroke(FEED, top)
            return
        yield Stroke(STOP, bottom)
        yield Stroke(RAPID, top) if self.name == "G86" else Stroke(PAUSE, bottom)
        yield Stroke(TURN, top)

    def _back_bore(self, place: tuple[float, float], clear: float) -> Iterator[Stroke]:
        beside = (place[0] + self.aside[0], place[1] + self.aside[1])
        deep, free = (*place, self.z), (*beside, self.z)
        yield from (Stroke(RAPID, (*beside, self.r)), Stroke(STOP, free), Stroke(ORIENT, free))
        yield from (Stroke(RAPID, free), Stroke(RAPID, deep), Stroke(TURN, deep))
        yield from (Stroke(FEED, (*place, self.middle)), Stroke(FEED, deep), Stroke(STOP, deep), Stroke(ORIENT, deep))
        yield from (Stroke(RAPID, free), Stroke(RAPID, (*beside, clear)), Stroke(RAPID, (*place, clear)))
        yield Stroke(TURN, (*place, clear))
