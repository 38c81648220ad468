# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which characters of a line are which kind of word, and their colours on a light and on a dark ground. No Qt here."""

from __future__ import annotations

import re
from typing import NamedTuple

_NUMBER = r"[ \t]*[-+]?(?:[0-9][0-9 \t]*\.?[0-9 \t]*|\.[0-9][0-9 \t]*)"
_KINDS = {
    "mark": r"^[ \t]*/|^[ \t]*%",
    "comment": r"\([^)]*\)?|;.*",
    "flow": r"(?<![A-Za-z])[Oo](?:<[^>]*>?|[0-9]+)[ \t]*[A-Za-z]*",
    "value": r"#<[^>]*>?|#+[0-9]*|\b(?:ABS|ACOS|ASIN|ATAN|COS|EXP|FIX|FUP|LN|ROUND|SIN|SQRT|TAN|EXISTS|"
    r"MOD|AND|OR|XOR|EQ|NE|GT|GE|LT|LE)\b|[][*/=]",
    "motion": r"[Gg][ \t]*0*[0-3](?![0-9.])",
    "code": rf"[GgMm](?:{_NUMBER})?",
    "number": rf"[Nn]{_NUMBER}",
    "axis": rf"[XYZABCUVWxyzabcuvw](?:{_NUMBER})?",
    "centre": rf"[IJKRijkr](?:{_NUMBER})?",
    "feed": rf"[FSTHDPQLEfsthdpqle](?:{_NUMBER})?",
}
_WORDS = re.compile("|".join(f"(?P<{kind}>{pattern})" for kind, pattern in _KINDS.items()))
LIGHT = {
    "motion": "#0b4fa8",
    "code": "#7a1fa2",
    "axis": "#1a1d21",
    "centre": "#3f6b00",
    "feed": "#b04400",
    "number": "#8a8f98",
    "comment": "#5f7a55",
    "flow": "#b3005e",
    "value": "#006d77",
    "mark": "#8a8f98",
    "wrong": "#d40000",
    "line": "#eaf1fb",
    "margin": "#f3f4f6",
    "digits": "#8a8f98",
}
DARK = {
    "motion": "#7fb4ff",
    "code": "#d7a1f9",
    "axis": "#e6e8eb",
    "centre": "#b5d97a",
    "feed": "#ffb26b",
    "number": "#8b929c",
    "comment": "#8fb58a",
    "flow": "#ff8ac4",
    "value": "#5fd3dc",
    "mark": "#8b929c",
    "wrong": "#ff6b6b",
    "line": "#2b3340",
    "margin": "#24282e",
    "digits": "#7c838d",
}
BOLD = ("motion", "code", "flow")


class Span(NamedTuple):
    """Characters [start, start + length) of a line, and their kind."""

    start: int
    length: int
    kind: str


def spans_of(text: str) -> list[Span]:
    """Return the words of a line, from left to right; what is none of them is left out."""
    found = []
    for match in _WORDS.finditer(text):
        length = len(match[0].rstrip())
        if length and match.lastgroup:
            found.append(Span(match.start(), length, match.lastgroup))
    return found


def word_at(text: str, column: int) -> str:
    """Return the word in which a column lies, counted from 0, without blanks and in capitals; "" outside of any."""
    for span in spans_of(text):
        if span.start <= column < span.start + span.length:
            word = text[span.start : span.start + span.length]
            return word if span.kind == "comment" else re.sub(r"[ \t]", "", word).upper()
    return ""


def colours_on(lightness: int) -> dict[str, str]:
    """Return the colours for a ground of that lightness, from 0 (black) to 255."""
    return DARK if lightness < 128 else LIGHT
