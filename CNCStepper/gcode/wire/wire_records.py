# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wire text of a language of records: each record whole, so that a chunk may begin at any of them.

    G01 X-10. F1. # Z-50. #   ->   G01X-10.F1.#G01Z-50.F1.#
    G90 # G00 X5. Z8. # X3. # ->   G90#G00X5.Z8.#G00X3.Z8.#

The mini-lathe has no acknowledgement and a buffer of unknown size, so that a sender ends chunks with "?" where it
likes; each must open with its G word. Numbers stay as they are written: without its point a number is another one. In
absolute mode the control drives an axis without a word to 0: the word where it stands is added, or the record refused.
"""

from __future__ import annotations

from CNCStepper.errors import Place, ProgramError
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.syntax.words import Word

AXES = "XZ"


class Records:
    """Follows from record to record the motion, its F, and in absolute mode the axis positions."""

    def __init__(self, dialect: Dialect):
        self.are_used = "records" in dialect.front
        self._codes = dialect.codes
        self._absolute = dialect.distance == "absolute"
        self._motion: Word | None = None
        self._feed: Word | None = None
        self._at: dict[str, Word] = {}

    def wire(self, blocks: list[list[Word]]) -> str:
        """Return the records of one line; raises ProgramError where an axis of an absolute one is nowhere named."""
        records = ([word for word in block if word.letter != "N"] for block in blocks)
        return "".join(f"{self._record(words)}#" for words in records if words)

    def _record(self, words: list[Word]) -> str:
        self._follow(words)
        if not any(word.letter in AXES for word in words):
            return "".join(word.text for word in words)
        if self._absolute:
            words = self._with_both_axes(words)
        opens = any(self._group(word) == "motion" for word in words)
        has_feed = any(word.letter == "F" for word in words)
        before = [self._motion] if self._motion and not opens else []
        after = [self._feed] if self._feed and not has_feed else []
        return "".join(word.text for word in (*before, *words, *after))

    def _follow(self, words: list[Word]) -> None:
        """Note the modes that a record sets."""
        for word in words:
            group = self._group(word)
            if group == "motion":
                self._motion, self._feed = word, None
            elif group:
                self._motion = None
                self._at = {}  # other units or a distance mode: the words mean something else
            if group == "distance":
                self._absolute = self._codes[word.name].sets["distance"] == "absolute"
        self._feed = next((word for word in words if word.letter == "F"), self._feed)

    def _with_both_axes(self, words: list[Word]) -> list[Word]:
        self._at |= {word.letter: word for word in words if word.letter in AXES}
        named = next(word for word in words if word.letter in AXES)
        for axis in AXES:
            if axis not in self._at:
                what = "in absolute mode the control drives an axis without a word to 0"
                place = Place(column=named.column)
                raise ProgramError("absent-axis", what, value=named.text, advice="name both axes", place=place)
        others = [word for word in words if word.letter not in AXES]
        codes = [word for word in others if word.letter in "GM"]
        return [*codes, *(self._at[axis] for axis in AXES), *(word for word in others if word not in codes)]

    def _group(self, word: Word) -> str:
        code = self._codes.get(word.name) if word.letter in "GM" else None
        return code.group if code else ""
