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
from helpers.job.example_jobs import TABLE_JOBS as JOBS

ROOT = Path(__file__).parents[2]
SIGN = ROOT / "examples" / "jobs" / "sign.toml"

CROSSING = """
[[shape]]
name = "rim"
rectangle_mm = { corner_a = [20, 30], corner_b = [60, 60] }

[[shape]]
name = "hole"
circle_mm = { centre = [20, 45], radius = 8 }
"""


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


def test_an_island_that_leaves_its_pocket_is_told(document: Any, tmp_path: Path) -> None:
    text = SIGN.read_text("utf-8").replace("../drawings", (ROOT / "examples" / "drawings").as_posix())
    text = text.replace("[[operation]]", f"{CROSSING}\n[[operation]]", 1)
    text = text.replace('region = ["pocket"]', 'region = ["rim"]\nislands = ["hole"]')
    (tmp_path / "crossing.toml").write_text(text, encoding="utf-8")
    job, _ = open_job(document, tmp_path / "crossing.toml")
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
