# SPDX-License-Identifier: LGPL-2.1-or-later
"""The single-line font for engraving: all of Latin-1, letters of their heights, marks that stand clear."""

from __future__ import annotations

import numpy as np
import pytest

from CNCStepper.drawing.text.stroke_font import find_stroke_font
from CNCStepper.drawing.text.text_curves import TextStyle, text_curves
from CNCStepper.errors import JobError
from CNCStepper.geometry.curve import Curve

LATIN_1 = [chr(code) for code in (*range(0x21, 0x7F), *range(0xA1, 0x100)) if code != 0xAD]
STYLE = TextStyle(single_line="engraving", height_mm=5.0)


def box(text: str) -> np.ndarray:
    """Return the box round a text of 5 mm."""
    boxes = np.array([curve.box_mm for curve in text_curves(STYLE, text, 0.005)])
    return np.array([*boxes[:, :2].min(axis=0), *boxes[:, 2:].max(axis=0)])


@pytest.mark.parametrize("letter", LATIN_1)
def test_every_letter_of_latin_1_is_drawn_between_its_bearings(letter: str) -> None:
    left, low, right, top = box(letter)
    glyph = find_stroke_font("engraving").glyph(letter)
    assert glyph is not None and left >= -0.3 and right <= glyph.advance * 0.25 + 0.3
    assert low >= -2.0 and top <= 7.0


@pytest.mark.parametrize("letter", "ABEHIMZ0")
def test_capitals_and_digits_are_as_high_as_asked(letter: str) -> None:
    _, low, _, top = box(letter)
    assert low == pytest.approx(0.0, abs=0.01) and top == pytest.approx(5.0, abs=0.01)


def test_letters_are_open_strokes_and_an_o_is_one_that_comes_round() -> None:
    assert [curve.closed for curve in text_curves(STYLE, "Lo", 0.005)] == [False, True]


@pytest.mark.parametrize("pair", ["ìí", "ÎÏ", "ãõ", "Ää"])
def test_marks_of_neighbours_do_not_cross(pair: str) -> None:
    one, other = (len(text_curves(STYLE, letter, 0.005)) for letter in pair)
    curves = text_curves(STYLE, pair, 0.005)
    assert len(curves) == one + other
    first, second = curves[:one], curves[one:]
    assert min(_apart_mm(a, b) for a in first for b in second) > 0.3


def _apart_mm(one: Curve, other: Curve) -> float:
    return float(one.distances_mm(other.points(0.01)).min())


def test_an_unknown_single_line_font_is_refused_with_those_there_are() -> None:
    with pytest.raises(JobError) as refusal:
        text_curves(TextStyle(single_line="gothic"), "a", 0.01)
    assert refusal.value.code == "font-unknown" and "engraving" in str(refusal.value.advice)
