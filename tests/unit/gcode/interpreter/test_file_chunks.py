# SPDX-License-Identifier: LGPL-2.1-or-later
"""A file's text in pieces is the same as whole, whatever its encoding, its ends of lines and the size of a piece."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from CNCStepper.gcode.interpreter import file_chunks
from CNCStepper.gcode.interpreter.file_chunks import text_pieces
from CNCStepper.gcode.syntax.text_format import BOM, decoded

contents = st.binary(max_size=60) | st.text("Gç1\r\n\x85\u2028", max_size=60).map(str.encode)


@given(content=contents, mark=st.sampled_from([b"", BOM]), piece=st.integers(len(BOM), 20))
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
def test_pieces_are_the_text_in_whole_lines(tmp_path: Path, content: bytes, mark: bytes, piece: int) -> None:
    file = tmp_path / "peça.nc"
    file.write_bytes(mark + content)
    with pytest.MonkeyPatch.context() as here:
        here.setattr(file_chunks, "PIECE", piece)
        pieces = list(text_pieces(file))
    assert "".join(pieces) == decoded(mark + content)[0]
    assert all(before.endswith(("\n", "\r")) for before in pieces[:-1])


def test_little_is_read_at_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "long.nc"
    file.write_text("G1 X1\n" * 1000, encoding="ascii")
    monkeypatch.setattr(file_chunks, "PIECE", 100)
    assert max(map(len, text_pieces(file))) <= 106
