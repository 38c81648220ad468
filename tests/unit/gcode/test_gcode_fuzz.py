# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hostile input: whatever the text, the reader gives a table or a refusal, in little time and memory.

`make fuzz` takes 100 000 cases of each; CNCSTEPPER_FUZZ is their number.
"""

from __future__ import annotations

import os
import tracemalloc
from datetime import timedelta

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects import dialect
from CNCStepper.gcode.interpreter.flow.flow_line_parser import is_plain
from CNCStepper.gcode.interpreter.state.interpreter_state import model_at
from CNCStepper.gcode.interpreter.state.system_parameters import SystemParameters
from CNCStepper.gcode.syntax.expressions import Scanner
from CNCStepper.gcode.syntax.words import pack, split_line, words_of
from CNCStepper.state import Start
from helpers.gcode.hostile_programs import DIALECTS, LETTERS, PROGRAMS, STARTS, TEXTS, VALUES, check, read

CASES = int(os.environ.get("CNCSTEPPER_FUZZ", "50"))
HOSTILE = settings(
    max_examples=CASES,
    deadline=timedelta(seconds=10),
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)


@HOSTILE
@given(TEXTS, st.booleans())
def test_any_line_has_words_or_is_refused(text, strict):
    try:
        line = split_line(text, strict)
        words = words_of(line.code)
    except ProgramError as error:
        assert error.place is not None and 1 <= error.place.column <= len(text) + 1
        return
    packed, columns = pack(line.code)
    assert "".join(word.text for word in words) == packed
    assert [word.column for word in words] == sorted(word.column for word in words)
    assert len(packed) == len(columns)


@HOSTILE
@given(VALUES)
def test_any_value_is_finite_or_refused(text):
    known = SystemParameters(model_at(Start.at_zero(), dialect("linuxcnc")), 1)
    scanner = Scanner(*pack(text), known)
    try:
        value = scanner.value()
    except ProgramError as error:
        assert error.place is not None
        return
    assert abs(value) < float("inf")


@HOSTILE
@given(TEXTS, DIALECTS, STARTS)
def test_any_text_is_read_or_refused(text, name, start):
    check(read(text, name, start), text)


@pytest.mark.slow
@HOSTILE
@given(PROGRAMS, DIALECTS, STARTS)
def test_any_program_is_read_or_refused(text, name, start):
    check(read(text, name, start), text)


@HOSTILE
@given(PROGRAMS)
def test_the_same_text_gives_the_same_outcome(text):
    one, other = read(text, "linuxcnc"), read(text, "linuxcnc")
    assert str(one) == str(other) if isinstance(one, ProgramError) else one.states == other.states


@HOSTILE
@given(LETTERS)
def test_what_is_told_plain_holds_words_only(text):
    """The compiled way must never see what it cannot read."""
    if not is_plain(text):
        return
    for line in text.replace("\r", "\n").split("\n"):
        code = split_line(line).code
        assert "#" not in code and "[" not in code


GREEDY = {
    "loop": "o1 while [1]\no1 endwhile\nm2",
    "loop of moves": "f100\no1 while [1]\ng91 g1 x1\no1 endwhile\nm2",
    "repeat": "o1 repeat [1e9]\no1 endrepeat\nm2",
    "many repeats": "o1 repeat [999999999]\ng91 g0 x1\no1 endrepeat\nm2",
    "do": "o1 do\no1 while [1]\nm2",
    "recursion": "o1 sub\no1 call\no1 endsub\no1 call\nm2",
    "rounds of m98": "m98 p5 l999999999\nm2\no5\nm99",
    "labels": "#1=0\no9 while [1]\n#1=[#1+1]\no#1 if [1]\no#1 endif\no9 endwhile\nm2",
    "names": "#1=0\no9 while [1]\n#1=[#1+1]\n#[#1 mod 5000 + 1]=1\no9 endwhile\nm2",
    "brackets": "g0 x" + "[" * 100 + "1" + "]" * 100 + "\nm2",
    "signs": "g0 x" + "-[" * 100 + "\nm2",
    "hashes": "g0 x" + "#" * 200 + "1\nm2",
    "powers": "#1=[9**99]\n#1=[#1**9]\nm2",
    "drill for ever": "g91 f9 g81 x1 z-1 r0 l2000000000\nm2",
    "pecks": "f9 g83 x1 z-1e6 r0 q0.0001\nm2",
    "turns": "f9 g2 x0 y0 i1 p2000000000\nm2",
    "long number": "g0 x" + "9" * 200 + "\nm2",
    "long name": "#<" + "a" * 200 + ">=1\nm2",
    "many words": "g0 " + "x1 " * 80 + "\nm2",
}


@pytest.mark.parametrize("name", GREEDY)
def test_greedy_programs_stop_within_little_memory(name):
    tracemalloc.start()
    try:
        check(read(GREEDY[name], "linuxcnc", Start.at_zero()), GREEDY[name])
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert peak < 60_000_000


FOUND = [
    "c80 g92 x0",
]


@pytest.mark.parametrize("text", FOUND)
def test_what_fuzzing_has_found_stays_mended(text):
    for start in (Start(), Start.at_zero()):
        check(read(text, "linuxcnc", start), text)
