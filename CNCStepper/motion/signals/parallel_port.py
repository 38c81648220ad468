# SPDX-License-Identifier: LGPL-2.1-or-later
"""The bytes of a parallel port: lines on pins, each with its own active level, as two registers.

base + 0   data      bits 0 to 7   pins 2 to 9
base + 2   control   bits 0 to 3   pins 1 14 16 17; the port turns 1, 14 and 17 round: a 1 makes them low
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from CNCStepper.errors import MachineRefusal
from CNCStepper.machine.wiring import CONTROL_PINS, DATA_PINS, INVERTED_PINS, Signals
from CNCStepper.motion.signals.pulse_stream import PulseStream
from CNCStepper.motion.signals.step_direction import Edges, Timeline

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
            f"the signal {name} is on no pin of the parallel port",
            advice=f"say it in the machine's profile: [signals] pins = {{ {name} = 2, ... }}",
        )


def port_chunks(stream: PulseStream, signals: Signals) -> Iterator[PortChunk]:
    """Yield what is written to the port and when, tick 0 being the first write; edges without a pin are left out.

    While the axes stand in a hold the same is written again and again, so that whoever waits for writes hears them.
    Raises MachineRefusal where a motor that the stream may move has no pin for its steps.
    """
    _check_pins(signals)
    timeline = Timeline(stream, signals)
    last = -1
    for edges in timeline:
        words = port_words(signals, timeline.lines, edges.levels)
        kept = (np.diff(words.astype(np.int64), prepend=last) != 0) | edges.held
        last = int(words[-1]) if len(words) else last
        yield _chunk(edges, words, kept)


def _chunk(edges: Edges, words: np.ndarray, kept: np.ndarray) -> PortChunk:
    words = words[kept]
    return PortChunk(edges.ticks[kept], (words & 0xFF).astype(np.uint8), (words >> CONTROL_SHIFT).astype(np.uint8))


def pin_levels(data: int, control: int) -> dict[int, bool]:
    """Return the voltage (high or not) on each output pin for two register values."""
    word = data | control << CONTROL_SHIFT
    return {pin: bool(word >> _bit_of(pin) & 1) != (pin in INVERTED_PINS) for pin in (*DATA_PINS, *CONTROL_PINS)}


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


def _check_pins(signals: Signals) -> None:
    for motor in signals.motor_names:
        for what in ("step", "direction"):
            require_pin(signals, f"{motor}_{what}")
