# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines that are spelled differently: hostile text is refused with its place, and columns are those of the text."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects import dialect, dialect_names
from CNCStepper.gcode.dialects.preprocessor import pieces
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.syntax.words import program_lines
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.state import Start

FRONTED = [name for name in dialect_names() if dialect(name).front]
PARTS = st.sampled_from(
    [
        *("G00", "G01", "g1", "G04", "G4", "M0", "M117 ", "M30", "G90", "G91", "G20", "G70", "N10", "X1.", "X5000"),
        *("Z-2", "F1.", "f2500", "P2", "S1", "S.5", "#", "?", ";", "(", ")", "*", "*97", "%", ":12", "O1", "/", " "),
        *("\t", ".", "-", "ф", "\x00", "X", "1e5", "99999999999999999999", "\n", "\n", "G", "text", "!"),
    ]
)


@pytest.mark.parametrize("name", FRONTED)
@given(st.lists(PARTS, max_size=14).map("".join))
@settings(max_examples=120, deadline=None)
def test_hostile_text_ends_in_a_refusal_with_its_place(name, text):
    for read in (lambda: interpret(text, Start.at_zero(), name, "f"), lambda: prepare(text, name, "f")):
        try:
            read()
        except ProgramError as error:
            lines = program_lines(text)
            assert error.place and 0 <= error.place.line <= len(lines)
            assert error.place.column <= len(lines[max(error.place.line, 1) - 1]) + 1 if lines else True


@pytest.mark.parametrize("name", FRONTED)
@given(st.lists(PARTS, max_size=10).map("".join))
@settings(max_examples=80, deadline=None)
def test_each_character_of_a_piece_has_its_column(name, text):
    for line in program_lines(text):
        try:
            found = pieces(line, dialect(name))
        except ProgramError:
            continue
        for piece in found:
            assert len(piece.columns) == len(piece.text)
            assert all(1 <= column <= len(line) for column in piece.columns)
            assert list(piece.columns) == sorted(piece.columns)


@pytest.mark.parametrize(
    ("name", "line", "expected"),
    [
        ("mini-lathe", "N10 X5000 # G01 Z-1. F2.5 #", ["N10 X0.5000 ", " G01 Z-1. F150.0 "]),
        ("mini-lathe", "X-5 ; a (b) #?", ["X-0.0005 (a [b])", ""]),
        ("marlin", "G4 P1 S2 ; wait", ["G4  P2000 ; wait"]),
        ("marlin", "M117 Ready", ["(MSG, Ready)"]),
        ("iso", "N20 G04 U1.5", ["N20 G04 P1.5"]),
        ("iso", "%1234", ["%"]),
    ],
)
def test_what_the_grammar_gets_to_see(name, line, expected):
    assert [piece.text for piece in pieces(line, dialect(name))] == expected
