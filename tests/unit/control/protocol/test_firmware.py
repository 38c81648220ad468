# SPDX-License-Identifier: LGPL-2.1-or-later
"""The three firmwares: recognised, their codes complete and in words, their buffers, line lengths and units."""

from __future__ import annotations

import pytest

from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.program.wire_line import check_length
from CNCStepper.control.protocol.grbl.alarms_and_errors_fluidnc import FLUIDNC_ERROR_NAMES
from CNCStepper.control.protocol.grbl.connect import ControllerInfo, handshake
from CNCStepper.control.protocol.grbl.driver import Grbl
from CNCStepper.control.protocol.grbl.firmware import (
    FIRMWARES,
    FLUIDNC,
    GRBL,
    GRBLHAL,
    LATHE,
    firmware_of_greeting,
    firmware_of_tag,
)
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.control.service.sender import Sender
from CNCStepper.control.session.status import DONE, REFUSED
from CNCStepper.errors import MachineRefusal, ProgramError
from helpers.control.fake_controller import FakeClock, FakeController, FakeLink

# The numbers of each firmware's own table, read from its source.
NUMBERS = {
    "grbl": ([*range(1, 18), *range(20, 39)], range(1, 11)),
    "grblhal": ([*range(1, 59), *range(60, 68), *range(70, 85), 253], range(1, 22)),
    "fluidnc": (
        [
            *range(1, 41), *range(60, 71), *range(80, 84), 90, 100, 101, *range(110, 115), 120, 130, *range(150, 153),
            *range(160, 163), *range(170, 182),
        ],
        range(1, 19),
    ),
    **{own: ([*range(1, 18), *range(20, 39), 90], range(1, 11)) for own in ("parport", "board", "lathe")},
}  # fmt: skip
INFO = {
    "grbl": ("[VER:1.1h.20190830:]", "[OPT:V,15,{rx_bytes}]"),
    "grblhal": (
        "[VER:1.1f.20250225:]",
        "[OPT:VNMSL,100,{rx_bytes},3,0]",
        "[AXS:3:XYZ]",
        "[NEWOPT:ENUMS,RT+,ES]",
        "[FIRMWARE:grblHAL]",
        "[DRIVER VERSION:250129]",
    ),
    "fluidnc": ("[VER:3.7 FluidNC v3.7.8:]", "[OPT:PHS]", "[MSG:Machine: Table]"),
}
GREETINGS = {
    "grbl": "Grbl 1.1h ['$' for help]",
    "grblhal": "GrblHAL 1.1f ['$' or '$HELP' for help]",
    "fluidnc": "Grbl 3.7 [FluidNC v3.7.8 (wifi) '$' for help]",
}


class Bench:
    """One firmware, as a scripted controller in memory."""

    def __init__(self, key: str, **options):
        self.clock = FakeClock()
        self.controller = FakeController(self.clock, **options)
        self.controller.info, self.controller.greeting = INFO[key], GREETINGS[key]
        self.controller.settings |= {30: 24000}
        if key == "fluidnc":
            del self.controller.settings[13]
            self.controller.named["$/report_inches"] = "false"
        self.told: list[tuple[str, str]] = []
        self.driver = Grbl(FakeLink(self.controller, self.clock), self.clock)

    def meet(self) -> ControllerInfo:
        return handshake(self.driver, Timing())

    def send(self, *lines: str, **job):
        job = {"zero_confirmed": True} | job
        sender = Sender(
            SendJob("fake", lines, **job),
            opener=lambda name, baud: self.driver.link,
            clock=self.clock,
            tell=lambda kind, text: self.told.append((kind, text)),
        )
        return sender.run()


@pytest.mark.parametrize("firmware", FIRMWARES, ids=lambda firmware: firmware.key)
def test_every_code_of_its_table_is_in_words_with_what_to_do(firmware):
    errors, alarms = NUMBERS[firmware.key]
    assert sorted(firmware.errors) == list(errors) and sorted(firmware.alarms) == list(alarms)
    for code in [*firmware.errors.values(), *firmware.alarms.values()]:
        assert len(code.meaning.split()) > 2 and len(code.advice.split()) > 1
        assert not code.meaning.endswith(".") and not code.advice.endswith(".")


@pytest.mark.parametrize("firmware", FIRMWARES, ids=lambda firmware: firmware.key)
def test_code_that_is_not_listed_is_stated_as_such(firmware):
    assert firmware.name in firmware.error(249).meaning and "no such error" in firmware.error(249).meaning
    assert "no such alarm" in firmware.alarm(99).meaning
    assert not firmware.alarm(99).position_kept and not firmware.alarm(-1).position_kept
    assert firmware.error(-1).advice


def test_codes_that_differ_do_differ():
    for number in (5, 10, 38):
        assert len({firmware.error(number).meaning for firmware in (GRBL, FLUIDNC)}) == 2
    assert len({firmware.alarm(10).meaning for firmware in FIRMWARES}) == 3
    assert GRBLHAL.error(40) != FLUIDNC.error(40)
    assert all(firmware.alarm(2).position_kept and not firmware.alarm(3).position_kept for firmware in FIRMWARES)


def test_names_that_fluidnc_says_in_place_of_numbers_are_understood():
    assert set(FLUIDNC_ERROR_NAMES.values()) <= set(FLUIDNC.errors)
    assert FLUIDNC.error_number("error:Unsupported GCode command") == 20
    assert FLUIDNC.error_number("error: Something new") == -1


@pytest.mark.parametrize("key", GREETINGS)
def test_firmware_is_recognised_by_its_greeting(key):
    assert firmware_of_greeting(GREETINGS[key]).key == key


