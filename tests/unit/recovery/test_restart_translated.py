# SPDX-License-Identifier: LGPL-2.1-or-later
"""Restarts of programs in a language that the machine's controller lacks, and machines that cannot be restarted."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

from CNCStepper.cli.main import group
from CNCStepper.errors import CNCStepperError, ProgramError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.machine.profile import load_machine
from CNCStepper.recovery.restart.interrupted_program import read_on_machine
from CNCStepper.recovery.restart.prove_restart import certificate_of_restart, restart_program
from CNCStepper.recovery.restart.restart_places import RequestedPlace, contours
from CNCStepper.state import Start
from helpers.controllers.thesis_programs import PROGRAMS, moves_of

# the programs run about the origin, and the table begins at 0
ROOM = Start(position_mm=(300.0, 300.0, 0.0), work_offsets_mm={"G54": (300.0, 300.0, 0.0)})
TABLE = load_machine("thesis-table")


def text_of(number: int) -> str:
    return PROGRAMS[number].replace("|", "\n").replace(" " * 8, "") + "\n"


@pytest.mark.parametrize("number", PROGRAMS)
def test_each_move_of_the_thesis_programs_can_be_restarted_to_the_same_end(number: int) -> None:
    text = text_of(number)
    program = read_on_machine(text, TABLE, "", ROOM, "p.txt")
    lines = [program.file_line(row) for row in range(len(program.table))]
    assert len(lines) == len(moves_of(number)) and lines == sorted(set(lines)), "a line of the file is one place"
    for line in lines[1:]:
        made = restart_program(text, TABLE, RequestedPlace(line=line), file="p.txt", start=ROOM)
        assert not made.proof.refused, made.proof.findings
        assert made.restart.text.splitlines()[2] == "M5 M9", made.restart.text
        again = interpret(made.restart.text, made.restart.start, made.restart.program.dialect).table()
        assert np.allclose(again.end[-1, :2], program.table.end[-1, :2], atol=1e-6)
        first = made.restart.file_lines[made.restart.file_lines > 0][0]
        assert first <= line, "nothing that is not certainly cut is left out"
        sent = certificate_of_restart(made).send_job()
        assert sent.dialect.startswith("grbl") and sent.restart_of


def test_a_contour_is_named_as_in_the_program() -> None:
    text = "g90\nx20\nG0\nx40\nG90\nx60\ny20\nG0\nx0 y0\n"
    program = read_on_machine(text, TABLE, "", None, "p.txt")
    assert [program.file_line(one.first) for one in contours(program)] == [2, 6]
    made = restart_program(text, TABLE, RequestedPlace(contour=2), file="p.txt")
    assert made.restart.entrance.row == 2 and "line 6" in made.restart.text


def test_the_lathe_is_refused_with_what_to_do() -> None:
    text = "N30 G01X-1. F1. # N40 Z-5. # N50 X5000 Z5. F2.0 #\nG00 X-.5 #\nM02 #\n"
    with pytest.raises(ProgramError, match=r"begins at the work zero.*send the whole program") as refused:
        restart_program(text, load_machine("mini-lathe"), RequestedPlace(line=2), file="p.txt")
    assert refused.value.code == "restart-lathe"


def test_letters_are_refused_with_what_to_do(tmp_path: Path) -> None:
    (tmp_path / "a.letters").write_text("AAADDD\n", "ascii")
    words = ["restart", str(tmp_path / "a.letters"), "--machine", "usb-board", "--line", "1"]
    refused = CliRunner().invoke(group, words).exception
    assert isinstance(refused, CNCStepperError) and refused.code == "restart-letters" and "back" in refused.advice


def test_the_file_says_in_which_language_it_is(tmp_path: Path) -> None:
    path, out = tmp_path / "p.txt", tmp_path / "rest.nc"
    path.write_text("g90\nx20\ny20\nx0\n", "ascii")
    words = ["restart", str(path), "--machine", "thesis-table", "--line", "3", "-o", str(out)]
    made = CliRunner().invoke(group, words)
    assert made.exit_code == 0 and "--dialect grbl" in made.stdout, made.output
    checked = CliRunner().invoke(group, ["check", str(out), "--machine", "thesis-table", "--dialect", "grbl"])
    assert checked.exit_code == 0, checked.output
