# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program of an outline: round all that is cut, in air, without power, in the machine's own dialect."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from CNCStepper.errors import JobError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.job.editing.outline_run import outline_program
from CNCStepper.job.make import make_program
from CNCStepper.job.model import load_job
from CNCStepper.job.prove import prove_job
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.simulation.finding import refused
from CNCStepper.toolpath import RAPID, Toolpath

JOBS = Path(__file__).parents[4] / "examples" / "jobs"
ARC = "G21 G90\nM3 S1000\nG0 Z5\nG0 X10 Y0\nG1 Z-1 F100\nG3 X-10 Y0 I-10 J0\nG0 Z20\nM5\nM2\n"


def outline_of(text: str, machine: Machine, process: str = "milling") -> Toolpath:
    return interpret(outline_program(text, machine, process), dialect=machine.language())


def test_it_goes_round_what_is_cut_at_the_greatest_height() -> None:
    path = outline_of(ARC, load_machine("table-a"))
    table = path.table()
    feeds = table.end[table.kind != RAPID]
    assert feeds[:, 0].min() == -10 and feeds[:, 0].max() == 10
    assert feeds[:, 1].min() == 0 and feeds[:, 1].max() == pytest.approx(10, abs=0.01)  # the arc's, not its ends'
    assert (feeds[:, 2] == 20).all() and len(feeds) == 4
    assert feeds[-1].tolist() == table.end[table.kind == RAPID][-1].tolist()
    assert all(state.spindle == "off" for state in path.states)


@pytest.mark.parametrize("name", ["elliptical-pocket.toml", "gasket-plasma.toml", "name-plate.toml"])
def test_the_outline_of_an_example_cuts_nothing_and_passes_the_checks(name: str) -> None:
    job, machine = load_job(JOBS / name)
    text = outline_program(make_program(job, machine).program, machine, job.process)
    bare = job.model_copy(update={"operation": ()})
    proof = prove_job(bare, machine, text, name)
    assert not refused(proof.findings), [finding.text for finding in proof.findings]
    assert proof.part is None or np.ptp(proof.part.heights_mm) == 0


def test_a_wire_and_a_program_without_a_cut_are_refused() -> None:
    machine = load_machine("table-a")
    with pytest.raises(JobError, match="outline-wire"):
        outline_of(ARC, machine, "hot-wire")
    with pytest.raises(JobError, match="outline-empty"):
        outline_of("G21 G90\nG0 X10 Y10\nM2\n", machine)
