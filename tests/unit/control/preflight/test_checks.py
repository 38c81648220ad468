# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program is not sent to a controller in whose modes it would mean something else than was proven.

A restart goes up first: it is not sent while the tool stands above the height at which it crosses the work.
"""

from __future__ import annotations

from typing import Any

import pytest

from CNCStepper.control.preflight.checks import codes_before_cut, cuts_at_implied_speed, implied_modes, mode_differences
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.service.sender import Sender
from CNCStepper.control.session.status import DONE, REFUSED, Outcome
from helpers.control.sender_bench import Bench
from helpers.control.service_bench import Table

MODES = "G21G17G90G94"
WHOLE = ("G21G17G90G94", "G54", "G0X10", "G20", "G91", "M2")


@pytest.mark.parametrize(
    ("lines", "granted"),
    [
        (WHOLE, ()),
        (("G0X10", "G21G90G17G94"), ("G17", "G21", "G90", "G94")),
        (("M3S1000", "G90", "X10"), ("G17", "G21", "G94")),
        (("F600", "G20G91G18G93G1X1"), ("G17", "G21", "G90", "G94")),
        (("G90.1", "G1X1"), ("G17", "G21", "G90", "G94")),
        (("M3S1000", "M5"), ()),
    ],
)
def test_what_a_program_does_not_say_before_it_moves_is_taken_for_granted(lines, granted):
    assert implied_modes(lines) == granted


def test_modes_are_compared_where_the_program_relies_on_them():
    left = "G1 G54 G18 G20 G91 G93 M5 M9 T0 F0 S0"
    assert mode_differences(left, {}, WHOLE) == []
    assert mode_differences("", {}, ("X1",)) == []
    assert mode_differences(left, {}, ("G21", "G17", "G94", "G0X1")) == ["G91 is in force, wanted G90"]
    assert len(mode_differences(left, {}, ("X1",))) == 4
    assert mode_differences(left, {"TLO": (0.001,)}, WHOLE) == []
    assert mode_differences(left, {"TLO": (20.0,)}, WHOLE) == [
        "a tool length of 20.000 mm is in force, wanted none (G49)"
    ]


@pytest.mark.parametrize(
    ("left", "lines", "found"),
    [
        ("M3", ("G0X1", "G1X2F100", "M5"), ["M3 is in force, wanted M5"]),
        ("M4", ("G0X1", "G02X2I1F100"), ["M4 is in force, wanted M5"]),
        ("M3", ("G0X1", "M4S100", "G1X2F100"), []),
        ("M3", ("G0X1", "G1M5X2F100"), []),
        ("M5 M8", ("G0X1", "M3S100M7", "G1X2F100"), ["M8 is in force, wanted M9"]),
        ("M5 M7 M8", ("G53G0X1", "M9", "G38.2Z-1F100"), []),
        ("M5 M7 M8", ("G0X1", "G81X2Z-1R1"), ["M7 is in force, wanted M9", "M8 is in force, wanted M9"]),
        ("M3 M8", ("G0X1", "G28", "G10L2P1X0", "M5"), ["M8 is in force, wanted M9"]),
        ("M5 M9 S9000", ("M3", "G1X2F100"), ["S9000 is in force, wanted S0"]),
        ("M5 M9 S9000", ("G1X1F100", "M03G1X2"), ["S9000 is in force, wanted S0"]),
        ("M5 M9 S9000", ("M3", "S100", "G1X2F100"), []),
        ("M5 M9 S9000", ("M3", "M5", "G1X2F100"), []),
        ("M5 M9 S9000", ("G1X2F100", "M2"), []),
        ("M5 M9 S0", ("M3", "G1X2F100"), []),
    ],
)
def test_what_a_hand_left_on_is_found_where_the_program_does_not_speak_of_it_before_it_cuts(left, lines, found):
    assert mode_differences(f"G1 G54 G17 G21 G90 G94 {left} T0 F0", {}, (MODES, *lines)) == found


def test_where_a_program_cuts_first():
    assert codes_before_cut(("M3", "G4P1", "G1X1", "M8")) == {"M3", "G4", "G1"}
    assert codes_before_cut(("G80", "G0X1", "G59", "M8")) == {"G80", "G0", "G59", "M8"}
    assert not cuts_at_implied_speed(())


@pytest.mark.parametrize(
    ("modes", "length", "said"),
    [
        ("G1 G54 G17 G20 G90 G94", "0.000", "G20 is in force, wanted G21"),
        ("G1 G54 G17 G21 G91 G94", "0.000", "G91 is in force, wanted G90"),
        ("G1 G54 G17 G21 G90 G94 M3", "0.000", "M3 is in force, wanted M5"),
        ("G1 G54 G17 G21 G90 G94", "12.500", "a tool length of 12.500 mm is in force"),
    ],
)
def test_modes_that_an_earlier_program_left_are_refused_before_the_first_line(modes, length, said):
    bench = Bench(("G1X10F600",))
    bench.controller.modes, bench.controller.length = modes, length
    outcome = bench.run()
    assert outcome.kind == REFUSED and outcome.error.code == "modes-differ" and said in outcome.text
    assert not bench.controller.lines
    allowed = Bench(("G1X10F600",), allow_differences=True)
    allowed.controller.modes, allowed.controller.length = modes, length
    assert allowed.run().done and any(kind == "warning" and said in text for kind, text in allowed.told)


def test_a_program_that_says_its_modes_is_sent_whatever_they_are():
    bench = Bench(WHOLE)
    bench.controller.modes = "G1 G54 G18 G20 G91 G93"
    assert bench.run().done


LINES = ("G21G90G54", "G0Z5", "X-10", "G1Z4F600")
LIFT = {"system": "G54", "z_mm": 5.0, "height_mm": 5.0}
ZERO_AT_MM = -60.0  # machine Z of G54


def sent(table: Table, told: list[str], **job: Any) -> Outcome:
    table.board.receive(f"$X\nG10L2P1Z{ZERO_AT_MM}\n".encode("ascii"))
    table.pass_time(0.5)
    table.written.clear()
    sender = Sender(
        SendJob("table", LINES, zero_confirmed=True, **job),
        opener=lambda name, baud: table,
        clock=table.clock,
        tell=lambda kind, text: told.append(text),
    )
    return sender.run()


def moved(table: Table) -> bool:
    return b"G0Z5" in b"".join(data for _, data in table.written)


def test_a_tool_that_stands_higher_is_not_sent_down() -> None:
    table = Table()
    outcome = sent(table, [], lift=LIFT)
    assert outcome.kind == REFUSED and outcome.error and outcome.error.code == "restart-above"
    assert "is at Z 60.000, and the restart first goes straight down to Z 5.000" in outcome.text
    assert "the height 60.0" in outcome.text
    assert not moved(table)


@pytest.mark.parametrize(
    "lift",
    [
        {},
        {"system": "G54", "z_mm": 60.0, "height_mm": 60.0},
        {"system": "G54", "z_mm": 90.0, "height_mm": 60.0},  # with a tool of 30 mm
        {"system": "G55", "z_mm": 5.0, "height_mm": 5.0},  # whose zero is higher
    ],
)
def test_one_that_stands_below_goes_up(lift: dict[str, Any]) -> None:
    table = Table()
    assert sent(table, [], lift=lift).kind == DONE
    assert moved(table)


@pytest.mark.slow
def test_a_machine_that_has_just_homed_goes_down_and_says_so() -> None:
    table, told = Table(homing=True), list[str]()
    assert sent(table, told, lift=LIFT, home_first=True).kind == DONE
    assert any("goes straight down first" in text for text in told)
