# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page on job files is true: its pieces are one job, and its tables are what the cycles declare."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from CNCStepper.cycles.catalogue import CYCLES, cycle_class
from CNCStepper.cycles.turning.turning_operation import TURNING_OPERATIONS
from CNCStepper.job.make import make_program
from CNCStepper.job.model import load_job
from CNCStepper.job.prove import prove_job
from helpers.tools import load

ROOT = Path(__file__).parents[3]
PAGE = (ROOT / "docs" / "reference" / "job-file.md").read_text("utf-8")


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


def test_the_tables_of_the_cycles_are_those_of_the_code() -> None:
    tool = load("reference")
    assert tool.page(PAGE) == PAGE, "run 'python tools/reference.py'"


@pytest.mark.parametrize("cycle", CYCLES)
def test_every_key_of_every_cycle_is_declared_with_its_help(cycle: str) -> None:
    told = PAGE.partition(f"### `{cycle}`\n")[2].partition("\n### ")[0]
    if "those of `pocket`" in told:
        told += PAGE.partition("### `pocket`\n")[2].partition("\n### ")[0]
    keys = {key.partition(".")[0] for key in re.findall(r"^\| `([\w.]+)` \|", told, re.MULTILINE)}
    shapes = {"outlines", "islands", "curves", "marks", *(["pattern"] if "`pattern.circles`" in told else [])}
    assert keys == set(cycle_class(cycle).model_fields) - shapes - {"cycle", "tool"}


@pytest.mark.parametrize("cycle", TURNING_OPERATIONS)
def test_every_key_of_every_cycle_of_a_lathe_is_declared_with_its_help(cycle: str) -> None:
    lathe = PAGE.partition("## Operations of a lathe\n")[2]
    told = lathe.partition("\n### ")[0] + lathe.partition(f"### `{cycle}`\n")[2].partition("\n##")[0]
    keys = set(re.findall(r"^\| `(\w+)` \|", told, re.MULTILINE))
    assert keys == set(TURNING_OPERATIONS[cycle].model_fields) - {"cycle", "tool", "profile"}
