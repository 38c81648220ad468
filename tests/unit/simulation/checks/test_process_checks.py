# SPDX-License-Identifier: LGPL-2.1-or-later
"""Power, pierce delay, chart and wire: each program that must be refused has a near twin that must pass."""

from dataclasses import replace

import pytest

from CNCStepper.machine.processes import PROCESSES
from helpers.simulation.torch_programs import DATA, LASER, TABLE, Plate, hole, square, text_of

PLATE = Plate()
TWO = (hole(40, 40, 8), square(90, 60, 30))
WIRE = Plate(process=PROCESSES["hot-wire"], data=None)
GOOD_WIRE = "G21 G90\nG0 X-10 Y20\nM3 S500\nG4 P2\nG1 X40 Y20 F300\nG1 X40 Y60\nG1 X-10 Y60\nM5\nM2\n"


def test_two_clean_cuts_have_no_finding_but_the_info_of_nothing() -> None:
    assert [str(one) for one in PLATE.findings(text_of(TWO))] == []


@pytest.mark.parametrize(
    ("name", "cut", "line"),
    [
        ("no G4", replace(TWO[1], delay=""), "G1 Z1.5 F500"),
        ("G4 far too short", replace(TWO[1], delay="G4 P0.1"), "G1 Z1.5 F500"),
    ],
)
def test_a_pierce_without_its_delay_is_refused(name: str, cut, line: str) -> None:
    text = text_of((TWO[0], cut))
    assert PLATE.codes(text) == {"pierce-delay"}
    assert PLATE.lines_of(text, "pierce-delay") == [line]
    (found,) = [one for one in PLATE.findings(text) if one.code == "pierce-delay"]
    assert found.limit == 0.4 and found.value < 0.2 and found.place_mm[:2] == (105.0, 55.25)


@pytest.mark.parametrize("delay", ["G4 P0.4", "G4 P0.2\nG4 P0.2", "G4 P0.38"])
def test_the_delay_of_the_chart_may_be_written_in_pieces(delay: str) -> None:
    assert PLATE.findings(text_of((TWO[0], replace(TWO[1], delay=delay)))) == []


@pytest.mark.parametrize("delay", ["G4 P0.25", "G4 P0.7"])
def test_a_delay_that_is_not_quite_the_charts_is_a_warning(delay: str) -> None:
    text = text_of((replace(TWO[0], delay=delay), TWO[1]))
    assert (PLATE.codes(text), PLATE.codes(text, "warning")) == (set(), {"chart-pierce-delay"})


def test_without_a_chart_no_delay_is_asked_for() -> None:
    assert Plate(data=None).findings(text_of((replace(TWO[0], delay=""), TWO[1]))) == []


@pytest.mark.parametrize(
    ("wrong", "right"),
    [
        ({"delay": "G4 P3"}, {"delay": "G4 P0.4"}),
        ({"blocks": [TWO[1].blocks[0], "G4 P1", *TWO[1].blocks[1:]]}, {}),
        ({"off": "G4 P0.5\nM5"}, {"off": "M5\nG4 P0.5"}),
    ],
)
def test_power_that_stands_is_refused(wrong: dict, right: dict) -> None:
    assert PLATE.codes(text_of((TWO[0], replace(TWO[1], **wrong)))) == {"power-standing"}
    assert PLATE.findings(text_of((TWO[0], replace(TWO[1], **right)))) == []


def test_a_pause_with_the_power_on_is_refused() -> None:
    assert "power-standing" in PLATE.codes(text_of((replace(TWO[0], off="M0\nM5"), TWO[1])))
    assert PLATE.findings(text_of((replace(TWO[0], off="M5\nM0"), TWO[1]))) == []
    knife = Plate(process=PROCESSES["scribe"])
    assert "power-standing" not in knife.codes(text_of((replace(TWO[0], off="M0\nM5"),)))


def test_a_spot_without_a_cut_is_a_pierce_of_its_own() -> None:
    spot = "G0 X20 Y90\nG0 Z3.8\nM3 S1000\nG4 P{:g}\nM5\nG0 Z10\n"
    begin = "G21 G90\nG0 Z10\n"
    assert PLATE.findings(begin + spot.format(0.4) + "M2\n") == []
    assert PLATE.codes(begin + spot.format(2) + "M2\n") == {"power-standing"}


