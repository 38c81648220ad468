# SPDX-License-Identifier: LGPL-2.1-or-later
"""Single-line fonts of our own for engraving: letters as strokes along which the tool runs once.

The strokes are in `engraving.strokes`, whose head describes the form.
"""

from __future__ import annotations

import itertools
import re
from functools import lru_cache
from pathlib import Path

import numpy as np

from CNCStepper.drawing.text.font import Glyph
from CNCStepper.errors import JobError, Text
from CNCStepper.geometry.fitting.bezier_path import BezierPath, PathPen

FILES = {"engraving": Path(__file__).with_name("engraving.strokes")}
UNITS, CAP_HEIGHT, SMALL_HEIGHT, LINE_HEIGHT = 28.0, 20.0, 13.0, 34.0
BEARING = 2.4  # on each side of a letter
ABOVE = {True: 22.2, False: 15.4}  # where marks stand: over capitals, over small letters
NAMES = {"space": " ", "nbsp": "\xa0", "hash": "#"}
QUARTER = 0.5522847498  # of the half axis: the control points of a quarter of an ellipse
STROKE = re.compile(r"([MLCvh])([^MLCvh]*)")


class StrokeFont:
    """A single-line font; its paths are open, or closed where a stroke comes round."""

    units, cap_height, line_height = UNITS, CAP_HEIGHT, LINE_HEIGHT

    def __init__(self, name: str, text: str):
        self.name = name
        self._glyphs: dict[str, Glyph] = {}
        self._kerning: dict[tuple[str, str], float] = {}
        marks: dict[str, tuple[BezierPath, ...]] = {}
        for line in text.splitlines():
            head, _, rest = line.partition(" ")
            if line.startswith("#") or not line:
                continue
            if head == "mark":
                name, _, strokes = rest.partition(" ")
                marks[name] = _paths(strokes, 0.0)
            elif head == "kern":
                amount, *pairs = rest.split()
                self._kerning |= {(pair[0], pair[1]): -float(amount) for pair in pairs}
            elif rest.startswith("= "):
                letter, mark = rest.split()[1:]
                self._glyphs[head] = self._marked(letter, mark, marks)
            else:
                width, _, strokes = rest.partition(" ")
                self._glyphs[NAMES.get(head, head)] = Glyph(_paths(strokes, BEARING), float(width) + 2.0 * BEARING)

    def glyph(self, character: str) -> Glyph | None:
        """Return the glyph of a character, None where the font has none."""
        return self._glyphs.get(character)

    def kerning(self, left: str, right: str) -> float:
        """Return by how many units the distance of two characters changes."""
        return self._kerning.get((left, right), 0.0)

    def _marked(self, letter: str, mark: str, marks: dict[str, tuple[BezierPath, ...]]) -> Glyph:
        glyph = self._glyphs[letter]
        y = 0.0 if mark == "cedilla" else ABOVE[letter.isupper()]
        half = max(float(np.abs(path.points.real).max()) for path in marks[mark]) + BEARING / 2.0
        left = max(half - glyph.advance / 2.0, 0.0)  # a mark that is wider than its letter
        place = np.array([(1.0, 0.0, left + glyph.advance / 2.0), (0.0, 1.0, y)])
        moved = np.array([(1.0, 0.0, left), (0.0, 1.0, 0.0)])
        paths = (path.transformed(moved) for path in glyph.paths), (path.transformed(place) for path in marks[mark])
        return Glyph(tuple(itertools.chain(*paths)), glyph.advance + 2.0 * left)


def _paths(strokes: str, left: float) -> tuple[BezierPath, ...]:
    """Return the strokes of a glyph, moved right by `left`."""
    pens: list[PathPen] = []
    for command, numbers in STROKE.findall(strokes):
        values = [float(number) for number in numbers.split()]
        points = [complex(x + left, y) for x, y in zip(values[::2], values[1::2], strict=True)]
        if command == "M":
            pens.append(PathPen(points[0]))
            continue
        pen, end = pens[-1], points[-1]
        way = end - pen.place
        level, upright = way.real * QUARTER, way.imag * QUARTER * 1j
        if command == "L":
            pen.line(end)
        elif command == "C":
            pen.cubic(*points)
        elif command == "v":
            pen.cubic(pen.place + upright, end - level, end)
        else:
            pen.cubic(pen.place + level, end - upright, end)
    return tuple(pen.path() for pen in pens)


@lru_cache
def find_stroke_font(name: str) -> StrokeFont:
    """Return a single-line font by its name; raises JobError that names those there are."""
    if name not in FILES:
        raise JobError(
            "font-unknown",
            Text("there is no single-line font '{name}'", name=name),
            advice=Text("name one of {names}", names=", ".join(FILES)),
        )
    return StrokeFont(name, FILES[name].read_text("utf-8"))
