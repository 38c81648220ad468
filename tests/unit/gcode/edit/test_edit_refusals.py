# SPDX-License-Identifier: LGPL-2.1-or-later
"""An edit that is refused says where, what the changed line would have been, and what to do."""

from __future__ import annotations

import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.edit.edit_result import Edited
from CNCStepper.gcode.edit.renumber import renumber
from CNCStepper.gcode.edit.transform_verbs import convert_units, scale
from CNCStepper.gcode.edit.verification import require_same_path
from CNCStepper.gcode.interpreter.interpret import interpret

COMPENSATED = "G21 G90 G17 F100\nG0 X0 Y0 Z5\nG41.1 D2\nG1 X20 Y10\nY40\nG40 G0 X60\nM2\n"


def test_a_scale_that_would_not_scale_the_tool_shows_the_changed_line():
    with pytest.raises(ProgramError, match=r"^part.ngc:4:1: .*\(value G1 X40 Y20\); expand it first") as told:
        scale(COMPENSATED, 2.0, dialect="linuxcnc", file="part.ngc")
    assert told.value.code == "edit-differs"


def test_other_moves_are_told_with_the_line_from_which_they_differ():
    old = "G21 G90\nG0 X0 Y0\nG1 X5 F100\nX10\nX15\nM2\n"
    new = old.replace("X10\n", "\n")
    tables = [interpret(text, None, "linuxcnc") for text in (old, new)]
    with pytest.raises(ProgramError, match=r"^part.ngc:4: the changed program makes other moves"):
        require_same_path(*tables, Edited(old, new, tuple(range(1, 7))), "part.ngc")


def test_what_is_no_word_is_shown():
    text = "G21\no1 if [0]\n  never read ? !\no1 endif\nM2\n"
    with pytest.raises(
        ProgramError, match=r"part.ngc:3:\d+: this is no word that can be edited .*\(value .*\); take it out"
    ):
        renumber(text, dialect="linuxcnc", file="part.ngc")


def test_a_pitch_that_inches_cannot_tell_is_refused_with_its_line():
    text = "G21\nM3 S100 G33 Z-5 K1\nZ-6 K2\nM2\n"
    with pytest.raises(ProgramError, match=r"^part.ngc:2: the changed program makes other moves; expand it first"):
        convert_units(text, "inch", dialect="linuxcnc", file="part.ngc")


def test_a_program_of_subroutines_that_has_no_end_lacks_it_in_its_last_line():
    text = "o<hop> sub\nG0 X1\no<hop> endsub\no<hop> call\nG90\n"
    with pytest.raises(ProgramError, match=r"^part.ngc:5: the program has no end"):
        convert_units(text, "inch", dialect="linuxcnc", file="part.ngc")


def test_what_is_said_otherwise_is_told_with_its_line_where_nothing_moves():
    text = "G21\n(debug, unit #<_imperial>)\nG4 P1\n(debug, metric #<_metric>)\nM2\n"
    with pytest.raises(ProgramError, match=r"^part.ngc:2: the changed program makes other moves"):
        convert_units(text, "inch", dialect="linuxcnc", file="part.ngc")


@pytest.mark.parametrize("head", ["", "G21\n"])
def test_a_line_is_the_programs_own_where_a_unit_word_is_put_before_it(head):
    text = f"{head}G90\nG0 X1 Y1\nM3 S100 G33 Z-5 K1\nZ-6 K2\nM2\n"
    line = 3 + bool(head)
    with pytest.raises(ProgramError, match=rf"^part.ngc:{line}: the changed program makes other moves"):
        convert_units(text, "inch", dialect="linuxcnc", file="part.ngc")
