# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs of lathe jobs: the examples as files, on the virtual lathe's reader, and in other languages."""

from __future__ import annotations

import re
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.errors import CNCStepperError
from CNCStepper.gcode.interpreter.canonical_trace import canonical_calls
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.job.turning.make_turning import in_part, make_turning, placement_of
from CNCStepper.job.turning.prove_turning import prove_turning, whole_report
from CNCStepper.job.turning.turning_job import TurningJob, load_turning_job
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.virtual.lathe.records import Reader
from helpers.gcode.rs274_runs import rs274_calls, same_call

ROOT = Path(__file__).parents[4]
GOLDEN = Path(__file__).parent / "golden"
EXAMPLES = ("lathe-cylinder", "lathe-cone", "lathe-shaft")


def example(name: str, **changes: object) -> tuple[TurningJob, Machine]:
    job, machine = load_turning_job(ROOT / "examples" / "jobs" / f"{name}.toml")
    return job.model_copy(update=changes), machine


@pytest.mark.parametrize("name", EXAMPLES)
def test_the_programs_of_the_examples_are_those_of_the_golden_files(name):
    """Write them anew with tests/unit/job/turning/golden/README.md's command where a change is wanted."""
    programs = make_turning(*example(name), title="golden")
    assert [path.name for path in sorted(GOLDEN.glob(f"{name}*.nc"))] == [
        f"{name}{one.file_name.removeprefix('program')}" for one in programs
    ]
    for one in programs:
        assert (GOLDEN / f"{name}{one.file_name.removeprefix('program')}").read_text("ascii") == one.program


@pytest.mark.parametrize("name", EXAMPLES)
def test_the_examples_are_proven_and_the_part_has_its_dimensions(name, tmp_path):
    job, machine = example(name)
    proven = list(prove_turning(job, machine, make_turning(job, machine), tmp_path))
    assert [one.proof.refused for one in proven] == [False] * len(proven)
    report, verdict = proven[-1].proof.report, proven[-1].verdict
    assert report["profile"] and report["x_is"] == job.x_is
    wanted = {
        "lathe-cylinder": [(-0.01, 50.0), (-75.0, 50.0), (-149.99, 50.0)],
        "lathe-cone": [(-75.0, 25.0), (-120.0, 40.0), (-149.0, 149 / 3)],
        "lathe-shaft": [(-0.5, 23.0), (-15.0, 24.0), (-45.0, 36.0), (-50.0, 30.0), (-80.0, 50.0)],
    }[name]
    for z, diameter in wanted:
        assert verdict.dimension_at(z)[0] == pytest.approx(diameter, abs=0.01)
    for one in proven:
        own = one.proof.report
        for key in ("cut_length_mm", "air_length_mm"):
            assert sum(each[key] for each in own["operations"]) == pytest.approx(own[key], abs=1.0)  # between them: air
    whole = whole_report(proven)
    assert whole["profile"] == report["profile"] and len(whole["operations"]) == len(job.operation)
    assert whole["cut_length_mm"] == pytest.approx(sum(one.proof.report["cut_length_mm"] for one in proven))


@pytest.mark.parametrize("distance", ["absolute", "incremental"])
@pytest.mark.parametrize("x_is", ["radius", "diameter"])
def test_the_virtual_lathe_takes_the_steps_of_the_table(x_is, distance):
    job, machine = example("lathe-cone", distance=distance)
    job = job.model_copy(update={"x_is": x_is, "start": (65.0, 6.0) if x_is == "diameter" else (32.5, 6.0)})
    text = make_turning(job, machine)[0].program
    table = interpret(text, None, machine.language()).table()
    assert ("G91" in text) == (distance == "incremental") and ("G21" in text) == (x_is == "diameter")
    reader, places = Reader(), [np.zeros(2, int)]
    for record in re.sub(r";[^#]*#", "", text).replace("?", "").split("#"):
        if (steps := reader.read(record.strip())) is not None:
            places.append(places[-1] + np.array(steps_of(steps)))
    ends = np.rint(table.end[:, [0, 2]] * 80.0)
    moved = [place for before, place in pairwise(places) if (before != place).any()]
    told = [end for before, end in pairwise([np.zeros(2), *ends]) if (before != end).any()]
    assert np.abs(np.array(moved) - np.array(told)).max() <= 1  # half a step of rounding in the record's own way


