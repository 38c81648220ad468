# SPDX-License-Identifier: LGPL-2.1-or-later
"""LinuxCNC's parameter file: what is refused, and what a start state makes of it, judged by `rs274 -v`."""

from __future__ import annotations

from dataclasses import replace

import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.canonical_trace import BARE_UNIT_MM, canonical_calls, default_start
from CNCStepper.gcode.interpreter.functions.tools import read_tool_table
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.interpreter.state.parameters import read_parameters, with_parameters
from CNCStepper.state import Start
from helpers.gcode.rs274_runs import run_rs274, same_call

KEPT = {31: 7.25, 5161: 1, 5162: 2, 5163: 3, 5181: -4, 5183: 0.5}
SECOND = {5220: 2, 5221: 9, 5241: 1.5, 5242: -2.5, 5243: 0.25, 5244: 10, 5250: 30, 5263: -1}
PROGRAM = "G21 G90\nG0 X1 Y2 Z3 A4\nG28 Z9\nG30\n#1=[#5241+#31]\nG1 X#1 F100\nG54\nG0 X0 Y0 Z0\nG92.3\nG0 X0 Y0\nM2\n"


def file_of(numbers: dict[int, float]) -> str:
    return "".join(f"{number}\t{value:.6f}\n" for number, value in sorted(numbers.items()))


@pytest.mark.parametrize(
    "numbers",
    [
        KEPT,
        KEPT | SECOND,
        KEPT | SECOND | {5210: 1, 5211: 0.75, 5212: -3, 5213: 1.25},
        KEPT | {5210: 0, 5211: 0.75, 5212: -3, 5213: 1.25},
    ],
    ids=["homes", "second system, turned", "G92", "G92 suspended"],
)
def test_a_machine_that_remembers_is_read_as_rs274_reads_it(numbers, tmp_path):
    (tmp_path / "program.ngc").write_text(PROGRAM, "ascii")
    (tmp_path / "kept.var").write_text(file_of(numbers), "ascii")
    run = run_rs274(tmp_path, "-v", "kept.var", "program.ngc")
    theirs = [line.rstrip() for line in run.stdout.splitlines() if line.strip()]
    start = with_parameters(default_start(), read_parameters(file_of(numbers)))
    ours = [call.rstrip() for call in canonical_calls(PROGRAM, start=start)]
    assert run.returncode == 0 and len(ours) == len(theirs)
    for mine, real in zip(ours, theirs, strict=True):
        assert same_call(mine, real), f"ours {mine}\nreal {real}"


def test_tools_of_a_table_are_traced_as_rs274_traces_them(tmp_path):
    table, program = "T7 P2 D0.25 Z1.5\n", "G21\nT7 M6\nG43\nG0 X1 Y2 Z3\nG41 D7\nG1 X30 Y40 F100\nG40\nM2\n"
    (tmp_path / "program.ngc").write_text(program, "ascii")
    (tmp_path / "mill.tbl").write_text(table, "ascii")
    run = run_rs274(tmp_path, "-t", "mill.tbl", "program.ngc")
    theirs = [line.rstrip() for line in run.stdout.splitlines() if line.strip()]
    ours = list(canonical_calls(program, start=replace(default_start(), tools=read_tool_table(table, BARE_UNIT_MM))))
    assert run.returncode == 0 and all(same_call(*pair) for pair in zip(ours, theirs, strict=True))
    assert any("1.5000" in call or "38.1" in call for call in ours)


def test_offsets_are_the_machines_own():
    start = with_parameters(Start(), read_parameters("5161 10\n5162 20\n5163 30\n5221 100\n5222 50\n5223 -20\n"))
    assert start.zero_known and start.work_offsets_mm == {"G54": (100.0, 50.0, -20.0)}
    assert interpret("G28\nG0 X1 Y2 Z3\n", start).table().end.tolist() == [[10, 20, 30], [101, 52, -17]]


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("5161 1\n5161 2\n", 2),
        ("5162 1\n\n5161 2\n", 3),
        *((f"{line}\n", 1) for line in ("0 1", "5602 1", "5161", "5161 nan", "5161 inf", "5161 1 2", "x 1")),
    ],
)
def test_a_wrong_line_is_refused_with_its_place(text, line):
    with pytest.raises(ProgramError) as caught:
        read_parameters(text, "a ç.var")
    assert (caught.value.code, caught.value.place.file, caught.value.place.line) == ("parameter-file", "a ç.var", line)


@pytest.mark.parametrize("system", [0, 10, 1.5, -1])
def test_a_work_system_that_is_none_is_refused(system):
    with pytest.raises(ProgramError, match="5220"):
        with_parameters(Start(), {5220: system})
