# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user's own profiles: made, changed, checked before they are written; shipped ones are never written."""

from __future__ import annotations

from pathlib import Path

import pytest

from CNCStepper.errors import JobError
from CNCStepper.machine.files.profile_files import own_folder, own_names, shipped_file, shipped_names
from CNCStepper.machine.own_profiles import (
    change,
    create,
    differences,
    profile_content,
    profile_text,
    profiles,
    read_change,
    save,
    values_of,
)
from CNCStepper.machine.profile import load_machine, profile_names

STEPS = ("axis", "x", "steps_per_mm")


def test_a_new_profile_is_named_like_a_shipped_one_and_keeps_the_comments() -> None:
    written = create("mine", "table-a")
    assert written.path == own_folder() / "mine.toml" and written.comments_kept
    assert "mine" in profile_names() and own_names() == ["mine"]
    assert load_machine("mine").name == "mine"
    assert load_machine("mine").axis == load_machine("table-a").axis
    assert "# machine coordinates" in profile_text("mine")


def test_a_name_in_use_and_one_that_is_no_name_are_refused() -> None:
    create("mine", "table-a")
    for name, code in (("mine", "profile-exists"), ("table-a", "profile-exists"), ("../x", "profile-name")):
        with pytest.raises(JobError) as refused:
            create(name, "table-b")
        assert refused.value.code == code
    assert own_names() == ["mine"]


def test_the_first_change_of_a_shipped_profile_makes_a_copy_that_takes_its_place() -> None:
    shipped = shipped_file("table-a").read_text("utf-8")
    before = load_machine("table-a")
    written = change("table-a", {STEPS: 80.5})
    assert written.copied_from == "table-a" and written.comments_kept
    assert shipped_file("table-a").read_text("utf-8") == shipped
    assert load_machine("table-a").axis["x"].steps_per_mm == 80.5 != before.axis["x"].steps_per_mm
    assert change("table-a", {STEPS: 81}).copied_from == ""
    assert [profile.is_own for profile in profiles() if profile.name == "table-a"] == [True]


@pytest.mark.parametrize(
    ("path", "value", "words"),
    [
        (STEPS, -1.0, "steps_per_mm"),
        (STEPS, "many", "steps_per_mm"),
        (("axis", "x", "step_per_mm"), 80.0, "step_per_mm"),
        (("axis", "x"), None, "axis.x"),
        (("axis", "x", "travel_max_mm"), -500.0, "travel_min_mm must be below travel_max_mm"),
        (("name", "x"), 1, "name.x"),
    ],
)
def test_a_change_that_makes_no_machine_writes_nothing(path: tuple[str, ...], value: object, words: str) -> None:
    create("mine", "table-a")
    before = profile_text("mine")
    with pytest.raises(JobError) as refused:
        change("mine", {("planner", "ramp"): "trapezoid", path: value})
    assert words in str(refused.value)
    assert profile_text("mine") == before
    assert sorted(entry.name for entry in own_folder().iterdir()) == ["mine.toml"]


def test_a_profile_of_a_path_is_changed_in_its_place(tmp_path: Path) -> None:
    path = tmp_path / "máquina.toml"
    path.write_bytes(profile_text("table-b").replace("\n", "\r\n").encode())
    assert change(str(path), {STEPS: 99}).path == path
    assert load_machine(path).axis["x"].steps_per_mm == 99
    assert own_names() == []


def test_a_json_profile_becomes_one_of_the_users_and_is_not_written_itself(tmp_path: Path) -> None:
    path = tmp_path / "m.json"
    path.write_text(load_machine("torch-table").model_dump_json(), "utf-8")
    with pytest.raises(JobError, match="JSON"):
        change(str(path), {STEPS: 99})
    create("from-json", str(path))
    assert load_machine("from-json").axis == load_machine("torch-table").axis


def test_saving_content_changes_only_what_differs() -> None:
    create("mine", "table-a")
    content = profile_content("mine")
    content["axis"]["x"]["steps_per_mm"] = 77
    del content["outputs"]
    assert list(differences(profile_content("mine"), content)) == [(STEPS, 77), (("outputs",), None)]
    written = save("mine", content)
    assert written.comments_kept and profile_content("mine") == content
    assert save("another", content).machine == load_machine("another")


def test_words_of_the_command_line_are_read_as_toml_and_else_as_text() -> None:
    assert read_change("axis.x.steps_per_mm=80") == (STEPS, 80)
    assert read_change("planner.ramp=s_curve") == (("planner", "ramp"), "s_curve")
    assert read_change("outputs.coolant=['mist']") == (("outputs", "coolant"), ["mist"])
    assert read_change("spindle.laser=true")[1] is True
    assert read_change("axis.z=") == (("axis", "z"), None)
    for word in ("axis.x", "=3", "axis..x=3"):
        with pytest.raises(JobError):
            read_change(word)


def test_values_in_force_are_shown_with_defaults() -> None:
    machine = load_machine("table-a")
    assert 'tool_length = "touch_off"' in values_of(machine)
    assert values_of(machine, ("planner", "ramp")) == ['planner.ramp = "trapezoid"']
    assert all(line.startswith("axis.x.") for line in values_of(machine, ("axis", "x")))
    with pytest.raises(JobError):
        values_of(machine, ("axis", "w"))


def test_every_shipped_profile_goes_through_the_users_folder_unchanged() -> None:
    for name in shipped_names():
        machine = load_machine(name)
        copy = create(f"copy-of-{name}", name)
        assert copy.comments_kept
        assert copy.machine.model_copy(update={"name": machine.name}) == machine


def test_a_profile_with_relays_is_another_machine_than_one_without_and_one_without_says_nothing_of_them() -> None:
    assert "relay" not in load_machine("table-a").model_dump()
    relays = [{"name": "oxygen", "device": "flood"}, {"name": "light", "device": "output_0"}]
    machine = change("table-a", {("relay",): relays}).machine
    assert machine.model_dump()["relay"] == tuple(relays)
    for wrong in ([*relays, {"name": "oxygen", "device": "mist"}], [*relays, {"name": "x", "device": "flood"}]):
        with pytest.raises(JobError, match="is there twice"):
            change("table-a", {("relay",): wrong})
