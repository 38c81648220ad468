# SPDX-License-Identifier: LGPL-2.1-or-later
"""The virtual grbl's parser: what it takes, and the code with which it refuses the rest."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from CNCStepper.errors import MachineRefusal
from CNCStepper.virtual.grbl.alarms_and_errors import ERRORS
from CNCStepper.virtual.grbl.gcode.block import Modal, Parser
from CNCStepper.virtual.grbl.gcode.checks import complete
from CNCStepper.virtual.grbl.gcode.parser import read_block
from CNCStepper.virtual.grbl.gcode.words import f32, read_number, read_words
from CNCStepper.virtual.grbl.settings import no_places

NO_PLACES = no_places()


def parsed(line: str, **state: object):
    """Return the completed block of `line`."""
    parser = Parser(**state)  # type: ignore[arg-type]
    block = read_block(line, parser.modal)
    complete(block, parser, NO_PLACES)
    return block


REFUSED = [
    ("1X1", 1),
    ("X", 2),
    ("G1X--1F1", 2),
    ("G1X+-1F1", 2),
    ("G1X.F1", 2),
    ("G1X1F-1", 4),
    ("S-1", 4),
    ("G4P-1", 4),
    ("G1X1", 22),
    ("G1.5X1F1", 23),
    ("G59.1", 23),
    ("M3.1", 23),
    ("G5X1", 20),
    ("G41", 20),
    ("G43Z1", 20),
    ("G64", 20),
    ("G61.1", 20),
    ("G90.1", 20),
    ("G92.2", 20),
    ("G38.1X1F1", 20),
    ("G81X1Z1R1F1", 20),
    ("G-1", 20),
    ("M6", 20),
    ("M7", 20),
    ("A1", 20),
    ("G0H1", 20),
    ("G0G1X1F1", 24),
    ("G20G21", 21),
    ("M3M5", 21),
    ("G90G91", 21),
    ("G17G18", 21),
    ("G54G55", 21),
    ("G4P1G53X1", 21),
    ("G92X1G1X1F1", 24),
    ("G28G0X1", 24),
    ("G43.1Z1G0X1", 24),
    ("G0X1X2", 25),
    ("F1F2", 25),
    ("G2I1F1", 26),
    ("G38.2F10", 26),
    ("G92", 26),
    ("G10L2P1", 26),
    ("N10000001", 27),
    ("G4", 28),
    ("G10X1", 28),
    ("G10L2P7X1", 29),
    ("G10L3P1X1", 20),
    ("G10L2P1R1X1", 20),
    ("G53G2X1I1F1", 30),
    ("G80X1", 31),
    ("G2Z1I1F10", 32),
    ("G17G3Z1F10I1J1", 32),
    ("G2X10I4F100", 33),
    ("G38.2X0F10", 33),
    ("G2X10R4F100", 34),
    ("G2X0R5F10", 33),
    ("G2X10F10", 35),
    ("G2X10K5F10", 35),
    ("G0X1I1", 36),
    ("G0X1P1", 36),
    ("G1X1F1L2", 36),
    ("G43.1X1", 37),
    ("G43.1Z1Y1", 37),
    ("G43.1", 37),
    ("T256", 38),
    ("$J=X1", 22),
    ("$J=X1F0", 22),
    ("$J=F100", 26),
    ("$J=G2X1F100", 35),  # the arc is looked at before the jog
    ("$J=G2X1I1F100", 33),
    ("$J=G3X2I1F100", 16),
    ("$J=G0X1F100", 16),
    ("$J=M3X1F100", 16),
    ("$J=G54X1F100", 16),
    ("$J=X1F100S10", 36),
    ("$J=G93X1F100", 16),
]


@pytest.mark.parametrize(("line", "code"), REFUSED)
def test_refuses_with_the_firmwares_code(line: str, code: int) -> None:
    with pytest.raises(MachineRefusal) as refusal:
        parsed(line)
    assert refusal.value.code == f"error:{code}"


ACCEPTED = [
    "",
    "G17G21G40G49G54G80G90G91.1G94",
    "G61",
    "G0",
    "G1F100",
    "M0",
    "M1",
    "M30",
    "M8",
    "T255",
    "N10000000",
    "G28",
    "G30.1",
    "G92.1",
    "G28.1",
    "G10L2P0X1",
    "G10L20P6Z1",
    "G49",
    "G53G0X1",
    "G93G1X1F2",
    "G2X10R5F10",
    "G3X10Y0I5F10",
    "$J=G91G20X1F100",
    "$J=G53N5Y1F1",
    "G4P0",
    "G38.3Z-1F10",
]


@pytest.mark.parametrize("line", ACCEPTED)
def test_accepts(line: str) -> None:
    parsed(line)


def test_every_code_of_the_parser_is_tested() -> None:
    raised_elsewhere = {3, 5, 6, 8, 9, 10, 11, 15, 39, 40, 54, 162}
    assert {code for _, code in REFUSED} | raised_elsewhere == set(ERRORS)


@pytest.mark.parametrize(
    ("line", "target"),
    [
        ("G0X1", [111.0, 20.0, 30.0]),
        ("G91G0X1", [11.0, 20.0, 30.0]),
        ("G53G0X1", [1.0, 20.0, 30.0]),
        ("G20G0X1", [f32(25.4 + 110), 20.0, 30.0]),
        ("G0Z1", [10.0, 20.0, 1.0 + 5.0 + 7.0]),
    ],
)
def test_targets_are_machine_coordinates(line: str, target: list[float]) -> None:
    state = {"position": [10.0, 20.0, 30.0], "system_offset": [100.0, 0.0, 5.0], "g92": [10.0, 0.0, 0.0]}
    assert parsed(line, tool_length=7.0, **state).target == pytest.approx(target, abs=1e-5)


def test_centre_from_radius_lies_on_the_side_that_sense_and_sign_say() -> None:
    for line, centre in [
        ("G2X10Y0R10F1", -math.sqrt(75)),
        ("G3X10Y0R10F1", math.sqrt(75)),
        ("G2X10Y0R-10F1", math.sqrt(75)),
        ("G3X10Y0R-10F1", -math.sqrt(75)),
    ]:
        block = parsed(line)
        assert block.centre[:2] == pytest.approx([5.0, centre], abs=1e-5), line
        assert block.radius == 10.0


@pytest.mark.parametrize(
    ("line", "passes"),
    [
        ("G3X10.004Y0I5F1", True),  # 0.004 apart
        ("G3X10.006Y0I5F1", False),  # 0.006 apart and more than 0.1 % of 5
        ("G3X100.04Y0I50F1", True),  # 0.04 apart, under 0.1 % of 50
        ("G3X100.06Y0I50F1", False),
        ("G3X2000.6Y0I1000F1", False),  # under 0.1 %, but more than 0.5
    ],
)
def test_arc_radius_rule(line: str, passes: bool) -> None:
    if passes:
        parsed(line)
    else:
        with pytest.raises(MachineRefusal, match=r"error:33"):
            parsed(line)


def test_checks_do_not_touch_the_state() -> None:
    parser = Parser(modal=Modal(motion=1))
    for line, _ in REFUSED:
        with pytest.raises(MachineRefusal):
            complete(read_block(line, parser.modal), parser, NO_PLACES)
    assert parser == Parser(modal=Modal(motion=1))


def test_numbers_have_eight_digits_and_32_bits() -> None:
    assert read_number("0.1", 0) == (f32(0.1), 3)
    assert read_number("123456789012", 0)[0] == f32(123456780000.0)
    assert read_number("0.00000009", 0)[0] == 0.0  # the ninth digit is not read
    assert read_number("-.5X", 0) == (-0.5, 3)
    assert list(read_words("G1X-2.5")) == [("G", 1.0), ("X", -2.5)]


def test_a_number_too_large_for_32_bits_is_refused() -> None:
    with pytest.raises(MachineRefusal, match="error:2"):
        read_number("9" * 60, 0)


@given(st.decimals(-9999, 9999, places=3))
def test_three_decimals_survive(value) -> None:
    assert read_number(str(value), 0)[0] == pytest.approx(float(value), rel=3e-7)


@given(st.text(alphabet="GMXYZIJKRFSPLNT$=0123456789.-+", max_size=79))
def test_any_line_is_read_or_refused(line: str) -> None:
    try:
        parsed(line.replace("$", "") if not line.startswith("$J=") else line)
    except MachineRefusal as refusal:
        assert refusal.code.startswith("error:")
