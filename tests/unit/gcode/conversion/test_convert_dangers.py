# SPDX-License-Identifier: LGPL-2.1-or-later
"""What would hurt: a spindle that runs while somebody reaches in, a tool that is not changed, a hole that is lost."""

from __future__ import annotations

import math

import numpy as np
import pytest

from CNCStepper.gcode.conversion.convert import convert
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.state import Start
from CNCStepper.toolpath import RAPID

ZERO = Start.at_zero()
SHIFTED = Start(position_mm=(0.0, 0.0, 0.0), zero_known=True, work_offsets_mm={"G56": (-7.0, 2.0, -1.0)})


def lines(text: str, target: str, start: Start = ZERO, **options) -> list[str]:
    return convert(text, "linuxcnc", target, start, **options).text.splitlines()


@pytest.mark.parametrize("target", ["grbl", "linuxcnc", "marlin", "mach"])
@pytest.mark.parametrize("after", ["M2\n", "M6 T2\nG1 X2\nM2\n", "T2 M6\nG0 X3\nG1 X2\nM2\n"])
def test_the_spindle_stands_still_where_the_program_pauses_after_m5(target, after):
    text = "G21 G90 F100\nT1 M6\nM3 S1000 \nM8\nG1 X1\nM5\nM9\nG4 P3\nM0\n" + after
    made = lines(text, target)
    wait = next(number for number, line in enumerate(made) if line in ("G4 P3", "G4 P3000"))
    assert {"M5", "M9"} <= set(made[:wait]) and "M0" in made[wait:]


@pytest.mark.parametrize(
    ("target", "asked"), [("grbl", "M0"), ("marlin", "M0"), ("linuxcnc", "T4 M6"), ("iso", "T04 M06")]
)
def test_a_tool_named_after_the_first_cut_is_changed(target, asked):
    text = "G21 G90 F100\nG0 Z5\nG1 X1\nG0 Z9\nT4 M6\nG1 X2\nM2\n"
    made = [line.partition(" ")[2] if line.startswith("N") else line for line in lines(text, target)]
    assert asked.replace("T04", "T4") in [line.replace("T04", "T4") for line in made]
    before = lines("G21 G90 F100\nG0 Z5\nT4 M6\nG1 X2\nM2\n", "grbl")
    assert "M0" not in before and "T4" in before


@pytest.mark.parametrize("target", ["grbl", "grblhal", "fluidnc", "linuxcnc", "mach", "iso"])
def test_a_whole_circle_stays_whole_where_the_work_system_changes_before_it(target):
    text = "G21 G90 F100\nG0 X4 Y0 Z8\nG56\nG2 I-35.789 J-44.247 Z12\nM2\n"
    made = convert(text, "linuxcnc", target, SHIFTED, units="inch")
    old, new = interpret(text, SHIFTED, "linuxcnc"), interpret(made.text, SHIFTED, target)
    arcs = new.table().kind > RAPID + 1
    radius = math.hypot(35.789, 44.247)
    begins, ends, centres = new.begins()[arcs], new.table().end[arcs], new.table().centre[arcs]
    assert len(old) == 2 and arcs.sum() == 1
    assert np.hypot(*(begins[0] - centres[0])[:2]) == pytest.approx(radius, abs=0.01)
    assert (begins[0][:2] == ends[0][:2]).all()  # the same point: a whole turn


def test_what_the_table_hides_is_told():
    text = (
        "G21 G90 F100\nM3\nG53 G0 Z0\nG41.1 D4\nG1 X10\nX20\nG40\nX30\nG61.1\nX31\nG0 Z5\nG84 X1 Y1 Z-5 R2\nG80\nM2\n"
    )
    said = "; ".join(map(str, convert(text, "linuxcnc", "grbl", ZERO).notes))
    for what in ("contains the tool's radius", "places of the machine", "tapping became", "G61.1", "S0"):
        assert what in said
    for source, what in (("linuxcnc", "lines with / are cut always"), ("grbl", "lines with / are left out")):
        (note,) = convert("G21 G90 F100\n/G1 X1\nG1 X2\nM2\n", source, "mach", ZERO).notes
        assert str(note).startswith(what) and note.line == 2
    assert not convert("G21 G90 F100 (G53 G41)\nG1 X1\nM2\n", "linuxcnc", "grbl", ZERO).notes


@pytest.mark.parametrize(("stop", "line"), [("M0", 4), ("M1", 4), ("T2 M6", 4)])
def test_it_is_told_that_the_first_move_after_a_stop_names_all_axes(stop: str, line: int) -> None:
    text = f"G21 G90 F100\nT1 M6\nG0 X1 Y1 Z5\n{stop}\nG0 X5\nG1 X9\nM2\n".replace("T1 M6\n", "G0 Z5\n")
    (note,) = convert(text, "linuxcnc", "linuxcnc", ZERO).notes
    assert "names all its axes" in note.what and (note.times, note.line) == (1, line)
    assert not convert(text.replace(stop, "") + "M0\n", "linuxcnc", "linuxcnc", ZERO).notes


@pytest.mark.parametrize(("target", "words"), [("mach", "G43 H2"), ("linuxcnc", "G43 H2"), ("grbl", "G43.1 Z25.000")])
def test_the_length_of_the_new_tool_is_the_only_one_after_its_change(target, words):
    first = "G21 G90 G17 F100\nT1 M6\nG43 H1\nM3 S1000\nG0 X1 Y1 Z5\nG1 Z-1\nG0 Z50\nM5\n"
    text = first + "T2 M6\n(roughing)\nM3 S2000\nG4 P1\nG43 H2\nG0 X3\nG0 Z5\nG1 Z-1\nG0 Z50\nM5\nM2\n"
    lengths = {1: 10.0, 2: 25.0}
    start = Start(position_mm=(0.0, 0.0, 80.0), zero_known=True, tool_lengths_mm=lengths)
    made = convert(text, "linuxcnc", target, start, tool_lengths_mm=lengths).text
    changes = [line for line in made.splitlines() if line.startswith(("G43", "G49"))]
    assert changes == [words.replace("H2", "H1").replace("25", "10"), words]
    old, new = (interpret(one, start, name).table().end for one, name in ((text, "linuxcnc"), (made, target)))
    assert np.allclose(old, new)


def test_a_mode_is_told_with_the_line_of_its_code_and_not_with_that_of_a_move():
    text = "G21 G90 F100\nG0 X1 Y1 Z5\nG91\n(two)\n\nG1 X1\nG90\nG1 X9\nG93\nG91\n\nG1 X1 F2\nG94 G90\nM2\n"
    lines = {note.what.partition(" ")[0]: note.line for note in convert(text, "linuxcnc", "grbl", ZERO).notes}
    assert (lines["incremental"], lines["feeds"]) == (3, 9)
    inside = "G21 F100\nG0 X1 Y1 Z5\no1 call\nM2\no1 sub\nG91 G1 X1\nG90\no1 endsub\n"
    notes = convert(inside, "linuxcnc", "grbl", ZERO).notes
    assert [note.line for note in notes if "incremental" in note.what] == [6]
