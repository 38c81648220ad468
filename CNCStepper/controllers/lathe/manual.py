# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jogs by the lathe's manual mode: one byte begins to move, P ends it, and the time between them is the way.

           arrives          P arrives half a wait behind the last step
    A ─────►|--|--|--|--|--|-►
              steps

    A B   X towards the centre, away from it, at rapid      E F   the same at the feed that I sets
    C D   Z away from the chuck (right), towards it         G H

While it moves the lathe takes nothing but P. A rapid stops by its ramp, which is a part of the way. How well the
computer keeps the time decides how well the place is known: a step lasts 0.5 ms at rapid, 6 ms at the fastest feed.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, replace

import numpy as np

from CNCStepper.control.protocol.lathe.jog_guard import STOP
from CNCStepper.controllers.lathe import step_times
from CNCStepper.controllers.lathe.outward_line import OutwardLine

RAPIDS, FEEDS = (b"A", b"B", b"C", b"D"), (b"E", b"F", b"G", b"H")  # X-, X+, Z-, Z+
JOG_AHEAD_S = 1.0  # the jog queue's limit: the client that could cancel it may have left


@dataclass(frozen=True)
class Jog:
    """A way along one axis (0 is X, 1 is Z) in steps, at a feed in mm/s; None is rapid."""

    axis: int
    steps: int
    feed_mm_s: float | None

    def continues(self, other: Jog) -> bool:
        """Return whether this jog continues another one, at its speed."""
        same_way = (self.steps > 0) == (other.steps > 0)
        return same_way and (self.axis, self.feed_mm_s) == (other.axis, other.feed_mm_s)

    @property
    def byte(self) -> bytes:
        """The byte that begins it."""
        letters = RAPIDS if self.feed_mm_s is None else FEEDS
        return letters[2 * self.axis + (self.steps > 0)]


