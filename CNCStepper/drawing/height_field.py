# SPDX-License-Identifier: LGPL-2.1-or-later
"""Height fields: the heights of a surface in mm, one row of points a line, from the front (lowest Y) to the back.

Values are separated by commas, tabs or blanks; where a line has a semicolon, that is the separator and a comma the
decimal point. `#` begins a comment.
"""

from __future__ import annotations

from pathlib import Path

from CNCStepper.errors import JobError, Place, Text
from CNCStepper.input_file import read_input

Heights = tuple[tuple[float, ...], ...]


def read_heights(path: Path) -> Heights:
    """Return the rows of a file, each along X; raises JobError that names file and line."""
    try:
        lines = read_input(path).decode("utf-8-sig").splitlines()
    except UnicodeDecodeError as error:
        what = Text("the heights cannot be read: {reason}", reason=error.reason)
        raise JobError("heights-text", what, advice="save the file as UTF-8 text", place=Place(str(path))) from error
    rows = [_row(text, Place(str(path), number)) for number, text in enumerate(lines, start=1)]
    kept = tuple(row for row in rows if row)
    if len({len(row) for row in kept}) > 1:
        wrong, advice = "the lines have different numbers of heights", "give every line as many"
        raise JobError("heights-rows", wrong, advice=advice, place=Place(str(path)))
    return kept


def _row(text: str, place: Place) -> tuple[float, ...]:
    plain = text.partition("#")[0].strip()
    plain = plain.replace(",", ".").replace(";", " ") if ";" in plain else plain.replace(",", " ")
    try:
        return tuple(float(word) for word in plain.split())
    except ValueError as error:
        raise JobError("heights-number", str(error), advice="write numbers in mm", place=place) from error
