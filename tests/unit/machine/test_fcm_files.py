# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's machine files: read in both layouts, written, there and back; and the real machines to begin from."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from CNCStepper.errors import JobError
from CNCStepper.machine.files.fcm_files import fcm_text, read_fcm, write_fcm
from CNCStepper.machine.own_profiles import profile_content, profile_text
from CNCStepper.machine.profile import Machine, load_machine

OLD = {  # as FreeCAD's first machine files were
    "machine": {
        "axes": {
            "X": {"type": "linear", "min": 0.0, "max": 1000, "max_velocity": 10000, "joint": [[1, 0, 0], [0, 0, 0]]},
            "Y": {"type": "linear", "min": 0, "max": 1000, "max_velocity": 10000},
            "Z": {"type": "linear", "min": 0, "max": 1000, "max_velocity": 10000},
        },
        "name": "Generic Grbl",
        "spindles": [{"name": "Spindle 1", "max_power_kw": 1.5, "max_rpm": 24000, "min_rpm": 0, "spindle_wait": 2.0}],
        "units": "metric",
    },
    "postprocessor": {"file_name": "generic_grbl_post"},
}
NEW = {
    "machine": {
        "name": "Laser ü",
        "axes": {
            "X": {"type": "linear", "limits": {"min": 0, "max": 510}, "max_velocity": 18000},
            "Y": {"type": "linear", "limits": {"min": -5.5, "max": 360}, "max_velocity": 12000},
            "A": {"type": "rotary", "limits": {"min": 0, "max": 360}, "max_velocity": 10000},
        },
        "toolheads": [{"name": "L", "toolhead_type": "laser", "max_rpm": 255, "tool_change": "automatic"}],
        "units": "imperial",
    },
    "postprocessor": {"file_name": "linuxcnc"},
}
REAL = [
    "foam-cutter",
    "genmitsu-3018-pro",
    "k40-laser",
    "lowrider-3",
    "mpcnc",
    "openbuilds-lead-1010",
    "openbuilds-lead-1010-plasma",
    "openbuilds-ox",
    "ortur-laser-master-2",
    "shapeoko-3",
    "sherline-5400",
    "x-carve-1000",
]


def read(tmp_path: Path, content: Any) -> Machine:
    file = tmp_path / "machine.fcm"
    file.write_text(json.dumps(content), "utf-8")
    return Machine.model_validate(read_fcm(file, profile_content("table-a")))


def test_both_layouts_of_freecad_are_read_over_a_profile(tmp_path: Path) -> None:
    mill = read(tmp_path, OLD)
    assert (mill.name, mill.controller, mill.processes) == ("Generic Grbl", "grbl", ("milling",))
    assert (mill.axis["z"].travel_min_mm, mill.axis["z"].travel_max_mm, mill.axis["x"].max_rate_mm_min) == (
        0,
        1000,
        1e4,
    )
    assert (mill.spindle.max_rpm, mill.spindle.power_w, mill.spindle.spin_up_s) == (24000, 1500, 2)
    assert mill.axis["z"].steps_per_mm == 400, "what the file does not say is the profile's"
    laser = read(tmp_path, NEW)
    assert (laser.name, laser.controller, laser.processes, list(laser.axis)) == (
        "Laser ü",
        "linuxcnc",
        ("laser",),
        ["x", "y"],
    )
    assert laser.spindle.laser and laser.tool_change == "m6" and laser.axis["y"].travel_min_mm == -5.5


@pytest.mark.parametrize("name", ["table-a", "laser-table", "torch-table", "mini-lathe", "mpcnc"])
def test_a_profile_goes_to_freecad_and_back(tmp_path: Path, name: str) -> None:
    machine = load_machine(name)
    file = tmp_path / "m.fcm"
    write_fcm(file, machine)
    assert json.loads(file.read_text("utf-8"))["machine"]["toolheads"][0]["name"] == "Spindle"
    again = Machine.model_validate(read_fcm(file, profile_content(name)))
    assert again.own_axes == machine.own_axes
    assert (again.spindle.max_rpm, again.spindle.laser, again.outputs) == (
        machine.spindle.max_rpm, machine.spindle.laser, machine.outputs)  # fmt: skip


@pytest.mark.parametrize(
    "content",
    [[], {"machine": 3}, {"machine": {"axes": {"X": {}}}}, {"machine": {"axes": {"X": {"max": "far"}, "Y": {}}}}],
)
def test_what_is_no_machine_is_refused(tmp_path: Path, content: Any) -> None:
    with pytest.raises(JobError):
        read(tmp_path, content)


@pytest.mark.parametrize("name", REAL)
def test_a_real_machine_names_where_its_figures_come_from(name: str) -> None:
    comments = [line for line in profile_text(name).splitlines() if line.startswith("#")]
    assert any("Source" in line for line in comments)
    machine = load_machine(name)
    assert json.loads(fcm_text(machine))["machine"]["name"] == machine.name
