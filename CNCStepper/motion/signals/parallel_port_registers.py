# SPDX-License-Identifier: LGPL-2.1-or-later
"""The bytes of a parallel port: lines on pins, each with its own active level, as two registers.

base + 0   data      bits 0 to 7   pins 2 to 9
base + 2   control   bits 0 to 3   pins 1 14 16 17; the port turns 1, 14 and 17 round: a 1 makes them low
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from CNCStepper.errors import MachineRefusal, Text
from CNCStepper.kernels import njit
from CNCStepper.machine.wiring import CONTROL_PINS, DATA_PINS, DEVICES, ENABLE, INVERTED_PINS, Signals
from CNCStepper.motion.signals.pulse_stream import PulseStream
from CNCStepper.motion.signals.step_direction import (
    EDGES_A_PULSE,
    FREE,
    GAP,
    LATE,
    LEVEL,
    SETUP,
    Edges,
    Timeline,
    edge_times,
    enable_lead,
    mask_tables,
    write_edges,
)

NS_PER_S = 1_000_000_000
CONTROL_OFFSET = 2
CONTROL_SHIFT = 8  # of the control register in a word of both


@dataclass(frozen=True)
class PortChunk:
    """Consecutive writes to the port: ticks int64[k], strictly rising; data uint8[k], control uint8[k]."""

    ticks: np.ndarray
    data: np.ndarray
    control: np.ndarray

    def __len__(self) -> int:
        return len(self.ticks)


def port_words(signals: Signals, lines: tuple[str, ...], levels: np.ndarray) -> np.ndarray:
    """Return both registers for the levels of lines (bit n: line n is active), uint16[k], the control one shifted."""
    words = np.full(len(levels), _idle_word(signals), np.uint16)
    for name, pin in signals.wired.items():
        active = (levels >> np.uint32(lines.index(name))) & np.uint32(1)
        words ^= active.astype(np.uint16) << np.uint16(_bit_of(abs(pin)))
    return words


def idle_registers(signals: Signals) -> tuple[int, int]:
    """Return the data and the control register while no line is active."""
    word = _idle_word(signals)
    return word & 0xFF, word >> CONTROL_SHIFT


def require_pin(signals: Signals, name: str) -> None:
    """Raise MachineRefusal where a signal has no pin."""
    if name not in signals.wired:
        raise MachineRefusal(
            "no-pin",
            Text("the signal {name} is on no pin of the parallel port", name=name),
            advice=Text("say it in the machine's profile: [signals] pins = {{ {name} = 2, ... }}", name=name),
        )


def port_chunks(stream: PulseStream, signals: Signals) -> Iterator[PortChunk]:
    """Yield the writes to the port with their times, tick 0 being the first; edges without a pin are left out.

    Raises MachineRefusal where a motor that the stream may move has no pin for its steps.
    """
    check_motor_pins(signals)
    timeline = Timeline(stream, signals)
    last = -1
    for edges in timeline:
        words = port_words(signals, timeline.lines, edges.levels)
        kept = np.diff(words.astype(np.int64), prepend=last) != 0
        last = int(words[-1]) if len(words) else last
        yield _chunk(edges, words, kept)


def _chunk(edges: Edges, words: np.ndarray, kept: np.ndarray) -> PortChunk:
    words = words[kept]
    return PortChunk(edges.ticks[kept], (words & 0xFF).astype(np.uint8), (words >> CONTROL_SHIFT).astype(np.uint8))


def pin_levels(data: int, control: int) -> dict[int, bool]:
    """Return the voltage (high or not) on each output pin for two register values."""
    word = data | control << CONTROL_SHIFT
    return {pin: bool(word >> _bit_of(pin) & 1) != (pin in INVERTED_PINS) for pin in (*DATA_PINS, *CONTROL_PINS)}


@njit
def write_registers(levels, count, idle, bit_of, data, control):
    """Write both registers for the levels of lines, uint32; bit_of: each line's bit in a word of both."""
    for row in range(count):
        word, level = idle, levels[row]
        for line in range(len(bit_of)):
            if (level >> np.uint32(line)) & np.uint32(1):
                word ^= bit_of[line]
        data[row], control[row] = word & 0xFF, word >> CONTROL_SHIFT


