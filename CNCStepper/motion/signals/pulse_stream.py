# SPDX-License-Identifier: LGPL-2.1-or-later
"""The stream of pulses from which all signals are made: chunks of columns, one row for each time of a step.

    ticks   0    400   800   1200 ...   clock of the stream, strictly rising
    step    01   11    01    11         bit n: axis n makes one step
    back    00   10    00    10         bit n: ... in its negative direction; never without its step bit
            ^ switches: devices that go on or off before a row

Ten bytes a row and chunks of at most PULSE_ROWS: memory does not grow with the job.

Which axes step on each tick of a segment, without a branch for each tick.

    0 ┬───────────┬───┬─────► tick     each tick adds an axis' share to what its sum lacks of a whole; where
      │      /|   │  /│  /             nothing is lacking, the axis steps and a whole is lacking again: the floor
    - │   /|/ |  /│/| │/|              of `step_timeline.place_in`, kept as its remainder less the whole
      │_/__│__│/__│_│_│_│

First the bits of all ticks are made, AXES_AT_ONCE axes in one loop so that their sums stay in registers; where ticks
are many and steps few, each axis goes from step to step instead. Then the ticks without a step are left out. Bit n
belongs to axis n.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

import numpy as np

from CNCStepper.errors import MachineRefusal
from CNCStepper.kernels import njit, njit_inline
from CNCStepper.machine.profile import Machine
from CNCStepper.motion.planner.buffers import EIGHTHS, TICKS_PER_S
from CNCStepper.motion.planner.chunk_window import ChunkWindow
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.planner.plan import Run
from CNCStepper.motion.signals.device_switching import Change, Changes, Switch
from CNCStepper.toolpath import Chunk, Toolpath

AXES_AT_ONCE = 4
SLOW_UNIT = 2  # eighths of an event a tick: up to here steps are so seldom that they are sought one by one
SIGN_BIT = 63  # of an int64


@njit_inline
def write_bits(segment, first, last, bits):
    """Write which axes step on ticks (first, last] of a segment to `bits`, uint8[at least last - first]."""
    for tick in range(last - first):
        bits[tick] = 0
    if segment.unit <= SLOW_UNIT:
        for axis in range(len(segment.steps)):
            _add_seldom(segment, first, last, bits, axis)
    else:
        for axis in range(0, len(segment.steps), AXES_AT_ONCE):
            _add_bits(segment, first, last, bits, axis)


@njit_inline
def _add_seldom(segment, first, last, bits, axis):
    """Add the bits of an axis that steps on few of the ticks: the tick of each of its steps, by division.

    Exact though in floats: the numbers are below 2**53, so no quotient is rounded over a whole number.
    """
    if segment.steps[axis] == 0:
        return
    lack, add = _lack_of(segment, axis, first)
    due = -lack
    tick = math.ceil(due / add)
    while tick <= last - first:
        bits[tick - 1] |= 1 << axis
        due += EIGHTHS * segment.events
        tick = math.ceil(due / add)


@njit_inline
def _add_bits(segment, first, last, bits, axis):
    """Add the bits of AXES_AT_ONCE axes from `axis` on."""
    whole = EIGHTHS * segment.events
    lack_0, add_0 = _lack_of(segment, axis, first)
    lack_1, add_1 = _lack_of(segment, axis + 1, first)
    lack_2, add_2 = _lack_of(segment, axis + 2, first)
    lack_3, add_3 = _lack_of(segment, axis + 3, first)
    for tick in range(last - first):
        lack_0, lack_1, lack_2, lack_3 = lack_0 + add_0, lack_1 + add_1, lack_2 + add_2, lack_3 + add_3
        on_0, on_1, on_2, on_3 = _reached(lack_0), _reached(lack_1), _reached(lack_2), _reached(lack_3)
        lack_0, lack_1 = lack_0 - (whole & on_0), lack_1 - (whole & on_1)
        lack_2, lack_3 = lack_2 - (whole & on_2), lack_3 - (whole & on_3)
        bits[tick] |= (on_0 & 1 | on_1 & 2 | on_2 & 4 | on_3 & 8) << axis


@njit_inline
def _reached(lack):
    """Return all ones where the whole is reached, else 0."""
    return ~(lack >> SIGN_BIT)


@njit_inline
def _lack_of(segment, axis, first):
    """Return what an axis' sum lacks after `first` ticks, and what each tick adds; nothing beyond the last axis."""
    if axis >= len(segment.steps):
        return -1, 0
    steps = abs(segment.steps[axis])
    whole = EIGHTHS * segment.events
    done = segment.eighths + first * segment.unit
    return (EIGHTHS // 2 * segment.events + done * steps - 1) % whole - whole, steps * segment.unit


@njit_inline
def reverse_bits(segment):
    """Return the bits of the axes that go backwards."""
    reverse = 0
    for axis in range(len(segment.steps)):
        reverse |= (segment.steps[axis] < 0) << axis
    return reverse


@njit_inline
def keep_steps(segment, first, last, bits, ticks, step, back, count):
    """Write a row for every tick of (first, last] with a step; returns the rows written so far.

    There must be room for a row on each of these ticks.
    """
    reverse = np.uint8(reverse_bits(segment))
    cycles = segment.cycles
    clock = segment.start + first * cycles
    for tick in range(last - first):
        clock += cycles
        on = bits[tick]
        ticks[count] = clock
        step[count] = on
        back[count] = on & reverse
        count += on != 0
    return count


PULSE_ROWS = 65_536
MOST_AXES = 8  # bits of a mask


@dataclass(frozen=True)
class PulseChunk:
    """Consecutive pulses: ticks int64[k], step uint8[k], back uint8[k]; what is switched between them."""

    ticks: np.ndarray
    step: np.ndarray
    back: np.ndarray
    switches: tuple[Switch, ...] = ()

    def __len__(self) -> int:
        return len(self.ticks)


NO_PULSES = PulseChunk(np.empty(0, np.int64), np.empty(0, np.uint8), np.empty(0, np.uint8))


@dataclass(frozen=True)
class PulseStream:
    """Chunks of pulses, run through once.

    ticks_per_s: of the clock; None where the ticks only count the rounds of an interpolator.
    begin_steps: where the axes stand before the first pulse.
    """

    chunks: Iterable[PulseChunk]
    axes: int = 3
    ticks_per_s: int | None = TICKS_PER_S
    begin_steps: tuple[int, ...] = (0, 0, 0)

    def __iter__(self) -> Iterator[PulseChunk]:
        return iter(self.chunks)


def pulse_stream(toolpath: Toolpath, machine: Machine | Limits, chunks: Iterable[Chunk] | None = None) -> PulseStream:
    """Return the pulses of a table of moves, as the planner times them; each chunk is valid until the next one.

    chunks: the table's own when left out; those of a table that is still being read come as they are made, its states
    and events before them. Raises MachineRefusal where there are more than MOST_AXES axes.
    """
    limits = machine if isinstance(machine, Limits) else Limits.of(machine)
    changes = Changes(toolpath.states, toolpath.events, limits.laser)
    coming: deque[Change] = deque()
    window = ChunkWindow(toolpath.chunks if chunks is None else chunks, lambda chunk: coming.extend(changes.of(chunk)))
    run = Run(replace(toolpath, chunks=window), limits)  # type: ignore[arg-type]
    begin = tuple(run.course.planner.position.tolist())
    return PulseStream(_switched(run, coming, changes), check_axes(run.limits.axes), TICKS_PER_S, begin)


def check_axes(axes: int, most: int = MOST_AXES) -> int:
    """Return the number of axes; raises MachineRefusal for more than the stream has."""
    if axes > most:
        advice = "leave axes out of the machine's profile"
        raise MachineRefusal("axes", "too many axes for these signals", value=f"{axes}", limit=f"{most}", advice=advice)
    return axes


def _switched(run: Run, coming: deque[Change], changes: Changes) -> Iterator[PulseChunk]:
    """Yield the pulses of a pass with the switching among them; `coming` grows as the pass reads chunks."""
    waiting: list[tuple[int, Change]] = []  # with the clock behind whose pulses each comes
    for segments in run.segments():
        while coming and coming[0].row <= segments.tag[-1]:
            change = coming.popleft()
            waiting.append((int(segments.start[np.searchsorted(segments.tag, change.row)]), change))
        for chunk in pulses_of([segments]):
            now = [one for one in waiting if one[0] < chunk.ticks[-1]]
            waiting = waiting[len(now) :]
            yield replace(chunk, switches=_on_rows(chunk.ticks, now)) if now else chunk
    last = [*waiting, *((run.clock, change) for change in (*coming, *changes.last()))]
    if last:
        yield replace(NO_PULSES, switches=_on_rows(NO_PULSES.ticks, last))


def _on_rows(ticks: np.ndarray, waiting: list[tuple[int, Change]]) -> tuple[Switch, ...]:
    rows = np.searchsorted(ticks, [clock for clock, _ in waiting], side="right").tolist()
    return tuple(
        Switch(row, clock - change.lead_ticks, change.device, change.on, change.rpm)
        for row, (clock, change) in zip(rows, waiting, strict=True)
    )


def pulses_of(pieces: Iterable[np.recarray]) -> Iterator[PulseChunk]:
    """Yield the pulses of the planner's segments, at most 8 axes; each chunk is valid until the next is asked for."""
    ticks = np.empty(PULSE_ROWS, np.int64)
    step, back = np.empty(PULSE_ROWS, np.uint8), np.empty(PULSE_ROWS, np.uint8)
    for segments in pieces:
        place = np.zeros(2, np.int64)
        while count := write_pulses(segments, place, ticks, step, back):
            yield PulseChunk(ticks[:count], step[:count], back[:count])


@njit
def write_pulses(segments, place, ticks, step, back):
    """Write the pulses from `place` (segment, ticks of it that are done) on; returns their number, 0 at the end.

    Exactly the steps of `step_timeline.place_in`: its floor is kept as a sum for each axis.
    """
    count = 0
    bits = np.empty(len(ticks), np.uint8)
    while place[0] < len(segments) and count < len(ticks):
        segment = segments[place[0]]
        last = min(segment.ticks, place[1] + len(ticks) - count)
        write_bits(segment, place[1], last, bits)
        count = keep_steps(segment, place[1], last, bits, ticks, step, back, count)
        place[1] = last
        if last == segment.ticks:
            place[0] += 1
            place[1] = 0
    return count


def moves_of(chunk: PulseChunk, axes: int) -> np.ndarray:
    """Return +1, 0 or -1 for each pulse and axis of a chunk, int64[k, axes]."""
    bits = np.arange(axes)
    step, back = ((mask[:, None].astype(np.int64) >> bits) & 1 for mask in (chunk.step, chunk.back))
    return step - 2 * back


def moved_steps(chunk: PulseChunk, axes: int) -> np.ndarray:
    """Return how far each axis goes in a chunk, int64[axes] in steps."""
    bits = np.arange(axes)
    forward = np.bincount(chunk.step & ~chunk.back, minlength=256)
    backward = np.bincount(chunk.back, minlength=256)
    has_bit = (np.arange(256)[:, None] >> bits) & 1
    return (forward - backward) @ has_bit
