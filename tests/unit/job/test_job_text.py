# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job written as a job file and read again is the same job, and gives the same program byte for byte."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from CNCStepper.errors import JobError
from CNCStepper.geometry.curve import from_points
from CNCStepper.job.files import job_text
from CNCStepper.job.files.job_text import save_job_file, write_job_file
from CNCStepper.job.make import make_program
from CNCStepper.job.model import Job, load_job, read_job
from helpers.job.example_jobs import EXAMPLES, LATHE_JOBS
from helpers.job.example_jobs import TABLE_JOBS as JOBS


def content(job: Job) -> tuple[Any, ...]:
    return job.model_dump(mode="json"), [each.model_dump(mode="json") for each in job.operation]


@pytest.mark.parametrize("path", JOBS, ids=lambda path: path.stem)
def test_every_job_comes_back_as_it_was(path: Path, tmp_path: Path) -> None:
    job = Job.load(path)
    save_job_file(job, tmp_path / "job.toml")
    assert content(read_job(tmp_path / "job.toml")) == content(job)
    save_job_file(job, tmp_path / "job.JSON")
    assert content(read_job(tmp_path / "job.JSON")) == content(job)


@pytest.mark.parametrize("path", LATHE_JOBS, ids=lambda path: path.stem)
def test_the_job_of_a_lathe_is_refused_by_its_name(path: Path) -> None:
    with pytest.raises(JobError, match=r"job of a lathe.*cncstepper run"):
        Job.load(path)


def test_the_program_is_the_same_byte_for_byte(tmp_path: Path) -> None:
    path = EXAMPLES / "plate.toml"
    job, machine = load_job(path)
    save_job_file(Job.load(path), tmp_path / "job.toml")
    again, same_machine = load_job(tmp_path / "job.toml")
    made, made_again = make_program(job, machine).program, make_program(again, same_machine).program
    assert made == made_again and len(made) > 2000


def test_a_person_can_read_it() -> None:
    text = write_job_file(Job.load(EXAMPLES / "plate.toml"))
    assert text.startswith("# a job, made by CNCStepper\n")
    assert 'islands = ["islands-2", "islands-3"]' in text and text.count("[[shape]]") == 4
    assert text.count("[[operation]]") == 4 and "notes" not in text and "clamp" not in text


def test_a_job_with_more_curves_than_names_keeps_them_in_its_operations(monkeypatch: pytest.MonkeyPatch) -> None:
    job = Job.load(EXAMPLES / "plate.toml")
    monkeypatch.setitem(job_text.MOST_ITEMS, "shapes", 2)
    text = write_job_file(job)
    assert "[[shape]]" not in text and "islands = [{ xy = " in text


def test_a_job_too_long_for_toml_is_refused_with_the_way_out(tmp_path: Path) -> None:
    job = Job.load(EXAMPLES / "brazil-engraving.toml")
    points = np.random.default_rng(1).uniform(0, 190, (90_000, 2)).tolist()
    engraving = job.operation[0].model_copy(update={"curves": (from_points(points),)})
    long = job.model_copy(update={"operation": (engraving,)})
    with pytest.raises(JobError, match=r"\.json"):
        save_job_file(long, tmp_path / "job.toml")
    assert not (tmp_path / "job.toml").exists()
    save_job_file(long, tmp_path / "job.json")
    assert content(read_job(tmp_path / "job.json")) == content(long)
