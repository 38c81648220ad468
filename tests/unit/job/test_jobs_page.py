# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page on job files tells the truth: its pieces are one job, and its tables name what there is."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from CNCStepper.cycles.catalogue import CYCLES
from CNCStepper.job.make import make_program
from CNCStepper.job.model import load_job
from CNCStepper.job.prove import prove_job

PAGE = (Path(__file__).parents[3] / "docs" / "reference" / "job-file.md").read_text("utf-8")


def job_file(folder: Path) -> Path:
    path = folder / "job.toml"
    path.write_text("\n".join(re.findall(r"```toml\n(.*?)```", PAGE, re.DOTALL)), encoding="utf-8")
    return path


def test_the_pieces_are_a_job_that_makes_a_program(tmp_path: Path) -> None:
    job, machine = load_job(job_file(tmp_path))
    assert len(job.operation) == PAGE.count("[[operation]]\n") and len(job.tool) == PAGE.count("[[tool]]\n")
    assert len(make_program(job, machine).program.splitlines()) > 200


@pytest.mark.slow
def test_the_job_is_proven_without_an_error(tmp_path: Path) -> None:
    job, machine = load_job(job_file(tmp_path))
    proof = prove_job(job, machine, make_program(job, machine).program)
    assert not proof.refused, [str(finding) for finding in proof.findings]


def test_every_cycle_and_its_keys_are_those_that_there_are() -> None:
    told = {}
    for row in re.findall(r"^\| `(\w+)` \|(.*)\|$", PAGE.partition("| cycle |")[2], re.MULTILINE):
        if row[0] in CYCLES:
            told[row[0]] = set(re.findall(r"`(\w+)`", row[1]))
    assert set(told) == set(CYCLES)
    values = {"zigzag", "oneway", "spiral", "pocket", "region"}
    for cycle, keys in told.items():
        assert keys - values <= set(CYCLES[cycle].model_fields), cycle
