# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Indexable inserts by their ISO 1832 code, and threading inserts by the code that their makers share.

    C  N  M  G   12     04        08            16  E  R   1.5 ISO
    |  |  |  |   |      |         |             |   |  |   `-- pitch in mm (or AG60: a range) and profile
    |  |  |  |   |      |         `-- nose 0.8  |   |  `-- right hand          of a threading insert
    |  |  |  |   |      `-- thickness 4.76      |   `-- external, I internal
    |  |  |  |   `-- edge 12.9 mm               `-- edge 16.5 mm: inscribed circle 9.525
    |  |  |  `-- fixing and chip breaker (not used)
    |  |  `-- tolerance class (not used)
    |  `-- clearance angle 0
    `-- shape: rhombus of 80 degrees

The edge's number is its whole millimetres; the inscribed circle behind it is one of the standard's.
"""

from __future__ import annotations

import functools
import math
import re
from dataclasses import dataclass

from CNCStepper.errors import JobError, Text

NOSE_ANGLES_DEG = {"C": 80.0, "D": 55.0, "E": 75.0, "K": 55.0, "M": 86.0, "S": 90.0, "T": 60.0, "V": 35.0, "W": 80.0}
RHOMBUSES = frozenset("CDEKMVS")
CLEARANCES_DEG = {"A": 3.0, "B": 5.0, "C": 7.0, "D": 15.0, "E": 20.0, "F": 25.0, "G": 30.0, "N": 0.0, "P": 11.0}
THICKNESSES_MM = {
    "01": 1.59, "T1": 1.98, "02": 2.38, "T2": 2.78, "03": 3.18, "T3": 3.97, "04": 4.76, "05": 5.56, "06": 6.35,
    "07": 7.94, "09": 9.52, "12": 12.7,
}  # fmt: skip
CIRCLES_MM = (3.97, 4.76, 5.56, 6.35, 7.94, 9.525, 12.7, 15.875, 19.05, 25.4, 31.75)
TRIGON_EDGE = 0.6845  # edge of a W insert by its inscribed circle
PROFILES_DEG = {"ISO": 60.0, "UN": 60.0, "W": 55.0, "BSPT": 55.0, "NPT": 60.0, "TR": 30.0, "ACME": 29.0}
SHORT_OF_WHOLE_MM = 0.01  # T11 has an edge of 10.998 mm

_CODE = re.compile(
    r"([A-Z]{4})\s*(\d\d)(\d\d|T\d)(\d\d|M0)(?:[\s\-/].*|[A-Z]{1,4}(?:[\s\-/].*)?)?",
)
_THREAD = re.compile(r"(06|08|11|16|22|27)\s*([EI])([RL])\s*(?:(\d+(?:\.\d+)?)\s*(ISO|TR)|(AG?|G|N)(55|60))")


@dataclass(frozen=True)
class Insert:
    """An insert: its shape's letter, the angle at its nose, clearance, edge, thickness, nose radius; lengths in mm.

    circle_mm: the inscribed circle; of a round insert its diameter, with an edge of 0. A threading insert has the shape
    "thread", the angle of its profile, and `pitch_mm` where it is of one pitch; hand and side only it names.
    """

    code: str
    shape: str
    nose_deg: float
    clearance_deg: float
    circle_mm: float
    edge_mm: float
    thickness_mm: float
    nose_radius_mm: float
    pitch_mm: float = 0.0
    inside: bool = False
    hand: str = ""


@functools.cache
def insert_of(code: str) -> Insert:
    """Return the insert of an ISO 1832 code such as "CNMG 120408" or of a threading insert such as "16ER 1.5 ISO".

    Raises JobError that says which letter or number of the code is not of the standard.
    """
    text = " ".join(code.upper().split())
    if match := _THREAD.fullmatch(text):
        return _threading(text, match)
    if not (match := _CODE.fullmatch(text)):
        what = Text("'{code}' is no insert of ISO 1832", code=code[:40])
        raise JobError("insert-code", what, advice="write four letters and six digits, for example CNMG 120408")
    letters, edge, thickness, nose = match.groups()
    shape, clearance = letters[0], letters[1]
    _require(shape in NOSE_ANGLES_DEG or shape == "R", code, "shape", shape, f"{', '.join(NOSE_ANGLES_DEG)}, R")
    _require(clearance in CLEARANCES_DEG, code, "clearance", clearance, ", ".join(CLEARANCES_DEG))
    _require(thickness in THICKNESSES_MM, code, "thickness", thickness, ", ".join(THICKNESSES_MM))
    given = (CLEARANCES_DEG[clearance], THICKNESSES_MM[thickness])
    if shape == "R":
        circle_mm = float(edge) if nose == "M0" else _round_circle(code, edge)
        return Insert(text, shape, 0.0, given[0], circle_mm, 0.0, given[1], circle_mm / 2)
    _require(nose != "M0", code, "nose radius", nose, "00 to 99, in tenths of a mm")
    circle_mm = _circle(shape, int(edge))
    _require(circle_mm > 0, code, "edge", edge, _edges(shape))
    edge_mm = edge_of(shape, circle_mm)
    return Insert(text, shape, NOSE_ANGLES_DEG[shape], given[0], circle_mm, edge_mm, given[1], int(nose) / 10)


def edge_of(shape: str, circle_mm: float) -> float:
    """Return the length in mm of the edges of an insert with that inscribed circle."""
    if shape == "T":
        return circle_mm * math.sqrt(3.0)
    if shape == "W":
        return circle_mm * TRIGON_EDGE
    return circle_mm / math.sin(math.radians(NOSE_ANGLES_DEG[shape]))


def _threading(text: str, match: re.Match[str]) -> Insert:
    size, side, hand, pitch, profile, _, angle = match.groups()
    nose_deg = PROFILES_DEG[profile] if profile else float(angle)
    circle_mm = _circle("T", int(size))
    hands = {"R": "right", "L": "left"}
    edge_mm, own = edge_of("T", circle_mm), (float(pitch or 0.0), side == "I", hands[hand])
    return Insert(text, "thread", nose_deg, 0.0, circle_mm, edge_mm, 0.0, 0.0, *own)


def _circle(shape: str, edge: int) -> float:
    """Return the standard's largest circle whose edge has so many whole millimetres, 0 for none."""
    return next((c for c in reversed(CIRCLES_MM) if int(edge_of(shape, c) + SHORT_OF_WHOLE_MM) == edge), 0.0)


def _round_circle(code: str, edge: str) -> float:
    """Return the diameter of a round insert whose size counts the inch's circles: 09 is 9.525 mm."""
    circle_mm = next((circle for circle in CIRCLES_MM if int(circle) == int(edge)), 0.0)
    _require(circle_mm > 0, code, "size", edge, ", ".join(f"{int(circle):02d}" for circle in CIRCLES_MM))
    return circle_mm


def _edges(shape: str) -> str:
    numbers = (int(edge_of(shape, circle) + SHORT_OF_WHOLE_MM) for circle in CIRCLES_MM)
    return ", ".join(dict.fromkeys(f"{number:02d}" for number in numbers))


def _require(holds: bool, code: str, name: str, value: str, limit: str) -> None:
    if not holds:
        what = Text("the insert '{code}' has no {name} of ISO 1832", code=code[:40], name=name)
        raise JobError("insert-code", what, value=value, limit=limit, advice="correct the insert's code")
