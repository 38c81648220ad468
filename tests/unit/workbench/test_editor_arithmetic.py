# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of the editor is only arithmetic: changes joined, marks that move with the text, the kinds of words."""

from __future__ import annotations

import random
from itertools import pairwise

import pytest

from CNCStepper.control.session.status import error_to_json
from CNCStepper.errors import Place, ProgramError
from CNCStepper.workbench.editor.model.error_marks import Change, Marks, joined, moved
from CNCStepper.workbench.editor.model.syntax_colours import BOLD, DARK, LIGHT, colours_on, spans_of, word_at


@pytest.mark.parametrize("seed", range(40))
def test_many_changes_joined_are_one_that_gives_the_same_text(seed: int) -> None:
    dice = random.Random(seed)
    told = [f"line {k}" for k in range(30)]
    present, change = list(told), None
    for step in range(dice.randint(1, 6)):
        first = dice.randint(0, len(present))
        removed = dice.randint(0, min(4, len(present) - first))
        new = [f"new {step}.{k}" for k in range(dice.randint(0, 4))]
        present[first : first + removed] = new
        change = joined(change, first, removed, len(new))
    assert change is not None
    again = list(told)
    again[change.first : change.first + change.removed] = present[change.first : change.first + change.added]
    assert again == present, f"seed {seed}: {change}"


def test_a_line_stands_elsewhere_after_a_change_above_it() -> None:
    assert [moved(line, first=4, removed=1, added=3) for line in (4, 5, 6, 9)] == [4, 5, 8, 11]
    assert [moved(line, first=4, removed=3, added=1) for line in (4, 6, 7, 8)] == [4, 5, 5, 6]
    assert joined(None, 3, 1, 2) == Change(3, 1, 2)


def refusal(line: int, column: int = 4) -> dict:
    return {**error_to_json(ProgramError("bad", f"line {line}", place=Place("", line, column))), "length": 2}


def test_marks_move_with_the_text_until_it_is_read_again() -> None:
    marks = Marks()
    marks.take([refusal(9), refusal(2), refusal(5)])
    marks.move(first=2, removed=1, added=3)
    assert [mark.line for mark in marks.all] == [2, 7, 11]
    assert [mark.line for mark in marks.between(3, 11)] == [7, 11] and marks.at(5) is None
    mark = marks.at(2)
    assert mark is not None and (mark.column, mark.length, mark.error.what) == (4, 2, "line 2")


@pytest.mark.parametrize(
    ("text", "kinds"),
    [
        ("N10 G01 X-1.5Y.2 F200 (slow)", "number motion axis axis feed comment"),
        ("g2x1 j-3 ; to the end G1", "motion axis centre comment"),
        ("G10 L2 P1 M6 T3", "code feed feed code feed"),
        ("o<deep> if [#<_x> GT 3]", "flow value value value value"),
        ("/G38.2 Z-5", "mark code axis"),
        ("%", "mark"),
        ("", ""),
    ],
)
def test_words_by_their_kinds(text: str, kinds: str) -> None:
    spans = spans_of(text)
    assert [span.kind for span in spans if span.kind != "value" or text[span.start] != " "] == kinds.split()
    assert all(before.start + before.length <= after.start for before, after in pairwise(spans))


def test_the_word_at_a_column() -> None:
    text = "g01 x 1.5 (Stop)"
    assert [word_at(text, column) for column in (0, 2, 3, 4, 8, 12)] == ["G01", "G01", "", "X1.5", "X1.5", "(Stop)"]


def test_both_themes_have_all_colours() -> None:
    assert LIGHT.keys() == DARK.keys() and set(BOLD) < LIGHT.keys()
    assert colours_on(250) is LIGHT and colours_on(30) is DARK
    kinds = {span.kind for text in ("N1G1X1I1F1(a)", "G2M6", "o1 if[#1]", "/G1") for span in spans_of(text)}
    assert kinds <= LIGHT.keys()