def test_qtplasmac_waits_by_itself_and_its_scribe_cuts_nothing() -> None:
    machine = TABLE.model_copy(update={"controller": "qtplasmac"})
    plate = Plate(machine=machine, language="qtplasmac")
    lines = "G21 G90\nG0 X75 Y55\nM3 ${0} S1\nG1 Y59.25 F3000\nG1 X59.25\nG1 Y90.75\nG1 X90.75\nG1 Y59.25\nG1 X75\n"
    hole_in_it = "M5 ${0}\nG0 X75 Y75\nM3 $0 S1\nG1 X80 F3000\nM5 $0\nM2\n"
    assert plate.codes(lines.format(1) + hole_in_it.format(1)) == set()
    assert plate.codes(lines.format(0) + hole_in_it.format(0)) == {"piece-free"}
    other = Plate(language="qtplasmac")  # the same text on a controller that does not wait
    assert "pierce-delay" in other.codes(lines.format(0) + hole_in_it.format(0))


def test_power_on_a_rapid_is_refused_even_beside_the_stock() -> None:
    wrong = text_of((replace(TWO[0], off=""), TWO[1]))
    assert "rapid-in-stock" in PLATE.codes(wrong)
    assert "rapid-in-stock" in replace(PLATE, data=None).codes(wrong)
    away = "G21 G90\nG0 X-10 Y-10\nM3 S900\nG0 X-15\nM5\nG0 X20 Y20\nM3 S900\nG4 P0.4\nG1 X30 F3000\nM5\nM2\n"
    assert Plate(data=None).codes(away) == {"rapid-in-stock"}


def test_a_laser_switches_itself_off_on_rapids() -> None:
    text = text_of((replace(TWO[0], off=""), TWO[1]))
    laser = Plate(process=PROCESSES["laser"], machine=LASER, data=None)
    assert laser.findings(text) == []


@pytest.mark.parametrize(
    ("changes", "code", "value"),
    [
        ({"feed_mm_min": 1000.0}, "chart-feed", 1000.0),
        ({"feed_mm_min": 4000.0}, "chart-feed", 4000.0),
        ({"cut_height_mm": 4.0}, "chart-height", 4.0),
        ({"pierce_height_mm": 1.5}, "chart-pierce-height", 1.5),
    ],
)
def test_what_is_not_the_charts_is_one_warning_with_the_worst_value(changes: dict, code: str, value: float) -> None:
    text = text_of((TWO[0], replace(TWO[1], **changes)))
    (found,) = PLATE.findings(text)
    assert (found.severity, found.code, found.value) == ("warning", code, value)
    assert found.limit is not None and found.advice
    assert Plate(data=None).findings(text) == []


def test_small_holes_may_be_cut_at_their_own_feed() -> None:
    assert PLATE.findings(text_of((replace(TWO[0], feed_mm_min=1800), TWO[1]))) == []


def test_a_tool_whose_width_is_not_the_charts_kerf_is_a_warning() -> None:
    wide = Plate(data=DATA.model_copy(update={"kerf_mm": 2.5}))
    assert wide.codes(text_of(TWO), "warning") == {"chart-kerf"}


def test_a_wire_goes_in_from_the_edge_and_stays_hot() -> None:
    assert WIRE.findings(GOOD_WIRE) == []
    assert WIRE.codes(GOOD_WIRE.replace("G0 X-10 Y20", "G0 X10 Y20")) == {"wire-entry"}
    assert WIRE.codes(GOOD_WIRE.replace("G1 X40 Y60", "M5\nG1 X40 Y60\nM3")) == {"wire-cold", "wire-entry"}


def test_a_wire_may_not_jump_inside_the_sheet_though_it_is_off() -> None:
    jump = GOOD_WIRE.replace("M5\n", "M5\nG0 X-10 Y90\nG0 X250\n")
    assert WIRE.codes(jump) == {"rapid-in-stock"}
    assert WIRE.findings(GOOD_WIRE.replace("M5\n", "M5\nG0 X-10 Y190\nG0 X-20\n")) == []


def test_a_hot_wire_stands_in_the_sheet_for_a_corner_only() -> None:
    corner = "G1 X40 Y20 F300\nG4 P{:g}"
    assert WIRE.findings(GOOD_WIRE.replace("G1 X40 Y20 F300", corner.format(0.5))) == []
    assert WIRE.codes(GOOD_WIRE.replace("G1 X40 Y20 F300", corner.format(5))) == {"power-standing"}


def test_a_wire_must_be_hot_before_it_moves() -> None:
    data = DATA.model_copy(update={"process": "hot-wire", "pierce_delay_s": 2.0, "feed_mm_min": 300.0})
    hot = replace(WIRE, data=data)
    assert hot.findings(GOOD_WIRE) == []
    assert hot.codes(GOOD_WIRE.replace("G4 P2\n", "")) == {"pierce-delay"}
    assert hot.findings(GOOD_WIRE.replace("G4 P2\n", "G4 P30\n")) == []  # beside the sheet it does no harm
