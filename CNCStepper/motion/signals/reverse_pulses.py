# SPDX-License-Identifier: LGPL-2.1-or-later
"""The motion back along exactly the pulses by which the axes came, from any point.

    forwards   |--p1---p2-p3------p4--┤ point            every pulse again, in the opposite order and direction,
    back       ├--p4------p3-p2---p1--|                  with the same times between them

Devices are not switched on the motion back: the operator chooses beam and spindle.
The first pulse comes at the speed of the last one: turn back where the axes stand, as after a hold.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from CNCStepper.machine.profile import Machine
from CNCStepper.motion.planner.buffers import TICKS_PER_S
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.planner.segment_index import SegmentIndex
from CNCStepper.motion.planner.step_timeline import place_in
from CNCStepper.motion.signals.pulse_stream import PulseChunk, PulseStream, moved_steps, pulses_of
from CNCStepper.toolpath import Toolpath

SEGMENTS_AT_ONCE = 256


def turned_back(chunk: PulseChunk, tick: int) -> PulseChunk:
    """Return the reversed pulses of a chunk, beginning at `tick`, at or after its last pulse."""
    step = chunk.step[::-1]
    return PulseChunk(tick - chunk.ticks[::-1], step, step & ~chunk.back[::-1])


class ReversePulses:
    """The pulses of a table of moves, from any time back to the begin; memory does not grow with the pulses."""

    def __init__(self, toolpath: Toolpath, machine: Machine | Limits):
        self._pieces = SegmentIndex(toolpath, machine)

    def stream(self, tick: int | None = None) -> PulseStream:
        """Return all pulses up to `tick` of the planner's clock backwards, from the last pulse when left out.

        Tick 0 of the stream is that time; its `begin_steps` is the position of the axes then.
        """
        number = self._pieces.number_at(np.inf if tick is None else tick / TICKS_PER_S)
        if not len(self._pieces):
            return PulseStream((), self._pieces.axes, TICKS_PER_S, self._pieces.begin_steps)
        last = self._pieces.piece(number)[-1]
        tick = int(last.start + last.ticks * last.cycles) if tick is None else tick
        begin = self._position(number, tick)
        return PulseStream(self._chunks(number, tick), self._pieces.axes, TICKS_PER_S, begin)

    def _position(self, number: int, tick: int) -> tuple[int, ...]:
        """Return the position of the axes at a time of a piece, in steps."""
        segments = self._pieces.piece(number)
        position = np.empty(self._pieces.axes, np.int64)
        place_in(segments[0], 0, position)
        for chunk in pulses_of([segments]):
            position += moved_steps(_until(chunk, tick), self._pieces.axes)
        return tuple(position.tolist())

    def _chunks(self, number: int, tick: int) -> Iterator[PulseChunk]:
        for segments in self._pieces.back_from(number):
            for row in range(len(segments) - 1, -1, -SEGMENTS_AT_ONCE):
                some = segments[max(0, row - SEGMENTS_AT_ONCE + 1) : row + 1].view(np.recarray)
                forwards = [_copied(_until(chunk, tick)) for chunk in pulses_of([some])]
                yield from (turned_back(chunk, tick) for chunk in reversed(forwards) if len(chunk))


def _until(chunk: PulseChunk, tick: int) -> PulseChunk:
    count = int(np.searchsorted(chunk.ticks, tick, side="right"))
    return PulseChunk(chunk.ticks[:count], chunk.step[:count], chunk.back[:count])


def _copied(chunk: PulseChunk) -> PulseChunk:
    return PulseChunk(chunk.ticks.copy(), chunk.step.copy(), chunk.back.copy())
