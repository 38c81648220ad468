# SPDX-License-Identifier: LGPL-2.1-or-later
"""Point lists: one "x,y" in mm a line, in drawing order; `#` comments and one heading line may precede.

Spreadsheets of countries with a decimal comma write "12,5;7,25": where a line has a semicolon, or
a tab, that is the separator and a comma the decimal point.
"""

from __future__ import annotations

import re
from pathlib import Path

from CNCStepper.errors import JobError, Place
from CNCStepper.geometry.curve import Curve, from_points

HEADING = re.compile(r"\s*x\w*\s*[,;\t]\s*y\w*\s*$", re.IGNORECASE)


def read_points(path: Path, closed: bool = False) -> Curve:
    """Return the polyline through the points of a file; raises JobError that names file and line."""
    if not path.is_file():
        raise JobError("points-missing", f"there is no point list '{path}'", advice="correct the path")
    try:
        text = path.read_text("utf-8-sig")
    except UnicodeDecodeError as error:
        raise JobError("points-text", "not a text file", place=Place(str(path))) from error
    points = [
        _point(line, Place(str(path), number))
        for number, line in enumerate(text.splitlines(), start=1)
        if line.strip() and not line.lstrip().startswith("#") and not HEADING.match(line)
    ]
    if len(points) < 2:
        raise JobError("points-few", "a line needs at least two points", value=str(len(points)), place=Place(str(path)))
    return from_points(points, closed)


def _point(line: str, place: Place) -> tuple[float, float]:
    separator = ";" if ";" in line else "\t" if "\t" in line else ","
    parts = [part.strip() for part in line.split(separator)]
    if separator != ",":
        parts = [part.replace(",", ".") for part in parts]
    try:
        x, y = (float(part) for part in parts[:2])
    except ValueError:
        raise JobError(
            "points-line", f"not a point: '{line.strip()[:40]}'", advice="write x,y in mm", place=place
        ) from None
    return x, y
