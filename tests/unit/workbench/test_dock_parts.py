# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ports, figures and the pieces of a jog, as the dock needs them."""

from __future__ import annotations

import pytest

from CNCStepper.workbench.dock.figures import INCH, MM, duration
from CNCStepper.workbench.dock.jogging import AHEAD, PIECE_S, Held
from CNCStepper.workbench.dock.ports import VIRTUAL, choices, needs_baud, port_of

FOUND = [("COM3", "Arduino Uno"), ("COM4", "n/a"), ("/dev/ttyS0", "/dev/ttyS0")]


def test_the_virtual_grbl_is_the_first_choice() -> None:
    listed = choices(FOUND, "Virtual")
    assert [choice.text for choice in listed] == ["Virtual", "COM3 – Arduino Uno", "COM4", "/dev/ttyS0"]
    assert listed[0].virtual and not listed[1].virtual
    assert choices([], "Virtual") == listed[:1]


def test_the_port_used_last_stays_in_the_list() -> None:
    assert [choice.port for choice in choices(FOUND, "Virtual", "socket://cnc:23")][-1] == "socket://cnc:23"
    assert choices(FOUND, "Virtual", "COM3") == choices(FOUND, "Virtual") == choices(FOUND, "Virtual", VIRTUAL)


def test_a_typed_text_is_an_entry_or_an_address() -> None:
    listed = choices(FOUND, "Virtual")
    assert port_of("Virtual", listed) == VIRTUAL
    assert port_of("COM3 – Arduino Uno", listed) == "COM3"
    assert port_of(" socket://10.0.0.2:23 ", listed) == "socket://10.0.0.2:23"


def test_only_serial_ports_have_a_baud_rate() -> None:
    assert needs_baud("COM3") and needs_baud("/dev/ttyUSB0")
    assert not needs_baud(VIRTUAL) and not needs_baud("socket://10.0.0.2:23")


@pytest.mark.parametrize(
    ("length_mm", "mm", "inch"),
    [(12.3456, "12.346", "0.4860"), (-0.0001, "0.000", "0.0000"), (None, "–", "–"), (-25.4, "-25.400", "-1.0000")],
)
def test_lengths(length_mm: float | None, mm: str, inch: str) -> None:
    assert (MM.text(length_mm), INCH.text(length_mm)) == (mm, inch)


def test_lengths_with_a_decimal_comma() -> None:
    assert MM.text(1.5, ",") == "1,500" and MM.step_text(0.01, ",") == "0,01" and INCH.speed_text(254, ",") == "10,0"


@pytest.mark.parametrize(
    ("time_s", "text"), [(0, "0:00"), (59.6, "1:00"), (725, "12:05"), (3725, "1:02:05"), (None, "–"), (-3, "0:00")]
)
def test_durations(time_s: float | None, text: str) -> None:
    assert duration(time_s) == text


def test_a_held_jog_is_fed_a_little_ahead_and_no_more() -> None:
    held = Held("y", -1, 600.0)
    first = list(held.pieces(0.0))
    assert first == [{"y_mm": pytest.approx(-600 / 60 * PIECE_S)}] * AHEAD
    assert list(held.pieces(0.5 * PIECE_S)) == []
    assert len(list(held.pieces(1.01 * PIECE_S))) == 1


def test_a_window_that_was_kept_busy_does_not_make_up_for_it() -> None:
    held = Held("x", 1, 600.0)
    list(held.pieces(0.0))
    assert len(list(held.pieces(60.0))) <= AHEAD
