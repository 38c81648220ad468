# SPDX-License-Identifier: LGPL-2.1-or-later
"""TEXT, ATTRIB and MTEXT as outlines, in the unit of the drawing.

    TEXT, ATTRIB   height of capitals, width factor, oblique angle, rotation, mirroring, all alignments; FIT changes the
                   width to reach from one point to the other, ALIGNED the height as well
    MTEXT          height, rotation, attachment point, line breaks, line spacing, words wrapped at its width; formats
                   inside it and columns are not applied, which a warning says

The font is that of the text style where the system has it. An SHX font, and one that is not there, becomes another one,
which a warning says.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import PurePath
from typing import Any

import numpy as np

from CNCStepper.drawing.dxf.attributes import decoded
from CNCStepper.drawing.dxf.plain_entities import LARGEST
from CNCStepper.drawing.text.font_files import find_face
from CNCStepper.drawing.text.text_curves import (
    MOST_MISSING,
    Align,
    TextStyle,
    font_of,
    lacking,
    line_layout,
    named,
    text_curves,
)
from CNCStepper.errors import GeometryError, JobError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.safe_text import printable

KINDS = ("TEXT", "ATTRIB", "MTEXT")
OUTLINES, STROKES = "sans-serif", "engraving"  # in place of a font that is not here, and of an SHX font
MOST_CHARACTERS = 100_000  # of all texts of a drawing, and of one as the file writes it: ezdxf takes the square of it
MOST_WRITTEN = 1_000_000  # of all texts as the file writes them, with their formats
MOST_SLANT_DEG = 85.0
DESCENT = 1.0 / 3.0  # of the height: how far "bottom" lies below the base line
PITCH = 5.0 / 3.0  # heights: from one base line of an MTEXT to the next, by the DXF reference
MOST_WORDS = 255
ALIGNS: tuple[Align, ...] = ("left", "center", "right")


class Texts:
    """Sets the texts of one drawing; `warnings` collects what was set otherwise than the file says."""

    def __init__(self, document: Any, tolerance: float):
        self._document, self._tolerance = document, tolerance
        self._characters = self._written = 0
        self._families: dict[str, str] = {}
        self.warnings: dict[str, None] = {}

    def curves(self, entity: Any) -> list[Curve]:
        """Return the outlines of a text; raises GeometryError with the reason where it cannot be set."""
        try:
            return self._multiline(entity) if entity.dxftype() == "MTEXT" else self._line(entity)
        except JobError as error:
            if error.code == "dxf-large":
                raise
            raise GeometryError(error.code, error.what, value=error.value, advice=error.advice) from error

    def _line(self, entity: Any) -> list[Curve]:
        from ezdxf.tools.text import plain_text

        self._count_written(str(entity.dxf.text))
        text = plain_text(decoded(str(entity.dxf.text)))
        self._count(text)
        style = self._style(entity, entity.dxf.get("height", 0.0))
        style = replace(
            style,
            width_factor=entity.dxf.get("width", 1.0),
            slant_deg=_slant(entity.dxf.get("oblique", 0.0)),
        )
        self._note_lacking(style, text)
        _, width = line_layout(font_of(style), style, text)
        placement, first, second = entity.get_placement()
        turn = math.radians(entity.dxf.get("rotation", 0.0))
        if second is not None and width > 0.0:
            run = math.hypot(second.x - first.x, second.y - first.y)
            turn = math.atan2(second.y - first.y, second.x - first.x)
            wider = run / width
            if placement.name == "FIT":
                style = replace(style, width_factor=style.width_factor * wider)
            else:
                style = replace(style, height_mm=style.height_mm * wider)
            width = run
        x = -width * _share_of_width(placement.name)
        y = -style.height_mm * _share_of_height(placement.name)
        flips = int(entity.dxf.get("text_generation_flag", 0))
        flip = (-1.0 if flips & 2 else 1.0, -1.0 if flips & 4 else 1.0)
        return [_placed(each, (x, y), flip, turn, first) for each in text_curves(style, text, self._tolerance)]

    def _multiline(self, entity: Any) -> list[Curve]:
        self._count_written(str(entity.text))
        lines = [decoded(str(line)) for line in entity.plain_text(split=True, fast=False)]
        self._count("".join(lines))
        if len(entity.text) > len("".join(lines)) + 2 * len(lines):
            self._warn("formats inside MTEXT are not applied")
        if entity.has_columns:
            self._warn("the columns of MTEXT are set one below the other")
            lines = [decoded(str(line)) for line in entity.all_columns_plain_text(split=True)]
        height = entity.dxf.get("char_height", 0.0)
        pitch = PITCH * height * entity.dxf.get("line_spacing_factor", 1.0)
        style = replace(self._style(entity, height), line_pitch_mm=pitch)
        self._note_lacking(style, "".join(lines))
        lines = self._wrapped(lines, style, entity.dxf.get("width", 0.0) or 0.0)
        column, row = (entity.dxf.attachment_point - 1) % 3, (entity.dxf.attachment_point - 1) // 3
        style = replace(style, align=ALIGNS[column])
        tall = (len(lines) - 1) * pitch
        y = (-height, (tall - height) / 2.0, tall)[min(max(row, 0), 2)]
        turn = math.radians(entity.get_rotation())
        placed = text_curves(style, "\n".join(lines), self._tolerance)
        return [_placed(each, (0.0, y), (1.0, 1.0), turn, entity.dxf.insert) for each in placed]

    def _wrapped(self, lines: Sequence[str], style: TextStyle, width: float) -> list[str]:
        """Return the lines, broken between words where they are wider than `width`; 0: as they are."""
        if not width > 0.0:
            return list(lines)
        font, wrapped = font_of(style), []
        for line in lines:
            words = line.split(" ")
            kept = words[0]
            for word in words[1:]:
                if line_layout(font, style, f"{kept} {word}")[1] > width:
                    wrapped.append(kept)
                    kept = word
                else:
                    kept = f"{kept} {word}"
            wrapped.append(kept)
        return wrapped

    def _style(self, entity: Any, height: float) -> TextStyle:
        if not 0.0 < height <= LARGEST:
            advice = "give it a height above 0"
            raise GeometryError("dxf-text", "its height is no length", value=f"{height}", advice=advice)
        name = _style_name(entity)
        if name not in self._families:
            self._families[name] = self._family(name)
        family = self._families[name]
        if family == STROKES:
            return TextStyle(single_line=STROKES, height_mm=height, kerning=False, missing="leave out")
        return TextStyle(font=family, height_mm=height, kerning=False, missing="leave out")

    def _family(self, name: str) -> str:
        """Return the font for a text style: its own where the system has it, else another, with a warning."""
        from ezdxf.fonts import fonts

        entry = self._document.styles.get(name) if self._document.styles.has_entry(name) else None
        file = str(entry.dxf.get("font", "")) if entry is not None else ""
        family = ""
        if file and not file.casefold().endswith(".shx") and PurePath(file).suffix:
            family = str(getattr(fonts.font_manager.get_font_face(file), "family", ""))
        for wanted in (family, PurePath(file).stem if family else ""):
            try:
                if wanted:
                    return find_face(wanted).family
            except JobError:
                continue
        other = STROKES if file.casefold().endswith(".shx") or not PurePath(file).suffix else OUTLINES
        shown = printable(file or name, MOST_WORDS)
        self._warn(Text("the font '{font}' is not here; its text is set in {other}", font=shown, other=other))
        return other

    def is_filled(self, entity: Any) -> bool:
        """Return whether the outlines of a text that was set enclose areas; strokes do not."""
        return self._families.get(_style_name(entity)) != STROKES

    def _count(self, text: str) -> None:
        self._characters += len(text)
        if self._characters > MOST_CHARACTERS:
            raise _too_much(MOST_CHARACTERS)

    def _count_written(self, text: str) -> None:
        """Count a text before it is taken apart."""
        self._written += len(text)
        if len(text) > MOST_CHARACTERS or self._written > MOST_WRITTEN:
            raise _too_much(MOST_CHARACTERS if len(text) > MOST_CHARACTERS else MOST_WRITTEN)

    def _note_lacking(self, style: TextStyle, text: str) -> None:
        """Note the characters that are left out because the font lacks them."""
        font = font_of(style)
        if missing := lacking(font, text):
            names = ", ".join(map(named, missing[:MOST_MISSING]))
            self._warn(Text("the font '{font}' lacks {names}; they are left out", font=font.name, names=names))

    def _warn(self, warning: str) -> None:
        self.warnings[warning] = None


def _style_name(entity: Any) -> str:
    return str(entity.dxf.get("style", "Standard"))


def _slant(oblique_deg: float) -> float:
    """Return how far letters lean to the right; DXF writes leaning to the left as -20 or as 340."""
    lean = (oblique_deg + 180.0) % 360.0 - 180.0
    if not abs(lean) <= MOST_SLANT_DEG:
        advice = Text("lean them by {most_deg:g} deg at most", most_deg=MOST_SLANT_DEG)
        raise GeometryError("dxf-text", "its letters lean too far", value=f"{oblique_deg:g}", advice=advice)
    return lean


def _share_of_width(alignment: str) -> float:
    return 1.0 if alignment.endswith("RIGHT") else 0.5 if alignment.endswith("CENTER") or alignment == "MIDDLE" else 0.0


def _share_of_height(alignment: str) -> float:
    """Return which share of the height lies between the base line and the point of alignment."""
    shares = {"TOP": 1.0, "MIDDLE": 0.5, "BOTTOM": -DESCENT}
    return next((share for word, share in shares.items() if alignment.startswith(word)), 0.0)


def _placed(curve: Curve, shift: tuple[float, float], flip: tuple[float, float], turn_rad: float, place: Any) -> Curve:
    """Return a curve shifted, mirrored, turned about the origin and moved to its place."""
    c, s = math.cos(turn_rad), math.sin(turn_rad)
    linear = np.array([(c, -s), (s, c)]) @ np.diag(flip)
    moved = linear @ np.array(shift) + np.array([place.x, place.y])
    return curve.transformed(np.column_stack([linear, moved]))


def _too_much(most: int) -> JobError:
    return JobError(
        "dxf-large", "the drawing has too much text", limit=f"{most} characters", advice="take text out of it"
    )
