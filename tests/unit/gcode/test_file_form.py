# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program's file is written as it was found: letters, line ends, byte-order mark, rights, and whole or not at all."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from CNCStepper.gcode.file_form import BOM, decoded, write_whole

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


def test_a_file_keeps_its_rights(tmp_path: Path) -> None:
    path = tmp_path / "peça.nc"
    path.write_bytes(b"old")
    path.chmod(0o640)
    write_whole(path, b"new")
    assert path.read_bytes() == b"new"
    assert sys.platform == "win32" or path.stat().st_mode & 0o777 == 0o640
    assert os.listdir(tmp_path) == [path.name]


def test_what_fails_leaves_the_old_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "a.nc"
    path.write_bytes(b"old")

    def full(self: Path, data: bytes) -> int:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", full)
    with pytest.raises(OSError, match="No space"):
        write_whole(path, b"new")
    assert path.read_bytes() == b"old"
    assert os.listdir(tmp_path) == ["a.nc"]
