# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs that must be refused, each naming code, line and column in its last line."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpret import Interpreter, interpret
from CNCStepper.gcode.words import program_lines
from CNCStepper.state import Start

FOLDER = Path(__file__).parents[2] / "bad"
PROGRAMS = sorted(FOLDER.glob("*.nc"))
EXPECT = re.compile(r"; expect (\S+) (\d+):(\d+) ?(\S*)")


def expected(text: str) -> tuple[str, int, int, str]:
    code, line, column, dialect = EXPECT.match(text.splitlines()[-1]).groups()
    return code, int(line), int(column), dialect or "grbl"


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.stem)
def test_the_program_is_refused_at_its_place(path):
    text = path.read_text("utf-8")
    code, line, column, dialect = expected(text)
    body = text[: text.rindex("; expect")]
    with pytest.raises(ProgramError) as caught:
        interpret(body, Start(), dialect, file=path.name)
    place = caught.value.place
    assert (caught.value.code, place.file, place.line, place.column) == (code, path.name, line, column)
    assert caught.value.what and not caught.value.what.endswith(".")


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.stem)
def test_the_refused_line_changes_nothing(path):
    """The table, the state and the next line are what they would be without the refused line."""
    text = path.read_text("utf-8")
    _, line, column, dialect = expected(text)
    if column == 0:  # refused for its end, not for a line
        return
    lines = program_lines(text)[: line - 1]
    refused, clean = Interpreter(Start(), dialect), Interpreter(Start(), dialect)
    for before in lines:
        refused.line(before)
        clean.line(before)
    with pytest.raises(ProgramError):
        refused.line(program_lines(text)[line - 1])
    assert refused.model.state == clean.model.state
    assert refused.model.motion == clean.model.motion
    assert repr(refused.model.position) == repr(clean.model.position)
    assert refused.table.states == clean.table.states
    assert refused.table.events == clean.table.events
    assert refused.table.index == clean.table.index


def test_every_program_has_its_expectation():
    assert len(PROGRAMS) > 50
    for path in PROGRAMS:
        assert EXPECT.match(path.read_text("utf-8").splitlines()[-1]), path


def test_the_sentence_names_value_and_what_the_controller_would_answer():
    with pytest.raises(ProgramError) as caught:
        interpret("G21\nG1 x 1 0 m6 F100", file="part.nc")
    assert str(caught.value).startswith("part.nc:2:10: grbl 1.1 does not accept M6 (value M6)")
    assert "error:20" in str(caught.value)
