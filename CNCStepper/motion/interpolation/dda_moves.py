# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moves by the thesis's own interpolators (A2, A3): straight lines, and arcs whole, each timed by itself.

    speed    ______________      every move begins and ends at rest: its first pulse comes after the time that the
            /              \\     acceleration takes for one step, which is the start/stop speed, and its last one as
           /________________\\    late behind the one before. A round is a unit of path, so pulses keep the speed along
            round ->             the path whatever their direction

A planner's ramp by jerk or by a table of waits does not apply here: the ramp is the axes' acceleration.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from CNCStepper.motion.interpolation.circular_dda import circular_dda
from CNCStepper.motion.interpolation.linear_dda import linear_dda
from CNCStepper.motion.planner.buffers import TICKS_PER_S
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.signals.planned_pulses import MoveSource, PlannedPulses
from CNCStepper.motion.signals.pulse_stream import PulseStream
from CNCStepper.units import mm_s_from_mm_min

Steps = tuple[int, ...]


@dataclass(frozen=True)
class _Move:
    """One move that waits; speeds and acceleration are along the path. A round of its pulses is `round_mm` of path."""

    pulses: Callable[[], PulseStream]
    round_mm: float
    speed_mm_s: float
    most_mm_s: float
    acceleration_mm_s2: float
    is_rapid: bool
    number: int


