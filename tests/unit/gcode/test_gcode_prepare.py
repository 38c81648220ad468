# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wire text means what the file means, and nothing else is on the wire."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpret import interpret
from CNCStepper.gcode.prepare import check_wire_line, prepare
from CNCStepper.state import Start

FILE = """%
(título: peça nº 1 !)
N10 g21 g90 (modes)

N20 G01 X 01.500 y-0.0 F0100. ; cut
/G0 X99
(MSG, turn the part)
M00
x2
M2
%
not a program any more
"""


def test_the_wire_and_its_map():
    wire = prepare(FILE)
    assert wire.lines == ("G21G90", "G1X1.5Y0F100", "M0", "X2", "M2")
    assert wire.file_lines.tolist() == [3, 5, 8, 9, 10]
    assert wire.messages == {2: "turn the part"}
    assert wire.text == "G21G90\nG1X1.5Y0F100\nM0\nX2\nM2\n"
    assert len(wire.sha256) == 64 and wire.sha256 == prepare(wire.text).sha256


def test_after_the_end_nothing_is_sent_where_nothing_is_read():
    assert prepare("G0 X1\nM2\nnonsense", "linuxcnc").lines == ("G0X1", "M2")


@pytest.mark.parametrize("line", ["G0X1!", "G0X1\x18", "ф", "G1~", "a\nb"])
def test_bytes_that_act_are_refused(line):
    with pytest.raises(ProgramError) as caught:
        check_wire_line(line)
    assert caught.value.code == "realtime-byte"


def test_lines_fit_the_buffer_of_80_with_newline():
    check_wire_line("X" * 79)
    with pytest.raises(ProgramError) as caught:
        prepare(
            "G0\nG1 X1.00000000000000001 Y1.0000000000000000001 Z1.0000000000000000001 F1.00000000000000001", file="f"
        )
    assert (caught.value.code, caught.value.place.line) == ("line-too-long", 2)


def test_a_refusal_names_its_place():
    with pytest.raises(ProgramError) as caught:
        prepare("G0 X1\nG0 X[1]", file="f.nc")
    assert str(caught.value).startswith("f.nc:2:4: expressions")


NUMBERS = st.decimals(min_value=-999, max_value=999, places=4).map(str)
WORDS = st.one_of(
    *(NUMBERS.map(lambda number, letter=letter: f"{letter}{number}") for letter in "XYZ"),
    st.sampled_from(["G0", "g1", "G01", "G90", "G91", "g 20", "G21", "F100", "f 5.50", "M3 S100", "m5", "M8", "(c)"]),
    st.sampled_from(["N7", "; tail", "(MSG, m)", "  ", "T2", "G4 P1", "G54", "G55", "M0", "G17", "/"]),
)
LINES = st.lists(st.lists(WORDS, max_size=4, unique_by=lambda word: word.strip()[:1]).map(" ".join), max_size=12)


@given(LINES)
@settings(max_examples=150, deadline=None)
def test_wire_and_file_are_the_same_program(lines):
    text = "\n".join(["G0 X0 Y0 Z0", *lines])
    try:
        of_file = interpret(text, Start.at_zero())
    except ProgramError:
        return
    wire = prepare(text)
    of_wire = interpret(wire.text, Start.at_zero())
    a, b = of_file.table(), of_wire.table()
    for name in ("kind", "end", "centre", "plane", "turns", "feed", "state"):
        assert np.array_equal(getattr(a, name), getattr(b, name)), name
    assert np.array_equal(a.line, wire.file_lines[b.line - 1])
    assert of_file.states == of_wire.states
    silent = ("comment", "message")
    assert [(e.kind, e.value) for e in of_file.events if e.kind not in silent] == [
        (e.kind, e.value) for e in of_wire.events
    ]
    assert prepare(wire.text).lines == wire.lines
