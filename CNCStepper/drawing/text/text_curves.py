# SPDX-License-Identifier: LGPL-2.1-or-later
"""Text as curves of lines and arcs in mm: lines on a base line, or one line of it along a curve.

  height_mm                         cap height (size="cap"), or the em (size="em")
--+--  H e l l o                    letters stand along +X from the origin; further lines below
--+--  ---------- base line, y = 0  align: the origin is the left end, the middle or the right end of each line

along a curve: the middle of each letter stands upright on the curve, `along_mm` from its start
"""

from __future__ import annotations

import math
import unicodedata
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import Any, Literal

import numpy as np

from CNCStepper.cancellation import checkpoint
from CNCStepper.drawing.text.font import Font, find_font, open_font
from CNCStepper.drawing.text.overlaps import without_overlaps
from CNCStepper.drawing.text.stroke_font import find_stroke_font
from CNCStepper.errors import JobError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.safe_text import printable

Align = Literal["left", "center", "right"]
SHIFTS = {"left": 0.0, "center": -0.5, "right": -1.0}
MOST_CHARACTERS = 20_000
MOST_MISSING = 8  # characters named in a refusal
MOST_FITTED = 2048  # glyphs of one size that are kept fitted
TAB_SPACES = 4
UNSHAPED = {"R", "AL", "AN"}  # classes of direction: scripts that are written from the right


@dataclass(frozen=True)
class TextStyle:
    """How a text is set. The font is `file`, or else the family `font` of the system in its `style`.

    single_line: the name of a single-line font of our own in their place, whose letters are open curves.

    size: whether `height_mm` is that of capitals or the em. letter_spacing_mm: added between letters. line_spacing:
    a factor of the font's own distance of lines; `line_pitch_mm` gives that distance itself. slant_deg: leaning to the
    right. width_factor: of the widths alone. missing: whether a character that the font lacks is refused, or left out.
    """

    font: str = "sans-serif"
    style: str = ""
    file: Path | None = None
    single_line: str = ""
    height_mm: float = 10.0
    size: Literal["cap", "em"] = "cap"
    align: Align = "left"
    letter_spacing_mm: float = 0.0
    line_spacing: float = 1.0
    line_pitch_mm: float | None = None
    slant_deg: float = 0.0
    width_factor: float = 1.0
    kerning: bool = True
    missing: Literal["refuse", "leave out"] = "refuse"


@dataclass(frozen=True)
class PlacedGlyph:
    """A character, where it stands on its line (mm from the line's start), and its width."""

    character: str
    x_mm: float
    advance_mm: float


def font_of(style: TextStyle) -> Font:
    """Return the font of a style; raises JobError for one that is not there or cannot be read."""
    if style.single_line:
        return find_stroke_font(style.single_line)
    return open_font(style.file) if style.file is not None else find_font(style.font, style.style)


def text_curves(style: TextStyle, text: str, tolerance_mm: float) -> tuple[Curve, ...]:
    """Return the curves of a text with the start of its first base line at the origin, within `tolerance_mm`.

    Outlines are closed and counter-clockwise, holes in them clockwise. Raises JobError for characters that the font
    does not have, scripts that need shaping, and a text without a letter.
    """
    font = font_of(style)
    found: list[Curve] = []
    for number, line in enumerate(_lines(text)):
        glyphs, width_mm = line_layout(font, style, line)
        x_mm, y_mm = SHIFTS[style.align] * width_mm, -number * line_pitch_mm(font, style)
        for glyph in glyphs:
            for curve in _fitted(font, style, glyph.character, tolerance_mm):
                found.append(curve.moved(x_mm + glyph.x_mm, y_mm))
    return _not_empty(found, text)


def text_along(
    style: TextStyle, text: str, along: Curve, tolerance_mm: float, along_mm: float = 0.0, above_mm: float = 0.0
) -> tuple[Curve, ...]:
    """Return the curves of one line of text along a curve, its origin `along_mm` from the start, `above_mm` above it.

    On a closed curve the text may go on past its start. Raises JobError as `text_curves`, and for a text that is longer
    than the curve.
    """
    font = font_of(style)
    glyphs, width_mm = line_layout(font, style, " ".join(_lines(text)))
    begin_mm = along_mm + SHIFTS[style.align] * width_mm
    _require_room(along, begin_mm, width_mm)
    found: list[Curve] = []
    for glyph in glyphs:
        middle_mm = begin_mm + glyph.x_mm + glyph.advance_mm / 2.0
        place, direction = along.at_length(middle_mm % along.length_mm if along.closed else middle_mm)
        left = np.array([-direction[1], direction[0]])
        x, y = (place + above_mm * left - glyph.advance_mm / 2.0 * direction).tolist()
        angle_deg = math.degrees(math.atan2(direction[1], direction[0]))
        for curve in _fitted(font, style, glyph.character, tolerance_mm):
            found.append(curve.rotated(angle_deg).moved(x, y))
    return _not_empty(found, text)


