# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines that go to a place of the machine (G28, G30, G53): they are sent as written, since beyond it travel may end.

text      A ───────────► P
motors    A ─► ────────► P    what is left of the gaps first, where several axes move: so the tool goes straight
tool      A ──────────► T     short of P by the play, where its axis goes against its true sense
next feed move          T►P   begins with the motors' way on by the play, unless it leads this axis alone
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence, Set
from math import isnan

from CNCStepper.machine.backlash import SAME_MM, Motors

Place = tuple[float, ...]


class AsWritten:
    """Follows the motors along such lines, and which axes have left their tool short of the place."""

    def __init__(self, motors: Motors):
        self._motors, self._play = motors, motors.play
        self._short: dict[int, float] = {}  # by axis: how far the motor is ahead of the tool, which is not at its place

    def ready_mm(self, position_mm: Sequence[float], first_mm: Sequence[float]) -> Place | None:
        """Return the motor positions at which the tool starts with them; None when they are there.

        position_mm: of the tool, as the text says. first_mm: to which the motors go first.
        """
        at_mm = self._motors.at_mm
        ready = list(at_mm)
        for axis in (moved := self.moved(at_mm, first_mm)):
            ahead_mm = self._ahead_mm(axis, position_mm)
            if len(moved) > 1 and not isnan(ahead_mm):
                sense = self._play.sense(axis, at_mm[axis], first_mm[axis])
                place = at_mm[axis] - ahead_mm + self._play.ahead_mm(axis, sense)
                ready[axis] = min(place, first_mm[axis]) if sense > 0 else max(place, first_mm[axis])
        return tuple(ready) if any(abs(one - at) > SAME_MM for one, at in zip(ready, at_mm, strict=True)) else None

    def go(self, axes: Iterable[int], position_mm: Sequence[float], places_mm: Iterable[Sequence[float]]) -> None:
        """Let the motors of some axes go from place to place, the tool being where the text says."""
        places = list(places_mm)
        for axis in axes:
            ahead_mm, at_mm = self._ahead_mm(axis, position_mm), self._motors.at_mm[axis]
            for place in places:
                ahead_mm = self._after(axis, ahead_mm, place[axis] - at_mm)
                at_mm = place[axis]
            self._motors.at_mm[axis] = at_mm
            self._short.pop(axis, None)
            if abs(ahead_mm) > SAME_MM and not isnan(at_mm):
                self._short[axis] = ahead_mm

    def rest_mm(self, moved: Set[int]) -> Place | None:
        """Return where the motors go before a feed move so that the tool is where the text says; None where it is.

        moved: the axes that the move leads; one that it leads alone comes to its way by itself.
        """
        if not self._short.keys() - (moved if len(moved) == 1 else set()):
            return None
        ready = list(self._motors.at_mm)
        for axis in self._short:
            ready[axis] += self._play.ahead_mm(axis, -self._play.true_sense[axis])
        return tuple(ready)

    def went(self, axes: Iterable[int]) -> None:
        """Note that the play of some axes was taken up, or that they go on by a way that takes it up."""
        for axis in axes:
            self._short.pop(axis, None)

    def moved(self, begin_mm: Sequence[float], end_mm: Sequence[float]) -> set[int]:
        """Return the axes that make steps between two places, of which none may be unknown."""
        ways = enumerate(zip(begin_mm, end_mm, strict=True))
        return {axis for axis, way in ways if not any(map(isnan, way)) and self._play.sense(axis, *way)}

    def _ahead_mm(self, axis: int, position_mm: Sequence[float]) -> float:
        """Return how far a motor is ahead of its tool; NaN where nobody knows."""
        return self._short.get(axis, self._motors.at_mm[axis] - position_mm[axis])

    def _after(self, axis: int, ahead_mm: float, way_mm: float) -> float:
        """Return the same after a way; from a place that nobody knows the tool may be as short as it can."""
        if isnan(ahead_mm) or isnan(way_mm):
            return self._play.ahead_mm(axis, -self._play.true_sense[axis])
        return self._play.ahead_after(axis, ahead_mm, way_mm)
