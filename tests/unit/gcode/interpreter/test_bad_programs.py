# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs that must be refused, each naming code, line and column in its last line, many the sentence too.

What is refused for LinuxCNC, its own interpreter refuses as well.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.flow.flow_line_parser import leads
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.syntax.words import program_lines
from CNCStepper.state import Start
from helpers.gcode.rs274_runs import rs274_calls

FOLDER = Path(__file__).parents[3] / "bad"
PROGRAMS = sorted(FOLDER.glob("*.nc"))
EXPECT = re.compile(r"; expect (\S+) (\d+):(\d+) ?([^ |]*)(?: \| (.*))?")
OURS_ALONE = {
    "lc-py-comment": "rs274 runs the Python in the comment",
    "lc-canned-pecks": "rs274 makes peck after peck, for hours",
}
GROUP_0 = "Non-modal codes (Group 0): G4, G10 G28, G30, G52, G53, G92, G92.1, G92.2, G92.3"
# What rs274 takes and we do not, each with the sentence of LinuxCNC's own documents that we follow there.
STRICTER = {
    "lc-name-too-soon": "Uninitialized named parameters signal an error when used in an expression.",
    "lc-g92-3-with-g30": GROUP_0,  # "two G words from the same modal group may not appear on the same line"
    "lc-comp-g92-1": GROUP_0,  # rs274 says "Cannot change axis offsets with cutter radius comp" of G92 and G52 only
    "lc-q-below-0": "Q: Feed increment in G73, G83 canned cycles",  # rs274 refuses Q0, but takes -1 for no word at all
    "lc-g43-1-and-motion": "It is an error if: motion is commanded on the same line as G43.1",
    # of G71 and G72; rs274 takes G70 then, and cuts beside the profile
    "lc-comp-g70": "It is an error if: [...] G41, G42 Cutter Compensation is active.",
}


def expected(text: str) -> tuple[str, int, int, str]:
    code, line, column, dialect, _ = EXPECT.match(text.splitlines()[-1]).groups()
    return code, int(line), int(column), dialect or "grbl"


def sentence(text: str) -> str:
    return EXPECT.match(text.splitlines()[-1])[5] or ""


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
    assert sentence(text) in ("", caught.value.sentence)


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.stem)
def test_the_refused_line_changes_nothing(path):
    """The table, the state and the next line are what they would be without the refused line."""
    text = path.read_text("utf-8")
    _, line, column, dialect = expected(text)
    if column == 0:  # refused for its end, not for a line
        return
    lines = program_lines(text)[: line - 1]
    if any(map(leads, program_lines(text)[:line])):  # no line of its own
        return
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


LINUXCNC = [
    path
    for path in PROGRAMS
    if expected(path.read_text("utf-8"))[3].startswith("linuxcnc") and path.stem not in {*OURS_ALONE, *STRICTER}
]


@pytest.mark.slow
@pytest.mark.parametrize("path", LINUXCNC, ids=lambda path: path.stem)
def test_rs274_refuses_what_is_refused_for_linuxcnc(path, tmp_path):
    text = path.read_text("utf-8")
    assert not rs274_calls(text[: text.rindex("; expect")], tmp_path)[1]


@pytest.mark.parametrize("name", STRICTER)
def test_what_only_we_refuse_rs274_takes(name, tmp_path):
    text = (FOLDER / f"{name}.nc").read_text("utf-8")
    assert rs274_calls(text[: text.rindex("; expect")], tmp_path)[1]


def test_few_rules_are_stricter_than_those_of_rs274():
    assert len(set(STRICTER.values())) <= 5


def test_every_program_has_its_expectation():
    assert len(PROGRAMS) > 50
    for path in PROGRAMS:
        assert EXPECT.match(path.read_text("utf-8").splitlines()[-1]), path


def test_the_sentence_names_value_and_what_the_controller_would_answer():
    with pytest.raises(ProgramError) as caught:
        interpret("G21\nG1 x 1 0 m6 F100", file="part.nc")
    assert str(caught.value).startswith("part.nc:2:10: grbl 1.1 does not accept M6 (value M6)")
    assert "error:20" in str(caught.value)
