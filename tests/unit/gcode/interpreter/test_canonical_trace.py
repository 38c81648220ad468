# SPDX-License-Identifier: LGPL-2.1-or-later
"""Our canonical calls against those of LinuxCNC's own interpreter, `rs274 -g`, number by number."""

from __future__ import annotations

from pathlib import Path

import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.canonical_trace import canonical_calls, motion_calls, traced_path
from helpers.gcode.rs274_runs import rs274_calls as rs274
from helpers.gcode.rs274_runs import run_rs274
from helpers.gcode.rs274_runs import same_call as same

PROGRAMS = sorted((Path(__file__).parents[3] / "data" / "ngc").glob("*.ngc"))

REFUSED = [
    "G1 X1\nM2",
    "X1\nM2",
    "G80 X1\nM2",
    "G2 X10 F10\nM2",
    "G21 G2 F10 X100 I50.03\nM2",
    "G21 G2 X.002 I.001 F1\nM2",
    "G20 G2 X2 I1.002 F1\nM2",
    "G17 G2 X10 I5 R5 F10\nM2",
    "G90.1 G2 X10 I5 F10\nM2",
    "G93 G1 X1\nM2",
    "G94 F100 G1 X1\nG93 X2 F5\nG94 X3\nM2",
    "G0 G28 X1\nM2",
    "G91 G53 G0 X1\nM2",
    "G92.1 X1\nM2",
    "G10 L2 P10 X1\nM2",
    "M3 M4\nM2",
    "G0 X1",
    "% G0 X1\nM2",
    "F9 G81 X1 R2\nM2",
    "F9 G81 X1 Z-5\nM2",
    "F9 G81 X1 Z-5 R-6\nM2",
    "F9 G81 X1 Z-5 R2 L0\nM2",
    "F9 G81 X1 Z-5 R2 L1.5\nM2",
    "F9 G81 X1 Z-5 R2 P1\nM2",
    "F9 G81 X1 Z-5 R2\nG81 R3\nM2",
    "F9 G81 X1 Z-5 R2\nG80\nG81 X2\nM2",
    "F9 G82 X1 Z-5 R2\nM2",
    "F9 G82 X1 Z-5 R2 P1\nG81 X2\nM2",
    "F9 G83 X1 Z-5 R2\nM2",
    "F9 G83 X1 Z-5 R2 Q0\nM2",
    "F9 G83 X1 Z-5 R2 Q1\nG73 X2 Z-5 R2\nM2",
    "F9 G93 G81 X1 Z-5 R2\nM2",
    "F9 G98 G99 G81 X1 Z-5 R2\nM2",
    "G81 X1 Z-5 R2\nM2",
]


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.stem)
def test_every_call_is_the_one_of_rs274(path, tmp_path):
    run = run_rs274(tmp_path, str(path), folder_of_program=path.parent)
    assert run.returncode == 0, run.stderr
    theirs = [line.rstrip() for line in run.stdout.splitlines() if line.strip()]
    ours = list(canonical_calls(path.read_text("ascii"), file=str(path)))
    assert len(ours) == len(theirs)
    for mine, real in zip(ours, theirs, strict=True):
        assert same(mine, real), f"ours {mine}\nreal {real}"


@pytest.mark.parametrize("text", REFUSED)
def test_what_rs274_refuses_is_refused(text, tmp_path):
    assert not rs274(text + "\n", tmp_path)[1]
    with pytest.raises(ProgramError):
        list(canonical_calls(text))


def test_the_comparison_can_fail(tmp_path):
    theirs, _ = rs274("G21\nG1 X10 F100\nG2 X20 I5.001\nM2\n", tmp_path)
    ours = traced_path("G21\nG1 X10 F100\nG2 X20 I5.003\nM2\n")
    real = motion_calls(theirs)
    assert len(ours) == len(real)
    assert not all(same(mine, other) for mine, other in zip(ours, real, strict=True))


def test_a_grbl_program_is_traced_too():
    assert traced_path("T1\nG0 X1\nG4 P2", "grbl") == [
        "STRAIGHT_TRAVERSE(1.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)",
        "DWELL(2.0000)",
    ]
