# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pulse player in this process, on a clock that only goes on where it is read or slept on; what it writes, decoded.

The decoder knows the standard pins and nothing of the encoder: x on 2 and 3, y on 4 and 5, z on 6 and 7, step first.
"""

from __future__ import annotations

import random
from dataclasses import dataclass, field
from math import hypot, sqrt
from typing import Any

import numpy as np
import pytest

from CNCStepper.control.pulses import pacing, pulse_loop
from CNCStepper.control.pulses.player_process import writer_of
from CNCStepper.control.pulses.pulse_loop import PulseLoop
from CNCStepper.control.pulses.pulse_player_client import PulseOutput
from CNCStepper.control.pulses.pulse_ring import PulseRing
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.motion.planner.buffers import TICKS_PER_S, UNLIMITED
from CNCStepper.motion.signals.pulse_player import SENSE

READ_NS = 100
ACCELERATION = 200.0
STEPS_PER_MM = 20.0
STEP_BITS, DIRECTION_BITS = (0, 2, 4), (1, 3, 5)


class Clock:
    """Stands in for the module `time`."""

    def __init__(self) -> None:
        self.ns = 0

    def perf_counter_ns(self) -> int:
        """Return the time, and let some pass."""
        self.ns += READ_NS
        return self.ns

    def monotonic(self) -> float:
        """Return the time in seconds."""
        return self.ns / 1e9

    def sleep(self, seconds: float) -> None:
        """Let time pass."""
        self.ns += round(seconds * 1e9)


@dataclass
class Writes:
    """A port that notes when each write was, and in which sense its player was going."""

    clock: Clock
    patience_ns: int = pacing.NEVER_NS
    is_real: bool = False
    sleep_ns: int = 1000
    takes_ns: dict[int, int] = field(default_factory=dict)  # of single writes, by their number
    rows: list[tuple[int, int, int, int]] = field(default_factory=list)  # ns, data, control, sense
    words: Any = None
    register: int = 0
    waiting: int = 0  # bytes that the device has not taken

    def write(self, data: Any, control: int) -> None:
        """Note a write, of a board its bytes and their number."""
        self.clock.ns += self.takes_ns.get(len(self.rows), 0)
        self.rows.append((self.clock.ns, data, control, int(self.words[SENSE])))

    def status(self) -> int:
        """Return the status register."""
        return self.register

    def queued(self) -> int:
        """Return how many bytes wait."""
        return self.waiting

    def rest(self) -> None:
        """Do nothing."""

    def close(self) -> None:
        """Do nothing."""


class _Living:
    def poll(self) -> None:
        """Return that it lives."""


class VirtualPlayer:
    """A PulseOutput whose loop runs in this process, as far as `run_for` and `run_until` let it."""

    def __init__(self, patch: pytest.MonkeyPatch, machine: Machine, **port: Any):
        self.clock, self.machine = Clock(), machine
        for module in (pacing, pulse_loop):
            patch.setattr(module, "time", self.clock)
        self.ring = PulseRing.create()
        self.ring.forget_name()
        self.port = Writes(self.clock, words=self.ring.words, **port)
        self.loop = PulseLoop(self.ring, writer_of(machine), self.port, 0)
        self.output = PulseOutput(_Living(), self.ring, "record:none", machine, None)  # type: ignore[arg-type]

    def run_for(self, seconds: float) -> None:
        """Let the loop run for so long."""
        end_ns = self.clock.ns + round(seconds * 1e9)
        while self.clock.ns < end_ns:
            assert self.loop.goes_on()

    def run_until(self, *states: str, limit_s: float = 1000.0) -> None:
        """Let the loop run until the output has one of these states."""
        end_ns = self.clock.ns + round(limit_s * 1e9)
        while self.output.state not in states:
            assert self.clock.ns < end_ns, f"still {self.output.state}"
            assert self.loop.goes_on()


def machine(**signals: Any) -> Machine:
    """Return a table of three axes with few steps and signals that take hardly any time."""
    table = load_machine("table-a")
    axes = {name: axis.model_copy(update={"steps_per_mm": STEPS_PER_MM}) for name, axis in table.axis.items()}
    times = {"pulse_us": 2.0, "gap_us": 2.0, "direction_setup_us": 2.0, "enable_lead_us": 100.0}
    return table.model_copy(update={"axis": axes, "signals": type(table.signals)(**(times | signals))})


def pulses(count: int, per_s: float, step: int = 1, first: int = 1) -> tuple[Any, ...]:
    """Return columns of steady pulses of one mask, whose motors may start and stop at once."""
    ticks = np.arange(first, first + count) * round(TICKS_PER_S / per_s)
    ones = np.ones(count)
    speed, acceleration = (per_s / 80 * ones).astype(np.float32), np.full(count, UNLIMITED, np.float32)
    return ticks, (step * ones).astype(np.uint8), np.zeros(count, np.uint8), speed, acceleration, ones < 0


@dataclass(frozen=True)
class Pulse:
    """A decoded pulse: when it rose, which axes stepped, which of them backwards, and the player's sense."""

    ns: int
    step: int
    back: int
    sense: int


