# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads a line whose dialect has a preprocessor: piece by piece, errors with their place in the line as written.

In a language of records each is a block of its own: what a refused one stands behind has been read.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Protocol

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.dialects.preprocessor import Piece, pieces
from CNCStepper.gcode.interpreter.state.model import Model
from CNCStepper.toolpath import TableBuilder

_WORD = re.compile(r"[A-Z][ \t]*[+-]?[0-9.]+", re.IGNORECASE)
_CODE = re.compile(r"([GM])[ \t]*([0-9.]+)", re.IGNORECASE)


class Reader(Protocol):
    """The line reader's interface for a preprocessor (`line_interpreter.py`)."""

    dialect: Dialect
    file: str
    line_number: int
    model: Model
    table: TableBuilder

    def forget_motion(self) -> None:
        """Let no motion be modal."""


def read_pieces(reader: Reader, line: str, read: Callable[[str], None]) -> None:
    """Read a line by `read`, which takes text in the form of RS274; raises ProgramError."""
    try:
        found = pieces(line, reader.dialect)
    except ProgramError as error:
        raise error.at(Place(reader.file, reader.line_number, error.place.column if error.place else 0)) from None
    for piece in found:
        try:
            read(piece.text)
        except ProgramError as error:
            raise _in_line(error, piece, line) from None
        if "records" in reader.dialect.front:
            _after_record(reader, piece)


def _in_line(error: ProgramError, piece: Piece, line: str) -> ProgramError:
    """Return the error with its column and its word as the line has them."""
    place = error.place or Place()
    column = piece.column(place.column)
    word = _WORD.match(line, column - 1) if column else None
    value = word[0] if word and error.value[:1] == word[0][0].upper() else error.value
    return ProgramError(
        error.code,
        error.what,
        advice=error.advice,
        value=value,
        limit=error.limit,
        place=Place(place.file, place.line, column),
    )


def _after_record(reader: Reader, piece: Piece) -> None:
    """A motion lasts until the next G or M; in absolute mode an axis without a word stays, with a warning."""
    code = piece.text.partition("(")[0].upper()
    names = {f"{letter}{float(number):g}" for letter, number in _CODE.findall(code)}
    known = [reader.dialect.codes[name] for name in names if name in reader.dialect.codes]
    if piece.ends_chunk or (known and all(one.group != "motion" for one in known)):
        reader.forget_motion()
    axes = [axis for axis in "XZ" if axis in code]
    if len(axes) == 1 and reader.model.absolute:
        absent = "XZ".replace(axes[0], "")
        what = Text(
            "{absent} is absent: the axis stays here, but the published control would drive it to 0", absent=absent
        )
        reader.table.event("warning", text=what, line=reader.line_number)
