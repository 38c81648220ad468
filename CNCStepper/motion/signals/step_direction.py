# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines to step and direction drives and devices: every edge of every line, in chunks.

    direction  ______|‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾
    step       ___________|‾‾‾‾‾|_______|‾‾‾‾‾|__
                     |set |width|  gap  |
                     |-up |     |       |

A pulse begins at the stream's own moment where the times allow it, and else as soon as they do: the step behind a
change of direction may so be late by some microseconds. Invariants: no two edges (of any lines) closer than the
gap, no pulse shorter than the width, a direction stands still from its set-up until the gap after the pulse.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from CNCStepper.errors import MachineRefusal
from CNCStepper.kernels import njit
from CNCStepper.machine.profile import AXIS_NAMES
from CNCStepper.machine.wiring import ENABLE, Signals
from CNCStepper.motion.planner.machine_limits import STEP_IDLE_DELAY_S
from CNCStepper.motion.signals.pulse_stream import PulseChunk, PulseStream, Switch

MOST_LATE_S = 0.001
EDGES_A_PULSE = 3
US_PER_S = 1_000_000

LATE, FREE, LEVEL = range(3)  # of the kernel's memory: worst delay, first tick for an edge, levels of the lines
WIDTH, GAP, SETUP = range(3)  # of its times, in ticks


@dataclass(frozen=True)
class Edges:
    """Consecutive edges: ticks int64[k], strictly rising; levels uint32[k] from each on, bit n: line n is active."""

    ticks: np.ndarray
    levels: np.ndarray

    def __len__(self) -> int:
        return len(self.ticks)


class Timeline:
    """All edges of a stream of pulses, run through once.

    lines: the name of each bit. Tick 0 lies `lead` ticks before that of the stream, so that the drives are on in time.
    """

    def __init__(self, stream: PulseStream, signals: Signals):
        if stream.ticks_per_s is None:
            raise MachineRefusal("no-clock", "these pulses have no time", advice="give them an interval")
        self.lines = signals.lines
        self.ticks_per_s = stream.ticks_per_s
        self.late_ticks = 0  # the worst delay of a pulse so far
        self._stream, self._signals = stream, signals
        self._times = edge_times(signals, self.ticks_per_s)
        self._enable_lead = enable_lead(signals, self.ticks_per_s)
        self.lead = self._enable_lead + int(self._times[SETUP])
        self._memory = np.zeros(3, np.int64)
        self._tables = mask_tables(signals, stream.axes)

    def __iter__(self) -> Iterator[Edges]:
        yield self._switch(0, ENABLE, True)
        self._memory[FREE] = self._enable_lead
        for chunk in self._stream:
            yield from self._edges_of(chunk)
        lag = math.ceil(STEP_IDLE_DELAY_S * self.ticks_per_s)
        yield self._switch(int(self._memory[FREE]) + lag, ENABLE, False)

    def _edges_of(self, chunk: PulseChunk) -> Iterator[Edges]:
        """Yield the edges of a chunk, parted where something is switched."""
        done = 0
        for switch in chunk.switches:
            yield from self._pulses(chunk, done, switch.row)
            yield from self._device(switch)
            done = switch.row
        yield from self._pulses(chunk, done, len(chunk))

    def _pulses(self, chunk: PulseChunk, first: int, last: int) -> Iterator[Edges]:
        if first == last:
            return
        columns = (chunk.ticks[first:last] + self.lead, chunk.step[first:last], chunk.back[first:last])
        room = EDGES_A_PULSE * (last - first)
        ticks, levels = np.empty(room, np.int64), np.empty(room, np.uint32)
        count = write_edges(*columns, *self._tables, self._times, self._memory, ticks, levels)
        self.late_ticks = int(self._memory[LATE])
        if self.late_ticks > MOST_LATE_S * self.ticks_per_s:
            self._refuse()
        yield Edges(ticks[:count], levels[:count])

    def _device(self, switch: Switch) -> Iterator[Edges]:
        """Yield the edge of a device's line, none where the level is right or there is no line."""
        bit = self._bit(switch.device) if switch.device in self.lines else 0
        if bit and bool(bit & int(self._memory[LEVEL])) != switch.on:
            yield self._switch(switch.tick + self.lead, switch.device, switch.on)

    def _switch(self, tick: int, line: str, on: bool) -> Edges:
        memory = self._memory
        memory[LEVEL] = memory[LEVEL] | self._bit(line) if on else memory[LEVEL] & ~self._bit(line)
        return self._edge(tick)

    def _edge(self, tick: int) -> Edges:
        """Return the levels as they are now, at a tick or as soon after it as an edge may come."""
        memory = self._memory
        at = max(tick, int(memory[FREE]))
        memory[FREE] = at + self._times[GAP]
        return Edges(np.array([at], np.int64), np.array([memory[LEVEL]], np.uint32))

    def _bit(self, line: str) -> int:
        return 1 << self.lines.index(line)

    def _refuse(self) -> None:
        signals = self._signals
        raise MachineRefusal(
            "pulse-rate",
            "the pulses come faster than the signals of this machine can follow",
            value=f"{self.late_ticks / self.ticks_per_s * 1000:.3f} ms late",
            limit=f"{US_PER_S / (max(signals.pulse_us, signals.gap_us) + signals.gap_us):.0f} pulses/s",
            advice="lower the greatest rate of the axis, or shorten pulse_us and gap_us as its drive allows",
        )


