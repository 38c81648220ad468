# SPDX-License-Identifier: LGPL-2.1-or-later
"""Restarts at every line of programs in which the state matters: the rest is run as in the undisturbed run."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.recovery.restart.approach import Options
from CNCStepper.recovery.restart.interrupted_program import read_program
from CNCStepper.recovery.restart.restart_places import RequestedPlace
from CNCStepper.recovery.restart.restart_program import Restart, restart, restart_of
from CNCStepper.state import Start
from CNCStepper.toolpath import RAPID, Toolpath
from helpers.gcode.restart_programs import END, HEAD, PROGRAMS

OFFSETS = {"G54": (-200.0, -150.0, -30.0), "G55": (-90.0, -60.0, -25.0), "G59": (-150.0, -40.0, -28.0)}
START = Start(work_offsets_mm=OFFSETS, zero_known=True)
NOWHERE = {"restart-at-start", "restart-nothing-left", "restart-time"}
SQUARE = HEAD + "G0 X0 Y0\nG1 Z-1 F200\nX40 F800\nY20\nX0\nY0\nZ-2 F200\nX40 F800\nY20\nX0\nY0\n" + END


def restarts(name: str, start: Start | None = START, overlap_mm: float = 0.0) -> list[tuple[int, Restart]]:
    """Return all restarts of a program, with the line that was asked for; what is refused is refused for a reason."""
    dialect, text = PROGRAMS[name]
    program, made = read_program(text, dialect, start, "p.nc"), []
    for number, time in product(range(1, text.count("\n") + 1), (1, 2, 3) if "repeat" in text else (0,)):
        try:
            made.append((number, restart_of(program, RequestedPlace(line=number, time=time), Options(overlap_mm))))
        except ProgramError as error:
            assert error.code in NOWHERE, (number, error)
    assert made
    return made


def running(path: Toolpath, row: int) -> tuple:
    """Return what holds on a row, as this test understands it."""
    state, table = path.states[int(path.table().state[row])], path.table()
    modes = (state.units, state.distance, state.plane, state.feed_mode, state.path_mode, state.work_system, state.tool)
    on = (state.spindle, state.spindle_rpm, state.mist, state.flood)
    numbers = (*state.offset_mm, *state.g92_mm, state.tool_length_mm, state.feed_mm_min, table.feed[row])
    return modes, on, tuple(round(float(number), 4) + 0.0 for number in numbers)


def assert_same_rest(made: Restart, told: str) -> None:
    """Compare the rows after the entered one with those of the whole program, from the end."""
    whole, own = made.program.path, interpret(made.text, made.start, made.program.dialect)
    count = len(whole) - made.entrance.row - 1
    for back in range(1, count + 1):
        old, new = len(whole) - back, len(own) - back
        ends = whole.table().end[old], own.table().end[new]
        assert np.allclose(*ends, atol=1e-4, equal_nan=True), (told, old, *ends)
        assert running(whole, old) == running(own, new), (told, old)


def assert_nothing_cut_on_the_way(made: Restart, told: str) -> None:
    """Up to the entrance all moves are rapids at one height, then one plunge straight above it."""
    path = interpret(made.text, made.start, made.program.dialect)
    table, at = path.table(), np.array(made.approach.at_mm)
    first = int(np.flatnonzero(np.isclose(table.end[:, :3], at, atol=1e-4, equal_nan=True).all(axis=1))[0])
    before = table.end[:first]
    assert (table.kind[:first] == RAPID).all(), told
    assert len(np.unique(np.round(before[:, 2], 6))) <= 1, told
    assert np.isnan(at[2]) or np.isnan(before[0, :2]).all(), told


@pytest.mark.slow
@pytest.mark.parametrize("name", PROGRAMS)
def test_from_every_line_the_rest_is_run_as_in_the_undisturbed_run(name: str) -> None:
    for line, made in [*restarts(name), *restarts(name, overlap_mm=3.0)[::2]]:
        told = f"line {line}: {made.entrance}\n{made.text}"
        assert_same_rest(made, told)
        assert_nothing_cut_on_the_way(made, told)
        prepare(made.text, PROGRAMS[name][0], start=made.start)


@pytest.mark.parametrize("name", ["g92", "incremental", "inches", "canned cycles", "laser"])
def test_a_work_zero_that_is_not_known_is_no_hindrance(name: str) -> None:
    for line, made in restarts(name, None):
        assert_same_rest(made, f"line {line}")


def test_the_entry_comes_from_above_with_the_spindle_turning() -> None:
    made = restart(SQUARE, RequestedPlace(line=10), start=START, options=Options(spin_up_s=5.0))
    entry = made.text.splitlines()[2:]
    assert entry[:9] == [
        "M5 M9",
        "G21 G17 G90 G91.1",
        "G40 G49 G94",
        "G54",
        "G0 Z10",
        "T1",
        "G0 X40 Y20",
        "M3 S12000",
        "G4 P5",
    ]
    assert entry[9:12] == ["G1 Z-1 F200", "F800", "G1 X0"]


def test_a_beam_is_switched_on_once_it_is_down_with_the_programs_own_pierce() -> None:
    text = "G21 G90\nG0 Z10\nX0 Y0\nG1 Z0 F500\nM3 S1\nG4 P0.7\nG1 X10 F1500\nY10\nX0\nM5\nG0 Z10\nM2\n"
    jet = Tool(number=0, shape="jet", diameter_mm=1.0)
    made = restart(text, RequestedPlace(line=8), options=Options(spin_up_s=9.0, tools=jet))
    assert made.approach.is_beam
    lines = made.text.splitlines()
    assert lines[lines.index("G1 Z0 F500") :][:4] == ["G1 Z0 F500", "M3 S1", "G4 P0.7", "F1500"]


def test_the_overlap_ends_where_the_pass_begins() -> None:
    made = restart(SQUARE, RequestedPlace(line=15), start=START, options=Options(overlap_mm=500.0))
    assert made.entrance.row == 8
    assert made.entrance.overlap_mm == pytest.approx(60.0)
    assert "the cut begins there" in made.entrance.notes[0]


def test_the_overlap_is_cut_again_and_no_more() -> None:
    made = restart(SQUARE, RequestedPlace(line=10), start=START, options=Options(overlap_mm=25.0))
    assert made.approach.at_mm == pytest.approx((-200 + 35, -150, -31))
    assert made.text.splitlines()[12] == "G1 X40 Y0 Z-1 F800"


def test_a_descent_is_entered_at_its_begin() -> None:
    cut = "G0 X50 Y0\nG1 Z-1 F200\nX60 F800\nG0 Z10\n"
    text = HEAD + cut + "G0 X0 Y0\nG1 Z0 F500\nG1 X10 Z-1 F300\nX0 Z-2\nX10 Z-3\nX0\nY10 F800\nX10\n" + END
    made = restart(text, RequestedPlace(line=14), start=START)
    assert made.entrance.notes == ("it is within a way into the cut, which begins at line 11",)


def test_a_lead_in_is_entered_at_the_plunge() -> None:
    text = HEAD + "G0 X0 Y0\nG1 Z-1 F200\nG3 X5 Y5 I0 J5 F800\nG1 X40\nY40\nX5\nY5\nG3 X0 Y10 I-5 J0\n" + END
    text = text.replace(END, "G0 Z10\nX60\nG1 Z-1\nX80\n" + END)
    with pytest.raises(ProgramError, match="restart-at-start"):
        restart(text, RequestedPlace(line=8), start=START)
    assert restart(text, RequestedPlace(line=10), start=START).entrance.row == 5


def test_a_plunge_from_an_unknown_height_gives_the_feed_of_the_entry() -> None:
    text = "G21 G90\nM3 S8000\nG0 X0 Y0\nG1 Z-1 F200\nX40 F3000\nY20\nX0\nG0 Z5\nX0 Y0\nM2\n"
    assert restart(text, RequestedPlace(line=6)).approach.plunge_mm_min == 200


def test_a_thread_mills_helix_is_entered_at_its_begin() -> None:
    helix = "G3 X2 Y0 I1 J0 F300\nG3 X2 Y0 Z-4 I-2 J0\nG3 X2 Y0 Z-3 I-2 J0\nG3 X0 Y0 I-1 J0\n"
    text = HEAD + "G0 X20 Y0\nG1 Z-1 F100\nX30\nG0 Z10\nG0 X0 Y0\nG1 Z-5 F200\n" + helix + END
    made = restart(text, RequestedPlace(line=14), start=START)
    assert "thread mills" in made.entrance.notes[0]
    assert made.program.file_line(made.entrance.row) == 11


def test_a_point_finds_the_nearest_cut_and_the_first_of_those_on_top_of_each_other() -> None:
    made = restart(SQUARE, RequestedPlace(at_mm=(41.0, 12.0)), start=START)
    assert made.approach.at_mm == pytest.approx((-160, -138, -31))
    made = restart(SQUARE, RequestedPlace(at_mm=(41.0, 12.0, -1.9)), start=START)
    assert made.approach.at_mm == pytest.approx((-160, -138, -32))


def test_a_point_lies_on_the_middle_of_an_arc() -> None:
    text = HEAD + "G0 X10 Y0\nG1 Z-1 F200\nG3 X10 Y0 I-10 J0 F700\n" + END
    made = restart(text, RequestedPlace(at_mm=(-20.0, 0.1)), start=START)
    x, y, _ = made.approach.at_mm
    assert np.hypot(x + 200, y + 150) == pytest.approx(10.0, abs=1e-6)
    assert (x, y) == pytest.approx((-210, -149.95), abs=0.02)


def test_operations_and_contours_are_found_by_name_and_number() -> None:
    one, two = "G0 X0 Y0\nG1 Z-1 F200\nX9 F800\nG0 Z10\n", "G0 X0 Y5\nG1 Z-1 F200\nX9 F800\nG0 Z10\n"
    text = f"{HEAD}(begin operation: face)\n{one}(finish operation: face)\n(begin operation: slot)\n{two}{one}"
    text += f"(finish operation: slot)\n{END}"
    assert restart(text, RequestedPlace(operation="Slot"), start=START).entrance.row == 5
    assert restart(text, RequestedPlace(operation="slot", contour=2), start=START).entrance.row == 10
    assert restart(text, RequestedPlace(contour=3), start=START).entrance.row == 10
    with pytest.raises(ProgramError, match=r"its operations are: 1 \(face\), 2 \(slot\)"):
        restart(text, RequestedPlace(operation="bore"), start=START)


def refusal(text: str, where: RequestedPlace, dialect: str = "grbl", options: Options | None = None) -> str:
    with pytest.raises(ProgramError) as error:
        restart(text, where, dialect, START, "p.nc", options)
    assert error.value.advice
    return error.value.code


def test_what_cannot_be_restarted_is_refused_with_a_reason() -> None:
    assert refusal(SQUARE, RequestedPlace(line=6)) == "restart-at-start"
    assert refusal(SQUARE, RequestedPlace(line=19)) == "restart-nothing-left"
    assert refusal(SQUARE, RequestedPlace()) == "restart-where"
    assert refusal(SQUARE, RequestedPlace(line=9, contour=1)) == "restart-where"
    assert refusal(SQUARE, RequestedPlace(contour=2)) == "restart-contour"
    assert refusal("M2\n", RequestedPlace(line=1)) == "restart-empty"
    assert refusal("G21\nG90\nG1 X5 F100\n", RequestedPlace(line=3), "marlin") == "restart-dialect"
    assert refusal(SQUARE, RequestedPlace(line=9), options=Options(height_mm=-5.0)) == "restart-height"
    assert refusal("G90 G21 G1 X0 Y0 Z-1 F100\nX5\nX9\nM2\n", RequestedPlace(line=3)) == "restart-height"
    assert refusal(PROGRAMS["subprograms"][1], RequestedPlace(line=3), "grblhal") == "restart-time"


def test_the_rest_that_would_differ_is_refused() -> None:
    text = HEAD + "G0 X0 Y0\nG1 Z-1 F200\nG28.1\nX10 F800\nX20\nG28 Z10\nX30\n" + END
    assert refusal(text, RequestedPlace(line=10)) == "restart-differs"


def test_marks_and_line_numbers_of_the_old_file_are_told() -> None:
    made = restart(SQUARE, RequestedPlace(line=10), start=START)
    lines, old = made.text.splitlines(), SQUARE.splitlines()
    assert [old[number - 1] for number in made.file_lines[made.file_lines > 0]][1:] == lines[-9:]
    assert len(made.file_lines) == len(lines)
    own = len(lines) - 9
    assert lines[1] == f"(line {own} here is its line {made.file_lines[own - 1]})"
