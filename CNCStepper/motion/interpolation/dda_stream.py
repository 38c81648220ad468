# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program's pulses by the thesis's own interpolators (A2, A3), as our controller sends them.

rows of the path ──► DdaMoves, the controller's own ──► pulses, each move from rest to rest
M3, M8, G4 ...   ──► switches between the moves; a dwell puts all that follows off
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator

import numpy as np

from CNCStepper.machine.profile import Machine
from CNCStepper.motion.interpolation.dda_moves import DdaMoves
from CNCStepper.motion.planner import plan
from CNCStepper.motion.planner.arc_segments import arc_points
from CNCStepper.motion.planner.buffers import TICKS_PER_S
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.planner.standstills import dwell_ticks
from CNCStepper.motion.signals.device_switching import Change, Changes, Switch
from CNCStepper.motion.signals.pulse_stream import PulseChunk, PulseStream
from CNCStepper.toolpath import ARC_CW, LINE, PLANE_AXES, RAPID, XYZ, Chunk, Toolpath, begins_of

Pulses = tuple[np.ndarray, np.ndarray, np.ndarray]  # ticks, step and back bits
AT_ONCE_S = 3600.0  # of pulses that are made together, at most those of one move


def dda_stream(toolpath: Toolpath, machine: Machine, chunks: Iterable[Chunk] | None = None) -> PulseStream:
    """Return the pulses of a table of moves by the machine's `interpolation`, "dda" or "published".

    chunks: as `pulse_stream` takes them. All positions of the table are known.
    """
    run = _Run(toolpath, machine, toolpath.chunks if chunks is None else chunks)
    return PulseStream(run.chunks(), XYZ, TICKS_PER_S, run.begin_steps)


def times_and_whole_s(
    toolpath: Toolpath, machine: Machine, progress: Callable[[float], None] = lambda share: None
) -> tuple[np.ndarray, float]:
    """Return when each row of a table ends, float64[n], and the whole time, s, by the machine's interpolation.

    progress: called with the share that is planned, from 0 to 1.
    """
    if machine.interpolation == "planner":
        return plan.times_and_whole_s(toolpath, machine, progress)
    run = DdaTimes(toolpath, machine, toolpath.chunks)
    ends_s = np.concatenate([np.zeros(0), *run.row_ends_s()])
    progress(1.0)
    return ends_s, run.whole_s


class DdaTimes:
    """The times of a table whose rows may come while they are read."""

    def __init__(self, toolpath: Toolpath, machine: Machine, chunks: Iterable[Chunk]):
        self._run = _Run(toolpath, machine, chunks)

    @property
    def whole_s(self) -> float:
        """How long all that is timed takes, the dwells behind it too once all is."""
        return self._run.clock / TICKS_PER_S

    def row_ends_s(self) -> Iterator[np.ndarray]:
        """Yield the end times in s of each chunk's rows, float64[n]."""
        for _ in self._run.chunks():
            if self._run.is_chunk_done:
                yield self._run.take_row_ends() / TICKS_PER_S


class _Run:
    """One pass through a table. row_ends: ticks, of the rows that are done."""

    def __init__(self, toolpath: Toolpath, machine: Machine, chunks: Iterable[Chunk]):
        limits = Limits.of(machine)
        self._chunks, self._events = chunks, toolpath.events
        self._event = 0  # the next one whose dwell is to come
        self._before = np.asarray(toolpath.start.position_mm[:XYZ], float)
        self.begin_steps = tuple(np.rint(self._before * np.array(limits.steps_per_mm)).astype(np.int64).tolist())
        self._moves = DdaMoves(limits, self.begin_steps, machine.interpolation == "published")
        self._tolerance_mm = limits.arc_tolerance_mm
        self._changes = Changes(toolpath.states, toolpath.events, limits.laser)
        self._waited = self.clock = 0  # ticks: of all dwells so far; of the end of all that is done
        self.is_chunk_done = False  # and its row ends can be taken
        self.row_ends: list[int] = []

    def take_row_ends(self) -> np.ndarray:
        """Return the ends of the rows since the last call, float64[n]."""
        ends, self.row_ends = np.array(self.row_ends, float), []
        return ends

    def chunks(self) -> Iterator[PulseChunk]:
        """Yield the pulses of the rows, with the switching before each."""
        for chunk in self._chunks:
            changes = self._changes.of(chunk)
            begins = begins_of(chunk, self._before)
            for row in range(len(chunk)):
                index = chunk.first + row
                self._wait(index)
                switches = self._switches(change for change in changes if change.row == index)
                for pulses in self._row(chunk, row, begins[row]):
                    yield PulseChunk(*pulses, switches)
                    switches = ()
                if switches:
                    yield PulseChunk(*_nothing(), switches)
                self.row_ends.append(self.clock)
            self.is_chunk_done = True
            yield PulseChunk(*_nothing())
            self.is_chunk_done = False
            self._before = chunk.end[-1, :XYZ] if len(chunk) else self._before
        self._wait(None)
        if last := self._switches(self._changes.last()):
            yield PulseChunk(*_nothing(), last)

    def _wait(self, row: int | None) -> None:
        """Let the dwells before a row pass, all that are left for None."""
        while self._event < len(self._events) and (row is None or self._events[self._event].index <= row):
            ticks = dwell_ticks(self._events[self._event])
            self._waited, self.clock, self._event = self._waited + ticks, self.clock + ticks, self._event + 1

    def _switches(self, changes: Iterable[Change]) -> tuple[Switch, ...]:
        """Return changes before the pulses that come next."""
        return tuple(Switch(0, self.clock - one.lead_ticks, one.device, one.on, one.rpm) for one in changes)

    def _row(self, chunk: Chunk, row: int, begin_mm: np.ndarray) -> Iterator[Pulses]:
        """Yield ticks, step and back bits of a row's pulses."""
        kind, end_mm, feed = int(chunk.kind[row]), chunk.end[row, :XYZ], float(chunk.feed[row])
        plane = int(chunk.plane[row])
        if kind > LINE and int(chunk.turns[row]) == 1 and self._moves.takes_arc(end_mm.tolist(), plane):
            centre_mm = chunk.centre[row]
            radius_mm = math.hypot(*(begin_mm[axis] - centre_mm[axis] for axis in PLANE_AXES[plane][:2]))
            self._moves.arc(end_mm.tolist(), centre_mm[:2].tolist(), radius_mm, kind == ARC_CW, feed)
            yield from self._made()
            return
        places = end_mm[None]
        if kind > LINE:
            turns = int(chunk.turns[row])
            places = arc_points(begin_mm, end_mm, chunk.centre[row], kind, plane, turns, self._tolerance_mm)
        for place in places:
            self._moves.line(place.tolist(), feed, kind == RAPID)
            yield from self._made()

    def _made(self) -> Iterator[Pulses]:
        while not self._moves.idle:
            for pulses in self._moves.make(AT_ONCE_S):
                ticks = pulses.ticks + self._waited
                self.clock = int(ticks[-1])
                yield ticks, pulses.step, pulses.back


def _nothing() -> Pulses:
    return np.zeros(0, np.int64), np.zeros(0, np.uint8), np.zeros(0, np.uint8)
