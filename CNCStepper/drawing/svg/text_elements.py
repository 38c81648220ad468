# SPDX-License-Identifier: LGPL-2.1-or-later
"""<text>, <tspan> and <textPath> of SVG as outlines, in mm.

<text x y> ──► text_letters.py: letters, each with its style and the places that the file gives ──► chunks: letters
           that an anchor moves together ──► spots on a line from 0 ──► textLength, text-anchor ──► outlines
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from CNCStepper.cancellation import checkpoint
from CNCStepper.drawing.svg.matrices import Matrix, length
from CNCStepper.drawing.svg.styles import BOLD, SLANTED, Style, font_size
from CNCStepper.drawing.svg.text_letters import FixedLength, Letter, Letters
from CNCStepper.drawing.text.font import Font, find_font
from CNCStepper.drawing.text.overlaps import without_overlaps
from CNCStepper.drawing.text.text_curves import TextStyle, lacking, line_layout, named, oriented, scale_of
from CNCStepper.errors import JobError
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.fitting.path_columns import SampleBudget

ANCHORS = {"middle": -0.5, "end": -1.0}
FALLBACK = "sans-serif"
MOST_FAMILIES = 32  # of one list that are looked for
MOST_FITTED = 4096  # letters of one size and turn that are kept fitted
FLIP = Matrix.of(1.0, 0.0, 0.0, -1.0, 0.0, 0.0)  # letters have Y up, user units Y down
Told = Callable[[str, str], None]
PathCurve = Callable[[str], Curve | None]


@dataclass
class _Spot:
    """A letter on its line: its place from the chunk's begin, its advance, and by how much it is stretched."""

    letter: Letter
    font: Font
    style: TextStyle
    place: complex
    advance: float
    stretch: float = 1.0


class LetterOutlines:
    """The outlines of the letters of a drawing in mm; those that differ by their place alone are fitted once."""

    def __init__(self, tolerance_mm: float, budget: SampleBudget):
        self._tolerance_mm, self._budget = tolerance_mm, budget
        self._fitted: dict[tuple[Font, str, complex, complex], list[Curve]] = {}

    def of(self, font: Font, character: str, matrix: Matrix) -> list[Curve]:
        """Return the outlines of a character; `matrix` places the font's units.

        Raises GeometryError where the curves of the drawing are too many for the tolerance.
        """
        key = font, character, matrix.turn, matrix.mirror
        if key not in self._fitted:
            checkpoint()
            if len(self._fitted) >= MOST_FITTED:
                self._fitted.clear()
            self._fitted[key] = self._fit(font, character, Matrix(matrix.turn, matrix.mirror))
        x, y = matrix.shift.real, matrix.shift.imag
        return [curve.moved(x, y) for curve in self._fitted[key]]

    def _fit(self, font: Font, character: str, matrix: Matrix) -> list[Curve]:
        glyph = font.glyph(character)
        assert glyph is not None  # TextSetter._spots has seen to it
        curves = [path.transformed(matrix.array).curve(self._tolerance_mm, self._budget) for path in glyph.paths]
        return without_overlaps(oriented(curves), self._tolerance_mm)


