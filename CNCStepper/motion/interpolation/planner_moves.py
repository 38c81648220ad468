# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moves through grbl's planner: look-ahead, junctions and ramps as on the controller, in planned time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from CNCStepper.motion.planner.buffers import EIGHTHS, TICKS_PER_S
from CNCStepper.motion.planner.live_motion import Motion
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.signals.planned_pulses import MoveSource, PlannedPulses
from CNCStepper.motion.signals.pulse_stream import pulses_of

TAGS_A_MOVE, RAPID = 2, 1  # the tag of a line is twice its number, and one more for a rapid


class PlannerMoves(MoveSource):
    """Straight moves, planned by `Motion`. Nothing waits for drivers between moves: they stay under current."""

    def __init__(self, limits: Limits, steps: Sequence[int]):
        self._begin_tick = 0  # of the planned clock, when the motion in hand began
        self._feed = 1.0
        self._motion = self._new_motion(limits, steps)

    @property
    def room(self) -> int:
        return self._motion.room

    @property
    def idle(self) -> bool:
        return self._motion.idle

    @property
    def end_steps(self) -> tuple[int, ...]:
        """Where the last pulse ends that is made."""
        return self._motion.position_steps

    def line(self, target_mm: Sequence[float], feed_mm_min: float, rapid: bool) -> None:
        tag = TAGS_A_MOVE * (self.last_move + 1) + RAPID * rapid
        self.last_move += self._motion.line(target_mm, feed_mm_min, rapid, tag)

    def make(self, seconds: float) -> list[PlannedPulses]:
        """Let so much planned time pass and return the pulses of the segments that ended in it."""
        self._motion.advance(seconds)
        return [
            _pulses(segments, self._motion.limits, self._begin_tick)
            for segments in self._motion.segments()
            if len(segments)
        ]

    def quicken(self, feed: float) -> None:
        self._feed = feed
        self._motion.override(feed, 1.0)

    def stand_at(self, steps: Sequence[int], limits: Limits) -> None:
        self._begin_tick += round(self._motion.time_s * TICKS_PER_S)
        self._motion = self._new_motion(limits, steps)

    def _new_motion(self, limits: Limits, steps: Sequence[int]) -> Motion:
        motion = Motion(replace(limits, idle_delay_s=0.0), steps, record=True)
        motion.override(self._feed, 1.0)
        return motion


def _pulses(segments: np.recarray, limits: Limits, begin_tick: int) -> PlannedPulses:
    """Return the pulses of segments, each with speed and acceleration of its own segment."""
    chunks = [(chunk.ticks.copy(), chunk.step.copy(), chunk.back.copy()) for chunk in pulses_of([segments])]
    ticks, step, back = (np.concatenate(columns) for columns in zip(*chunks, strict=True))
    rows = np.searchsorted(segments.start, ticks, side="left") - 1
    speeds, accelerations = _path_values(segments, limits)
    moves, rapids = np.divmod(segments.tag[rows], TAGS_A_MOVE)
    return PlannedPulses(ticks + begin_tick, step, back, speeds[rows], accelerations[rows], rapids == RAPID, moves)


def _path_values(segments: np.recarray, limits: Limits) -> tuple[np.ndarray, np.ndarray]:
    """Return speed in mm/s and the acceleration allowed in mm/s² along the path, float32[segments]."""
    ways_mm = np.abs(segments.steps) / np.array(limits.steps_per_mm)
    lengths_mm = np.linalg.norm(ways_mm, axis=1)
    events_per_s = segments.unit / EIGHTHS * TICKS_PER_S / segments.cycles
    with np.errstate(divide="ignore"):
        allowed = np.array(limits.acceleration_mm_s2) * lengths_mm[:, None] / ways_mm
    speeds = lengths_mm / segments.events * events_per_s
    return speeds.astype(np.float32), allowed.min(axis=1).astype(np.float32)
