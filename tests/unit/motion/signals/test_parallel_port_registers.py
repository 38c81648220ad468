# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parallel-port bytes: pins, active levels and the port's own inversions, seen from the plug."""

from itertools import pairwise

import numpy as np
import pytest
from pydantic import ValidationError

from CNCStepper.errors import MachineRefusal
from CNCStepper.machine.wiring import OUTPUT_PINS, Signals
from CNCStepper.motion.signals.parallel_port_registers import pin_levels, port_chunks, port_words
from CNCStepper.motion.signals.pulse_stream import PulseChunk, PulseStream, Switch

XYZ = {f"{axis}_{what}": 2 + 2 * n + k for n, axis in enumerate("xyz") for k, what in enumerate(("step", "direction"))}


def on_plug(chunks):
    """Return ticks and the voltage of each pin after every write."""
    ticks = np.concatenate([chunk.ticks for chunk in chunks])
    pairs = [pair for chunk in chunks for pair in zip(chunk.data.tolist(), chunk.control.tolist(), strict=True)]
    return ticks, [pin_levels(data, control) for data, control in pairs]


def test_the_registers_of_the_source():
    word = port_words(Signals(), Signals().lines, np.zeros(1, np.uint32))
    assert word.tolist() == [0b1011 << 8]  # all pins low: 1, 14 and 17 are inverted by the port itself
    assert pin_levels(0x81, 0b1011) == {pin: pin in (2, 9) for pin in OUTPUT_PINS}
    assert pin_levels(0, 0) == {pin: pin in (1, 14, 17) for pin in OUTPUT_PINS}


@pytest.mark.parametrize("seed", range(12))
def test_every_pin_shows_its_line_with_its_active_level(seed):
    rng = np.random.default_rng(seed)
    print("seed", seed)
    lines = Signals().lines
    names = rng.permutation(lines)[:12].tolist()
    pins = {n: int(p * rng.choice([-1, 1])) for n, p in zip(names, rng.permutation(OUTPUT_PINS), strict=True)}
    levels = rng.integers(0, 1 << len(lines), 50).astype(np.uint32)
    for level, word in zip(levels.tolist(), port_words(Signals(pins=pins), lines, levels).tolist(), strict=True):
        plug = pin_levels(word & 0xFF, word >> 8)
        for name, pin in pins.items():
            assert plug[abs(pin)] == (bool(level >> lines.index(name) & 1) == (pin > 0))


def test_pulses_and_a_relay_arrive_at_the_plug():
    switches = (Switch(2, 230, "spindle_cw", True),)
    chunk = PulseChunk(
        np.array([100, 200, 300]), np.array([1, 3, 4], np.uint8), np.array([0, 2, 0], np.uint8), switches
    )
    signals = Signals(pins=XYZ | {"spindle_cw": -17, "enable": 1})
    ticks, plug = on_plug(list(port_chunks(PulseStream([chunk], 3, 1_000_000), signals)))

    def rises(pin):
        return sum(after[pin] and not before[pin] for before, after in pairwise(plug))

    assert [rises(pin) for pin in (2, 4, 6)] == [2, 1, 1]
    assert [rises(pin) for pin in (3, 5, 7)] == [0, 1, 0]
    relay = [levels[17] for levels in plug]
    assert relay[0] and not relay[-1] and sum(a != b for a, b in pairwise(relay)) == 1
    assert plug[0][1] and not plug[-1][1]
    assert (np.diff(ticks) >= 10).all()


def test_what_is_on_no_pin_makes_no_write():
    chunk = PulseChunk(np.array([100]), np.array([1], np.uint8), np.zeros(1, np.uint8), (Switch(0, 50, "mist", True),))
    ticks, _ = on_plug(list(port_chunks(PulseStream([chunk], 3, 1_000_000), Signals(pins=XYZ))))
    assert len(ticks) == 3  # the idle levels, the pulse's rise and its fall


@pytest.mark.parametrize(
    ("pins", "word"),
    [
        ({"x_step": 10}, "input"),
        ({"x_step": 18}, "no output"),
        ({"a_step": 2}, "no signal"),
        ({"x_step": 0}, "no output"),
    ],
)
def test_wrong_pins_are_refused(pins, word):
    with pytest.raises(ValidationError, match=word):
        Signals(pins=pins)


def test_two_signals_on_one_pin_are_refused_whatever_their_level():
    with pytest.raises(ValidationError, match="two signals"):
        Signals(pins={"x_step": 2, "y_step": -2})


def test_a_motor_without_pins_is_refused():
    with pytest.raises(MachineRefusal, match="y_step"):
        list(port_chunks(PulseStream([], 3), Signals(pins={"x_step": 2, "x_direction": 3})))


def test_without_a_pin_map_the_pins_are_those_of_most_boards():
    assert Signals().wired["x_step"] == 2 and Signals().wired["z_direction"] == 7
    assert set(Signals(motors=("x", "-z")).wired) == {
        *("x_step", "x_direction", "z_step", "z_direction", "enable"),
        *("spindle_cw", "spindle_ccw", "flood", "mist"),
    }
