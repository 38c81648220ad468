# SPDX-License-Identifier: LGPL-2.1-or-later
"""A profile while it is changed in the window: rows from the model, texts, problems at their rows, nothing lost."""

from __future__ import annotations

import random
import sys
from types import SimpleNamespace

import pytest

from CNCStepper.machine.own_profiles import profile_content
from CNCStepper.machine.profile import Machine, profile_names
from CNCStepper.machine.wiring import DEVICES, Signals
from CNCStepper.workbench.machines import labels
from CNCStepper.workbench.machines.declaration import CHOICE, SET, rows, tables
from CNCStepper.workbench.machines.draft import ROWS, TABLES, Draft
from CNCStepper.workbench.services.choice_labels import WORDS

TEXTS = ("", "x", "-1", "0", "12,5", "1.2.3", "80", "1e400", "é", "0 1; 2", "true", "\x00", "9" * 400)
STEPS = ("axis", "x", "steps_per_mm")


def draft(name: str = "table-a") -> Draft:
    return Draft(name, profile_content(name))


def test_every_key_of_the_model_has_a_row_or_a_table_and_a_label() -> None:
    paths = {row.path for row in rows()}
    keys = {path[0] for path in paths} | {table.key for table in tables()}
    assert keys == set(Machine.model_fields)
    assert {"x", "y", "z"} == {path[1] for path in paths if path[0] == "axis"}
    assert ("signals", "pins") not in paths
    for row in (*rows(), *(column for table in tables() for column in table.columns)):
        dotted = ".".join(row.path[-2:])
        assert dotted in labels.LABELS or row.path[-1] in labels.LABELS, f"{dotted} has no label"
        if row.kind in (CHOICE, SET):
            assert row.choices


def test_every_choice_has_words(monkeypatch: pytest.MonkeyPatch) -> None:
    english = SimpleNamespace(translate=lambda context, text: text)
    monkeypatch.setitem(sys.modules, "FreeCAD", SimpleNamespace(Qt=english))
    columns = [column for table in TABLES.values() for column in table.columns]
    chosen = [
        (row.path[-1], choice) for row in (*ROWS, *columns) if row.kind in (CHOICE, SET) for choice in row.choices
    ]
    assert len(chosen) > 30
    assert not [pair for pair in chosen if ".".join(pair) not in labels.CHOICES and pair[1] not in WORDS]
    assert all(labels.signal_label(name) != name for name in Signals().lines)
    assert len({labels.signal_label(name) for name in DEVICES}) == len(DEVICES)


@pytest.mark.parametrize("name", profile_names())
def test_a_profile_that_is_only_looked_at_stays_what_it_is(name: str) -> None:
    content, problems = draft(name).judged()
    assert content == profile_content(name) and not problems
    assert not draft(name).is_changed


def test_random_texts_lose_nothing_and_a_good_one_is_taken() -> None:
    seed = random.SystemRandom().randrange(2**32)
    print("seed", seed)
    dice = random.Random(seed)
    bad = good = 0
    for _ in range(600):
        one = draft(dice.choice(profile_names()))
        path = dice.choice(list(one.texts))
        text = dice.choice(
            ["", "x", "-1", "0", "12,5", "1.2.3", "80", "1e400", "é", "0 1; 2", "true", "\x00", "9" * 400]
        )
        before = dict(one.texts)
        one.texts[path] = text
        content, problems = one.judged()
        assert one.texts == {**before, path: text}
        bad += bool(problems)
        if not problems:
            good += one.is_changed
            Machine.model_validate(content)
    assert bad > 30 and good > 10


@pytest.mark.parametrize(
    ("path", "text", "at", "words"),
    [
        (STEPS, "many", STEPS, "no number"),
        (STEPS, "0", STEPS, "must be at least"),
        (STEPS, "", STEPS, "missing"),
        (("axis", "x", "travel_max_mm"), "-500", ("axis", "x", "travel_min_mm"), "must be below travel_max_mm"),
        (("planner", "ramp"), "s_curve", ("axis", "x", "jerk_mm_s3"), "jerk_mm_s3 is missing"),
        (("planner", "look_ahead_blocks"), "2.5", ("planner", "look_ahead_blocks"), "no whole number"),
        (("axis", "y", "motor", "torque"), "0 1.2 3", ("axis", "y", "motor", "torque"), "write points"),
        (("processes",), "milling dance", ("processes",), "must be 'milling', '"),
        (("name",), "", ("name",), "missing"),
    ],
)
def test_a_problem_stands_at_its_row(path: tuple[str, ...], text: str, at: tuple[str, ...], words: str) -> None:
    one = draft()
    one.texts[path] = text
    problems = one.judged()[1]
    assert at in problems, problems
    assert words in str(problems[at])


def test_values_are_read_as_people_write_them() -> None:
    one = draft()
    one.texts[STEPS] = "80,5"
    one.texts[("axis", "z", "motor", "torque")] = "0 1,2; 300 1"
    for key, text in (("travel_per_turn_mm", "5"), ("mass_kg", "8")):
        one.texts[("axis", "z", "motor", key)] = text
    one.texts[("signals", "motors")] = "x, y -y z"
    one.texts[("signals", "base")] = "0x278"
    one.texts[("spindle", "laser")] = "true"
    content, problems = one.judged()
    assert not problems
    assert content["axis"]["x"]["steps_per_mm"] == 80.5
    assert content["axis"]["z"]["motor"]["torque"] == [[0, 1.2], [300, 1]]
    assert content["signals"] == {"motors": ["x", "y", "-y", "z"], "base": 0x278}
    assert content["spindle"]["laser"] is True
    assert one.signals[:8] == ("x_step", "x_direction", "y_step", "y_direction", "y2_step", "y2_direction",
                               "z_step", "z_direction")  # fmt: skip


def test_a_table_that_is_emptied_is_left_out() -> None:
    one = draft()
    for path in one.texts:
        if path[:2] == ("axis", "z"):
            one.texts[path] = ""
    content, problems = one.judged()
    assert not problems and set(content["axis"]) == {"x", "y"}


def test_pins_relays_and_inputs() -> None:
    assert draft("table-a").standard_pin("x_step") == 2
    one = draft("thesis-table")
    one.pins.clear()
    one.lists["relay"].clear()
    one.lists["input"].clear()
    one.pins.update({"x_step": "-3", "x_direction": "4"})
    assert one.standard_pin("y_step") is None
    one.lists["relay"].append({"name": "light", "device": "output_1"})
    one.lists["input"].append({"pin": "11", "act": "pause", "port": "/dev/parport0"})
    content, problems = one.judged()
    assert not problems, problems
    assert content["signals"]["pins"] == {"x_step": -3, "x_direction": 4}
    assert content["relay"] == [{"name": "light", "device": "output_1"}]
    assert content["input"] == [{"pin": 11, "act": "pause", "port": "/dev/parport0"}]
    one.lists["relay"].append({"name": "lamp", "device": "output_1"})
    assert "twice" in str(one.judged()[1][("relay",)])
    one.pins["y_step"] = "11"
    one.lists["input"].append({"pin": "Q", "act": "stop", "debounce_ms": "x"})
    problems = one.judged()[1]
    assert ("input", "1", "debounce_ms") in problems and ("input", "1", "pin") in problems
    assert any(path[:1] == ("signals",) for path in problems)
    one.pins = {}
    one.lists["relay"].clear()
    assert "relay" not in one.content()[0] or one.content()[0]["relay"] == []
