# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cut that will take long is announced before it is made, from the numbers alone."""

from __future__ import annotations

from pathlib import Path

import pytest

from CNCStepper.job.estimate import cut_length_mm, long_work
from CNCStepper.job.make import make_program
from CNCStepper.job.model import load_job
from CNCStepper.toolpath import RAPID
from helpers.job.example_jobs import EXAMPLES
from helpers.job.example_jobs import TABLE_JOBS as JOBS


@pytest.mark.parametrize("path", JOBS, ids=lambda path: path.stem)
def test_every_cycle_is_estimated_and_no_example_is_long(path: Path) -> None:
    job, _ = load_job(path)
    assert all(cut_length_mm(operation, job)[0] > 0 for operation in job.operation)
    assert long_work(job) == []


@pytest.mark.slow
def test_the_estimate_is_near_the_cut() -> None:
    job, machine = load_job(EXAMPLES / "cycles" / "pocket.toml")
    told_mm, levels = cut_length_mm(job.operation[0], job)
    made = make_program(job, machine).toolpath
    assert levels >= 1 and 0.2 < told_mm / _fed_mm(made) < 5.0


def _fed_mm(table: object) -> float:
    import numpy as np

    length_mm, at = 0.0, None
    for chunk in table.chunks:  # type: ignore[attr-defined]
        for kind, end in zip(chunk.kind, chunk.end, strict=True):
            if at is not None and kind != RAPID:
                length_mm += float(np.nan_to_num(np.linalg.norm(end - at)))
            at = end
    return length_mm


def test_a_long_cut_is_told_with_its_length_and_levels() -> None:
    job, _ = load_job(EXAMPLES / "cycles" / "pocket.toml")
    fine = job.operation[0].model_copy(update={"stepover_mm": 0.001, "stepdown_mm": 0.01})
    (sentence,) = long_work(job.model_copy(update={"operation": (fine,)}))
    assert sentence.startswith("operation 1 (pocket) will take long: about ") and "levels" in sentence
