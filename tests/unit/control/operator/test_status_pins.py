# SPDX-License-Identifier: LGPL-2.1-or-later
"""The status pins of a parallel port: the register's bits, a file that stands for them, and the thread that looks."""

from __future__ import annotations

import threading

import pytest

from CNCStepper.control.operator.hardware_buttons import PinWatch, open_pins
from CNCStepper.control.pulses.parallel_port import STATUS_BITS, high_pins
from CNCStepper.errors import LinkError
from CNCStepper.machine.wiring import INPUT_PINS

LIMIT_S = 20.0


def test_every_input_pin_has_its_bit_and_pin_11_is_turned_round():
    assert set(STATUS_BITS) == set(INPUT_PINS)
    assert high_pins(0b0000_0000) == {11}
    assert high_pins(0b1111_1000) == {10, 12, 13, 15}
    assert high_pins(0b1000_0111) == set()
    assert high_pins(0b0100_0000) == {10, 11} and high_pins(0b0010_0000) == {11, 12}
    assert high_pins(0b0001_0000) == {11, 13} and high_pins(0b0000_1000) == {11, 15}


def test_file_stands_for_a_port(tmp_path):
    path = tmp_path / "pinos ç.txt"
    path.write_text("10 12\n", "utf-8")
    pins = open_pins(str(path))
    assert pins.high() == {10, 12}
    path.write_text("", "utf-8")
    assert pins.high() == frozenset()


@pytest.mark.parametrize("text", [None, "high"])
def test_file_without_pins_is_refused(tmp_path, text):
    path = tmp_path / "pins"
    if text:
        path.write_text(text, "utf-8")
    with pytest.raises(LinkError, match="has no pins to read"):
        open_pins(str(path))


class Script:
    """Pins that show one thing after the other, then cannot be read."""

    def __init__(self, *shown):
        self._shown = list(shown)

    def high(self):
        if not self._shown:
            raise LinkError("input-port", "it is gone")
        return frozenset(self._shown.pop(0))


def test_watch_passes_on_every_look_until_the_port_is_lost():
    seen, lost, over = [], [], threading.Event()
    watch = PinWatch(Script({10}, {10, 11}, set()), seen.append, lambda error: (lost.append(error), over.set()))
    assert over.wait(LIMIT_S)
    watch.close()
    assert seen == [{10}, {10, 11}, set()] and [error.code for error in lost] == ["input-port"]
