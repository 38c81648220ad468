# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mini-lathe's acceptance parts: made, proven, and driven by its controller to the end on a virtual lathe."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.job.turning.make_turning import make_turning
from CNCStepper.job.turning.prove_turning import prove_turning
from CNCStepper.job.turning.turning_job import load_turning_job
from helpers.controllers.lathe_twin import LatheAtTwin

JOBS = Path(__file__).parents[4] / "examples" / "jobs"
STEP_S = 0.02  # how often controller and lathe are looked at: the lathe has two seconds of its program


@pytest.mark.parametrize(
    ("name", "changes"),
    [
        ("lathe-cylinder", {}),
        ("lathe-cylinder", {"distance": "incremental"}),
        ("lathe-cone", {}),
        ("lathe-thread", {}),
        ("lathe-threaded-cone", {}),
        ("lathe-shaft", {}),
    ],
)
def test_an_acceptance_part_is_proven_and_takes_its_steps_on_the_virtual_lathe(name, changes, tmp_path):
    job, machine = load_turning_job(JOBS / f"{name}.toml")
    job = job.model_copy(update=changes)
    for proven in prove_turning(job, machine, make_turning(job, machine), tmp_path):
        assert [finding for finding in proven.proof.findings if finding.severity == "error"] == []
        ends = interpret(proven.program.program, None, machine.language()).table().end[:, [0, 2]]
        places = np.vstack([np.zeros(2), np.rint(ends * 80.0)])
        waits = "synchronised" in {event.kind for event in proven.proof.toolpath.events} or "thread" in name
        at = LatheAtTwin(machine, STEP_S, thread_start=waits, spindle_rpm=90.0 if waits else 0.0)
        at.run(list(proven.proof.wire.lines))  # switched off and on for each program: M02 ends automatic mode for good
        made = np.concatenate([np.zeros((1, 2)), *(block[:, 1:] for block in at.twin.take_path())])
        assert at.twin.refused == [] and at.twin.buffer.lost == 0 and not at.twin.moving
        assert np.array(at.twin.places).tolist() == places[-1].tolist()  # though it rounds each increment for itself
        travelled = np.abs(np.diff(np.rint(made * 80.0), axis=0)).sum(axis=0)
        wanted = np.abs(np.diff(places, axis=0)).sum(axis=0)
        assert travelled.tolist() == wanted.tolist()