def edge_times(signals: Signals, ticks_per_s: int) -> np.ndarray:
    """Return the width of a pulse, the gap behind it and the direction's set-up as `write_edges` takes them."""
    times = (max(signals.pulse_us, signals.gap_us), signals.gap_us, max(signals.direction_setup_us, signals.gap_us))
    return np.array([math.ceil(time_us * ticks_per_s / US_PER_S) for time_us in times], np.int64)


def enable_lead(signals: Signals, ticks_per_s: int) -> int:
    """Return the ticks from switching the drives on to the first edge."""
    return math.ceil(max(signals.enable_lead_us, signals.gap_us) * ticks_per_s / US_PER_S)


def mask_tables(signals: Signals, axes: int) -> tuple[np.ndarray, ...]:
    """Return for each mask of axes, uint32[256]: step lines; direction lines; those that are on forwards, backwards."""
    tables = np.zeros((4, 256), np.uint32)
    masks = np.arange(256)
    for motor, turning in enumerate(signals.motors):
        axis = AXIS_NAMES.index(turning[-1])
        has = ((masks >> axis) & 1).astype(np.uint32) if axis < axes else np.zeros(256, np.uint32)
        step, direction = np.uint32(1 << 2 * motor), np.uint32(2 << 2 * motor)
        tables[0] |= has * step
        tables[1] |= has * direction
        tables[2 if turning.startswith("-") else 3] |= has * direction
    return tuple(tables)


@njit
def write_edges(pulses, step, back, steps_of, directions_of, forwards_of, backwards_of, times, memory, ticks, levels):
    """Write the edges of pulses at `pulses` (ticks); returns their number."""
    count = 0
    late, free, level = memory[LATE], memory[FREE], memory[LEVEL]
    width, gap, setup = times[WIDTH], times[GAP], times[SETUP]
    for row in range(len(pulses)):
        turned = level & ~np.int64(directions_of[step[row]])
        turned |= np.int64(forwards_of[step[row] & ~back[row]] | backwards_of[back[row]])
        begin = max(pulses[row], free)
        if turned != level:
            level = turned
            ticks[count], levels[count] = max(pulses[row] - setup, free), level
            begin = max(pulses[row], ticks[count] + setup)
            count += 1
        late = max(late, begin - pulses[row])
        ticks[count], levels[count] = begin, level | np.int64(steps_of[step[row]])
        ticks[count + 1], levels[count + 1] = begin + width, level
        free = begin + width + gap
        count += 2
    memory[LATE], memory[FREE], memory[LEVEL] = late, free, level
    return count
