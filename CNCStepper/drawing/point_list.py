# SPDX-License-Identifier: LGPL-2.1-or-later
"""Point lists: one "x,y" in mm a line, in drawing order; `#` begins a comment, a heading "x,y" is passed over.

Spreadsheets of countries with a decimal comma write "12,5;7,25": where a line has a semicolon, or
a tab, that is the separator and a comma the decimal point.

Height fields: the heights of a surface in mm, one row of points a line, from the front (lowest Y) to the back.

Values are separated by commas, tabs or blanks; where a line has a semicolon, that is the separator and a comma the
decimal point. `#` begins a comment.
"""

from __future__ import annotations

import re
from pathlib import Path

from CNCStepper.errors import JobError, Place, Text
from CNCStepper.geometry.curve import LIMIT_MM, Curve, from_points
from CNCStepper.input_file import read_input
from CNCStepper.quantities import MOST_ITEMS

HEADING = re.compile(r"\W*x[^,;\t]*[,;\t]\W*y[^,;\t]*$", re.IGNORECASE)
LONGEST_HEADING = 200
NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)(e[+-]?\d+)?", re.IGNORECASE | re.ASCII)


def read_points(path: Path, closed: bool = False) -> Curve:
    """Return the polyline through the points of a file; raises JobError that names file and line."""
    lines = [line.split("#")[0].strip() for line in _text(path).splitlines()]
    _require_few(sum(map(bool, lines)), Place(str(path)))
    points = [
        _point(line, Place(str(path), number))
        for number, line in enumerate(lines, start=1)
        if line and not (len(line) <= LONGEST_HEADING and HEADING.match(line))
    ]
    different = len(set(points))
    if different < 2:
        raise JobError(
            "points-few",
            "a line needs at least two different points",
            value=str(different),
            limit="2",
            advice="write one x,y in mm a line",
            place=Place(str(path)),
        )
    return from_points(points, closed)


def _require_few(count: int, place: Place) -> None:
    """Raise JobError for more lines than a list of points may have."""
    if count > (most := MOST_ITEMS["points"]):
        value, limit, advice = f"{count}", f"{most}", "give fewer points"
        raise JobError("points-many", "too many points", value=value, limit=limit, advice=advice, place=place)


def _text(path: Path) -> str:
    content = read_input(path)
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise JobError("points-text", "not a text file", advice="save it as UTF-8", place=Place(str(path))) from error


def _point(line: str, place: Place) -> tuple[float, float]:
    separator = ";" if ";" in line else "\t" if "\t" in line else ","
    parts = [part.strip() for part in line.split(separator)]
    if separator != ",":
        parts = [part.replace(",", ".") for part in parts]
    if len(parts) != 2 or not all(NUMBER.fullmatch(part) for part in parts):
        raise JobError(
            "points-line",
            Text("not a point: '{line}'", line=line[:40]),
            advice="write x,y in mm, or x;y where the comma is the decimal sign",
            place=place,
        )
    x, y = (float(part) for part in parts)
    if max(abs(x), abs(y)) > LIMIT_MM:
        raise JobError(
            "points-far",
            "a point is too far away",
            value=line[:40],
            limit=f"{LIMIT_MM:g} mm",
            advice="write mm",
            place=place,
        )
    return x, y


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
