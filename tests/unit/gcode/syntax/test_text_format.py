# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program's file is written as it was found: letters, line ends, byte-order mark."""

from __future__ import annotations

import pytest

from CNCStepper.gcode.syntax.text_format import BOM, decoded

TEXT = "(furação)\nG0 X1\n"


@pytest.mark.parametrize(("encoding", "mark"), [("utf-8", b""), ("utf-8", BOM), ("latin-1", b"")])
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_what_is_read_is_written_again_to_the_byte(encoding: str, end: str, mark: bytes) -> None:
    data = mark + TEXT.replace("\n", end).encode(encoding)
    text, form = decoded(data)
    assert text == TEXT.replace("\n", end)
    assert form.encoded(text) == data
    assert form.bytes_of(TEXT) == data


def test_a_letter_that_latin_1_lacks_makes_it_utf_8() -> None:
    _, form = decoded(TEXT.encode("latin-1"))
    assert form.bytes_of("(€)\n") == "(€)\n".encode()
