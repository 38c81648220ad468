# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program's file in pieces of whole lines, so that its text need not be held whole."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

from CNCStepper.errors import Place
from CNCStepper.gcode.interpreter.fast_path.policy import PIECE
from CNCStepper.gcode.syntax.text_format import BOM
from CNCStepper.gcode.syntax.words import require_short


def text_pieces(path: Path) -> Iterator[str]:
    """Yield the text of a file as `text_format.decoded` gives it whole."""
    encoding = encoding_of(byte_pieces(path))
    for piece in byte_pieces(path, BOM):
        yield piece.decode(encoding)


def byte_pieces(path: Path, mark: bytes = b"") -> Iterator[bytes]:
    """Yield the bytes of a file, without the mark before them, if it is there.

    Raises ProgramError for a line that is longer than any program's.
    """
    rest = b""
    with path.open("rb") as file:
        while piece := file.read(PIECE):
            rest = (rest + piece).removeprefix(mark)
            mark = b""
            end = _end_of_lines(rest)
            if end:
                yield rest[:end]
            rest = rest[end:]
            if len(rest) > PIECE:
                require_short(len(rest), Place(str(path)))
    if rest:
        yield rest


def encoding_of(pieces: Iterable[bytes]) -> str:
    """Return the encoding of whole lines: UTF-8, or Latin-1 where they cannot be that."""
    return "utf-8" if all(map(_is_utf_8, pieces)) else "latin-1"


def _end_of_lines(data: bytes) -> int:
    """Return where the last whole line of `data` ends; a CR at the very end may belong to a LF that follows."""
    return data.rfind(b"\n") + 1 or data.rfind(b"\r", 0, -1) + 1


def _is_utf_8(piece: bytes) -> bool:
    if piece.isascii():
        return True
    try:
        piece.decode("utf-8")
    except UnicodeDecodeError:
        return False
    return True