@dataclass(frozen=True)
class TextSetter:
    """Sets the texts of a drawing; `told(key, name)` is called with what is set otherwise than the file says.

    `path_curve` gives the path of a textPath in user units by its address.
    """

    letters: LetterOutlines
    path_curve: PathCurve
    told: Told

    def outlines(self, letters: Letters, matrix: Matrix) -> list[Curve]:
        """Return the outlines of a <text> in mm; `matrix` places its user units."""
        found: list[Curve] = []
        place = 0j
        for chunk in letters.chunks():
            spots, end = self._spots(chunk)
            stretch = chunk[0].number, chunk[-1].number + 1
            end += _fit_lengths(spots, [fixed for fixed in letters.fixed if self._is_within(fixed, stretch)])
            place = self._place_chunk(chunk[0], spots, place, end, matrix, found)
        return found

    def _is_within(self, fixed: FixedLength, stretch: tuple[int, int]) -> bool:
        """Return whether all letters of a length lie in one chunk; one that is cut through is told."""
        if fixed.last <= stretch[0] or fixed.first >= stretch[1]:
            return False
        within = stretch[0] <= fixed.first and fixed.last <= stretch[1]
        if not within:
            self.told("length", "textLength")
        return within

    def _spots(self, chunk: Sequence[Letter]) -> tuple[list[_Spot], complex]:
        """Return the letters of a chunk one after the other from 0 on, and where the next one goes on."""
        spots: list[_Spot] = []
        pen = 0j
        for _, run in itertools.groupby(chunk, key=lambda letter: id(letter.style)):
            letters = list(run)
            font, style = _font(letters[0].style, lambda name: self.told("font", name))
            for missing in lacking(font, "".join(letter.character for letter in letters)):
                self.told("glyph", named(missing))
            letters = [letter for letter in letters if font.glyph(letter.character) is not None]
            glyphs, width = line_layout(font, style, "".join(letter.character for letter in letters))
            shift = 0j
            for letter, glyph in zip(letters, glyphs, strict=True):
                shift += complex(letter.dx or 0.0, letter.dy or 0.0)
                spots.append(_Spot(letter, font, style, pen + glyph.x_mm + shift, glyph.advance_mm))
            pen += width + shift
        return spots, pen

    def _place_chunk(
        self, start: Letter, spots: list[_Spot], place: complex, end: complex, matrix: Matrix, found: list[Curve]
    ) -> complex:
        """Set the letters of a chunk where the file has it; return where the next one goes on."""
        x = start.x if start.x is not None else place.real
        y = start.y if start.y is not None else place.imag
        path = start.path
        along = self.path_curve(path.get("href") or path.get("xlink:href")) if path is not None else None
        if along is not None and path is not None:
            offset = length(path.get("startOffset"), along.length_mm, 0.0)
            x, y = offset, 0.0
        width = end.real - (spots[0].place.real if spots else 0.0)
        at = complex(x + ANCHORS.get(start.style.get("text-anchor", ""), 0.0) * width, y)
        for spot in spots:
            own = _letter_matrix(at + spot.place, spot, along)
            if own is None:
                self.told("path-end", spot.letter.character)
            else:
                scale = Matrix(complex(scale_of(spot.font, spot.style)))
                found.extend(self.letters.of(spot.font, spot.letter.character, matrix @ own @ scale))
        return at + end


def _fit_lengths(spots: Sequence[_Spot], fixed: Sequence[FixedLength]) -> float:
    """Bring letters to the lengths that the file gives; return by how much the end moves."""
    moved = 0.0
    for wanted in fixed:
        own = [spot for spot in spots if wanted.first <= spot.letter.number < wanted.last]
        if not own:
            continue
        begin, natural = own[0].place.real, own[-1].place.real + own[-1].advance - own[0].place.real
        more = wanted.length - natural
        for order, spot in enumerate(own):
            if wanted.glyphs and natural > 0.0:
                factor = wanted.length / natural
                spot.place = complex(begin + (spot.place.real - begin) * factor, spot.place.imag)
                spot.advance, spot.stretch = spot.advance * factor, spot.stretch * factor
            else:
                spot.place += more * order / max(len(own) - 1, 1)
        if wanted.glyphs or len(own) > 1:
            for spot in spots:
                spot.place += more if spot.letter.number >= wanted.last else 0.0
            moved += more
    return moved


def _letter_matrix(place: complex, spot: _Spot, along: Curve | None) -> Matrix | None:
    """Return where a letter with Y up stands, in user units; None for one beyond the ends of its path."""
    turned = Matrix.of(spot.stretch, 0.0, 0.0, 1.0, 0.0, 0.0)
    if spot.letter.rotate_deg:
        angle = math.radians(spot.letter.rotate_deg)
        turned = Matrix(complex(math.cos(angle), math.sin(angle))) @ turned
    if along is None:
        return Matrix(shift=place) @ turned @ FLIP
    middle = place.real + spot.advance / 2.0
    if not 0.0 <= middle <= along.length_mm:
        return None
    point, direction = along.at_length(middle)
    turn = complex(*direction.tolist())
    at = complex(*point.tolist()) + turn * (complex(-spot.advance / 2.0, place.imag))
    return Matrix(turn, 0j, at) @ turned @ FLIP


def _font(style: Style, told: Callable[[str], None]) -> tuple[Font, TextStyle]:
    """Return the first font of the list that the system has, and how it is set, in user units."""
    size = font_size(style)
    slanted = style.get("font-style", "") in SLANTED
    bold = style.get("font-weight", "") in BOLD
    wanted = " ".join(word for word, is_so in (("Bold", bold), ("Italic", slanted)) if is_so)
    names = [name.strip(" '\"") for name in style.get("font-family", FALLBACK).split(",", MOST_FAMILIES)]
    spacing = length(style.get("letter-spacing", ""), size, 0.0, em=size)
    for number, name in enumerate([*names, FALLBACK]):
        for kind in dict.fromkeys((wanted, "")):
            try:
                font = find_font(name, kind)
            except JobError as error:
                if error.code not in ("font-unknown", "font-style"):
                    raise
                continue
            if number or kind != wanted:
                told(f"{names[0]} {wanted}".strip())
            return font, TextStyle(height_mm=size, size="em", letter_spacing_mm=spacing)
    raise JobError("font-unknown", "the system has no font", advice="convert the text to paths in the drawing program")
