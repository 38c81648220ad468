# SPDX-License-Identifier: LGPL-2.1-or-later
"""The buttons of a machine profile, checked whole."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from CNCStepper.errors import JobError
from CNCStepper.machine.profile import load_machine
from CNCStepper.machine.wiring import Input, letters_of_own, seen_by_sender

PROFILE = Path(load_machine.__code__.co_filename).parent / "profiles" / "table-a.toml"


def machine(tmp_path: Path, text: str):
    path = tmp_path / "máquina ç.toml"
    path.write_text(PROFILE.read_text("utf-8") + text, "utf-8")
    return load_machine(path)


def test_buttons_are_read_with_what_is_left_out(tmp_path):
    found = machine(
        tmp_path,
        """
[[input]]
pin = "P"
act = "pause"
level = "low"

[[input]]
pin = 11
port = "/dev/parport0"
act = "switch"
line = "M64P1"
release_line = "M65P1"
debounce_ms = 5
""",
    ).input
    assert [entry.name for entry in found] == ["pin P", "pin 11 of /dev/parport0"]
    assert (found[0].level, found[0].debounce_ms, found[1].level, found[1].debounce_ms) == ("low", 30, "high", 5)


def test_machine_without_buttons_has_none():
    assert load_machine("table-a").input == ()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('pin = "Q"\nact = "stop"', "pin 'Q' is no pin of a controller"),
        ('pin = "XY"\nact = "stop"', "pin 'XY' is no pin of a controller"),
        ('pin = ""\nact = "stop"', "pin '' is no pin of a controller"),
        ('pin = 9\nport = "/dev/parport0"\nact = "stop"', "pin 9 is no input of a parallel port"),
        ('pin = true\nact = "stop"', "pin"),
        ('pin = 11\nact = "stop"', "has a port"),
        ('pin = "P"\nport = "/dev/parport0"\nact = "stop"', "has a port"),
        ('pin = "P"\nact = "limit"', "on the machine's own"),
        ('pin = 11\nport = "/dev/parport0"\nact = "door"', "on the machine's own"),
        ('pin = "P"\nact = "explode"', "act"),
        ('pin = "P"\nact = "stop"\nlevel = "on"', "level"),
        ('pin = "P"\nact = "stop"\ndebounce_ms = 2000', "debounce_ms"),
        ('pin = "P"\nact = "switch"', "line belong together"),
        ('pin = "P"\nact = "stop"\nline = "M8"', "line belong together"),
        ('pin = "P"\nact = "stop"\nrelease_line = "M9"', "release_line goes with line"),
        ('pin = "P"\nact = "stop"\n\n[[input]]\npin = "P"\nact = "start"', "two inputs are on pin P"),
        ('pin = "P"\nact = "stop"\nbounce = 3', "there is no key input.0.bounce"),
    ],
)
def test_what_cannot_be_is_refused_in_words(tmp_path, text, said):
    with pytest.raises(JobError, match=re.escape(said)):
        machine(tmp_path, f"\n[[input]]\n{text}\n")


@pytest.mark.parametrize(
    "line", ["G0X10", "M3 S5", "M0", "M30", "M2", "M6T1", "M8!", "m8", "$H", "M8?", "M64P1X3", "S9"]
)
def test_line_that_does_more_than_switch_is_refused(tmp_path, line):
    with pytest.raises(JobError, match="only switches"):
        machine(tmp_path, f'\n[[input]]\npin = "P"\nact = "switch"\nline = "{line}"\n')


@pytest.mark.parametrize("line", ["M3S9000", "M8", "M9", "M5", "M64P0", "M67E0Q12.5"])
def test_line_that_switches_is_taken(tmp_path, line):
    (entry,) = machine(tmp_path, f'\n[[input]]\npin = "P"\nact = "switch"\nline = "{line}"\n').input
    assert entry.line == line


def test_a_sender_sees_of_the_machines_own_pins_what_only_it_can_do():
    acts = {10: "pause", 11: "back", 12: "limit", 13: "switch", 15: "door"}
    own = [Input(pin=pin, act=act, line="M8" if act == "switch" else "", level="low") for pin, act in acts.items()]
    others = [Input(pin="H", act="pause"), Input(pin=11, port="/dev/parport1", act="stop")]
    seen = seen_by_sender([*own, *others])
    assert [(entry.pin, entry.act, entry.level) for entry in seen] == [
        ("A", "back", "high"),
        ("B", "switch", "high"),
        ("H", "pause", "high"),
        (11, "stop", "high"),
    ]
    assert letters_of_own(own) == {11: "A", 13: "B"}
