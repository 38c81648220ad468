# SPDX-License-Identifier: LGPL-2.1-or-later
"""G71, G72 and G70 of lathe jobs: rs274 drives the same moves, and the part is that of the moves written out."""

from __future__ import annotations

from pathlib import Path

import pytest

from CNCStepper.gcode.interpreter.canonical_trace import canonical_calls
from CNCStepper.job.turning.make_turning import make_turning
from CNCStepper.job.turning.prove_turning import prove_turning
from CNCStepper.job.turning.turning_job import TurningJob, load_turning_job
from CNCStepper.machine.profile import Machine, load_machine
from helpers.cycles.seeds import SEEDS
from helpers.gcode.rs274_runs import rs274_calls, same_call
from helpers.job.random_turning import random_job

ROOT = Path(__file__).parents[4]
WAYS = [{}, {"inside": True}, {"along": "x"}]


def machine_of(controller: str) -> Machine:
    return load_machine("mini-lathe").model_copy(update={"controller": controller, "tool_change": "m6"})


def cut(job: TurningJob, tmp_path: Path) -> tuple[str, float]:
    """Return the program of a job, and the volume of its part; no finding but what a person may know."""
    machine = machine_of("linuxcnc")
    (program,) = make_turning(job, machine)
    (proven,) = prove_turning(job, machine, [program], tmp_path)
    assert [str(found) for found in proven.verdict.findings if found.severity != "info"] == []
    return program.program, proven.verdict.report()["volume_mm3"]


@pytest.mark.parametrize("seed", SEEDS[::4])
def test_the_cycles_cut_the_part_of_the_moves_and_rs274_drives_them(seed, tmp_path):
    job = random_job(seed, "mini-lathe", **WAYS[seed % len(WAYS)])
    plain, volume_mm3 = cut(job, tmp_path)
    text, canned_mm3 = cut(job.model_copy(update={"canned": True}), tmp_path)
    assert "G70 Q" in text and ("G71 Q" in text or job.operation[-2].along == "x") and " SUB" not in plain
    assert canned_mm3 == pytest.approx(volume_mm3, rel=2e-5)
    theirs, is_taken = rs274_calls(text, tmp_path)
    ours = list(canonical_calls(text))
    assert is_taken and len(ours) == len(theirs) > 50
    assert [pair for pair in zip(ours, theirs, strict=True) if not same_call(*pair)] == []


def test_g72_is_written_where_the_profile_only_rises():
    for last_but_one, name in ((20.0, True), (19.8, False)):
        job = random_job(2, "mini-lathe", along="x")
        points = [(2.0, 0.0), (20.0, -10.0), (last_but_one, -30.0), (28.0, -30.0)]
        content = job.model_dump() | {"profile": [{"name": "part", "points": points}], "canned": True}
        job = type(job).model_validate({**content, "operation": job.operation})
        assert ("G72 Q" in make_turning(job, machine_of("linuxcnc"))[0].program) == name


@pytest.mark.parametrize("x_is", ["diameter", "radius"])
def test_the_shaft_in_cycles_is_that_of_the_moves(x_is, tmp_path):
    job, _ = load_turning_job(ROOT / "examples" / "jobs" / "lathe-shaft.toml")
    parts = []
    for canned in (False, True):
        asked = job.model_copy(update={"canned": canned, "x_is": x_is})
        parts.append(cut(asked, tmp_path))
    assert "G71 Q101" in parts[1][0] and "G70 Q102" in parts[1][0]
    assert parts[1][1] == pytest.approx(parts[0][1], rel=2e-5)
    theirs, is_taken = rs274_calls(parts[1][0], tmp_path)
    assert is_taken and all(map(same_call, canonical_calls(parts[1][0]), theirs))


@pytest.mark.parametrize("controller", ["iso", "mach", "mini-lathe"])
def test_controllers_without_these_cycles_get_the_moves(controller):
    job = random_job(3, "mini-lathe").model_copy(update={"canned": True})
    text = make_turning(job, machine_of(controller))[0].program
    assert "SUB" not in text and "G70 Q" not in text and "G71 Q" not in text
