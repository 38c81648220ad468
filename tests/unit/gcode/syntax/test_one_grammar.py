# SPDX-License-Identifier: LGPL-2.1-or-later
"""Who finds words in a text, to edit or to colour them, finds those that the interpreter reads, where it does."""

from __future__ import annotations

import re

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.edit.line_tokens import tokens_of
from CNCStepper.gcode.syntax.words import Word, split_line, words_of
from CNCStepper.workbench.editor.model.syntax_colours import spans_of

NUMBERS = st.from_regex(r"[+-]?([0-9]{1,4}(\.[0-9]{0,3})?|\.[0-9]{1,3})", fullmatch=True)
BLANKS = st.sampled_from(["", "", "", " ", "\t", "  "])
LETTERS = st.sampled_from("ABCDEFGHIJKLMNPQRSTUVWXYZgmxyzf@^$")
PIECES = st.one_of(
    st.tuples(LETTERS, BLANKS, NUMBERS, BLANKS).map("".join),
    st.tuples(LETTERS, BLANKS, NUMBERS, BLANKS).map("".join),
    st.sampled_from(["(G1 X2)", " (", "/", "1 2", ". 5", "+ 3"]),
)
WITHIN = re.compile(r"\)[ \t]*[-+0-9.]")  # a number that goes on behind a comment: read, but nobody writes it
LINES = st.lists(PIECES, max_size=6).map("".join).filter(lambda line: not WITHIN.search(line))


def read(line: str) -> list[Word]:
    """Return the words of a line as the interpreter reads it."""
    try:
        words = words_of(split_line(line).code)
    except ProgramError:
        words = []
    assume(words)
    return words


@pytest.mark.slow
@settings(max_examples=100, deadline=None)
@given(LINES)
def test_an_edit_finds_the_words_that_are_read(line: str) -> None:
    words, tokens = read(line), tokens_of(line)
    assert [(token.letter, token.number, token.begin + 1) for token in tokens] == [
        (word.letter, float(word.number), word.column) for word in words
    ]
    for token in tokens:
        assert float("".join(line[token.first : token.last].split())) == token.number


@pytest.mark.slow
@settings(max_examples=100, deadline=None)
@given(LINES)
def test_every_word_that_is_read_is_coloured_as_one(line: str) -> None:
    words = [word for word in read(line) if word.letter.isalpha()]
    coloured = {span.start + 1: line[span.start : span.start + span.length] for span in spans_of(line)}
    for word in words:
        assert "".join(coloured[word.column].split()).upper() == word.text
