# SPDX-License-Identifier: LGPL-2.1-or-later
"""A font as the layout needs it: glyphs by character, their widths, kerning and heights, all in the font's units.

OutlineFont    a face of a font file: closed outlines               find_font, open_font
StrokeFont     a single-line font of our own: open lines            stroke_font.py
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Protocol

from CNCStepper.drawing.text.character_map import CharacterMap
from CNCStepper.drawing.text.font_files import find_face
from CNCStepper.drawing.text.glyph_outlines import outlines_of
from CNCStepper.drawing.text.kerning import Kerning
from CNCStepper.drawing.text.sfnt import Sfnt, damage_of, font_file
from CNCStepper.errors import JobError, Place
from CNCStepper.geometry.fitting.bezier_path import BezierPath

CAP_SHARE = 0.7  # of the em: the height of capitals where a font has neither an H nor a word of it
MOST_OPEN = 16  # fonts that are kept open


@dataclass(frozen=True, eq=False)
class Glyph:
    """The paths of a character from its place on the base line, and how far the next one is; in the font's units."""

    paths: tuple[BezierPath, ...]
    advance: float


class Font(Protocol):
    """What the layout takes of a font."""

    name: str
    units: float
    cap_height: float
    line_height: float

    def __hash__(self) -> int:
        """Return a number by which fitted glyphs are kept."""

    def glyph(self, character: str) -> Glyph | None:
        """Return the glyph of a character, None where the font has none."""

    def kerning(self, left: str, right: str) -> float:
        """Return by how many units the distance of two characters changes."""


class OutlineFont:
    """A face of a font file; raises JobError for one that is damaged, when it is opened or where a glyph is."""

    def __init__(self, path: Path, face: int = 0, name: str = ""):
        self.name, self._path = name or path.stem, path
        self._sfnt = Sfnt(font_file(path), face, path)
        with damage_of(path):
            self._characters = CharacterMap(self._sfnt.table("cmap"))
            self._outlines = outlines_of(self._sfnt)
            self._kerning = Kerning(self._sfnt)
        metrics = self._sfnt.metrics
        self.units = float(metrics.units)
        self.line_height = float(metrics.ascender - metrics.descender + metrics.line_gap) or 1.2 * self.units
        self._glyphs: dict[int, Glyph] = {}
        self._numbers: dict[str, int] = {}
        capital = self.glyph("H")
        heights = [path.points.imag.max() for path in capital.paths] if capital else []
        self.cap_height = float(max(heights, default=0.0)) or float(metrics.cap_height) or CAP_SHARE * self.units

    def glyph(self, character: str) -> Glyph | None:
        """Return the glyph of a character, None where the font has none."""
        with damage_of(self._path):
            number = self._number(character)
            if not number:
                return None
            if number not in self._glyphs:
                self._glyphs[number] = Glyph(self._outlines.paths(number), float(self._sfnt.advance(number)))
            return self._glyphs[number]

    def kerning(self, left: str, right: str) -> float:
        """Return by how many units the distance of two characters changes."""
        with damage_of(self._path):
            return float(self._kerning.units(self._number(left), self._number(right)))

    def _number(self, character: str) -> int:
        """Return the number of a character's glyph, 0 for none; what was found stays known."""
        if character not in self._numbers:
            self._numbers[character] = self._characters.glyph(character)
        return self._numbers[character]


@lru_cache(MOST_OPEN)
def _opened(path: Path, face: int, name: str, stamp: tuple[int, int]) -> OutlineFont:
    return OutlineFont(path, face, name)


def open_font(path: Path, face: int = 0, name: str = "") -> OutlineFont:
    """Return a face of a font file, kept open until the file changes; raises JobError for one that cannot be read."""
    try:
        found = path.stat()
        stamp = found.st_mtime_ns, found.st_size
    except (OSError, ValueError) as error:
        what, advice = "there is no such font file", "correct the path"
        raise JobError("font-missing", what, advice=advice, place=Place(str(path))) from error
    return _opened(path, face, name, stamp)


def find_font(family: str, style: str = "") -> OutlineFont:
    """Return the font of the system by family and style; raises JobError that names those there are."""
    face = find_face(family, style)
    return open_font(face.path, face.number, f"{face.family} {face.style}")