class RegisterWriter:
    """What a parallel port is written, as pulses come some at a time; times are ns.

    The drives stay on from the first pulse until `off`. lead_ns: by how much a pulse comes later than it is due, so
    that its direction can stand before it.
    """

    def __init__(self, signals: Signals, axes: int):
        check_motor_pins(signals)
        self._lines, self._signals = signals.lines, signals
        self._times, self._tables = edge_times(signals, NS_PER_S), mask_tables(signals, axes)
        self._memory = np.zeros(3, np.int64)
        self._idle = np.int64(_idle_word(signals))
        bits = {self._lines.index(name): 1 << _bit_of(abs(pin)) for name, pin in signals.wired.items()}
        self._bit_of = np.array([bits.get(line, 0) for line in range(len(self._lines))], np.int64)
        self._devices = sum(1 << self._lines.index(name) for name in DEVICES)
        self._enable = 1 << self._lines.index(ENABLE) if ENABLE in signals.wired else 0
        self._room(1)
        self.lead_ns = int(self._times[SETUP])

    @property
    def keep_ns(self) -> int:
        """Edges that are due no farther apart are kept apart: those of a pulse."""
        return int(self._times.max())

    def writes(self, due: np.ndarray, step: np.ndarray, back: np.ndarray) -> list[tuple[int, int, int]]:
        """Return (ns, data, control) of pulses that are due at `due` + lead_ns; masks of no axis change nothing."""
        if EDGES_A_PULSE * len(due) > len(self._ns):
            self._room(len(due))
        count = write_edges(
            due + self.lead_ns, step, back, *self._tables, self._times, self._memory, self._ns, self._levels
        )
        write_registers(self._levels, count, self._idle, self._bit_of, self._data, self._control)
        columns = self._ns[:count], self._data[:count], self._control[:count]
        return list(zip(*(column.tolist() for column in columns), strict=True))

    def late_ns(self) -> int:
        """Return by how much the pulses since the last call came later than due, as the signals' times force them."""
        late, self._memory[LATE] = int(self._memory[LATE]), 0
        return late

    def ready(self, now_ns: int) -> tuple[list[tuple[int, int, int]], int]:
        """Return what switches the drives on, and from when on pulses may come."""
        if not self._enable & ~int(self._memory[LEVEL]):
            return [], now_ns
        edges = self._edge(now_ns, int(self._memory[LEVEL]) | self._enable)
        self._memory[FREE] = edges[0][0] + enable_lead(self._signals, NS_PER_S)
        return edges, int(self._memory[FREE])

    def device_bit(self, device: str) -> int:
        """Return the bit of a device among the relays; raises MachineRefusal where it has no pin."""
        require_pin(self._signals, device)
        return 1 << self._lines.index(device)

    def relays(self, bits: int, now_ns: int) -> list[tuple[int, int, int]]:
        """Return what switches the devices as `bits` say; nothing where they are so."""
        level = int(self._memory[LEVEL]) & ~self._devices | bits
        return self._edge(now_ns, level) if level != self._memory[LEVEL] else []

    def off(self, now_ns: int) -> list[tuple[int, int, int]]:
        """Return what makes every line inactive."""
        return self._edge(now_ns, 0)

    def _edge(self, now_ns: int, level: int) -> list[tuple[int, int, int]]:
        at = max(now_ns, int(self._memory[FREE]))
        self._memory[LEVEL], self._memory[FREE] = level, at + int(self._times[GAP])
        self._levels[0] = level
        write_registers(self._levels, 1, self._idle, self._bit_of, self._data, self._control)
        return [(at, int(self._data[0]), int(self._control[0]))]

    def _room(self, pulses: int) -> None:
        room = EDGES_A_PULSE * pulses
        self._ns, self._levels = np.empty(room, np.int64), np.empty(room, np.uint32)
        self._data, self._control = np.empty(room, np.uint8), np.empty(room, np.uint8)


def _bit_of(pin: int) -> int:
    """Return a pin's bit in a word of both registers."""
    return DATA_PINS.index(pin) if pin in DATA_PINS else CONTROL_SHIFT + CONTROL_PINS.index(pin)


def _idle_word(signals: Signals) -> int:
    """Return both registers with every line inactive; pins without a line are low."""
    word = 0
    for pin in (*DATA_PINS, *CONTROL_PINS):
        high = -pin in signals.wired.values()
        word |= (high != (pin in INVERTED_PINS)) << _bit_of(pin)
    return word


def check_motor_pins(signals: Signals) -> None:
    """Raise MachineRefusal where a motor has no pin for its steps or its direction."""
    for motor in signals.motor_names:
        for what in ("step", "direction"):
            require_pin(signals, f"{motor}_{what}")
