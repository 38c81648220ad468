# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job's program that is proven piece by piece has the findings, the report and the certificate of the whole text."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

from CNCStepper.job.make import make_program
from CNCStepper.job.model import Job, load_job
from CNCStepper.job.prove import prove_job
from CNCStepper.job.prove_file import FileProof
from CNCStepper.job.prove_job_file import prove_job_file
from CNCStepper.machine.profile import Machine
from CNCStepper.simulation.first_lines import FirstLines
from CNCStepper.toolpath import Span
from helpers.job.prove_runs import assert_same, pieces  # noqa: F401  a fixture

JOBS = Path(__file__).parents[3] / "examples" / "jobs"
FEW = [pytest.param((50, 1 << 21), id="few-rows")]  # judging takes its time with each


@pytest.fixture(scope="module", params=["elliptical-pocket", pytest.param("plate", marks=pytest.mark.slow)])
def made(request: pytest.FixtureRequest) -> tuple[Job, Machine, str]:
    job, machine = load_job(JOBS / f"{request.param}.toml")
    return job, machine, make_program(job, machine).program


def both(folder: Path, job: Job, machine: Machine, text: str) -> tuple[Any, FileProof]:
    file = folder / "program.nc"
    file.write_text(text, encoding="utf-8", newline="")
    whole = prove_job(job, machine, text, str(file))
    return whole, prove_job_file(job, file, machine, sent=folder)


@pytest.mark.slow
@pytest.mark.parametrize("pieces", FEW, indirect=True)
@pytest.mark.usefixtures("pieces")
def test_the_job_s_own_program(tmp_path: Path, made: tuple[Job, Machine, str]) -> None:
    whole, parts = both(tmp_path, *made)
    assert whole.report["gouge_mm"] is not None and parts.report["operations"][0]["figures"]
    assert_same(whole, parts)


@pytest.mark.parametrize("pieces", FEW, indirect=True)
@pytest.mark.usefixtures("pieces")
def test_a_program_that_cuts_something_else(tmp_path: Path, made: tuple[Job, Machine, str]) -> None:
    job, machine, text = made
    deepest_mm = max(float(depth) for depth in re.findall(r"Z-([\d.]+)", text))
    deeper = re.sub(rf"Z-{deepest_mm:g}\b[.0]*", f"Z-{deepest_mm + 0.5:g}", text)
    whole, parts = both(tmp_path, job, machine, deeper)
    assert {"gouge", "below-stock"} & {finding.code for finding in whole.findings}
    assert_same(whole, parts)


def test_an_operation_that_moves_nothing_at_the_end_is_placed_at_the_begin() -> None:
    assert FirstLines().of_operations([Span("operation", "drill", 7, 7)]) == [1]
