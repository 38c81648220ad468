# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers and text of a controller that no firmware writes: told as damaged, safe to show, and never believed."""

from __future__ import annotations

import pytest

from CNCStepper.control.operator.console import kind_of, setting_of
from CNCStepper.control.protocol.grbl.connect import read_modes, read_offsets
from CNCStepper.control.protocol.grbl.driver import Grbl
from CNCStepper.control.protocol.grbl.status_reports import (
    OK,
    Alarm,
    Answer,
    Damaged,
    Feedback,
    Status,
    Unknown,
    count,
    decimal,
    parse,
    sizes,
    vector,
)
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.control.stream.executed_lines import Capacity
from CNCStepper.control.stream.status_snapshot import forward_messages, status_snapshot
from CNCStepper.errors import LinkError, MachineRefusal
from helpers.control.fake_controller import FakeClock, Unqueued

LONG = "9" * 5000
NO_NUMBERS = [
    LONG,
    f"-{LONG}.5",
    "nan",
    "inf",
    "-infinity",
    "1e308",
    "1e5",
    "1_0",
    "٣",
    "",
    " ",
    "+",
    ".",
    "1e999",
    "0x1",
]


class Said(Unqueued):
    """A link on which a controller has said something; its answers come to each line that is written."""

    name = "said"

    def __init__(self, answers: bytes = b""):
        self.clock = FakeClock()
        self.answers = answers
        self.data = b""

    def read(self, wait_s: float) -> bytes:
        self.clock.now_s += 0.01
        data, self.data = self.data, b""
        return data

    def write(self, data: bytes) -> None:
        self.data += self.answers


def driver_that_heard(*lines: str, listen=lambda received: None) -> Grbl:
    link = Said()
    driver = Grbl(link, link.clock, listen)
    link.data = "\r\n".join((*lines, "")).encode("utf-8")
    driver.receive(0.0)
    return driver


@pytest.mark.parametrize("text", NO_NUMBERS)
def test_what_no_firmware_writes_is_no_number(text):
    for read in (decimal, count, vector):
        with pytest.raises(ValueError, match="number"):
            read(text)


@pytest.mark.parametrize("text", ["12345678", "-99999999.9"])
def test_numbers_beyond_all_machines_are_refused(text):
    with pytest.raises(ValueError, match="beyond"):
        decimal(text)


@pytest.mark.parametrize(
    ("text", "value"), [("-1.5", -1.5), ("+.25", 0.25), ("3.", 3.0), ("0", 0.0), ("9999999", 9999999)]
)
def test_numbers_of_firmwares_are_read(text, value):
    assert decimal(text) == value and count("128") == 128


@pytest.mark.parametrize("number", [*NO_NUMBERS, "99999999"])
@pytest.mark.parametrize(
    "form", ["<Run|MPos:1,{},3>", "<Run|MPos:0,0,0|WCO:0,0,{}>", "<Run|MPos:0,0,0|FS:{},0>", "<Run|MPos:0,0,0|Bf:{},1>"]
)
def test_a_status_with_such_a_number_is_told_and_moves_nothing(form, number):
    good = "<Run|MPos:7.000,8.000,9.000|WCO:1.000,1.000,1.000|Bf:15,128|Ov:100,100,100>"
    heard, told = [], []
    driver = driver_that_heard("$13=0", good, form.format(number), listen=heard.extend)
    assert status_snapshot(driver, "running") == status_snapshot(driver_that_heard("$13=0", good), "running")
    assert isinstance(heard[-1], Damaged)
    forward_messages(heard[-1:], lambda kind, text: told.append((kind, len(text) < 3000 and "damaged" in text)))
    assert told == [("warning", True)]


@pytest.mark.parametrize("state", ["Foo", "Running", "idle", "Idle:x", "Hold:99999", "", "Idle\x1b[2J", "Run:-1"])
def test_a_state_that_no_firmware_has_is_damaged(state):
    assert isinstance(parse(f"<{state}|MPos:0,0,0>"), Damaged)


@pytest.mark.parametrize("state", ["Idle", "Run", "Hold:1", "Door:3", "Tool", "Starting", "ConfigAlarm", "Critical"])
def test_states_of_the_firmwares_are_read(state):
    assert isinstance(parse(f"<{state}|MPos:0,0,0>"), Status)


def test_codes_and_settings_with_such_numbers_have_none():
    assert parse(f"error:{LONG}") == Answer(-1, f"error:{LONG}") and parse(f"ALARM:{LONG}") == Alarm(-1)
    for line in (f"$13={LONG}", f"${LONG}=1", "$100=99999999999"):
        assert type(parse(line)) is Unknown


@pytest.mark.parametrize("size", [LONG, "4294967295", "-1", "1e5", "nan"])
def test_a_buffer_of_such_a_size_changes_nothing(size):
    driver, capacity = driver_that_heard(f"[OPT:V,{size},{size}]"), Capacity()
    capacity.on_message([Feedback("OPT", f"V,{size},{size}")])
    fresh = driver_that_heard()
    assert (driver.window, driver.planner_blocks) == (fresh.window, fresh.planner_blocks)
    assert capacity.moves == Capacity().moves and sizes(f"V,15,{size}") == (15, 0)


@pytest.mark.parametrize("number", NO_NUMBERS)
def test_offsets_and_modes_with_such_numbers_are_refused(number):
    link = Said(f"[G54:0.000,{number},0.000]\r\nok\r\n".encode())
    with pytest.raises(LinkError, match="damaged"):
        read_offsets(Grbl(link, link.clock), Timing())
    link = Said(f"[GC:G0 G54 F{number}]\r\nok\r\n".encode())
    with pytest.raises(LinkError, match="modes"):
        read_modes(Grbl(link, link.clock), Timing())


@pytest.mark.parametrize("text", [f"$100={LONG}", f"${LONG}=1", "$100=1.2.3", "$100=", "$100=+"])
def test_a_typed_setting_with_such_a_number_is_refused(text):
    with pytest.raises(MachineRefusal):
        kind_of(text)
    assert setting_of("$100=80.5") == (100, 80.5)


def test_what_drives_a_terminal_is_shown_as_its_escape():
    """One boundary: whatever a controller says leaves the driver without control characters."""
    heard = []
    link = Said()
    driver = Grbl(link, link.clock, heard.extend)
    link.data = (
        b"[MSG:\x1b]0;owned\x07]\r\n<Idle|MPos:0,0,0|Pn:\x1b[2J>\r\nGrbl 1.1h \x1b[31m\r\n[VER:\x9b2J:]\r\n"
        b"$N0=\x1b]8;;x\x07\r\n>\x1b[H:ok\r\n\x7f\x08noise\r\n[echo:\x0b\x0c]\r\nerror:\x1bname\r\nok\x1f\r\n"
    )
    driver.receive(0.0)
    assert len(heard) == 10
    assert all(text.isprintable() for report in heard for text in vars(report).values() if isinstance(text, str))
    assert "\\x1b]0;owned\\x07" in heard[0].text and OK not in heard
