# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers as people type and read them."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from CNCStepper.workbench.panels.number_input import LOST, Refused, shown, tidied


@pytest.mark.parametrize(
    ("typed", "read"),
    [
        ("12.5", "12.5"),
        ("12,5", "12.5"),
        (" 12,5  mm ", "12.5 mm"),
        (",5", ".5"),
        ("10,5 mm + 2.25 mm", "10.5 mm + 2.25 mm"),
        ("−3", "-3"),
        ("1\u00a0mm", "1 mm"),
        ('1/4"', '1/4"'),
        ("1 1/2 in", "(1+1/2) in"),
        ("3′ 4″", "3' 4\""),
        ("45º", "45°"),
        ("2 × 3 mm", "2 * 3 mm"),
        ("1 m 20 cm", "1 m 20 cm"),
    ],
)
def test_what_is_typed_is_read(typed: str, read: str) -> None:
    assert tidied(typed) == read


@pytest.mark.parametrize(
    ("typed", "word"),
    [
        ("", "missing"),
        ("   ", "missing"),
        ("mm", "no number"),
        ("deep", "no number"),
        ("1.234,5", "several decimal"),
        ("1,234.5", "several decimal"),
        ("1,2,3", "several decimal"),
        ("1.2.3 mm", "several decimal"),
        ("1..2", "several decimal"),
        ("2 mm + 1.234,5 mm", "several decimal"),
        ("12 mm²", "²"),
        ("１２ mm", "１"),
        ("12;5", ";"),
        ("5 €", "€"),
        ("__import__('os')#1", "#"),
    ],
)
def test_what_is_no_clear_number_is_refused_with_a_reason(typed: str, word: str) -> None:
    with pytest.raises(Refused, match=word):
        tidied(typed)


@given(st.text(max_size=30))
def test_any_text_is_read_or_refused(text: str) -> None:
    try:
        assert "," not in tidied(text)
    except Refused as refused:
        assert len(str(refused)) < 120


@pytest.mark.parametrize(
    ("value", "decimals", "text"),
    [
        (12.5, 2, "12.50"),
        (0.01, 2, "0.01"),
        (0.005, 2, "0.005"),
        (40 / 25.4, 2, "1.575"),
        (0.0, 3, "0.000"),
        (-0.0, 2, "0.00"),
        (-1e-9, 2, "0.000000"),
        (1000.0, 0, "1000"),
        (800.0, 9, "800.000000"),
    ],
)
def test_a_number_has_the_decimals_that_it_needs(value: float, decimals: int, text: str) -> None:
    assert shown(value, decimals) == text


def test_the_decimal_separator_is_the_user_s() -> None:
    assert shown(1234.5, 2, ",") == "1234,50"


@given(st.floats(0.01, 1e6), st.integers(0, 6))
def test_what_is_shown_is_nearly_the_value(value: float, decimals: int) -> None:
    assert float(tidied(shown(value, decimals, ","))) == pytest.approx(value, rel=LOST, abs=1e-6)
