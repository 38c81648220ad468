# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ports and figures, as the dock shows them."""

from __future__ import annotations

import pytest

from CNCStepper.workbench.dock.model.port_choices import VIRTUAL, choices, needs_baud, port_of
from CNCStepper.workbench.services.number_format import INCH, MM, duration

FOUND = [("COM3", "COM3 – Arduino Uno"), ("COM4", "COM4")]


def test_the_virtual_grbl_is_the_first_choice() -> None:
    listed = choices(FOUND, "Virtual")
    assert [choice.text for choice in listed] == ["Virtual", "COM3 – Arduino Uno", "COM4"]
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
