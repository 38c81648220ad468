# SPDX-License-Identifier: LGPL-2.1-or-later
"""The planner and step generator as a live object: moves in, time passes, axes stand somewhere.

    line() ──► ring of blocks ──► up to SEGMENT_PLACES segments ──► advance(): position
                 may still change        are decided

It is the heart of a controller that listens while it moves; whole programs go through `plan.py`, which uses
the same kernels.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from CNCStepper.errors import MachineRefusal
from CNCStepper.kernels import njit
from CNCStepper.motion.limits import Limits
from CNCStepper.motion.memory import (
    BLOCKS,
    EIGHTHS,
    SEGMENT_PLACES,
    TICKS_PER_S,
    Planner,
    Segments,
    new_planner,
    new_segments,
)
from CNCStepper.motion.planner import (
    count_blocks,
    empty_planner,
    plan_again,
    push_line,
    reload_running_block,
    set_overrides,
)
from CNCStepper.motion.ramp import next_segment
from CNCStepper.motion.timeline import place_in
from CNCStepper.units import S_PER_MIN

RUNNING, HOLDING, HELD, IDLE = "running", "holding", "held", "idle"

_FLOW = np.dtype(
    [
        ("clock", "i8"),  # ticks: now
        ("free", "i8"),  # ticks: before this no segment can begin
        ("oldest", "i8"),  # place of the running segment in the ring of segments
        ("count", "i8"),  # segments that are decided
        ("idle_delay", "i8"),  # ticks
    ]
)


class _Ring(NamedTuple):
    planner: Planner
    segments: Segments
    flow: np.ndarray
    position: np.ndarray  # int64[axes], steps: where the last finished segment ended


class Motion:
    """A controller's motion: queue moves while there is room, let time pass, look where the axes are.

    Positions are machine coordinates; it begins at rest at `position_steps`. Not for several threads.
    """

    def __init__(self, limits: Limits, position_steps: Sequence[int] | None = None):
        self._limits = limits
        steps = np.array(position_steps or (0,) * limits.axes, np.int64)
        flow = np.zeros(1, _FLOW).view(np.recarray)
        flow[0].idle_delay = round(limits.idle_delay_s * TICKS_PER_S)
        planner = new_planner(limits, tuple(steps / np.array(limits.steps_per_mm)))
        planner.position[:] = steps
        self._ring = _Ring(planner, new_segments(SEGMENT_PLACES, limits.axes), flow, steps)
        self._holding = False

    @property
    def time_s(self) -> float:
        """The time that has passed."""
        return int(self._ring.flow[0].clock) / TICKS_PER_S

    @property
    def blocks(self) -> int:
        """How many moves are queued, the running one included."""
        return int(count_blocks(self._ring.planner))

    @property
    def room(self) -> int:
        """How many further moves can be queued."""
        return BLOCKS - 1 - self.blocks

    @property
    def state(self) -> str:
        """What it does: RUNNING, HOLDING (slowing down), HELD (stopped on the path, moves wait) or IDLE."""
        still = self._ring.flow[0].count == 0
        if self._holding:
            return HELD if still and (self._ring.planner.ramp[0].ended or not self.blocks) else HOLDING
        return IDLE if still and not self.blocks else RUNNING

    @property
    def idle(self) -> bool:
        """Whether no move is left to make."""
        return self._ring.flow[0].count == 0 and not self.blocks

    @property
    def position_steps(self) -> tuple[int, ...]:
        """Where the axes are."""
        return tuple(_place_now(self._ring).tolist())

    @property
    def position_mm(self) -> tuple[float, ...]:
        """Where the axes are."""
        return tuple(n / per_mm for n, per_mm in zip(self.position_steps, self._limits.steps_per_mm, strict=True))

    @property
    def rate_mm_min(self) -> float:
        """The speed along the path now."""
        flow, segments = self._ring.flow[0], self._ring.segments
        row = flow.oldest
        if flow.count == 0 or segments.start[row] > flow.clock:
            return 0.0
        event_mm = math.hypot(*(segments.steps[row] / np.array(self._limits.steps_per_mm))) / segments.events[row]
        tick_s = int(segments.cycles[row]) / TICKS_PER_S
        return event_mm * int(segments.unit[row]) / EIGHTHS / tick_s * S_PER_MIN

    @property
    def line_tag(self) -> int:
        """The tag of the move being made; -1 at rest."""
        flow = self._ring.flow[0]
        return int(self._ring.segments.tag[flow.oldest]) if flow.count else -1

    @property
    def until_change_s(self) -> float:
        """The time until the running segment ends, when room may fall free; infinite at rest."""
        flow, segments = self._ring.flow[0], self._ring.segments
        if flow.count == 0:
            return math.inf if self.state in (IDLE, HELD) else 0.0
        row = flow.oldest
        end = int(segments.start[row] + segments.ticks[row] * segments.cycles[row])
        return (end - int(flow.clock)) / TICKS_PER_S

    def line(self, target_mm: Sequence[float], feed_mm_min: float, rapid: bool = False, tag: int = 0) -> bool:
        """Queue a straight move; returns whether it has any step. Raises MachineRefusal where there is no room."""
        if self.room == 0:
            raise MachineRefusal(
                "planner-full", "the planner is full", limit=f"{BLOCKS - 1} blocks", advice="let time pass first"
            )
        target = np.array(target_mm, float)
        return bool(push_line(self._ring.planner, target, feed_mm_min / S_PER_MIN, rapid, tag))

    def advance(self, duration_s: float) -> None:
        """Let time pass."""
        flow = self._ring.flow[0]
        _flow(self._ring, int(flow.clock) + round(duration_s * TICKS_PER_S))

    def hold(self) -> None:
        """Slow down along the path to a stop; what is decided already is still run."""
        if not self._holding:
            self._holding = True
            reload_running_block(self._ring.planner)
            self._ring.planner.ramp[0].hold = True

    def resume(self) -> None:
        """Go on from where a hold has stopped; before it has, nothing happens."""
        if self.state == HELD:
            ramp = self._ring.planner.ramp[0]
            ramp.hold = ramp.ended = False
            ramp.speed = 0.0
            plan_again(self._ring.planner)
            self._holding = False

    def reset(self) -> bool:
        """Stop dead and forget all moves; returns whether the axes were moving, and so may have lost steps."""
        moving = self._ring.flow[0].count > 0
        position = _place_now(self._ring)
        self._ring.position[:] = position
        self._ring.flow[0].count = 0
        empty_planner(self._ring.planner, position)
        self._holding = False
        return moving

    def override(self, feed: float, rapid: float) -> None:
        """Let all moves, queued ones too, run at these factors of their speeds (1.0: as programmed)."""
        set_overrides(self._ring.planner, feed, rapid)


@njit
def _flow(ring, until):
    """Run segments until the clock stands at `until`, deciding further ones as their places fall free."""
    flow = ring.flow[0]
    while True:
        _decide(ring)
        row = flow.oldest
        end = ring.segments.start[row] + ring.segments.ticks[row] * ring.segments.cycles[row]
        if flow.count == 0 or end > until:
            flow.clock = until
            return
        flow.clock = end
        flow.free = end
        place_in(ring.segments, row, ring.segments.ticks[row], ring.position)
        flow.oldest = (row + 1) % SEGMENT_PLACES
        flow.count -= 1
        if flow.count == 0:
            _decide(ring)
        if flow.count == 0:  # the axes have come to rest: the firmware waits before it listens again
            flow.free = end + flow.idle_delay


@njit
def _decide(ring):
    """Cut segments from the planner while there is a place for them, and set them on the clock."""
    flow = ring.flow[0]
    while flow.count < SEGMENT_PLACES:
        row = (flow.oldest + flow.count) % SEGMENT_PLACES
        if not next_segment(ring.planner, ring.segments, row):
            return
        start = max(flow.clock, flow.free)
        if flow.count > 0:
            last = (row - 1) % SEGMENT_PLACES
            start = ring.segments.start[last] + ring.segments.ticks[last] * ring.segments.cycles[last]
        ring.segments.start[row] = start
        flow.count += 1


@njit
def _place_now(ring):
    """Return where the axes stand at the clock, int64[axes]."""
    flow = ring.flow[0]
    place = ring.position.copy()
    row = flow.oldest
    if flow.count > 0 and flow.clock >= ring.segments.start[row]:
        ticks = (flow.clock - ring.segments.start[row]) // ring.segments.cycles[row]
        place_in(ring.segments, row, min(ticks, ring.segments.ticks[row]), place)
    return place
