# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program's file read in pieces is the program read whole, with progress and cancel.

A file's text in pieces is the same as whole, whatever its encoding, its ends of lines and the size of a piece.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter import program_file
from CNCStepper.gcode.interpreter.fast_path import policy
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.interpreter.program_file import FileReading, interpret_file, text_pieces
from CNCStepper.gcode.syntax.text_format import BOM, decoded
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath
from helpers.gcode.fast_path_programs import COLUMNS, PlainPrograms

ZERO = Start.at_zero()
LOOP = "G0 X0 F100\n#1=0\no1 while [#1 LT 3]\n#1=[#1+1]\nG1 X#1\no1 endwhile\nX7\nM2\n"


def rows(path: Toolpath) -> list[bytes]:
    table = path.table()
    return [getattr(table, name).tobytes() for name in COLUMNS]


def check(file: Path, text: str, dialect: str) -> None:
    whole, pieces = interpret(text, ZERO, dialect, str(file)), interpret_file(file, ZERO, dialect)
    assert rows(pieces) == rows(whole)
    assert (pieces.states, pieces.events, pieces.spans) == (whole.states, whole.events, whole.spans)


@pytest.mark.parametrize("pays", [0, 1 << 30])
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("piece", [7, 64, 1000])
def test_pieces_of_any_size_give_the_table_of_the_whole(
    piece: int, end: str, pays: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(program_file, "PIECE", piece)
    monkeypatch.setattr(policy, "PAYS", pays)
    monkeypatch.setattr(policy, "PAYS_WITH_LOADING", pays)
    writer = PlainPrograms(piece, "grbl", ZERO)
    writer.program(150)
    reader = interpret_lines(writer.lines)
    text = end.join(reader) + end
    file = tmp_path / "peça.nc"
    file.write_bytes(text.encode("utf-8"))
    check(file, text, "grbl")
    file.write_bytes(b"\xef\xbb\xbf" + text.encode("utf-8"))
    check(file, text, "grbl")


def interpret_lines(lines: list[str]) -> list[str]:
    """Return the lines that are not refused, with a comment that is not ASCII."""
    from CNCStepper.gcode.interpreter.line_interpreter import Interpreter

    reader, good = Interpreter(ZERO), []
    for line in ["(peça)", *lines]:
        try:
            reader.line(line)
        except ProgramError:
            continue
        good.append(line)
    assert len(good) > 60
    return good


def test_a_file_that_is_no_utf_8_is_latin_1(tmp_path: Path) -> None:
    file = tmp_path / "a.nc"
    file.write_bytes("(peça)\nG0 X1\n(fin)".encode("latin-1"))
    assert interpret_file(file).events[0].text == "peça"


@pytest.mark.parametrize("piece", [16, 1 << 20])
def test_what_comes_after_plain_lines_may_lead_elsewhere(
    piece: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(program_file, "PIECE", piece)
    monkeypatch.setattr(policy, "PAYS", 0)
    file = tmp_path / "loop.ngc"
    file.write_text(LOOP, "ascii")
    assert interpret_file(file, ZERO, "linuxcnc").table().end[:, 0].tolist() == [0, 1, 2, 3, 7]
    check(file, LOOP, "linuxcnc")


def test_a_refusal_names_line_and_column_of_the_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(program_file, "PIECE", 32)
    file = tmp_path / "bad.nc"
    file.write_text("G0 X0 F100\n" + "G1 X1\n" * 40 + "G1 X2 Q1\n", "ascii")
    with pytest.raises(ProgramError) as caught:
        interpret_file(file)
    assert (caught.value.place.file, caught.value.place.line, caught.value.place.column) == (str(file), 42, 7)


def test_it_tells_how_far_it_is_and_can_be_cancelled(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(program_file, "PIECE", 1000)
    file = tmp_path / "long.nc"
    file.write_text("G0 X0 F100\n" + "G1 X1\nX2\n" * 2000, "ascii")
    shares: list[float] = []
    assert len(interpret_file(file, ZERO, progress=shares.append)) == 4001
    assert shares == sorted(shares) and shares[0] < 0.1 and shares[-1] == 1.0 and len(shares) > 10
    shares.clear()
    with pytest.raises(ProgramError) as caught:
        interpret_file(file, ZERO, progress=shares.append, cancelled=lambda: bool(shares and shares[-1] > 0.5))
    assert caught.value.code == "cancelled" and 0.5 < shares[-1] < 0.6


def test_a_stream_gives_whole_chunks_and_keeps_none(tmp_path: Path) -> None:
    file = tmp_path / "stream.nc"
    file.write_text("G0 X0 F100\n" + "G1 X1\nX2\n" * 70_000, "ascii")
    reading = FileReading(file, ZERO)
    lengths = [len(chunk) for chunk in reading.chunks()]
    assert lengths == [65_536, 65_536, 140_001 - 2 * 65_536]
    assert reading.interpreter.table.take() == []


contents = st.binary(max_size=60) | st.text("Gç1\r\n\x85\u2028", max_size=60).map(str.encode)


@given(content=contents, mark=st.sampled_from([b"", BOM]), piece=st.integers(len(BOM), 20))
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
def test_pieces_are_the_text_in_whole_lines(tmp_path: Path, content: bytes, mark: bytes, piece: int) -> None:
    file = tmp_path / "peça.nc"
    file.write_bytes(mark + content)
    with pytest.MonkeyPatch.context() as here:
        here.setattr(program_file, "PIECE", piece)
        pieces = list(text_pieces(file))
    assert "".join(pieces) == decoded(mark + content)[0]
    assert all(before.endswith(("\n", "\r")) for before in pieces[:-1])


def test_little_is_read_at_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "long.nc"
    file.write_text("G1 X1\n" * 1000, encoding="ascii")
    monkeypatch.setattr(program_file, "PIECE", 100)
    assert max(map(len, text_pieces(file))) <= 106