def steps_of(steps) -> tuple[int, int]:
    return steps.steps if hasattr(steps, "steps") else (steps.x, steps.z)


def other(machine: Machine, controller: str) -> Machine:
    return machine.model_copy(
        update={"controller": controller, "tool_change": "m6" if controller != "grbl" else "pause"}
    )


@pytest.mark.parametrize(("controller", "x_is"), [("linuxcnc", "diameter"), ("linuxcnc", "radius"), ("grbl", "radius"),
                                                  ("mach", "radius"), ("iso", "radius")])  # fmt: skip
def test_other_controllers_get_the_same_part(controller, x_is):
    job, machine = example("lathe-shaft")
    there = other(machine, controller)
    if x_is == "radius":
        content = job.model_dump() | {"x_is": "radius", "start": (37.5, 6.0)}
        for profile in content["profile"]:
            profile["points"] = [half(row) for row in profile["points"]]
        job = type(job).model_validate({**content, "operation": job.operation})
    text = make_turning(job, there)[0].program
    assert "G18" in text
    if controller == "linuxcnc":
        assert ("G7" if x_is == "diameter" else "G8") in text.split() and "G95" in text.split()
        assert "F0.25" in text
    path = in_part(interpret(text, None, there.language()), placement_of(job, there))
    own, here = make_turning(*example("lathe-shaft")), load_machine("mini-lathe")
    own_path = in_part(interpret(own[0].program, None, here.language()), placement_of(job, here))
    cut = path.table()
    on_first = cut.end[[path.states[int(state)].tool == 1 for state in cut.state]][:, [0, 2]]
    mine = own_path.table().end[:, [0, 2]]
    assert on_first[:, 0].min() == pytest.approx(mine[:, 0].min(), abs=1e-3)
    assert on_first[:, 1].min() == pytest.approx(mine[:, 1].min(), abs=1e-3)
    gaps = [np.hypot(*(mine - end).T).min() for end in on_first]
    assert max(gaps) < 2e-3  # arcs there end where chords end here


@pytest.mark.parametrize("name", [*EXAMPLES, "lathe-thread"])
def test_linuxcnc_drives_the_moves_of_the_program(name, tmp_path):
    job, machine = example(name, distance="absolute")
    text = make_turning(job, other(machine, "linuxcnc"))[0].program
    assert "Y" not in re.sub(r"\([^)]*\)", "", text)  # a lathe has no such axis
    theirs, is_taken = rs274_calls(text, tmp_path)
    ours = list(canonical_calls(text))
    assert is_taken and len(ours) == len(theirs) > 50
    assert [pair for pair in zip(ours, theirs, strict=True) if not same_call(*pair)] == []


def half(row):
    if isinstance(row, dict):
        return row | {"to": (row["to"][0] / 2, row["to"][1])}
    return row[0] / 2, row[1]


@pytest.mark.parametrize(
    ("changes", "controller", "says"),
    [
        ({"x_is": "diameter"}, "grbl", "no word for X as a diameter"),
        ({"distance": "incremental"}, "linuxcnc", "begins is not known"),
        ({"work_offset": "G55"}, "mini-lathe", "no work offsets"),
    ],
)
def test_what_a_controller_cannot_do_is_refused(changes, controller, says):
    job, machine = example("lathe-cylinder", **changes)
    with pytest.raises(CNCStepperError) as refusal:
        make_turning(job, other(machine, controller) if controller != "mini-lathe" else machine)
    assert says in str(refusal.value)


def test_a_feed_per_revolution_without_a_speed_is_refused_with_one_that_would_do():
    job, machine = example("lathe-cylinder")
    silent = job.model_copy(update={"tool": (job.tool[0].model_copy(update={"spindle_rpm": 0.0}),)})
    with pytest.raises(CNCStepperError) as refusal:
        make_turning(silent, machine)
    assert "operation 1 (turn face)" in str(refusal.value) and "spindle_rpm = 500, for example" in str(refusal.value)
    by_surface = job.model_copy(
        update={"tool": (job.tool[0].model_copy(update={"spindle_rpm": 0.0, "surface_speed_m_min": 120.0}),)}
    )
    assert "tool 1: 710 rpm" in make_turning(by_surface, machine)[0].program  # 694 rpm, the nearest preset
