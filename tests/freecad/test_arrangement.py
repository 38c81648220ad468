# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Arrangement: programs of jobs and files as one program, which says when one of them has changed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD
import pytest

from CNCStepper.errors import CNCStepperError
from CNCStepper.job.editing.arrangement import arranged_and_checked, at_places, program_of
from CNCStepper.workbench import api
from CNCStepper.workbench.document import program_file
from CNCStepper.workbench.document.machine_of_job import machine_of
from CNCStepper.workbench.features.base import problem_of
from CNCStepper.workbench.features.program import is_of_a_file

SQUARE = "G21 G90 G17\nM3 S1000\nG0 Z5\nG0 X0 Y0\nG1 Z-1 F200\nG1 X20 F600\nG1 Y10\nG1 X0\nG1 Y0\nG0 Z5\nM5\nM2\n"


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "square ç.nc"
    path.write_text(SQUARE, encoding="utf-8")
    return path


def test_a_file_and_a_program_become_the_program_of_the_core(document: Any, file: Path, tmp_path: Path) -> None:
    job = api.new_job(document)
    program = api.load_program(job, file)
    other = tmp_path / "other.nc"
    other.write_text(SQUARE.replace("X20", "X12"), encoding="utf-8")
    out = tmp_path / "sheet.nc"
    arrangement = api.add_arrangement(job, [program, other], file=str(out), tool_mm=2.0)
    api.arrange_programs(arrangement, [(0, 10.0, 10.0, 0.0), (0, 50.0, 10.0, 30.0), (1, 10.0, 40.0, 0.0)])
    document.recompute()
    assert problem_of(arrangement) == "" and arrangement.Placed == 3
    machine = machine_of(job)
    programs = [
        program_of(file.name, SQUARE, 2, machine.language(), 1.0),
        program_of(str(other), other.read_text("utf-8"), 1, machine.language(), 1.0),
    ]
    copies = at_places(programs, [(10.0, 10.0, 0.0), (50.0, 10.0, 30.0), (10.0, 40.0, 0.0)])
    text, errors = arranged_and_checked(programs, copies, machine.language(), str(out), machine)
    assert errors == [] and out.read_text("utf-8") == text
    (made,) = (each for each in document.Objects if is_of_a_file(each) and each.File == str(out))
    assert program_file.load(made) == text

    program_file.store(program, SQUARE.replace("Y10", "Y12"))
    document.recompute()
    assert "arrange them again" in problem_of(arrangement)


def test_copies_are_placed_by_the_search_and_survive_saving(document: Any, file: Path, tmp_path: Path) -> None:
    job = api.new_job(document)
    arrangement = api.add_arrangement(job, [str(file)], file=str(tmp_path / "out.nc"))
    arrangement.Counts = "[4]"
    api.arrange_programs(arrangement)
    path, name = tmp_path / "arranged.FCStd", arrangement.Name
    document.saveAs(str(path))
    FreeCAD.closeDocument(document.Name)
    again = FreeCAD.openDocument(str(path))
    try:
        again.recompute()
        assert problem_of(again.getObject(name)) == "" and again.getObject(name).Placed == 4
        file.write_text(SQUARE.replace("X20", "X25"), encoding="utf-8")
        again.getObject(name).touch()
        again.recompute()
        assert "arrange them again" in problem_of(again.getObject(name))
    finally:
        FreeCAD.closeDocument(again.Name)


def test_what_cannot_be_arranged_is_refused(document: Any, file: Path, tmp_path: Path) -> None:
    job = api.new_job(document)
    for programs, values, places, why in (
        ([], {}, [], "no program"),
        ([str(file)], {"sheet_x_mm": 0}, [], "sheet_x_mm"),
        ([str(file)], {}, [(0, 0.0, 0.0, 0.0), (0, 5.0, 0.0, 0.0)], "cut into each other"),
        ([str(file)], {}, [(0, 0.0, 0.0, 0.0), (0, 1e4, 0.0, 0.0)], "travel"),
        ([str(file)], {"file": ""}, [(0, 0.0, 0.0, 0.0)], "no file"),
        ([str(file)], {"file": "none.nc"}, [(0, 0.0, 0.0, 0.0)], "whole path"),
    ):
        arrangement = api.add_arrangement(job, programs, **{"file": str(tmp_path / "none.nc"), **values})
        with pytest.raises(CNCStepperError, match=why):
            api.arrange_programs(arrangement, places)
        assert arrangement.Placed == 0 and not (tmp_path / "none.nc").exists()
