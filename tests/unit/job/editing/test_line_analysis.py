# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program as an editor needs it: all refusals, and what holds after each line, plain or with O-words."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.job.editing.line_analysis import MOST_TOLD, SHORT, Abandoned, Reading, read_program
from CNCStepper.state import Start

PLAIN = ["G21 G90 G54", "T2 M3 S9000", "G0 X0 Y0 Z5", "G1 Z-1 F200", "", "F300 (slow)", "X10", "G91 X1", "M5", "M2"]


def read(*lines: str, dialect: str = "grbl", file: str = "") -> Reading:
    return read_program(list(lines), None, dialect, file)


def places(reading: Reading) -> list[tuple[int, int]]:
    return [(error.place.line, error.place.column) for error in reading.refusals if error.place]


def test_every_bad_line_is_told_and_changes_nothing() -> None:
    reading = read("G21", "G1 X1 Y", "G0 X4", "G2 X5", "X", "G1 X7 F100", "(open", "$H")
    assert places(reading) == [(2, 7), (4, 1), (5, 1), (8, 1)]
    assert reading.refused == 4
    after = reading.after(5)
    assert after is not None and after.work_mm[0] == 4
    assert reading.toolpath.table().line.tolist() == [3, 6]


def test_a_line_knows_what_holds_after_it() -> None:
    reading = read(*PLAIN)
    feeds = [after.state.feed_mm_min for line in range(1, 11) if (after := reading.after(line))]
    assert feeds == [0, 0, 0, 200, 200, 300, 300, 300, 300, 300]
    x = [after.work_mm[0] for line in range(3, 11) if (after := reading.after(line))]
    assert x == [0, 0, 0, 0, 10, 11, 11, 11]
    first, eighth = reading.after(1), reading.after(8)
    assert first is not None and math.isnan(first.work_mm[0]) and first.row == -1
    assert eighth is not None and (eighth.state.distance, eighth.state.tool) == ("incremental", 2)


@pytest.mark.parametrize("lines", [PLAIN, ["G20", "G1 X1 F10", "F20", "N7 F30", "X2", "G92 X0", "G0 Y1", "G18", "M30"]])
def test_it_is_what_the_interpreter_holds_line_by_line(lines: list[str]) -> None:
    reading, interpreter = read(*lines), Interpreter(None, "grbl")
    for number, line in enumerate(lines, 1):
        interpreter.line(line)
        after = reading.after(number)
        assert after is not None and after.state == interpreter.model.state, (number, line)
        work = interpreter.model.work(interpreter.model.position)
        assert after.work_mm == pytest.approx(work, nan_ok=True), (number, line)


def test_lines_that_o_words_lead_over_are_read_as_they_are_run() -> None:
    text = [
        "G21 G90",
        "G0 X0 Y0 Z0",
        "o1 repeat [3]",
        "G91 G1 X2 F100",
        "o1 endrepeat",
        "o2 if [0]",
        "G1 X99",
        "o2 endif",
        "M2",
    ]
    reading = read(*text, dialect="linuxcnc")
    assert not reading.in_order and reading.refused == 0
    assert len(reading.rows_of(4)) == 3 and reading.after(7) is None
    after = reading.after(4)
    assert after is not None and after.work_mm[0] == 6


def test_reading_goes_on_after_bad_lines_among_o_words() -> None:
    text = [
        "G0 X0 Y0 Z0",
        "o1 repeat [5]",
        "G1 X1 Y F1",
        "o1 endrepeat",
        "#1=[2 +]",
        "G0 X#1",
        "G2 X1",
        "o7 call",
        "G0 X1",
    ]
    reading = read(*text, dialect="linuxcnc")
    assert [place[0] for place in places(reading)][:3] == [3, 5, 7]
    assert any(error.code == "no-subroutine" for error in reading.refusals)


def test_a_refusal_in_a_subroutines_file_stands_where_it_is_called(tmp_path: Path) -> None:
    (tmp_path / "part.ngc").write_text("o<part> sub\nG1 X\no<part> endsub\n", encoding="utf-8")
    reading = read("G0 X0", "", "o<part> call", "M2", dialect="linuxcnc", file=str(tmp_path / "ação.ngc"))
    assert [error.place.line for error in reading.refusals if error.place] == [3]
    assert "part.ngc:2" in reading.refusals[0].what


def test_all_are_counted_and_not_all_told() -> None:
    reading = read(*["G1 X"] * (MOST_TOLD + 7))
    assert reading.refused == MOST_TOLD + 7 and len(reading.refusals) == MOST_TOLD


def test_long_programs_are_read_as_short_ones_are() -> None:
    lines = ["G21 G90", "G0 X0 Y0 Z1", "G1 Y F1", "X", "F50", "G1 X7"]
    filling = [f"G1 X{k % 90} F{100 + k % 3}" for k in range(SHORT)]
    long, short = read(*lines, *filling, *lines), read(*lines)
    assert places(long) == [*places(short), *((line + SHORT + 6, column) for line, column in places(short))]
    for number in range(1, 7):
        before, after = short.after(number), long.after(number)
        assert before is not None and after is not None and after.state == before.state
        assert after.work_mm == pytest.approx(before.work_mm, nan_ok=True)
    assert (last := long.after(SHORT + 11)) is not None and last.state.feed_mm_min == 50


def test_it_ends_when_nobody_waits() -> None:
    asked = []

    def go_on() -> bool:
        asked.append(1)
        return len(asked) < 3

    with pytest.raises(Abandoned):
        read_program(["G1 X1 F1"] * 50_000, None, "grbl", "", go_on)
    assert len(asked) == 3


def test_a_long_program_that_speaks_of_a_lathe_profile_is_read_to_its_end() -> None:
    lines = ["G21 G90 G17 F100", "(finished as with G70)", *(f"G1 X{n}" for n in range(1, 3001)), "G1 Q5", "M2"]
    reading = read_program(lines, Start.at_zero(), "linuxcnc")
    assert len(reading.table) == 3000 and [error.place.line for error in reading.refusals if error.place] == [3003]
