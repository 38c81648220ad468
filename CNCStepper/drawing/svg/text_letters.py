# SPDX-License-Identifier: LGPL-2.1-or-later
"""The letters of a <text>: each with its style, its path, and what x, y, dx, dy and rotate say of it.

A list of an attribute gives one value to each letter of its element, blanks that stay counted; the innermost element
that has a value for a letter has it. The last value of rotate goes on. Source: SVG 1.1, second edition, chapter 10.
"""

from __future__ import annotations

import math
import unicodedata
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

from CNCStepper.drawing.svg.document import TEXT, Element
from CNCStepper.drawing.svg.matrices import length
from CNCStepper.drawing.svg.styles import Style, font_size
from CNCStepper.errors import JobError

MOST_CHARACTERS = 20_000  # of one text
MOST_VALUES = 20_000  # of one attribute
INNER = ("tspan", "textPath", "a")


@dataclass
class Letter:
    """A letter by its number in the text; what the file does not say of its place is None."""

    number: int
    character: str
    style: Style
    path: Element | None
    is_kept: bool  # a blank of xml:space="preserve"
    x: float | None = None
    y: float | None = None
    dx: float | None = None
    dy: float | None = None
    rotate_deg: float | None = None


@dataclass(frozen=True)
class FixedLength:
    """The textLength of the letters from `first` up to `last`; `glyphs`: they are stretched, not moved apart."""

    first: int
    last: int
    length: float
    glyphs: bool


@dataclass
class Letters:
    """Gathers the letters of a <text>.

    `style_of` gives the style of an element by that around it and the elements above it; a percentage is one of the
    `viewport`. Raises JobError for too many letters.
    """

    style_of: Callable[[Element, Style, list[Element]], Style]
    viewport: tuple[float, float]
    letters: list[Letter] = field(default_factory=list)
    fixed: list[FixedLength] = field(default_factory=list)

    def read(self, element: Element, style: Style) -> None:
        """Add all letters of a <text>."""
        self._add(element, style, None, [])
        while self.letters and self.letters[-1].character == " " and not self.letters[-1].is_kept:
            self.letters.pop()

    def chunks(self) -> Iterator[list[Letter]]:
        """Yield the letters that an anchor moves together: up to the next one with a place of its own."""
        chunk: list[Letter] = []
        for letter in self.letters:
            if chunk and (letter.x is not None or letter.y is not None or letter.path is not chunk[-1].path):
                yield chunk
                chunk = []
            chunk.append(letter)
        if chunk:
            yield chunk

    def _add(self, element: Element, style: Style, path: Element | None, above: list[Element]) -> None:
        first = len(self.letters)
        preserve = element.get("xml:space") == "preserve"
        for child in element.children:
            if child.name == TEXT:
                self._add_text(child.text, style, path, preserve)
            elif child.name in INNER:
                own = self.style_of(child, style, [*above, element])
                if own.get("display") != "none":
                    self._add(child, own, child if child.name == "textPath" else path, [*above, element])
        self._place(element, style, first)

    def _add_text(self, text: str, style: Style, path: Element | None, preserve: bool) -> None:
        for character in unicodedata.normalize("NFC", text):
            if character in "\n\t\r":
                character = " "
            elif unicodedata.category(character) in ("Cc", "Cf"):
                continue
            if character == " " and not preserve and self._ends_with_blank():
                continue
            if len(self.letters) >= MOST_CHARACTERS:
                advice = "make several texts of it"
                raise JobError("svg-large", "a text is too long", limit=f"{MOST_CHARACTERS} characters", advice=advice)
            self.letters.append(Letter(len(self.letters), character, style, path, preserve))

    def _ends_with_blank(self) -> bool:
        """Return whether a further blank is left out; it is at the begin of a text too."""
        return not self.letters or (self.letters[-1].character == " " and not self.letters[-1].is_kept)

    def _place(self, element: Element, style: Style, first: int) -> None:
        """Give to the letters of an element what its attributes say, where those inside it have said nothing."""
        own, em = self.letters[first:], font_size(style)
        for key, whole in (("x", 0), ("y", 1), ("dx", 0), ("dy", 1)):
            texts = element.get(key).replace(",", " ").split()[:MOST_VALUES]
            for letter, text in zip(own, texts, strict=False):
                if getattr(letter, key) is None:
                    setattr(letter, key, length(text, self.viewport[whole], 0.0, em))
        turns = element.get("rotate").replace(",", " ").split()[:MOST_VALUES]
        for order, letter in enumerate(own if turns else ()):
            if letter.rotate_deg is None:
                letter.rotate_deg = length(turns[min(order, len(turns) - 1)], 0.0, 0.0)
        wanted = length(element.get("textLength"), self.viewport[0], math.nan, em)
        if own and wanted > 0.0:
            last = first + len(own) - (own[-1].character == " " and not own[-1].is_kept)
            self.fixed.append(FixedLength(first, last, wanted, element.get("lengthAdjust") == "spacingAndGlyphs"))
