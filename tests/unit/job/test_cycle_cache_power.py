# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cut that is kept and given to a program again has its power switched as the cycle itself does it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from CNCStepper.job.cycle_cache import CycleCache
from CNCStepper.job.make import make_program
from CNCStepper.job.model import load_job

JOBS = Path(__file__).parents[3] / "examples" / "jobs"


@pytest.mark.parametrize("name", ["gasket-plasma", "rib-wire"])
def test_the_program_of_a_kept_cut_is_that_of_the_cycle(name: str) -> None:
    job, machine = load_job(JOBS / f"{name}.toml")
    ready = job.on(machine)
    kept = tuple(CycleCache(each, ready.setup(each)) for each in ready.operation)
    program = make_program(ready.model_copy(update={"operation": kept}), machine, "").program
    assert program == make_program(job, machine, "").program
    assert "M3" in program
    states = [state.spindle for state in kept[0]._moves.states]
    assert len(set(states)) > 1, "the cut switches nothing: this test shows nothing"
    assert replace(kept[0]._moves.states[0], spindle="off") == kept[0]._moves.states[0]
