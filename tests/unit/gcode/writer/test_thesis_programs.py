# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sample programs of thesis A, read into the table of moves and written again in their own language."""

from __future__ import annotations

import re

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.writer.write import WriteOptions, write
from CNCStepper.machine.profile import load_machine
from CNCStepper.state import Start, State
from CNCStepper.toolpath import COLUMNS, LINE, RAPID, TableBuilder, Toolpath
from helpers.gcode.thesis_programs import SAMPLES

LANGUAGE = load_machine("thesis-table").language()
OPTIONS = WriteOptions(retract=False, work_offset="")


def words_of(text: str) -> list[str]:
    """Return the words of a program without those that say again what is in force, in capitals.

    The letters of an arc are kept all; so is a coordinate that is incremental.
    """
    in_force: dict[str, str] = {"X": "0", "Y": "0"}
    kept: list[str] = []
    for line in text.upper().splitlines():
        words = re.findall(r"[A-Z]-?[\d.]+", line)
        motion = next((word for word in words if word[0] == "G"), in_force.get("G", ""))
        for word in words:
            always = word[0] in "IJ" or (word[0] in "XY" and motion in ("G2", "G3", "G91"))
            if always or in_force.get(word[0]) != word[1:]:
                kept.append(word)
            in_force[word[0]] = word[1:]
        in_force["G"] = motion[1:]
    return kept


def read(text: str) -> Toolpath:
    return interpret(text, Start(), LANGUAGE)


@pytest.mark.parametrize("name", SAMPLES)
def test_a_sample_is_written_as_it_was(name: str) -> None:
    text = SAMPLES[name]
    path = read(text)
    written = write(path, LANGUAGE, OPTIONS)
    assert words_of(written) == words_of(text)
    again = read(written).table()
    for column in set(COLUMNS) - {"line", "state"}:
        assert np.array_equal(getattr(again, column), getattr(path.table(), column)), column
    assert write(read(written), LANGUAGE, OPTIONS) == written


def test_the_words_tell_programs_apart() -> None:
    texts = [words_of(text) for text in SAMPLES.values()]
    assert len({tuple(words) for words in texts}) == len(SAMPLES)


def test_the_wire_is_on_from_the_begin() -> None:
    assert all(state.spindle_turns for state in read("G90\nX10\n").states)
    without = interpret("G90\nX10\n", Start(), "thesis-a")
    assert not any(state.spindle_turns for state in without.states)


def heated(*ways: tuple[int, tuple[float, float], bool]) -> Toolpath:
    """Return a table of moves (kind, end, power), with a dwell behind each switching on."""
    table, was_on = TableBuilder(Start()), False
    for kind, (x, y), is_on in ways:
        table.set_state(State(spindle="cw", spindle_rpm=1.0) if is_on else State())
        if is_on and not was_on:
            table.event("dwell", 2.0)
        if kind == LINE:
            table.feed((x, y, 0.0), 900.0)
        else:
            table.rapid((x, y, 0.0))
        was_on = is_on
    return table.toolpath()


def test_the_words_for_power_and_heating_are_left_out() -> None:
    path = heated((RAPID, (-5, 0), False), (LINE, (20, 0), True), (LINE, (20, 30), True), (RAPID, (0, 0), False))
    text = write(path, LANGUAGE)
    assert text.splitlines() == ["G0 X-5 Y0", "G90 X20", "Y30", "G0 X0 Y0"]


def test_power_that_goes_on_twice_is_refused() -> None:
    path = heated((LINE, (20, 0), True), (RAPID, (40, 0), False), (LINE, (60, 0), True))
    with pytest.raises(ProgramError, match="cannot switch the power off"):
        write(path, LANGUAGE)
