# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a machine lacks is never written, and refused by name where it is read; a torch is switched cut by cut."""

from __future__ import annotations

import re

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects import dialect
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.gcode.wire.read_back import read_back, refused_lines
from CNCStepper.gcode.writer.write import WriteOptions, write
from CNCStepper.state import Start, State
from CNCStepper.toolpath import RAPID, TableBuilder, Toolpath

CONTROLLERS = ("grbl", "grblhal", "fluidnc", "linuxcnc", "mach", "mach:dwell=ms", "marlin", "iso")


def named(controller: str, settings: str) -> str:
    return controller + ("," if ":" in controller else ":") + settings


def torch_cuts(on_rpm: float) -> Toolpath:
    """Return two cuts as a contour-powered cycle makes them: rapid, on, dwell, way, off."""
    on, off = State(tool=1, spindle="cw", spindle_rpm=on_rpm), State(tool=1)
    table = TableBuilder(Start(), off)
    for x in (0.0, 50.0):
        table.set_state(off)
        table.rapid((x, 10.0, 0.0))
        table.set_state(on)
        table.event("dwell", 0.4)
        table.feed((x + 5.0, 10.0, 0.0), 3000.0)
        table.feed((x + 20.0, 15.0, 0.0), 3000.0)
    table.set_state(off)
    table.rapid((0.0, 0.0, 0.0))
    return table.toolpath()


@pytest.mark.parametrize("controller", CONTROLLERS)
@pytest.mark.parametrize(("settings", "on_rpm"), [("z=none,spindle=switch", 1.0), ("z=none", 600.0)])
def test_a_torch_is_switched_cut_by_cut(controller: str, settings: str, on_rpm: float) -> None:
    language, path = named(controller, settings), torch_cuts(on_rpm)
    text = write(path, language, WriteOptions())
    code = re.sub(r"\([^)]*\)|;.*", "", text)
    assert "Z" not in code
    assert ("S" in code) == (on_rpm > 1.0)
    lines = [re.sub(r"^N\d+ ", "", line) for line in code.splitlines()]
    begins = [number for number, line in enumerate(lines) if re.match(r"M0?3\b", line)]
    assert len(begins) == 2
    for number in begins:
        assert re.match(r"G0?4 ", lines[number + 1])
    again = interpret(text, Start(), language)
    assert np.array_equal(again.table().end, path.table().end)
    rapids = again.table().kind == RAPID
    on = np.array([again.states[state].spindle_turns for state in again.table().state])
    assert np.array_equal(on, ~rapids)
    assert [event.value for event in again.events if event.kind == "dwell"] == [0.4, 0.4]


@pytest.mark.parametrize("controller", ("grbl", "mach", "iso"))
@pytest.mark.parametrize(
    ("settings", "line", "word"),
    [
        ("z=none", "G0 X1 Z5", "Z5"),
        ("z=none", "G1 F100 Z-1", "Z-1"),
        ("z=none", "g0z-1", "[Zz]-1"),
        ("z=none", "G18", "G18"),
        ("z=none", "G19", "G19"),
        ("spindle=switch", "M3 S100", "S100"),
        ("spindle=switch", "S5", "S5"),
        ("spindle=none", "M3", "M3"),
        ("spindle=none", "M4", "M4"),
        ("spindle=none", "M5", "M5"),
        ("spindle=none", "S5", "S5"),
    ],
)
def test_words_for_what_is_missing_are_refused_by_name(controller: str, settings: str, line: str, word: str) -> None:
    interpret("G0 X0 Y0\n", Start(), named(controller, settings))
    with pytest.raises(ProgramError, match=rf"value {word}\).*this machine has no") as refusal:
        interpret(f"G0 X0 Y0\n{line}\n", Start(), named(controller, settings))
    assert refusal.value.place is not None
    assert refusal.value.place.line == 2


def test_a_z_in_a_long_run_of_plain_moves_is_refused_too() -> None:
    lines = ["G0 X0 Y0", "G1 X1 F100", *(f"X{n} Y{n % 7}" for n in range(2, 3000))]
    interpret("\n".join(lines), Start(), "grbl:z=none")
    lines[2000] += " Z1"
    with pytest.raises(ProgramError, match="no Z axis") as refusal:
        interpret("\n".join(lines), Start(), "grbl:z=none")
    assert refusal.value.place is not None
    assert refusal.value.place.line == 2001


def test_a_height_that_changes_is_not_written() -> None:
    table = TableBuilder(Start())
    table.rapid((0.0, 0.0, 0.0))
    table.feed((10.0, 0.0, -1.0), 100.0)
    with pytest.raises(ProgramError, match="no axis Z"):
        write(table.toolpath(), "grbl:z=none")


def test_knife_and_point_programs_hold_no_word_for_power() -> None:
    table = TableBuilder(Start())
    table.rapid((0.0, 0.0, 5.0))
    table.feed((0.0, 0.0, -1.0), 100.0)
    table.feed((10.0, 0.0, -1.0), 100.0)
    text = write(table.toolpath(), "grbl:spindle=none")
    assert "M5" not in text
    assert "M9" in text
    interpret(text, Start(), "grbl:spindle=none")


def test_the_height_that_is_not_there_stays_where_it_is() -> None:
    start = Start(zero_known=True, parameters={5161: -3.0, 5162: -4.0, 5163: -9.0})
    path = interpret("G0 X1 Y2\nG28\nG1 X5 F100\n", start, "grbl:z=none")
    assert path.table().end.tolist() == [[1, 2, 0], [-3, -4, 0], [5, -4, 0]]


def test_a_feed_setting_is_what_a_program_without_f_takes() -> None:
    text = "G0 X0 Y0\nG1 X10\nX20 F50\n"
    assert interpret(text, Start(), "grbl:feed=1200").table().feed.tolist() == [0.0, 1200.0, 50.0]
    with pytest.raises(ProgramError, match="feed"):
        interpret(text, Start(), "grbl")
    path = interpret(text, Start(), "grbl:feed=1200")
    assert "F1200" in write(path, "grbl:feed=1200"), "what is written stands without the setting"


@pytest.mark.parametrize(("units", "feed"), [("G21", "F1270"), ("G20", "F50")])
def test_a_controller_that_reads_files_takes_no_feed_that_is_not_in_them(units: str, feed: str) -> None:
    """LinuxCNC keeps the F of the program before, and what we send of a file is the file."""
    text = f"{units}\nG0 X0 Y0\nG1 X1\nX2\nM2\n"
    language = "linuxcnc:feed=1270"
    with pytest.raises(ProgramError) as refused:
        read_back(prepare(text, language), text, Start(), language)
    (again,) = refused_lines(text, Start(), language)
    for error in (refused.value, again):
        assert error.code == "no-feed" and feed in error.advice
        assert error.place is not None and error.place.line == 3
    converted = write(interpret(text, Start(), language), "grbl")  # what is converted names it
    assert "F1270" in converted
    written = text.replace("G1 X1", f"G1 X1 {feed}")
    assert interpret(written, Start(), "linuxcnc:feed=900").table().feed.tolist() == pytest.approx(
        [0.0, 1270.0, 1270.0]
    )


@pytest.mark.parametrize("setting", ["feed=0", "feed=-5", "feed=nan", "feed=", "feed=x", "z=some", "spindle=on"])
def test_settings_that_are_none_are_refused(setting: str) -> None:
    with pytest.raises(ProgramError, match=r"setting|no feed"):
        dialect(f"grbl:{setting}")