class Manual:
    """The jogs that wait and the one under way; places: steps of X and Z, those of jogs that have ended."""

    def __init__(self, line: OutwardLine, steps_per_mm: tuple[float, float]):
        self.places = [0, 0]
        self._line, self._per_mm = line, steps_per_mm
        self._waiting: deque[Jog] = deque()
        self._jog: Jog | None = None
        self._begin_s = 0.0  # when the lathe began to move
        self._made: int | None = None  # steps up to P, once it is sent
        self._rests_s = 0.0  # when it has stopped behind that
        self._feed_mm_s: float | None = None  # that the lathe was given last

    @property
    def active(self) -> bool:
        """Whether the lathe moves by hand, or is about to."""
        return self._jog is not None or bool(self._waiting)

    def has_room(self, now_s: float) -> bool:
        """Return whether one more jog may wait."""
        soon = self._jog is None or self._made is not None or self._release_s() - now_s < JOG_AHEAD_S
        return soon and not self._waiting

    def add(self, jog: Jog, now_s: float) -> None:
        """Queue a jog; one that continues the last in the same direction extends it."""
        if self._waiting and jog.continues(self._waiting[-1]):
            self._waiting[-1] = replace(jog, steps=self._waiting[-1].steps + jog.steps)
        elif self._jog and self._made is None and not self._waiting and jog.continues(self._jog):
            self._jog = replace(jog, steps=self._jog.steps + jog.steps)
        else:
            self._waiting.append(jog)
        self.advance(now_s)

    def advance(self, now_s: float) -> None:
        """Start due jogs and end finished ones; raises LinkError where the port is lost."""
        if self._jog and self._made is None and self._line.arrival_s(len(STOP), now_s) >= self._release_s():
            self._release(now_s, self._wanted_steps())
        if self._jog and self._made is not None and now_s >= self._rests_s:
            self.places[self._jog.axis] += self._signed(self._all_steps())
            self._jog = None
        if not self._jog and self._waiting:
            self._begin(self._waiting.popleft(), now_s)

    def stop(self, now_s: float) -> None:
        """End the jog under way now, and forget those that wait."""
        self._waiting.clear()
        if self._jog and self._made is None:
            self._release(now_s, None)

    def places_at(self, now_s: float) -> tuple[int, int]:
        """Return the steps of X and Z, reckoned."""
        x, z = self.places
        if self._jog is None:
            return x, z
        made = self._signed(self._steps_at(now_s))
        return (x + made, z) if self._jog.axis == 0 else (x, z + made)

    def speed_mm_s(self, now_s: float) -> float:
        """Return the speed of the jog under way."""
        if self._jog is None or now_s < self._begin_s:
            return 0.0
        return 1.0 / (self._wait_s(self._steps_at(now_s)) * self._per_mm[self._jog.axis])

    # -- inside --------------------------------------------------------------------------------------

    def _begin(self, jog: Jog, now_s: float) -> None:
        self._jog, self._made = jog, None
        if jog.feed_mm_s is not None and jog.feed_mm_s != self._feed_mm_s:
            self._line.send(f"I{jog.feed_mm_s:.4f}?".encode("ascii"), now_s)
            self._feed_mm_s = jog.feed_mm_s
        self._begin_s = self._line.send(jog.byte, now_s)

    def _release(self, now_s: float, made: int | None) -> None:
        """Send P; made: the steps that the lathe has made when it hears it, None for those by the clock."""
        assert self._jog
        there_s = self._line.send(STOP, now_s)
        by_clock = self._steps_before(there_s - self._begin_s)
        late = made is None or there_s - self._begin_s > self._time_of(made + 1)
        self._made = by_clock if late or made is None else made
        brakes_s = step_times.braking_s(self._made) if self._is_rapid else 0.0
        self._rests_s = there_s + brakes_s

    @property
    def _is_rapid(self) -> bool:
        return self._jog is not None and self._jog.feed_mm_s is None

    def _wanted_steps(self) -> int:
        """Return the steps up to P, so that what follows ends the way."""
        assert self._jog
        count = abs(self._jog.steps)
        if not self._is_rapid:
            return count
        ramp = len(step_times.WAITS)
        return count - ramp if count >= 2 * ramp else (count + 1) // 2

    def _release_s(self) -> float:
        """Return when P should be at the lathe: half a wait behind the last step before it."""
        made = self._wanted_steps()
        return self._begin_s + self._time_of(made) + self._wait_s(made) / 2

    def _all_steps(self) -> int:
        assert self._made is not None
        return self._made + (step_times.braking_steps(self._made) if self._is_rapid else 0)

    def _steps_at(self, now_s: float) -> int:
        """Return the steps made by now, without sign."""
        made = self._steps_before(now_s - self._begin_s)
        if self._made is None or made <= self._made:
            return made
        return self._all_steps() if now_s >= self._rests_s else self._made

    def _steps_before(self, after_s: float) -> int:
        """Return how many steps the lathe makes in a time, without an end."""
        if after_s <= 0.0 or self._jog is None:
            return 0
        if not self._is_rapid:
            return int(after_s / self._wait_s(0) + 1e-9)
        ramp = step_times.rapid_times_s(len(step_times.WAITS))
        if after_s < ramp[-1]:
            return int(np.searchsorted(ramp, after_s, side="right"))
        return len(ramp) + int((after_s - ramp[-1]) / step_times.rapid_wait_s(len(ramp)) + 1e-9)

    def _time_of(self, made: int) -> float:
        """Return when the lathe has made so many steps, from its begin."""
        if not self._is_rapid:
            return made * self._wait_s(0)
        ramp = min(made, len(step_times.WAITS))
        times = step_times.rapid_times_s(ramp)
        return (float(times[-1]) if ramp else 0.0) + (made - ramp) * step_times.rapid_wait_s(len(step_times.WAITS))

    def _wait_s(self, made: int) -> float:
        assert self._jog
        if self._jog.feed_mm_s is None:
            return step_times.rapid_wait_s(made)
        return step_times.feed_wait_s(self._jog.feed_mm_s, self._per_mm[self._jog.axis])

    def _signed(self, steps: int) -> int:
        assert self._jog
        return steps if self._jog.steps > 0 else -steps