def line_layout(font: Font, style: TextStyle, line: str) -> tuple[list[PlacedGlyph], float]:
    """Return the characters of one line from x = 0, and the line's width, mm."""
    _require_script(line)
    if style.missing == "leave out":
        line = without_lacking(font, line)
    else:
        _require_glyphs(font, line)
    scale = scale_of(font, style) * style.width_factor
    placed: list[PlacedGlyph] = []
    x_mm, before, gap_mm = 0.0, "", 0.0
    for character in line:
        glyph = font.glyph(character)
        assert glyph is not None  # _require_glyphs has seen to it
        kern = font.kerning(before, character) if style.kerning and before else 0.0
        x_mm += gap_mm + kern * scale
        placed.append(PlacedGlyph(character, x_mm, glyph.advance * scale))
        x_mm += glyph.advance * scale
        before, gap_mm = character, style.letter_spacing_mm
    return placed, x_mm


def scale_of(font: Font, style: TextStyle) -> float:
    """Return the length of a font's unit, mm."""
    return style.height_mm / (font.cap_height if style.size == "cap" else font.units)


def line_pitch_mm(font: Font, style: TextStyle) -> float:
    """Return the distance of two base lines."""
    return style.line_pitch_mm or style.line_spacing * font.line_height * scale_of(font, style)


def _lines(text: str) -> list[str]:
    """Return the lines of a text: composed, tabs as blanks, without characters that only control the setting."""
    if len(text) > MOST_CHARACTERS:
        raise JobError(
            "text-long",
            "the text is too long",
            value=Text("{count} characters", count=len(text)),
            limit=f"{MOST_CHARACTERS}",
            advice="make several texts of it",
        )
    composed = unicodedata.normalize("NFC", text).replace("\r\n", "\n").replace("\r", "\n")
    kept = composed.replace("\t", " " * TAB_SPACES)
    return [
        "".join(each for each in line if unicodedata.category(each) not in ("Cc", "Cf")) for line in kept.split("\n")
    ]


def _require_script(line: str) -> None:
    """Raise JobError for characters that are not set one after the other."""
    wrong = next((each for each in line if unicodedata.bidirectional(each) in UNSHAPED), None)
    if wrong is not None:
        raise JobError(
            "text-script",
            "scripts that are written from the right are not set",
            value=named(wrong),
            advice="convert the text to paths in the drawing program",
        )


def _require_glyphs(font: Font, line: str) -> None:
    """Raise JobError that names the characters which the font lacks."""
    missing = lacking(font, line)
    if missing:
        raise JobError(
            "text-glyph",
            Text("the font '{font}' lacks characters of the text", font=font.name),
            value=", ".join(map(named, missing[:MOST_MISSING])),
            advice="choose another font, or other characters",
        )


def lacking(font: Font, text: str) -> list[str]:
    """Return the characters of a text that a font does not have, each once."""
    return [each for each in dict.fromkeys(text) if font.glyph(each) is None]


def without_lacking(font: Font, text: str) -> str:
    """Return a text without the characters that a font does not have."""
    missing = set(lacking(font, text))
    return "".join(each for each in text if each not in missing) if missing else text


def named(character: str) -> str:
    """Return a character with its number and its name, for a person."""
    return f"{printable(character)} (U+{ord(character):04X} {unicodedata.name(character, '')})".replace(" )", ")")


def _require_room(along: Curve, begin_mm: float, width_mm: float) -> None:
    """Raise JobError for a text that does not fit onto its curve."""
    before_mm, over_mm = -begin_mm, begin_mm + width_mm - along.length_mm
    if along.closed:
        before_mm, over_mm = 0.0, width_mm - along.length_mm
    if max(before_mm, over_mm) > 1e-6:
        raise JobError(
            "text-along",
            "the text is longer than the curve from its place on",
            value=Text("{width_mm:.2f} mm from {begin_mm:.2f} mm on", width_mm=width_mm, begin_mm=begin_mm),
            limit=f"{along.length_mm:.2f} mm",
            advice="make the text smaller, move its start, or lengthen the curve",
        )


def _not_empty(found: list[Curve], text: str) -> tuple[Curve, ...]:
    if not found:
        raise JobError("text-empty", "the text has no letter", value=printable(text, 40), advice="write a letter")
    return tuple(found)


def _fitted(font: Font, style: TextStyle, character: str, tolerance_mm: float) -> tuple[Curve, ...]:
    """Return the curves of a character at the origin; they depend on few words of the style."""
    few = replace(
        TextStyle(),
        single_line=style.single_line,
        height_mm=style.height_mm,
        size=style.size,
        slant_deg=style.slant_deg,
        width_factor=style.width_factor,
    )
    return _fitted_glyph(font, few, character, tolerance_mm)


@lru_cache(MOST_FITTED)
def _fitted_glyph(font: Any, style: TextStyle, character: str, tolerance_mm: float) -> tuple[Curve, ...]:
    checkpoint()
    glyph, scale = font.glyph(character), scale_of(font, style)
    assert glyph is not None
    shear = math.tan(math.radians(style.slant_deg))
    matrix = np.array([(style.width_factor * scale, shear * scale, 0.0), (0.0, scale, 0.0)])
    curves = [path.transformed(matrix).curve(tolerance_mm) for path in glyph.paths]
    if style.single_line:
        return tuple(curves)
    outlines = oriented([curve for curve in curves if curve.closed])
    return (*without_overlaps(outlines, tolerance_mm), *(curve for curve in curves if not curve.closed))


def oriented(outlines: list[Curve]) -> list[Curve]:
    """Return the outlines of a glyph so that the largest one, and all that run as it does, are counter-clockwise."""
    largest = max((outline.area_mm2 for outline in outlines), key=abs, default=0.0)
    return [outline.reversed() for outline in outlines] if largest < 0.0 else outlines
