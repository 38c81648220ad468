# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lathe's records as its controller reads them: a move in steps, or nothing.

N30 G00 X-10. # N40 Z-50. # N50 X5000 Z50. #        a number without a point is in 1/10000: X5000 is 0.5 mm
N30 G01 X-10. F1. # ...                             F in mm/s; lasts as long as the run of G01
/ skips a record    ; begins a comment, up to the "#"

The published table is the default: G20 radius, G70 mm (both on at the begin), incremental. The listing reads both pairs
the other way round; inches are 25.4 mm in either. A motion stays in force until the next G or M, and no longer than to
the end of its "?"-ended piece. An absent X or Z is no move, in absolute mode too.

This reader is the machine's own: it shares nothing with the dialect of the sender's side.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from typing import Literal, NamedTuple

from CNCStepper.errors import MachineRefusal, Text

WHOLE = 10_000.0  # a number without a point is in parts of this
MM_PER_INCH = 25.4
AXES = "XZ"
_WORD = re.compile(r"([A-Z]) *([+-]?(?:\d+\.?\d*|\.\d+))")
MOTIONS = {0: "rapid", 1: "feed"}
G_CODES = (0, 1, 20, 21, 70, 71, 90, 91)
END = 2  # M02


class Steps(NamedTuple):
    """A straight move: steps of X (radius) and Z, the feed in mm/s (None: rapid), whether it begins a run of G01."""

    x: int
    z: int
    feed_mm_s: float | None
    begins_feed: bool = False


@dataclass
class Reader:
    """Reads one record after another; its fields hold the modal state.

    g20: what G20 means, g70: what G70 means. steps_per_mm: of X and Z. places: steps of X and Z, absolute.
    """

    g20: Literal["radius", "diameter"] = "radius"
    g70: Literal["mm", "inch"] = "mm"
    steps_per_mm: tuple[float, float] = (80.0, 80.0)
    places: list[int] = field(default_factory=lambda: [0, 0])
    ended: bool = False  # by M02
    is_diameter: bool = False
    is_inch: bool = False
    is_absolute: bool = False
    motion: str = ""
    feed_mm_s: float | None = None

    def __post_init__(self) -> None:
        self.begin()

    def begin(self) -> None:
        """Begin a program: what G20 and G70 mean is on, coordinates are incremental."""
        self.is_diameter, self.is_inch = self.g20 == "diameter", self.g70 == "inch"
        self.is_absolute = self.ended = False
        self.end_chunk()

    def end_chunk(self) -> None:
        """Forget the motion: the next piece of a program opens with its own G word."""
        self.motion, self.feed_mm_s = "", None

    def read(self, record: str) -> Steps | None:
        """Return the move of a record, None where it has none.

        Raises MachineRefusal where it cannot be read or carried out; nothing of it then counts.
        """
        text = record.partition(";")[0].strip()
        if not text or text.startswith("/"):
            return None
        words = _words(text)
        codes = _codes(words)
        if "M" in codes:
            self.ended, self.motion = True, ""
            return None
        self._check(codes, words, text)
        begins = self._set_modes(codes)
        if "F" in words:
            self.feed_mm_s = self._mm(words["F"])
        return self._move(words, begins)

    # -- inside --------------------------------------------------------------------------------------

    def _check(self, codes: dict[str, list[int]], words: dict[str, str], text: str) -> None:
        """Refuse a record before anything changes."""
        gs = codes.get("G", [])
        motions = [code for code in gs if code in MOTIONS]
        moves = any(axis in words for axis in AXES)
        motion = MOTIONS[motions[-1]] if motions else "" if gs else self.motion
        if moves and not motion:
            raise _refused(text, "no motion is in force", "G00, G01")
        feed = _number(words["F"]) if "F" in words else None if motions else self.feed_mm_s
        if motion == "feed" and not (feed and feed > 0):
            raise _refused(text, "a G01 needs its F", "F above 0 mm/s")

    def _set_modes(self, codes: dict[str, list[int]]) -> bool:
        """Take the G words over; return whether a run of G01 begins."""
        gs = codes.get("G", [])
        if not gs:
            return False
        before, self.motion = self.motion, ""
        for code in gs:
            if code in MOTIONS:
                self.motion = MOTIONS[code]
            elif code in (20, 21):
                self.is_diameter = (code == 20) == (self.g20 == "diameter")
            elif code in (70, 71):
                self.is_inch = (code == 70) == (self.g70 == "inch")
            else:
                self.is_absolute = code == 90
        if any(code in MOTIONS for code in gs):
            self.feed_mm_s = None
        return self.motion == "feed" and before != "feed"

    def _move(self, words: dict[str, str], begins: bool) -> Steps | None:
        if not any(axis in words for axis in AXES):
            return None
        moved = [0, 0]
        for n, axis in enumerate(AXES):
            if axis in words:
                steps = self._steps(words[axis], n)
                moved[n] = steps - self.places[n] if self.is_absolute else steps
        self.places = [place + steps for place, steps in zip(self.places, moved, strict=True)]
        return Steps(moved[0], moved[1], self.feed_mm_s if self.motion == "feed" else None, begins)

    def _steps(self, number: str, axis: int) -> int:
        """Return a coordinate in whole steps: each record is rounded for itself."""
        diameter = 2.0 if self.is_diameter and axis == 0 else 1.0
        return math.floor(self._mm(number) / diameter * self.steps_per_mm[axis] + 0.5)

    def _mm(self, number: str) -> float:
        return _number(number) * (MM_PER_INCH if self.is_inch else 1.0)


def _number(text: str) -> float:
    return float(text) if "." in text else int(text) / WHOLE


def _words(text: str) -> dict[str, str]:
    """Return the last number of each letter, all of G's joined by blanks."""
    words: dict[str, str] = {}
    at = 0
    while at < len(text):
        word = _WORD.match(text, at)
        if not word:
            raise _refused(text, "it cannot be read", "a letter and a number")
        letter, number = word[1], word[2]
        if letter not in "NGMXZF" or (letter in words and letter != "G"):
            raise _refused(text, Text("the word {letter} is not for here", letter=letter), "N, G, M, X, Z, F")
        words[letter] = f"{words['G']} {number}" if letter == "G" and "G" in words else number
        at = word.end()
        while at < len(text) and text[at] in " \r\n\t":
            at += 1
    return words


def _codes(words: dict[str, str]) -> dict[str, list[int]]:
    """Return the numbers of G and M; raises MachineRefusal for one that is not there."""
    codes: dict[str, list[int]] = {}
    for letter, known in (("G", G_CODES), ("M", (END,))):
        if letter in words:
            numbers = words[letter].split()
            if any(not number.isdecimal() or int(number) not in known for number in numbers):
                raise _refused(f"{letter}{numbers[0]}", "there is no such code", ", ".join(map(str, known)))
            codes[letter] = [int(number) for number in numbers]
    return codes


def _refused(record: str, why: str, limit: str) -> MachineRefusal:
    what = Text("the lathe leaves a record out: {why}", why=why)
    return MachineRefusal("lathe-record", what, value=record[:60], limit=limit, advice="correct that line")
