# SPDX-License-Identifier: LGPL-2.1-or-later
"""An edit is checked as the program runs from its start, also where its lines are written out for the controller."""

from __future__ import annotations

import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.wire.read_back import refused_lines
from CNCStepper.job.editing.edit_check import EditCheck
from CNCStepper.machine.profile import load_machine
from CNCStepper.state import Start

ASKS_ITS_PLACE = "G21 G90 G17\no1 if [#5420 GT 1]\nG1 X10 F100\no1 endif\nG1 X#5420 Y5 F100\nM2\n"


@pytest.mark.parametrize("dialect", ["grblhal", "fluidnc"])
def test_a_program_that_asks_its_place_is_checked_from_there(dialect: str) -> None:
    start = Start(position_mm=(5.0, 0.0, 0.0))
    assert EditCheck(dialect, start).new_errors(ASKS_ITS_PLACE, ASKS_ITS_PLACE) == []
    assert list(refused_lines(ASKS_ITS_PLACE, start, dialect)) == []
    with pytest.raises(ProgramError, match="is not known here"):
        EditCheck(dialect).new_errors(ASKS_ITS_PLACE, ASKS_ITS_PLACE)


def test_only_errors_that_the_old_program_had_not_are_new() -> None:
    check = EditCheck("grbl", Start.with_work_zero((-200.0, -150.0, -30.0)), machine=load_machine("table-a"))
    good = "G21 G90 G17\nG0 X0 Y0 Z5\nG0 X10\nM2\n"
    far = good.replace("X10", "X9000")
    assert check.new_errors(good, good) == []
    assert check.new_errors(good, far)
    assert check.new_errors(far, far) == []


def test_an_error_that_an_edit_makes_greater_is_new() -> None:
    check = EditCheck("grbl", Start.with_work_zero((-200.0, -150.0, -30.0)), machine=load_machine("table-a"))
    left = "G21 G90 G17\nG0 X0 Y0 Z5\nG0 X470\nM2\n"
    farther, nearer = left.replace("470", "9060"), left.replace("470", "460")
    assert [error.code for error in check.new_errors(left, farther)] == ["travel"]
    assert check.new_errors(left, nearer) == check.new_errors(left, left.replace("470", "470.01")) == []
