# SPDX-License-Identifier: LGPL-2.1-or-later
"""On a machine that wants a file a tool, a job has one program for each, of which it holds one and saves all."""

from __future__ import annotations

from importlib import resources
from pathlib import Path
from typing import Any

import pytest

from CNCStepper.errors import JobError, OutputError
from CNCStepper.job.prove import prior_proofs, prove_job
from CNCStepper.workbench import api
from CNCStepper.workbench.document import program_file
from CNCStepper.workbench.document.core_job import machine_of, programs
from CNCStepper.workbench.features.base import problem_of


@pytest.fixture
def job(document: Any, tmp_path: Path) -> Any:
    """A job with a pocket and six holes, for a table that wants a file a tool."""
    profile = (resources.files("CNCStepper.machine") / "profiles" / "table-a.toml").read_text("utf-8")
    path = tmp_path / "mesa dividida.toml"
    path.write_text('tool_change = "split"\n' + "".join(
        line for line in profile.splitlines(keepends=True) if not line.startswith("tool_change")
    ), "utf-8")  # fmt: skip
    job = api.new_job(document, machine=str(path))
    mill = api.add_tool(job, diameter_mm=6)
    drill = api.add_tool(job, shape="drill", diameter_mm=3, feed_mm_min=120, plunge_mm_min=120)
    api.add_operation(job, "circular_pocket", tool=mill, radius_mm=12, depth_mm=2)
    api.add_operation(job, "drill", tool=drill, depth_mm=5, pattern_radius_mm=25)
    document.recompute()
    return job


def test_the_job_holds_the_program_that_is_chosen(document: Any, job: Any) -> None:
    assert (problem_of(job), job.ProgramParts) == ("", 2)
    (_, first), (_, second) = programs(job)
    assert api.program_text(job) == first and "T2" not in first
    api.edit(job, part=2)
    document.recompute()
    assert api.program_text(job) == second and "T2" in second and "circular" not in second
    api.edit(job, part=3)
    document.recompute()
    assert "no such part" in problem_of(job)
    assert program_file.load(job) == ""


def test_all_are_saved_beside_each_other(job: Any, tmp_path: Path) -> None:
    files = api.save_program(job, tmp_path / "peça ç.nc")
    assert [file.name for file in files] == ["peça ç-1-T1.nc", "peça ç-2-T2.nc"]
    assert [file.read_text("ascii") for file in files] == [text for _, text in programs(job)]


def test_files_that_nobody_was_asked_about_stay(job: Any, tmp_path: Path) -> None:
    (tmp_path / "peça-2-T2.nc").write_text("(mine)\n", "ascii")
    with pytest.raises(OutputError, match=r"peça-2-T2\.nc") as caught:
        api.save_program(job, tmp_path / "peça.nc")
    assert caught.value.code == "output-exists"
    assert sorted(path.name for path in tmp_path.glob("peça*")) == ["peça-2-T2.nc"]
    assert (tmp_path / "peça-2-T2.nc").read_text("ascii") == "(mine)\n"
    assert len(api.save_program(job, tmp_path / "peça.nc", overwrite=True)) == 2
    assert "(mine)" not in (tmp_path / "peça-2-T2.nc").read_text("ascii")


def test_the_second_is_proven_on_what_the_first_has_cut(document: Any, job: Any) -> None:
    api.edit(job, part=2)
    document.recompute()
    model, machine, text = api.job_model(job), machine_of(job), api.program_text(job)
    earlier = prior_proofs(model, machine, text, job.Label)
    assert len(earlier) == 1
    proof = prove_job(model, machine, text, job.Label, earlier=earlier)
    assert not proof.refused
    assert proof.part is not None and proof.part.heights_mm.min() < -4
    assert (proof.part.heights_mm < -1.5).mean() > 0.05


def test_with_one_tool_there_is_one_program(document: Any, job: Any) -> None:
    api.edit(job.Operations[1], active=False)
    document.recompute()
    assert (problem_of(job), job.ProgramParts) == ("", 1)
    with pytest.raises(JobError):
        api.edit(job, parts=4)