def test_firmware_is_recognised_by_what_it_says_of_itself():
    assert firmware_of_tag("VER", "3.7 FluidNC v3.7.8:") is FLUIDNC
    assert firmware_of_tag("FIRMWARE", "grblHAL") is firmware_of_tag("AXS", "3:XYZ") is GRBLHAL
    assert firmware_of_tag("FIRMWARE", "CNCStepper lathe") is LATHE
    assert firmware_of_tag("FIRMWARE", "CNCStepper mill") is None
    assert firmware_of_tag("VER", "1.1h.20190830:") is firmware_of_tag("OPT", "V,15,128") is None


@pytest.mark.parametrize(("key", "window"), [("grbl", 127), ("grblhal", 1023), ("fluidnc", 127)])
def test_controller_met_without_greeting_is_known_with_its_buffer(key, window):
    bench = Bench(key, rx_bytes=window + 1)
    found = bench.meet()
    assert found.firmware.key == bench.driver.firmware.key == key
    assert bench.driver.window == window


def test_grblhal_that_greets_as_grbl_is_recognised():
    bench = Bench("grblhal", rx_bytes=1024)
    bench.controller.reset()
    bench.controller.out.clear()
    bench.controller.say(GREETINGS["grbl"])
    assert bench.meet().firmware is GRBLHAL


def test_small_buffer_of_fluidnc_is_respected():
    bench = Bench("fluidnc")
    bench.controller.report_extra = "|Bf:16,64"
    bench.meet()
    bench.driver.ask_status()
    bench.driver.receive(0.1)
    assert bench.driver.window == 63


@pytest.mark.parametrize(("answer", "inches"), [("false", 0.0), ("true", 1.0)])
def test_fluidnc_is_asked_in_what_units_it_reports(answer, inches):
    bench = Bench("fluidnc")
    bench.controller.named["$/report_inches"] = answer
    assert bench.meet().settings[13] == inches
    assert bench.driver.mpos_mm == pytest.approx((-90.0 * 25.4**inches, -40.0 * 25.4**inches, -10.0 * 25.4**inches))


def test_fluidnc_that_does_not_say_its_units_is_refused():
    bench = Bench("fluidnc")
    del bench.controller.named["$/report_inches"]
    with pytest.raises(MachineRefusal, match="uses mm or inches"):
        bench.meet()


@pytest.mark.parametrize("key", ["grbl", "grblhal"])
def test_job_is_refused_before_its_first_line_where_the_units_of_positions_are_not_known(key):
    bench = Bench(key)
    del bench.controller.settings[13]
    outcome = bench.send("G21G90", "G1X1F600", allow_differences=True)
    assert outcome.kind == REFUSED and outcome.error.code == "units-unknown"
    assert outcome.status.sent == 0


@pytest.mark.parametrize(("key", "length", "kind"), [("grbl", 80, REFUSED), ("grblhal", 80, DONE)])
def test_line_length_is_the_firmwares(key, length, kind):
    bench = Bench(key, rx_bytes=1024)
    outcome = bench.send("G1X1F600", "G1X1." + "1" * (length - 5))
    assert outcome.kind == kind
    if kind == REFUSED:
        assert outcome.error.code == "line-too-long" and outcome.error.place.line == 2
        assert bench.controller.lines == []


def test_blanks_count_where_the_firmware_keeps_them():
    check_length(" " * 20 + "X" * 79, GRBL, 127)
    with pytest.raises(ProgramError, match="254"):
        check_length(" " * 20 + "X" * 240, FLUIDNC, 1024)


@pytest.mark.parametrize(
    ("key", "words"), [("grbl", "lists no such error"), ("grblhal", "tool change"), ("fluidnc", "control pin")]
)
def test_refusal_of_a_line_is_in_the_firmwares_own_words(key, words):
    bench = Bench(key)
    bench.controller.on_line[1] = "error:40"
    outcome = bench.send("G1X1F600", "G1X2")
    assert outcome.error.code == f"{key}-error-40"
    assert words in str(outcome.error)


def test_refusal_by_name_is_understood():
    bench = Bench("fluidnc")
    bench.controller.on_line[0] = "error:Gcode undefined feed rate"
    assert bench.send("G1X1").error.code == "fluidnc-error-22"


@pytest.mark.parametrize(("number", "value"), [(30, 1000), (32, 1), (32, 2)])
def test_spindle_speed_and_laser_mode_are_compared_and_refuse(number, value):
    bench = Bench("grblhal")
    bench.controller.settings[number] = value
    outcome = bench.send("G1X1F600", expected={30: 24000, 32: 0})
    assert outcome.error.code == "settings-differ" and f"${number} is {value}" in str(outcome.error)
    assert bench.controller.lines == []


@pytest.mark.parametrize("firmware", FIRMWARES, ids=lambda firmware: firmware.name)
def test_unknown_command_is_to_be_written_in_a_language_of_this_firmware(firmware):
    named = firmware.error(20).advice.partition("the dialect ")[2].split(" or ")
    assert tuple(named) == firmware.dialects


@pytest.mark.parametrize("key", ["parport", "board", "lathe"])
def test_what_a_controller_of_ours_cannot_do_is_learnt_when_it_is_met(key):
    bench = Bench("grbl")
    bench.controller.info = (*INFO["grbl"], f"[FIRMWARE:CNCStepper {key}]", "[CANNOT:hold]", "[CANNOT:stop]")
    assert bench.driver.cannot == frozenset()
    assert bench.meet().firmware.key == key
    assert bench.driver.cannot == {"hold", "stop"} and bench.driver.firmware.key == key
