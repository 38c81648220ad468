# SPDX-License-Identifier: LGPL-2.1-or-later
"""The value of a word while it is edited: a number, or an expression wrapped in the operations of the edit.

The kind of number in each word of a line, by which a verb selects the words to change.

place    a coordinate of a place: X Y Z of G0, G1, G81 ... (under G91 the way to it)
centre   I J K of an arc: from its begin, or a place under G90.1
vector   a way in the plane whatever the mode: control points of G5
radius   R of an arc                       height   R of a canned cycle, along the plane's normal
depth    a length along the normal: Q      machine  a place of the machine, not of the work: with G53
here     the name that the tool's place is to have: G92, G10 L20
length   a length that has nothing to do with the path: G43.1 Z, G10 L2, G64 P
feed     F

Numbers as they are written: how many decimals a program has, and a new number in the manner of the old one.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

from CNCStepper.canned_cycle_expansion import CYCLE_NAMES
from CNCStepper.gcode.dialects import Dialect
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
_NOT_EDITED = frozenset(
    ("", "G5.2", "G5.3", "G32", "G50", "G76", "G87", "G96", "@", "^")
)  # "": a code by an expression


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


DECIMALS = {"mm": 3, "inch": 4}
MOST_DECIMALS = 9
FEED_DIGITS = 4  # significant ones


def decimals_of(written: str) -> int:
    """Return the number of digits after the point."""
    return len("".join(written.split()).partition(".")[2])


def dialect_decimals(dialect: Dialect, units: str) -> int:
    """Return the digits after the point that programs of this dialect have."""
    return (dialect.writing.decimals if dialect.writing else DECIMALS)[units]


def feed_decimals(feed: float, least: int) -> int:
    """Return the digits after the point that make a feed right to a thousandth: at least `least`, where it is 0 with
    these too."""
    if feed < 0.5 / 10**least:
        return least
    return max(least, FEED_DIGITS - 1 - math.floor(math.log10(feed)))


def number_text(value: float, decimals: int, least: int = 0, like: str = "") -> str:
    """Return `value` rounded to `decimals` digits, without zeros at its end beyond `least` of them; never -0.

    like: the number that it takes the place of: its bare point ("5.") or missing zero (".5") is kept.
    """
    text = f"{value:.{decimals}f}"
    if "." in text:
        whole, rest = text.split(".")
        rest = rest.rstrip("0").ljust(min(least, decimals), "0")
        text = f"{whole}.{rest}" if rest else whole + "." * like.rstrip().endswith(".")
    elif like.rstrip().endswith("."):
        text += "."
    if not text.strip("-0."):
        text = text.lstrip("-")
    if like.lstrip("+- \t").startswith(".") and text.lstrip("-").startswith("0.") and text.strip("-0."):
        text = text.replace("0.", ".", 1)
    return text


FACTOR_DIGITS = 12


@dataclass(frozen=True)
class Value:
    """number + the sum of factor * expression; expressions are copied as written."""

    number: float
    parts: tuple[tuple[float, str], ...] = ()

    @classmethod
    def of(cls, token: Token, factor: float) -> Value:
        """Return a word's value, times a factor."""
        if token.number is None:
            return cls(0.0, ((factor, token.written),))
        return cls(token.number * factor)

    @classmethod
    def total(cls, terms: Iterable[tuple[float, Value]], shift: float) -> Value:
        """Return the sum of values times factors, and a number."""
        number, parts = float(shift), []
        for factor, value in terms:
            number += float(factor) * value.number
            parts += [(float(factor) * own, text) for own, text in value.parts if factor]
        return cls(number, tuple(parts))

    @property
    def is_number(self) -> bool:
        """Whether no expression is part of it."""
        return not self.parts

    def times(self, factor: float) -> Value:
        """Return it multiplied."""
        return Value.total([(factor, self)], 0.0)

    def plus(self, number: float) -> Value:
        """Return it with a number added."""
        return Value(self.number + number, self.parts)

    def is_same(self, token: Token, factor: float) -> bool:
        """Whether it equals a word with an expression."""
        return self.parts == ((factor, token.written),) and not self.number

    def text(self, decimals: int, like: str = "") -> str:
        """Return it as it is written, in the manner of `like`: a number, or an expression in brackets."""
        if self.is_number:
            least = decimals_of(like) if like and not like.startswith(("[", "#")) else 0
            return number_text(self.number, decimals, least, like if like and like[0] not in "[#" else "")
        if len(self.parts) == 1 and round(self.parts[0][0], FACTOR_DIGITS) == 1.0 and not self.number:
            return self.parts[0][1]
        terms = [_term(factor, text) for factor, text in self.parts]
        if round(self.number, decimals):
            terms.append(
                f"[{number_text(self.number, decimals)}]" if self.number < 0 else number_text(self.number, decimals)
            )
        return f"[{' + '.join(terms)}]"


def _term(factor: float, text: str) -> str:
    rounded = round(factor, FACTOR_DIGITS)
    whole = text if text.startswith(("[", "#")) else f"[{text}]"
    if rounded == 1.0:
        return whole
    number = number_text(rounded, FACTOR_DIGITS)
    return f"{whole} * {f'[{number}]' if rounded < 0 else number}"
