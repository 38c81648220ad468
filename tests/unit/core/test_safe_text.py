# SPDX-License-Identifier: LGPL-2.1-or-later
"""Text from outside is shown without what drives a terminal."""

from __future__ import annotations

import unicodedata

import pytest
from hypothesis import given
from hypothesis import strategies as st

from CNCStepper.safe_text import printable


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("[MSG:\x1b]0;owned\x07]", "[MSG:\\x1b]0;owned\\x07]"),
        ("a\tb\r\nc", "a b\\x0d\\x0ac"),
        ("peça ã 日本", "peça ã 日本"),
        ("\x9b31m", "\\x9b31m"),
        ("gnp\u202ecod", "gnp\\u202ecod"),
        ("\ud800", "\\ud800"),
        ("x" * 3000, "x" * 2000 + "…"),
    ],
)
def test_control_characters_become_visible(text: str, shown: str) -> None:
    assert printable(text) == shown


@given(st.text(alphabet=st.characters(), max_size=50))
def test_nothing_that_drives_a_terminal_is_left(text: str) -> None:
    shown = printable(text)
    assert not {unicodedata.category(character) for character in shown} & {"Cc", "Cf", "Cs", "Zl", "Zp"}
    shown.encode("utf-8")
