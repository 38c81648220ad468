# SPDX-License-Identifier: LGPL-2.1-or-later
"""Job files opened and exported: the same program byte for byte, for every example that FreeCAD has objects for."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from CNCStepper.job.cut_transfer import program_texts
from CNCStepper.job.model import load_job
from CNCStepper.workbench import api
from CNCStepper.workbench.document.job_files import export_job, open_job
from CNCStepper.workbench.features.base import problem_of

ROOT = Path(__file__).parents[2]
SIGN = ROOT / "examples" / "jobs" / "sign.toml"
JOBS = sorted({*(ROOT / "examples" / "jobs").rglob("*.toml")} - {SIGN})


def program_of(path: Path, title: str) -> list[tuple[str, str]]:
    job, machine = load_job(path)
    return list(program_texts(job.on(machine), machine, title))


@pytest.mark.parametrize("path", JOBS, ids=lambda path: path.stem)
def test_a_job_file_gives_its_own_program_and_comes_out_again(document: Any, path: Path, tmp_path: Path) -> None:
    job, notes = open_job(document, path)
    document.recompute()
    assert not any(map(problem_of, (*job.Tools, *job.Operations, job)))
    assert [note for note in notes if "than its file" in note] == []
    assert api.program_text(job) == program_of(path, job.Label)[0][1]
    export_job(job, tmp_path / "out.toml")
    assert program_of(tmp_path / "out.toml", job.Label)[0][1] == api.program_text(job)


def test_an_island_that_leaves_its_pocket_is_told(document: Any) -> None:
    job, _ = open_job(document, SIGN)
    document.recompute()
    assert len(job.Operations) == 3
    assert [("cross" in problem_of(each)) for each in job.Operations].count(True) == 1


def test_a_moved_drawing_of_an_opened_job_is_cut_where_it_lies(document: Any) -> None:
    job, _ = open_job(document, ROOT / "examples" / "jobs" / "cycles" / "contour.toml")
    document.recompute()
    before = api.program_text(job)
    drawing = job.Operations[0].Drawings[0][0]
    drawing.Placement.Base.x += 0.5
    document.recompute()
    assert api.program_text(job) != before
