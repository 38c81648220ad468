# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a person reads of a message."""

from __future__ import annotations

import pytest

from CNCStepper.control.transport.link import cause_of, port_refusal
from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.services.messages import sentence
from CNCStepper.workbench.services.plain_words import plain, port_of_address

SAID = "The link to socket://10.0.0.2:23 broke: [Errno 32] Broken pipe [link-lost]"


def test_codes_numbers_and_schemes_are_left_out() -> None:
    assert plain(SAID) == "The link to 10.0.0.2:23 broke: Broken pipe"
    assert plain(f"{SAID}. Home the machine.") == "The link to 10.0.0.2:23 broke: Broken pipe. Home the machine."


@pytest.mark.parametrize("words", ["[MSG:Reset to continue]", "[VER:1.1h:]", "a[2] is too long", "[G54] is chosen"])
def test_what_a_controller_says_in_brackets_stays(words: str) -> None:
    assert plain(words) == words


def test_an_address_is_typed_without_its_scheme() -> None:
    assert port_of_address("192.168.0.7:23") == "socket://192.168.0.7:23"
    assert port_of_address("[fe80::1]:23") == "socket://[fe80::1]:23"
    for port in ("COM3", "/dev/ttyUSB0", "telnet://cnc", "socket://cnc:23"):
        assert port_of_address(port) == port


def test_a_value_has_neither_numbers_nor_codes() -> None:
    error = CNCStepperError("worker-start", "it cannot be started", value=str(OSError(8, "Exec format error [a-b]")))
    assert sentence(error) == "it cannot be started (Exec format error)"


def test_a_port_that_does_not_open_is_refused_without_numbers() -> None:
    error = OSError("Could not open port socket://h:1: [Errno 111] Connection refused")
    error.__context__ = ConnectionRefusedError(111, "Connection refused")
    assert port_refusal("socket://h:1", error).what == "nothing answers at socket://h:1: Connection refused"


def test_the_operating_system_is_quoted_without_its_number() -> None:
    assert cause_of(BrokenPipeError(32, "Broken pipe")) == "Broken pipe"
    assert cause_of(ValueError("write failed: [Errno 5] Input/output error")) == "write failed: Input/output error"
