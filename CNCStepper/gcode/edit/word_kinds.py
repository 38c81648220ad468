# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kind of number in each word of a line, so that a verb knows which to change.

place    a coordinate of a place: X Y Z of G0, G1, G81 ... (under G91 the way to it)
centre   I J K of an arc: from its begin, or a place under G90.1
vector   a way in the plane whatever the mode: control points of G5
radius   R of an arc                       height   R of a canned cycle, along the plane's normal
depth    a length along the normal: Q      machine  a place of the machine, not of the work: with G53
here     the name that the tool's place is to have: G92, G10 L20
length   a length that has nothing to do with the path: G43.1 Z, G10 L2, G64 P
feed     F
"""

from __future__ import annotations

from CNCStepper.canned_drilling import CYCLE_NAMES
from CNCStepper.gcode.dialects.codes import AXES
from CNCStepper.gcode.edit.line_tokens import Token

OTHER_AXES = "ABCUVW"
LINEAR_AXES = "XYZUVW"
PLACES = dict.fromkeys(AXES, "place")
CANNED = ("G81", "G82", "G83", "G73", "G74", "G84", "G85", "G86", "G88", "G89", *CYCLE_NAMES)
_LENGTHS = dict.fromkeys(LINEAR_AXES, "length")

_OF_MOTION: dict[str, dict[str, str]] = {
    "G0": PLACES,
    "G1": PLACES,
    "G2": PLACES | dict.fromkeys("IJK", "centre") | {"R": "radius"},
    "G3": PLACES | dict.fromkeys("IJK", "centre") | {"R": "radius"},
    "G5": PLACES | dict.fromkeys("IJPQ", "vector"),
    "G5.1": PLACES | dict.fromkeys("IJ", "vector"),
    "G33": PLACES | {"K": "length"},
    "G33.1": PLACES | {"K": "length"},
    "G80": {},
    **{f"G38.{way}": PLACES for way in range(2, 6)},
    **{name: PLACES | {"R": "height", "Q": "depth"} for name in CANNED},
}
_OF_CODE: dict[str, dict[str, str]] = {
    "G28": PLACES,
    "G30": PLACES,
    "G43.1": _LENGTHS,
    "G41.1": {"D": "length"},
    "G42.1": {"D": "length"},
    "G52": _LENGTHS,
    "G64": dict.fromkeys("PQ", "length"),
    "G92": dict.fromkeys(LINEAR_AXES, "here"),
}
_USE_AXES = frozenset(("G10", "G28", "G30", "G43.1", "G52", "G92"))
_NOT_EDITED = frozenset(("", "G5.2", "G5.3", "G76", "G87", "G96", "@", "^"))  # "": a code by an expression


def owner(tokens: list[Token], motion: str) -> str:
    """Return the code that uses the axis words of a line: one of its own, else the motion in force."""
    names = [token.name for token in tokens]
    return next((name for name in names if name in _USE_AXES), motion)


def kinds(tokens: list[Token], motion: str) -> dict[str, str] | None:
    """Return the kind of each word that holds a length, by its letter; None where a code of the line is not known."""
    names = [token.name for token in tokens]
    who = owner(tokens, motion)
    if any(name in _NOT_EDITED for name in (*names, who)):
        return None
    found: dict[str, str] = {}
    if who == "G10":
        found = _of_g10(tokens)
    elif who in _USE_AXES:
        found = _OF_CODE[who]
    elif any(token.letter in "XYZIJKR" for token in tokens):
        if who not in _OF_MOTION:
            return None
        found = _OF_MOTION[who]
    for name in names:
        found = found | (_OF_CODE.get(name, {}) if name not in _USE_AXES else {})
    if "G53" in names:
        found = found | dict.fromkeys(LINEAR_AXES, "machine")
    return found | {"F": "feed"}


def _of_g10(tokens: list[Token]) -> dict[str, str]:
    kind = next((token.number for token in tokens if token.letter == "L"), 0.0)
    if kind == 20:
        return dict.fromkeys(LINEAR_AXES, "here")
    return _LENGTHS | ({"R": "length"} if kind in (1, 10, 11) else {})
