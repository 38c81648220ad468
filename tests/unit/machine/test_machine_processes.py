# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machine profiles that name processes and lack Z or spindle, and what follows from it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from CNCStepper.control.protocol.grbl.settings import expected_settings
from CNCStepper.errors import JobError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.job.make_certificate import machine_digest
from CNCStepper.machine.profile import Machine, load_machine, profile_names, validated
from CNCStepper.motion.planner.plan import begun, times_s
from CNCStepper.motion.signals.pulse_stream import moved_steps, pulse_stream
from CNCStepper.simulation.checks.check_program import check
from CNCStepper.state import Start

SQUARE = "G0 X10 Y10\nM3\nG4 P0.5\nG1 X60 F1200\nY60\nG2 X10 Y60 I-25 J0\nM5\nG0 X-10 Y5\n"


def profile(**changes: Any) -> dict[str, Any]:
    """Return table-a as a file would hold it, with keys changed; None takes one out."""
    content = load_machine("table-a").model_dump(mode="json") | changes
    content["axis"] = {name: axis for name, axis in content["axis"].items() if axis is not None}
    return {key: value for key, value in content.items() if value is not None}


def without_z(**changes: Any) -> Machine:
    axes = profile()["axis"]
    del axes["z"]
    return validated(Machine, profile(axis=axes, **changes), "test")


def test_old_profiles_are_what_they_were() -> None:
    machine = load_machine("table-a")
    assert machine.processes == ("milling",)
    assert machine.language() == "grbl"
    assert not {"processes", "feed_mm_min", "rapid_mm_min"} & machine.model_dump().keys()


def test_a_laser_mills_and_burns_where_nothing_is_said() -> None:
    content = profile()
    content["spindle"]["laser"] = True
    assert validated(Machine, content, "test").processes == ("milling", "laser")


@pytest.mark.parametrize("name", profile_names())
def test_a_profile_survives_json(name: str) -> None:
    machine = load_machine(name)
    again = Machine.model_validate_json(machine.model_dump_json())
    assert again == machine
    assert machine_digest(again) == machine_digest(machine)
    assert again.language() == machine.language()


@pytest.mark.parametrize(
    ("name", "language", "processes"),
    [
        ("torch-table", "grbl", ("plasma", "oxyfuel")),
        ("plasmac-table", "qtplasmac:z=none,spindle=switch", ("plasma",)),
        ("laser-table", "grbl:z=none", ("laser",)),
        ("wire-table", "grbl:z=none", ("hot-wire",)),
        ("thesis-table", "thesis-a:z=none,spindle=always,feed=900", ("hot-wire", "plasma", "oxyfuel")),
    ],
)
def test_the_tables_that_ship(name: str, language: str, processes: tuple[str, ...]) -> None:
    machine = load_machine(name)
    assert (machine.language(), machine.processes) == (language, processes)


@pytest.mark.parametrize(
    ("processes", "language"),
    [
        (["plasma"], "grbl:z=none,spindle=switch"),
        (["milling"], "grbl:z=none,spindle=none"),
        (["drag-knife", "scribe"], "grbl:z=none,spindle=none"),
        (["scribe", "oxyfuel"], "grbl:z=none,spindle=switch"),
    ],
)
def test_without_a_spindle_a_torch_is_a_switch(processes: list[str], language: str) -> None:
    machine = without_z(spindle=None, processes=processes)
    assert machine.language() == language
    assert not machine.has_spindle
    assert machine.language("linuxcnc") == language.replace("grbl", "linuxcnc")
    assert machine.language(language) == language


def test_the_feed_of_the_profile_is_a_setting_of_its_language() -> None:
    machine = without_z(feed_mm_min=800)
    assert machine.language() == "grbl:z=none,feed=800"
    assert machine.language(feed_mm_min=3850.5) == "grbl:z=none,feed=3850.5"
    assert machine.language("grbl:feed=10") == "grbl:feed=10,z=none"


def test_a_process_that_the_machine_does_not_name_is_refused_with_the_list() -> None:
    machine = load_machine("torch-table")
    assert machine.process("oxyfuel").entry == "pierce"
    with pytest.raises(JobError, match=r"does not cut by laser.*use one of: plasma, oxyfuel"):
        machine.process("laser")
    with pytest.raises(JobError, match="no process 'lasers'"):
        machine.process("lasers")


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"processes": ["plasma", "glue"]}, "processes"),
        ({"processes": []}, "processes"),
        ({"feed_mm_min": 0}, "feed_mm_min"),
        ({"rapid_mm_min": -1}, "rapid_mm_min"),
        ({"axis": {"x": profile()["axis"]["x"]}}, "axis.y is missing"),
    ],
)
def test_bad_profiles_are_refused(changes: dict[str, Any], message: str) -> None:
    with pytest.raises(JobError, match=message):
        validated(Machine, profile(**changes), "test")


def test_settings_of_an_axis_that_is_not_there_are_not_compared() -> None:
    wanted = expected_settings(without_z(spindle=None, processes=["plasma"]))
    assert {100, 101, 110, 111, 120, 121, 32} == set(wanted)
    assert {102, 30} < set(expected_settings(load_machine("torch-table")))


def test_a_program_is_read_planned_checked_and_stepped_without_z() -> None:
    machine = without_z(spindle=None, processes=["plasma"])
    path = interpret(SQUARE, Start(work_offsets_mm={"G54": (-300, -300, 0)}, zero_known=True), machine.language())
    assert not path.table().end[:, 2].any()
    with_z = interpret(SQUARE.replace("M3", "M3 S1"), path.start, "grbl")
    times = times_s(path, machine)
    assert np.isfinite(times).all()
    assert times[-1] == pytest.approx(times_s(with_z, load_machine("table-a"))[-1], abs=1e-6)
    assert not [finding for finding in check(path, machine) if finding.code in ("travel", "height-unknown")]
    stream = pulse_stream(begun(path), machine)
    moved = sum(moved_steps(chunk, stream.axes) for chunk in stream.chunks)
    assert moved.tolist() == [-800, 400, 0]


def test_rapids_of_a_language_without_feeds_take_the_profiles_speed() -> None:
    machine = load_machine("thesis-table")
    text = "G0\nX600\n"
    fast = machine.model_copy(update={"rapid_mm_min": None})
    slow = machine.model_copy(update={"rapid_mm_min": 600.0})
    path = interpret(text, Start(), machine.language())
    assert times_s(path, slow)[-1] == pytest.approx(60.0, abs=0.5)
    assert times_s(path, fast)[-1] < 25.0
    other = slow.model_copy(update={"controller": "grbl"})
    assert times_s(path, other)[-1] == pytest.approx(times_s(path, fast)[-1])
