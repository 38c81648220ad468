# SPDX-License-Identifier: LGPL-2.1-or-later
"""Words, comments and columns of a line."""

from __future__ import annotations

import random
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.syntax.words import (
    is_percent_mark,
    program_lines,
    scanned_codes,
    scanned_words,
    split_line,
    words_of,
)
from helpers.imports import modules


def test_blanks_may_stand_anywhere_and_columns_stay():
    words = words_of("g 0x +0. 12 34y 7")
    assert [(word.letter, word.number, word.column) for word in words] == [
        ("G", "0", 1),
        ("X", "+0.1234", 4),
        ("Y", "7", 15),
    ]


def test_comments_become_blanks_so_that_columns_stay():
    line = split_line("G1 (to the (left) X5 ; and so on")
    assert line.code == "G1                X5            "
    assert [comment.text for comment in line.comments] == ["to the (left", "and so on"]
    assert words_of(line.code)[1].column == 19


@pytest.mark.parametrize("text", ["(MSG, look)", "( msg,look)", "x1 (Msg, look)"])
def test_messages(text):
    (comment,) = split_line(text).comments
    assert comment.message and comment.text.strip() == "look"


def test_a_semicolon_inside_a_comment_does_not_end_the_line():
    line = split_line("G0 (a ; b) X1")
    assert [word.text for word in words_of(line.code)] == ["G0", "X1"]


def test_block_delete_and_tape_mark():
    assert split_line(" /G0 X1").deleted
    assert not split_line("G0 X1").deleted
    assert is_percent_mark(" % ") and not is_percent_mark("%1")


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_lines_are_counted_as_editors_count_them(end):
    text = "\ufeff" + end.join(["G0 X1\x0b", "(a\x85b)", "", "M2"]) + end
    assert program_lines(text) == ["G0 X1\x0b", "(a\x85b)", "", "M2"]


@pytest.mark.parametrize("number, value", [("1.", 1.0), (".5", 0.5), ("-.5", -0.5), ("+05.10", 5.1), ("-0", 0.0)])
def test_numbers(number, value):
    assert interpret(f"G0 X{number}").table().end[0, 0] == value


@given(st.text(max_size=60))
def test_any_text_is_read_or_refused_with_its_column(text):
    try:
        words = words_of(split_line(text).code)
    except ProgramError as error:
        assert 1 <= error.place.column <= len(text)
        return
    assert all(text[word.column - 1].upper() == word.letter for word in words)


@given(
    st.lists(
        st.sampled_from(["G1", "X1.5", "F9", "(c)", "/", "%", "M2", "T1", "é", "G92", "I2", "\n", " "]), max_size=25
    )
)
def test_any_program_is_read_or_refused_with_its_place(parts):
    text = "".join(parts)
    try:
        interpret(text)
    except ProgramError as error:
        assert error.place.line >= 1


@pytest.mark.parametrize(
    ("code", "codes"),
    [
        ("N10 g01 X1.5 m 3", {"G1", "M3"}),
        ("G59.10", {"G59.1"}),
        ("#<g5> = 2", set()),
        ("O<m3> CALL [1]", set()),
        ("G[1] M#2 X-3", set()),
        ("G1.X2", {"G1"}),
    ],
)
def test_codes_are_scanned_without_refusing(code: str, codes: set[str]) -> None:
    assert scanned_codes(code) == codes


def test_scanned_words_are_the_read_ones() -> None:
    seed = random.randrange(2**32)
    print("seed", seed)
    chance, blanks = random.Random(seed), 0
    for _ in range(300):
        words = [chance.choice("GMXYZFSTN") + f"{chance.uniform(-99, 99):.3f}" for _ in range(5)]
        code = "".join(chance.choice(["", " ", "\t"]) + chance.choice([word, word.lower()]) for word in words)
        blanks += " " in code
        assert scanned_words(code) == [(word.letter, word.number) for word in words_of(code)]
    assert blanks > 100


SCANNERS = {"CNCStepper.word_pattern"}  # of words that stand in no program: tool tables, answers, reports
_LETTER = re.compile(r"\(\[(?:A-Z|A-Za-z|GM)[@^$]*\][)|]")  # the group in which a scanner has a word's letter


def test_only_this_module_scans_words() -> None:
    found = {name for name, path in modules().items() if _LETTER.search(path.read_text("utf-8"))}
    ours = {name for name in found if not name.startswith(("CNCStepper.gcode.syntax.", "CNCStepper.virtual."))}
    assert ours == SCANNERS, "scan words with CNCStepper.gcode.syntax.words"
    assert "CNCStepper.gcode.syntax.words" in found
    assert _LETTER.search('re.compile(r"([GM])0*([0-9]+)")')
