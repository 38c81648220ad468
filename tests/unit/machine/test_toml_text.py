# SPDX-License-Identifier: LGPL-2.1-or-later
"""TOML written anew and changed line by line: it reads back as what it should hold, and its comments stay."""

from __future__ import annotations

import copy
import random
import tomllib
from importlib import resources
from typing import Any

import pytest

from CNCStepper.machine.files.toml_text import changed_text, document_text, put, value_text

TEXT = """# the shop's table
name = "Table"                # as on its plate
list = [
    1,  # one
    2,
]

[axis.x]
steps_per_mm = 40             # measured in May
drive = { screw_pitch_mm = 5, microsteps = 2 }   # of the motor

# the second axis
[axis.y]
"odd key" = 'a # b'           # no comment inside

[[input]]
pin = "P"                     # the probe

[[input]]
pin = "D"
"""


def changed(path: str, value: Any) -> tuple[dict[str, Any], str, bool]:
    text, kept = changed_text(TEXT, {tuple(path.split(".")): value})
    return tomllib.loads(text), text, kept


def test_a_value_changes_and_its_comment_stays_in_its_column() -> None:
    content, text, kept = changed("axis.x.steps_per_mm", 80.25)
    assert kept and content["axis"]["x"]["steps_per_mm"] == 80.25
    assert "steps_per_mm = 80.25          # measured in May" in text
    assert text.count("#") == TEXT.count("#")


@pytest.mark.parametrize(
    ("path", "value", "line"),
    [
        ("axis.y.homing", "min", 'homing = "min"'),
        ("axis.x.drive.microsteps", 8, "drive = { screw_pitch_mm = 5, microsteps = 8 }   # of the motor"),
        ("axis.y.odd key", "c", "# no comment inside"),
        ("axis.z.steps_per_mm", 400, "[axis.z]"),
        ("feed_mm_min", 900, "feed_mm_min = 900"),
        ("spindle", {"min_rpm": 0, "max_rpm": 10}, "[spindle]"),
    ],
)
def test_a_key_changes_or_is_added_where_its_table_is(path: str, value: Any, line: str) -> None:
    content, text, kept = changed(path, value)
    assert kept and line in text and "# the second axis" in text and "# one" in text
    found: Any = content
    for part in path.split("."):
        found = found[part]
    assert found == value


def test_a_table_and_a_key_are_taken_out() -> None:
    content, text, kept = changed("axis.y", None)
    assert kept and "y" not in content["axis"] and "# measured in May" in text
    assert "drive" not in changed("axis.x.drive", None)[0]["axis"]["x"]
    assert "microsteps" not in changed("axis.x.drive.microsteps", None)[0]["axis"]["x"]["drive"]


def test_a_list_of_tables_is_written_a_table_a_line() -> None:
    content, text, kept = changed("input", [{"pin": "H"}, {"pin": "S"}])
    assert kept and content["input"] == [{"pin": "H"}, {"pin": "S"}]
    assert '    { pin = "H" },\n    { pin = "S" },\n' in text


def test_a_key_inside_a_list_is_refused_with_its_path() -> None:
    with pytest.raises(KeyError) as refused:
        changed("input.0.pin", "H")
    assert refused.value.args[0] == ("input", "0", "pin")


def test_what_the_line_editor_does_not_know_is_written_anew_and_said() -> None:
    text = 'axis = { x = 1 }\nnote = """\n[axis]\nx = 2\n"""\n'
    new, kept = changed_text(text, {("axis", "y", "z"): 3})
    assert tomllib.loads(new)["axis"] == {"x": 1, "y": {"z": 3}}
    assert tomllib.loads(new)["note"] == "[axis]\nx = 2\n"
    assert kept == new.startswith("axis = {")


@pytest.mark.parametrize("value", [True, 3, -2.5, 1e-9, 'a"b\\c\n#é😀\x7f', ["x", 1.5], {"a b": [{"c": False}]}, []])
def test_every_value_reads_back(value: Any) -> None:
    assert tomllib.loads(f"v = {value_text(value)}")["v"] == value


def a_value(dice: random.Random) -> Any:
    kinds = (dice.randint(-99, 99), dice.uniform(-1e6, 1e6), dice.random() < 0.5, dice.choice(["a # b", "[x]", "é"]),
             [dice.randint(0, 9) for _ in range(dice.randint(0, 4))], [{"pin": "P"}, {"act": "stop"}])  # fmt: skip
    return dice.choice(kinds)


def test_random_changes_of_the_shipped_profiles_read_back() -> None:
    seed = random.SystemRandom().randrange(2**32)
    print("seed", seed)
    dice = random.Random(seed)
    folder = resources.files("CNCStepper.machine") / "profiles"
    texts = [entry.read_text("utf-8") for entry in folder.iterdir() if entry.name.endswith(".toml")]
    done = {"kept": 0, "taken out": 0, "new table": 0}
    for _ in range(300):
        text = dice.choice(texts)
        wanted = tomllib.loads(text)
        changes: dict[tuple[str, ...], Any] = {}
        for _ in range(dice.randint(1, 4)):
            table = dice.choice([(), ("axis", dice.choice("xyz")), ("planner",), (dice.choice("ab"), "new table")])
            keys = ["steps_per_mm", "homing", "name", "fresh", "odd key"]
            changes[(*table, dice.choice(keys))] = dice.choice([None, a_value(dice)])
        expected = copy.deepcopy(wanted)
        for path, value in changes.items():
            put(expected, path, value)
            done["taken out"] += value is None
            done["new table"] += "new table" in path and value is not None
        new, kept = changed_text(text, changes)
        assert tomllib.loads(new) == expected, changes
        assert tomllib.loads(document_text(expected)) == expected
        done["kept"] += kept
    assert done["kept"] > 250 and done["taken out"] > 20 and done["new table"] > 20, done
