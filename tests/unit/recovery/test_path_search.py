# SPDX-License-Identifier: LGPL-2.1-or-later
"""The place of a held machine: passes that lie on top of each other are told apart, or the doubt is told."""

from __future__ import annotations

from math import cos, sin, tau

import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.recovery.retract.path_search import Controller, PositionReport, find
from CNCStepper.recovery.retract.places_on_path import Place, RetractPath
from CNCStepper.state import Start

GRBL = Controller(15, (80.0, 80.0, 400.0), 0.002, 5000.0)
THRICE = "G21G90\nG1Z-1F600\n" + 3 * "X10\nY10\nX0\nY0\n"  # 40 mm a pass, a second for each 10 mm
SPUR = "G21G90\nG1X10F600\nX0\n"


def way_of(text: str) -> RetractPath:
    return RetractPath(interpret(text, Start.at_zero()))


def seen(time_s: float, x: float, y: float, blocks: int = -1, lines: int = 14) -> PositionReport:
    return PositionReport(time_s, time_s + 0.01, lines, lines, (x, y, -1.0), blocks)


def test_a_place_that_only_one_row_passes_is_found() -> None:
    found = find(way_of("G21G90\nG1X10F600\nY10\n"), [PositionReport(0.0, 0.01, 3, 3, (10.0, 4.0, 0.0))], GRBL)
    assert found.early == found.late == pytest.approx(Place(1, 0.4))


@pytest.mark.parametrize("passes", range(3))
def test_blocks_left_tell_passes_apart(passes: int) -> None:
    blocks = 12 - 4 * passes  # of the pass being cut and those after it
    found = find(way_of(THRICE), [seen(0.0, 5.0, 0.0, blocks)], GRBL)
    assert found.early == found.late == pytest.approx(Place(1 + 4 * passes, 0.5))


def test_reports_of_the_way_there_tell_passes_apart() -> None:
    corners = [(10.0, 0.0), (10.0, 10.0), (0.0, 10.0), (0.0, 0.0)]
    reports = [seen(0.1 + number, *corners[number % 4]) for number in range(-1, 8)]
    reports[0] = PositionReport(-0.9, -0.89, 14, 14, (0.0, 0.0, -0.5))  # still going down
    found = find(way_of(THRICE), [*reports, seen(8.6, 5.0, 0.0)], GRBL)
    assert found.early == found.late == pytest.approx(Place(9, 0.5))


def test_what_cannot_be_told_apart_is_an_interval() -> None:
    found = find(way_of(THRICE), [seen(0.0, 5.0, 0.0)], GRBL)
    assert (found.early, found.late) == (pytest.approx(Place(1, 0.5)), pytest.approx(Place(9, 0.5)))


def test_way_out_and_way_back_of_a_spur_are_told_apart_by_blocks() -> None:
    for blocks, place in ((2, Place(0, 0.9)), (1, Place(1, 0.1))):
        found = find(way_of(SPUR), [PositionReport(0.0, 0.01, 3, 3, (9.0, 0.0, 0.0), blocks)], GRBL)
        assert found.early == found.late == pytest.approx(place)


def test_only_rows_that_may_be_cut_are_looked_at() -> None:
    text = "G21G90\n" + "".join(f"G1X{number % 2}F600\n" for number in range(1, 60))
    found = find(way_of(text), [PositionReport(0.0, 0.01, 40, 40, (0.5, 0.0, 0.0))], GRBL)
    assert found.early.row >= 38 - 16 and found.late.row <= 38


def test_before_the_first_move_there_is_no_way_back() -> None:
    with pytest.raises(ProgramError, match="retreat-begin"):
        find(way_of("G21G90\n"), [PositionReport(0.0, 0.01, 1, 1, (0.0, 0.0, 0.0))], GRBL)


def test_a_machine_beside_its_way_is_refused() -> None:
    with pytest.raises(ProgramError, match="retreat-off-path"):
        find(way_of(SPUR), [PositionReport(0.0, 0.01, 3, 3, (9.0, 0.1, 0.0))], GRBL)


def test_block_that_the_step_generator_has_taken_does_not_rule_a_pass_out() -> None:
    radius_mm, laps = 2.0, "G21G90G17\nG2X0Y0I-2J0F900\n" + 2 * "G2X0Y0I-2J0\n"

    def after(laps: float, lines: int, blocks: int) -> PositionReport:
        angle, time_s = -tau * laps, laps * tau * radius_mm / 15.0
        place = radius_mm * (cos(angle) - 1.0), radius_mm * sin(angle), 0.0
        return PositionReport(time_s, time_s + 0.006, lines + 1, lines, GRBL.on_step(place), blocks)

    reports = [after(0.4, 1, 15), after(0.6, 1, 15), after(0.89, 2, 15), after(1.13, 2, 15), after(1.37, 2, 15)]
    reports += [after(1.61, 2, 15), after(1.766, 3, 15), after(1.83, 3, 12)]
    found = find(way_of(laps), reports, GRBL)
    assert found.early == found.late and found.early.row == 1
    assert found.early.share == pytest.approx(0.83, abs=0.002)
