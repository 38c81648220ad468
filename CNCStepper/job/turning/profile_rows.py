# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows of a profile as lines of text, as a panel shows them and a document keeps them.

    24; -30                    X; Z
    24; -30; fillet 2          the corner there: chamfer or fillet
    50; -67; ccw radius 7      how it is reached: cw or ccw, radius
    50; -67; cw centre 36 -67  or the centre's X and Z

A number may have a decimal comma. Written lines have all digits.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Any

from CNCStepper.errors import JobError, Place, Text, placed
from CNCStepper.job.turning.profile_form import Corner

NUMBER = r"([-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?)"
WORDS = (
    (re.compile(rf"(chamfer|fillet) {NUMBER}"), lambda found: {f"{found[1]}_mm": float(found[2])}),
    (re.compile(rf"(cw|ccw) radius {NUMBER}"), lambda found: {"arc": found[1], "radius_mm": float(found[2])}),
    (
        re.compile(rf"(cw|ccw) centre {NUMBER} {NUMBER}"),
        lambda found: {"arc": found[1], "centre": (float(found[2]), float(found[3]))},
    ),
)


def content_of_lines(lines: Iterable[str]) -> list[Any]:
    """Return the rows of a profile as a job file has them; raises JobError that names the line."""
    kept = [line for line in lines if line.strip()]
    found = []
    for number, line in enumerate(kept, start=1):
        with placed(Place(Text("row {number}", number=number))):
            found.append(_content(line))
    return found


def _content(line: str) -> Any:
    parts = [" ".join(part.replace(",", ".").split()) for part in line.split(";")]
    if len(parts) < 2 or not all(re.fullmatch(NUMBER, part) for part in parts[:2]):
        what = Text("'{line}' is no row of a profile", line=line.strip()[:60])
        raise JobError("profile-row", what, advice="write X; Z, then for example chamfer 1 or ccw radius 7")
    place = (float(parts[0]), float(parts[1]))
    more: dict[str, Any] = {}
    for part in filter(None, parts[2:]):
        more |= _more(part, line)
    return {"to": place, **more} if more else place


def _more(part: str, line: str) -> dict[str, Any]:
    for pattern, content in WORDS:
        if found := pattern.fullmatch(part):
            return content(found)
    what = Text("'{part}' in '{line}' says nothing of a corner or an arc", part=part[:40], line=line.strip()[:60])
    advice = "write chamfer, fillet, cw radius, ccw radius or cw centre with their numbers"
    raise JobError("profile-row", what, advice=advice)


def lines_of(rows: Iterable[Any]) -> list[str]:
    """Return rows, as a job file has them or checked, as lines of text with all digits."""
    return [_line(_corner(row)) for row in rows]


def _corner(row: Any) -> Corner:
    if isinstance(row, Corner):
        return row
    return Corner(**row) if isinstance(row, dict) else Corner(to=row)


def _line(row: Corner) -> str:
    parts = [_number(row.to[0]), _number(row.to[1])]
    if row.radius_mm is not None:
        parts.append(f"{row.arc} radius {_number(row.radius_mm)}")
    if row.centre is not None:
        parts.append(f"{row.arc} centre {_number(row.centre[0])} {_number(row.centre[1])}")
    parts += [f"chamfer {_number(row.chamfer_mm)}"] if row.chamfer_mm else []
    parts += [f"fillet {_number(row.fillet_mm)}"] if row.fillet_mm else []
    return "; ".join(parts)


def _number(value: float) -> str:
    return repr(value).removesuffix(".0")


def in_x(content: Iterable[Any], factor: float) -> list[Any]:
    """Return rows as a job file has them with all X multiplied: 2 from radius to diameter, 0.5 back."""
    return [_in_x(row, factor) for row in content]


def _in_x(row: Any, factor: float) -> Any:
    if not isinstance(row, dict):
        return (row[0] * factor, row[1])
    places = {key: (row[key][0] * factor, row[key][1]) for key in ("to", "centre") if row.get(key) is not None}
    return row | places