def decoded(rows: list[tuple[int, int, int, int]]) -> list[Pulse]:
    """Return the pulses of register writes: the axes whose step pins rise, with their directions at that moment."""
    found, before = [], 0
    for ns, data, _, sense in rows:
        rises = [axis for axis in range(3) if data & ~before & 1 << STEP_BITS[axis]]
        before = data
        if rises:
            back = sum(1 << axis for axis in rises if data & 1 << DIRECTION_BITS[axis])
            found.append(Pulse(ns, sum(1 << axis for axis in rises), back, sense))
    return found


@dataclass(frozen=True)
class Plan:
    """Columns as `PulseOutput.append` takes them, and the way before each pulse in mm (0 behind a rest)."""

    ticks: np.ndarray
    step: np.ndarray
    back: np.ndarray
    speed: np.ndarray
    acceleration: np.ndarray
    is_rapid: np.ndarray
    way_mm: np.ndarray

    @property
    def columns(self) -> tuple[np.ndarray, ...]:
        """What is appended."""
        return self.ticks, self.step, self.back, self.speed, self.acceleration, self.is_rapid


def random_plan(dice: random.Random, moves: int) -> Plan:
    """Return moves in random directions, each from rest to rest or into the next one, with dwells between some."""
    rows: list[tuple[float, int, int, float, bool, float]] = []
    clock_s = entry = 0.0
    while moves:
        moves -= 1
        counts = [dice.choice((0, dice.randint(-60, 60), dice.randint(-300, 300))) for _ in range(3)]
        if not any(counts):
            counts[0] = 1
        rapid, top = dice.random() < 0.4, dice.choice((8.0, 20.0, 40.0))
        leaves = min(top, 8.0) if dice.random() < 0.5 and moves else 0.0
        clock_s, entry = _add_move(rows, clock_s, counts, rapid, (entry, max(top, entry), leaves))
        if entry == 0.0 and dice.random() < 0.5:
            clock_s += dice.choice((0.02, 0.3))
    seconds, step, back, speed, is_rapid, way = map(np.array, zip(*rows, strict=True))
    ticks = np.maximum.accumulate(np.round(seconds * TICKS_PER_S).astype(np.int64) + np.arange(len(rows)))
    masks = step.astype(np.uint8), back.astype(np.uint8)
    return Plan(ticks, *masks, speed.astype(np.float32), np.full(len(rows), ACCELERATION, np.float32), is_rapid, way)


def _add_move(
    rows: list[Any], clock_s: float, counts: list[int], rapid: bool, speeds: tuple[float, float, float]
) -> tuple[float, float]:
    """Add the pulses of a straight move; return the clock and the speed at its end."""
    events = max(map(abs, counts))
    length = hypot(*counts) / STEPS_PER_MM
    entry, top, leaves = speeds
    leaves = min(leaves, sqrt(entry * entry + 2 * ACCELERATION * length))
    peak = min(top, sqrt((entry**2 + leaves**2) / 2 + ACCELERATION * length))
    peak = max(peak, entry, leaves)
    if entry**2 - leaves**2 > 2 * ACCELERATION * length:  # too short to brake in: it goes on faster
        leaves = sqrt(entry**2 - 2 * ACCELERATION * length)
        peak = entry
    before_s, first = clock_s, entry == 0.0
    for event in range(1, events + 1):
        at_mm, from_mm = length * event / events, length * (event - 1) / events
        speed = [
            min(
                peak, sqrt(entry**2 + 2 * ACCELERATION * mm), sqrt(leaves**2 + 2 * ACCELERATION * max(length - mm, 0.0))
            )
            for mm in (from_mm, at_mm)
        ]
        wait_s = 2 * (at_mm - from_mm) / sum(speed) if sum(speed) else 0.02
        before_s += wait_s
        step = sum(1 << axis for axis in range(3) if _steps(counts[axis], event, events))
        back = sum(1 << axis for axis in range(3) if step >> axis & 1 and counts[axis] < 0)
        at_rest = first and event == 1
        rows.append((before_s, step, back, 0.0 if at_rest else (at_mm - from_mm) / wait_s, rapid, at_mm - from_mm))
    return before_s, leaves


def _steps(count: int, event: int, events: int) -> bool:
    return abs(count) * event // events != abs(count) * (event - 1) // events
