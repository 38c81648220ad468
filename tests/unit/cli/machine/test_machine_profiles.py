# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper machine`: what it lists, makes, shows and changes."""

from __future__ import annotations

from CNCStepper.machine.files.profile_files import own_folder, shipped_names
from CNCStepper.machine.profile import load_machine
from helpers.cli.command_line import called


def machine(*words: str) -> str:
    result = called("machine", *words)
    assert result.returncode == 0, result.stderr
    return result.stdout


def test_a_profile_is_made_changed_shown_and_taken_where_a_machine_is_named() -> None:
    assert "made from torch-table" in machine("new", "big-torch", "--from", "torch-table")
    machine("set", "big-torch", "axis.x.travel_max_mm=2500", "relay=[{name='oxygen', device='flood'}]")
    assert load_machine("big-torch").axis["x"].travel_max_mm == 2500
    assert "big-torch (yours): big-torch, grbl, plasma, oxyfuel, 3750 x" in machine("list")
    assert machine("show", "big-torch", "axis.x.travel_max_mm") == "axis.x.travel_max_mm = 2500.0\n"
    assert "travel_max_mm = 2500" in machine("show", "big-torch")
    assert 'tool_length = "touch_off"\n' in machine("show", "big-torch", ".")
    refused = called("time", "nothing.nc", "--machine", "big-torch")
    assert "machine" not in refused.stderr, "the profile is known: only the program is missing"


def test_the_list_has_every_shipped_profile_and_says_what_is_wrong_with_ones_own() -> None:
    machine("new", "broken")
    (own_folder() / "broken.toml").write_text('name = "x"\n', "utf-8")
    lines = machine("list").splitlines()
    assert [line.split()[0] for line in lines] == sorted([*shipped_names(), "broken"])
    assert next(line for line in lines if line.startswith("broken")).endswith("[bad-value]")


def test_a_shipped_profile_is_copied_at_its_first_change_and_that_is_said() -> None:
    said = machine("set", "table-a", "planner.look_ahead_blocks=31")
    assert "table-a ships with the program and stays as it is" in said
    assert "ships" not in machine("set", "table-a", "planner.look_ahead_blocks=32")
    assert "table-a (yours, instead of the shipped one)" in machine("list")


def test_a_file_in_another_layout_is_written_anew_and_that_is_said() -> None:
    machine("new", "mine")
    path = own_folder() / "mine.toml"
    text = path.read_text("utf-8").replace("[planner]", "[ planner ] # of ours").replace("\n[axis.x]", "\naxis.x]")
    assert called("machine", "set", "mine", "axis.x.steps_per_mm=81").returncode == 0
    path.write_text(text, "utf-8")
    refused = called("machine", "set", "mine", "axis.x.steps_per_mm=81")
    assert refused.returncode == 1 and "not a TOML file" in refused.stderr
    assert path.read_text("utf-8") == text


def test_refusals_name_key_value_and_remedy() -> None:
    for words, said in (
        (("set", "table-a", "axis.x.steps_per_mm=0"), "axis.x.steps_per_mm must be a number within its bounds"),
        (("set", "table-a", "axis.x.speed=5"), "there is no key axis.x.speed"),
        (("set", "table-a", "axis"), "write KEY=VALUE"),
        (("set", "nowhere", "name=x"), "there is no machine profile 'nowhere'"),
        (("new", "table-b"), "there is a machine profile 'table-b' already"),
        (("show", "table-a", "planner.nothing"), "the profile has no key planner.nothing"),
    ):
        result = called("machine", *words)
        assert result.returncode == 1 and said in result.stderr, result.stderr
    assert not own_folder().exists()
