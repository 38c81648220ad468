# SPDX-License-Identifier: LGPL-2.1-or-later
"""The heights of a stack: both ends alike, a section at the middle of each sheet and beside level faces."""

from __future__ import annotations

import pytest

from CNCStepper.drawing.solids.sheet_heights import (
    asked_slices,
    question_of,
    section_heights,
    sheet_begins,
    sheet_count,
)


def test_the_stack_is_as_high_as_the_solid_or_both_ends_stand_out_alike() -> None:
    assert sheet_begins(0.0, 4.0, 2.0) == [0.0, 2.0]
    assert sheet_begins(0.0, 5.0, 2.0) == pytest.approx([-0.5, 1.5, 3.5])
    assert sheet_count(0.0, 30.0 + 2e-7, 1.0) == 30 and sheet_count(0.0, 30.01, 1.0) == 31


def test_a_section_lies_beside_level_faces_and_within_the_solid() -> None:
    one, other = section_heights(0.0, 4.0, 2.0, levels=[1.0])
    assert 1.0 < one < 1.001 and other == 3.0
    assert section_heights(0.0, 1.0, 3.0, levels=[]) == [0.5]


def test_the_words_of_the_question_are_read_as_they_were_written() -> None:
    assert asked_slices(question_of("x", 0.1)) == ("x", 0.1)
    assert asked_slices("outline") is None and asked_slices("3.5") is None
