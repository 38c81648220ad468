# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wire text means what the file means, and nothing else is on the wire."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.wire.encoder import CUT, MOST_MESSAGE, check_wire_line, prepare
from CNCStepper.gcode.wire.read_back import read_back
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


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "sent"),
    [
        ("X10\nG1 X2 F100\nM2\n", ("G0X10", "G1X2F100", "M2")),
        ("G21 G90\nG92 X0\nF100\nN5 (there) z5\nX2\n", ("G21G90", "G92X0", "F100", "G0Z5", "X2")),
        ("G90\nG53 Z0\nG1 X2 F100\n", ("G90", "G0G53Z0", "G1X2F100")),
        ("G1 F100\nX2\n", ("G1F100", "X2")),
        ("G4 P1\nM2\n", ("G4P1", "M2")),
    ],
)
@pytest.mark.parametrize("dialect", ["grbl", "fluidnc", "grblhal"])
def test_the_first_move_on_the_wire_names_its_motion(text, sent, dialect):
    long = text + 3000 * "(so that a kernel writes it)\n"
    start = Start.at_zero()
    for program in (text, long):
        wire = prepare(program, dialect, "a.nc", start)
        assert wire.lines == sent
        back, read = (read_back(wire, program, start, dialect), interpret(program, start, dialect))
        assert np.array_equal(back.table().end, read.table().end, equal_nan=True)
        assert np.array_equal(back.table().kind, read.table().kind)


def test_a_first_move_that_does_not_fit_with_its_motion_is_refused():
    line = "".join(f"{axis}1.{23 * '1'}" for axis in "XYZ")
    with pytest.raises(ProgramError) as refused:
        prepare(f"G21\n{line}\n", "grbl", "a.nc")
    assert refused.value.code == "line-too-long" and refused.value.place.line == 2


def test_the_wire_and_its_map():
    wire = prepare(FILE)
    assert wire.lines == ("G21G90", "G1X1.5Y0F100", "M0", "X2", "M2")
    assert wire.file_lines.tolist() == [3, 5, 8, 9, 10]
    assert wire.messages == {2: "turn the part"}
    assert wire.text == "G21G90\nG1X1.5Y0F100\nM0\nX2\nM2\n"
    assert len(wire.sha256) == 64 and wire.sha256 == prepare(wire.text).sha256


@pytest.mark.parametrize("count", [50, 51, 100, 5000])
def test_of_too_many_messages_at_one_line_the_last_are_told(count: int) -> None:
    told = [f"{k:04} " + 74 * "x" for k in range(count)]  # 79 characters, and the end of a line
    wire = prepare("".join(f"(MSG, {text})\n" for text in told) + "M0\n(MSG, next)\nM1\n")
    whole, cut = "\n".join(told), wire.messages[0]
    assert len(cut) == min(MOST_MESSAGE, len(whole)) and wire.messages[1] == "next"
    assert cut == whole if count == 50 else cut.startswith(CUT) and whole.endswith(cut.removeprefix(CUT))


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


MACRO = """(begin operation: slots)
G21 G90
#1 = 2.5
o1 sub
G1 X[#1 * #5] (a slot)
o1 endsub
o2 repeat [2]
#5 = [#5 + 1]
o1 call [#1]
o2 endrepeat
(finish operation: slots)
G1 Y[1 / 3] F100
M2
"""


@pytest.mark.parametrize("name", ["grblhal", "fluidnc"])
def test_loops_and_expressions_are_written_out_where_lines_are_sent(name):
    text = MACRO.replace("G1 X[#1 * #5] (a slot)", "G1 X[#1 * #<_n>] F50").replace("#5", "#<_n>")
    text = text.replace("#1 = 2.5", "#1 = 2.5 #<_n> = 0")
    wire = prepare(text, name)
    assert wire.lines == ("G21G90", "G1X2.5F50", "G1X5F50", "G1Y0.333333F100", "M2")
    assert wire.file_lines.tolist() == [2, 5, 5, 12, 13]
    back, of_file = read_back(wire, text, Start.at_zero(), name), interpret(text, Start.at_zero(), name)
    assert np.allclose(back.table().end, of_file.table().end, atol=1e-6)
    assert back.table().line.tolist() == of_file.table().line.tolist() == [5, 5, 12]
    assert [(span.name, span.first, span.last) for span in back.spans] == [("slots", 0, 2)]


def test_a_controller_that_reads_the_file_keeps_its_loops():
    text = MACRO.replace("#5", "#<_n>").replace("#1 = 2.5", "#1 = 2.5 #<_n> = 0").replace("M2", "(the end)\nM2")
    text = text.replace("G1 X[#1 * #<_n>] (a slot)", "G1 X[#1 * #<_n>] F50 (a slot)")
    wire = prepare(text, "linuxcnc")
    assert "o2 repeat [2]" in wire.lines and not any("(" in line for line in wire.lines)
    back, of_file = (
        each.table()
        for each in (read_back(wire, text, Start.at_zero(), "linuxcnc"), interpret(text, Start.at_zero(), "linuxcnc"))
    )
    assert np.array_equal(back.end, of_file.end) and len(back) == 3


NUMBERS = st.decimals(min_value=-999, max_value=999, places=4).map(str)
WORDS = st.one_of(
    *(NUMBERS.map(lambda number, letter=letter: f"{letter}{number}") for letter in "XYZ"),
    st.sampled_from(["G0", "g1", "G01", "G90", "G91", "g 20", "G21", "F100", "f 5.50", "M3 S100", "m5", "M8", "(c)"]),
    st.sampled_from(["N7", "; tail", "(MSG, m)", "  ", "T2", "G4 P1", "G54", "G55", "M0", "G17", "/"]),
)
LINES = st.lists(st.lists(WORDS, max_size=4, unique_by=lambda word: word.strip()[:1]).map(" ".join), max_size=12)


@pytest.mark.slow
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