class DdaMoves(MoveSource):
    """Straight moves and arcs of the XY plane; published: with the registers as printed, for figure and table."""

    def __init__(self, limits: Limits, steps: Sequence[int], published: bool = False):
        self._published = published
        self._tick = 0  # of the planned clock: the last pulse made
        self._feed = 1.0
        self._moves: deque[_Move] = deque()
        self._made: PlannedPulses | None = None
        self._end: Steps = tuple(steps)
        self._adopt(limits)

    @property
    def room(self) -> int:
        return self._limits.look_ahead_blocks - len(self._moves)

    @property
    def idle(self) -> bool:
        return not self._moves and not self._made

    @property
    def end_steps(self) -> tuple[int, ...]:
        """Where the last pulse of the last move ends."""
        return self._end

    def line(self, target_mm: Sequence[float], feed_mm_min: float, rapid: bool) -> None:
        """Queue a straight move to a machine position; one shorter than a step is none."""
        end = self._steps_of(target_mm)
        way = tuple(there - here for there, here in zip(end, self._end, strict=True))
        if not any(way):
            return
        ways_mm = np.abs(np.array(way) / self._per_mm)
        length_mm = float(np.linalg.norm(ways_mm))
        rounds = math.isqrt(sum(count**2 for count in way))
        with np.errstate(divide="ignore"):
            most, acceleration = (float((values * length_mm / ways_mm).min()) for values in (self._tops, self._ramps))
        if rapid and self._limits.rapid_mm_min is not None:
            most = min(most, mm_s_from_mm_min(self._limits.rapid_mm_min))
        begin = self._end
        speed = most if rapid else mm_s_from_mm_min(feed_mm_min)
        number = self.last_move + 1
        self._queue(_Move(lambda: linear_dda(way, begin), length_mm / rounds, speed, most, acceleration, rapid, number))
        self._end = end

    def takes_arc(self, target_mm: Sequence[float], plane: int) -> bool:
        """Return whether an arc can be made whole: in XY, at one height, both axes of one resolution."""
        end = self._steps_of(target_mm)
        return plane == 0 and self._per_mm[0] == self._per_mm[1] and end[2:] == self._end[2:]

    def arc(
        self,
        target_mm: Sequence[float],
        centre_mm: Sequence[float],
        radius_mm: float,
        clockwise: bool,
        feed_mm_min: float,
    ) -> None:
        """Queue an arc that `takes_arc` takes; there must be room. Both places are the machine's."""
        (begin_x, begin_y, *_), end = self._end, self._steps_of(target_mm)
        centre = (float(centre_mm[0] * self._per_mm[0]), float(centre_mm[1] * self._per_mm[1]))
        radius = radius_mm * float(self._per_mm[0])
        acceleration = float(min(self._ramps[:2]))
        most = min(float(min(self._tops[:2])), math.sqrt(acceleration * radius_mm))

        def pulses() -> PulseStream:
            return circular_dda(
                (begin_x, begin_y), (end[0], end[1]), centre, clockwise, published=self._published, radius_steps=radius
            )

        round_mm = radius_mm / (radius * radius * math.sqrt(2.0))
        speed = mm_s_from_mm_min(feed_mm_min)
        self._queue(_Move(pulses, round_mm, speed, most, acceleration, False, self.last_move + 1))
        self._end = end

    def make(self, seconds: float) -> list[PlannedPulses]:
        """Return the next pulses, about so much time of them; those of the next move once the last one's are out."""
        if not self._made and self._moves:
            self._made = self._timed(self._moves.popleft())
        if not self._made:
            return []
        last = int(np.searchsorted(self._made.ticks, self._made.ticks[0] + seconds * TICKS_PER_S, side="right"))
        now, rest = self._made.cut(0, last), self._made.cut(last, len(self._made))
        self._made = rest if len(rest) else None
        return [now]

    def quicken(self, feed: float) -> None:
        """Make moves that are not begun yet at this factor, 1 or more, of their feed."""
        self._feed = feed

    def stand_at(self, steps: Sequence[int], limits: Limits) -> None:
        self._moves.clear()
        self._made = None
        self._end = tuple(steps)
        self._adopt(limits)

    def _adopt(self, limits: Limits) -> None:
        self._limits = limits
        self._per_mm = np.array(limits.steps_per_mm)
        self._tops, self._ramps = np.array(limits.max_speed_mm_s), np.array(limits.acceleration_mm_s2)

    def _queue(self, move: _Move) -> None:
        self.last_move = move.number
        self._moves.append(move)

    def _steps_of(self, place_mm: Sequence[float]) -> Steps:
        return tuple(np.rint(np.array(place_mm, float) * self._per_mm).astype(np.int64).tolist())

    def _timed(self, move: _Move) -> PlannedPulses | None:
        """Return the pulses of a whole move; None where it has none."""
        chunks = [(chunk.ticks.copy(), chunk.step.copy(), chunk.back.copy()) for chunk in move.pulses()]
        if not chunks:
            return None
        rounds, step, back = (np.concatenate(columns) for columns in zip(*chunks, strict=True))
        speed = min(move.speed_mm_s * (1.0 if move.is_rapid else self._feed), move.most_mm_s)
        places_mm = rounds * move.round_mm
        times_s = _times_s(places_mm, speed, move.acceleration_mm_s2)
        ticks = self._tick + _rising(np.rint(times_s * TICKS_PER_S).astype(np.int64))
        waits_s = np.diff(ticks, prepend=self._tick) / TICKS_PER_S
        speeds = (np.diff(places_mm, prepend=0.0) / waits_s).astype(np.float32)
        self._tick, count = int(ticks[-1]), len(rounds)
        values = (np.full(count, one) for one in (np.float32(move.acceleration_mm_s2), move.is_rapid, move.number))
        return PlannedPulses(ticks, step, back, speeds, *values)


def _rising(ticks: np.ndarray) -> np.ndarray:
    """Return ticks int64[k] with those put off that a large arc's rounds, shorter than a tick, have made one."""
    rows = np.arange(len(ticks))
    return np.maximum.accumulate(ticks - rows) + rows


def _times_s(places_mm: np.ndarray, speed_mm_s: float, acceleration_mm_s2: float) -> np.ndarray:
    """Return when places along a path are reached, from rest at 0 to rest at the last of them, float64 in s."""
    end_mm = places_mm[-1]
    top = min(speed_mm_s, math.sqrt(acceleration_mm_s2 * end_mm))
    ramp_mm, ramp_s = top**2 / (2 * acceleration_mm_s2), top / acceleration_mm_s2
    all_s = 2 * ramp_s + (end_mm - 2 * ramp_mm) / top
    left_mm = end_mm - places_mm
    from_begin_s, from_end_s = (np.sqrt(2 * way / acceleration_mm_s2) for way in (places_mm, left_mm))
    times_s = np.where(places_mm < ramp_mm, from_begin_s, ramp_s + (places_mm - ramp_mm) / top)
    return np.where(left_mm < ramp_mm, all_s - from_end_s, times_s)
