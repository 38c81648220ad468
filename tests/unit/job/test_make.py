# SPDX-License-Identifier: LGPL-2.1-or-later
"""Job to program text: what stands first, what stands last, and what a change of tool does."""

from __future__ import annotations

from pathlib import Path

import pytest

from CNCStepper.errors import CycleError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.job.make import make_program
from CNCStepper.job.model import Job, load_job
from CNCStepper.state import Start

JOBS = Path(__file__).parents[3] / "examples" / "jobs"


@pytest.fixture(scope="module")
def both() -> Job:
    """The pocket and the map in one job, each with its own tool."""
    pocket, _ = load_job(JOBS / "elliptical-pocket.toml")
    brazil, _ = load_job(JOBS / "brazil-engraving.toml")
    return pocket.model_copy(
        update={
            "tool": pocket.tool + brazil.tool,
            "operation": pocket.operation + brazil.operation,
            "machine": "table-a",
        }
    )


def machine():
    return load_job(JOBS / "elliptical-pocket.toml")[1]


def test_the_program_is_ascii_the_same_each_time_and_short_enough(both: Job) -> None:
    text = make_program(both, machine(), "Peça nº 1 ~ teste!").program
    assert text.isascii() and text == make_program(both, machine(), "Peça nº 1 ~ teste!").program
    assert not set(text) & set("!?~")
    assert max(map(len, text.splitlines())) < 80


def test_the_first_motion_is_z_to_clearance_and_the_end_is_safe(both: Job) -> None:
    text = make_program(both, machine()).program
    toolpath = interpret(text, Start())
    first = toolpath.table()
    assert first.kind[0] == 0 and first.end[0, 2] == 10.0
    assert first.end[-1, 2] == 10.0
    last = toolpath.states[-1]
    assert text.splitlines()[-1] == "M2"
    assert last.spindle == "off" and not last.flood and not last.mist


def test_the_spindle_has_its_time_before_anything_is_cut(both: Job) -> None:
    toolpath = interpret(make_program(both, machine()).program, Start())
    dwells = [event for event in toolpath.events if event.kind == "dwell"]
    assert [event.value for event in dwells] == [3.0, 3.0]
    table = toolpath.table()
    for event in dwells:
        assert toolpath.states[event.state].spindle == "cw"
        assert (table.kind[: event.index + 1][-1] == 0) if event.index < len(table.kind) else True


def test_a_tool_change_retracts_stops_the_spindle_and_waits(both: Job) -> None:
    toolpath = interpret(make_program(both, machine()).program, Start())
    pauses = [event for event in toolpath.events if event.kind == "pause"]
    assert len(pauses) == 1
    assert toolpath.states[pauses[0].state].spindle == "off"
    assert toolpath.table().end[pauses[0].index - 1, 2] == 10.0
    messages = [event.text for event in toolpath.events if event.kind == "message"]
    assert any("ball 2 mm" in text for text in messages)
    assert {toolpath.states[k].tool for k in toolpath.table().state} == {1, 2}


def test_inches_give_the_same_part(both: Job) -> None:
    millimetres = interpret(make_program(both, machine()).program, Start()).table()
    inches = interpret(make_program(both.model_copy(update={"units": "inch"}), machine()).program, Start()).table()
    assert len(inches.kind) == len(millimetres.kind)
    assert abs(inches.end[1:] - millimetres.end[1:]).max() < 0.003


def test_a_refusal_names_its_operation(both: Job) -> None:
    wide = both.operation[0].model_copy(update={"stepover_mm": 50.0})
    job = both.model_copy(update={"operation": (*both.operation, wide)})
    with pytest.raises(CycleError, match=rf"operation {len(job.operation)} \(elliptical pocket\): stepover_mm"):
        make_program(job, machine())
