# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mini-lathe's profile: a machine of X and Z alone, and what every reader of axes makes of it."""

from __future__ import annotations

import pytest

from CNCStepper.control.protocol.grbl.settings import expected_settings
from CNCStepper.errors import JobError
from CNCStepper.machine.profile import NO_AXIS, Machine, load_machine
from CNCStepper.machine.step_wait_tables import pull_out_s


def test_it_has_x_and_z_as_published() -> None:
    lathe = load_machine("mini-lathe")
    assert list(lathe.own_axes) == ["x", "z"] and lathe.is_lathe and lathe.has_z
    assert [axis.steps_per_mm for axis in lathe.own_axes.values()] == [80.0, 80.0]
    assert lathe.axes[1] is NO_AXIS and [number for number, *_ in lathe.numbered_axes] == [0, 2]
    assert lathe.planner.waits and lathe.planner.waits.waits_s == pytest.approx(pull_out_s())
    assert lathe.language() == "mini-lathe" and len(lathe.spindle.preset_rpm) == 10


def test_a_sender_expects_its_settings_of_x_and_z_only() -> None:
    wanted = expected_settings(load_machine("mini-lathe"))
    assert {number for number in wanted if number >= 100} == {100, 102, 110, 112, 120, 122}


@pytest.mark.parametrize(("controller", "axes", "missing"), [("mini-lathe", "xy", "z"), ("grbl", "x", "y")])
def test_each_machine_needs_its_own_axes(controller: str, axes: str, missing: str) -> None:
    content = load_machine("mini-lathe").model_dump() | {"controller": controller}
    content["axis"] = dict.fromkeys(axes, content["axis"]["x"])
    with pytest.raises(ValueError, match=f"axis.{missing} is missing"):
        Machine.model_validate(content)


def test_what_no_profile_says_stays_out_of_its_fingerprint() -> None:
    table = load_machine("table-a").model_dump()
    assert "link" not in table and "preset_rpm" not in table["spindle"]
    assert load_machine("mini-lathe").model_dump()["link"]["ahead_bytes"] == 128


def test_a_buffer_too_small_for_a_record_is_refused(tmp_path) -> None:
    from importlib import resources

    text = (resources.files("CNCStepper.machine") / "profiles" / "mini-lathe.toml").read_text("utf-8")
    file = tmp_path / "lathe.toml"
    file.write_text(text.replace("ahead_bytes = 128", "ahead_bytes = 10"), encoding="utf-8")
    with pytest.raises(JobError, match="ahead_bytes"):
        load_machine(file)
