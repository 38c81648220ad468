# SPDX-License-Identifier: LGPL-2.1-or-later
"""<text>, <tspan> and <textPath> of SVG as outlines, in mm.

<text x y> ──► runs: text of one style, with the place where it begins ──► chunks: runs that an anchor moves
           together ──► letters, each with its matrix ──► outlines
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

from CNCStepper.drawing.svg.document import TEXT, Element
from CNCStepper.drawing.svg.matrices import Matrix, length
from CNCStepper.drawing.svg.styles import Style
from CNCStepper.drawing.text.font import Font, find_font
from CNCStepper.drawing.text.overlaps import without_overlaps
from CNCStepper.drawing.text.text_curves import TextStyle, line_layout, oriented, scale_of
from CNCStepper.errors import JobError
from CNCStepper.geometry.curve import Curve

ANCHORS = {"middle": -0.5, "end": -1.0}
MOST_CHARACTERS = 20_000  # of one text
SIZE = 16.0  # of CSS: medium
SIZES = {
    "xx-small": 9.0,
    "x-small": 10.0,
    "small": 13.0,
    "medium": 16.0,
    "large": 18.0,
    "x-large": 24.0,
    "xx-large": 32.0,
}
BOLD = ("bold", "bolder", "600", "700", "800", "900")
FALLBACK = "sans-serif"
Warn = Callable[[str], None]
PathCurve = Callable[[str], Curve | None]


@dataclass
class _Run:
    """A text of one style: where it begins absolutely, if it does, by how much it is moved, and on which path."""

    text: str
    style: Style
    x: float | None
    y: float | None
    dx: float
    dy: float
    path: Element | None = None


@dataclass
class _Letters:
    """Gathers the runs of a <text>."""

    sheet_style: Callable[[Element, Style, list[Element]], Style]
    runs: list[_Run] = field(default_factory=list)
    characters: int = 0

    def add(self, element: Element, style: Style, path: Element | None, above: list[Element]) -> None:
        """Add what an element holds, with the place that its attributes give to its first letter."""
        first: dict[str, float | None] = {key: _first(element, key) for key in ("x", "y", "dx", "dy")}
        preserve = element.get("xml:space") == "preserve"
        for child in element.children:
            if child.name == TEXT:
                text = child.text.replace("\n", " ") if preserve else " ".join(f"|{child.text}|".split())[1:-1]
                text = text if preserve or self.runs else text.lstrip()
                self.characters += len(text)
                if self.characters > MOST_CHARACTERS:
                    raise JobError("svg-large", "a text is too long", limit=f"{MOST_CHARACTERS} characters")
                if text.strip() or (text and self.runs):
                    move = (first["dx"] or 0.0, first["dy"] or 0.0)
                    self.runs.append(_Run(text, style, first["x"], first["y"], *move, path))
                    first = dict.fromkeys(first)
            elif child.name in ("tspan", "textPath", "a"):
                own = self.sheet_style(child, style, [*above, element])
                if own.get("display") == "none":
                    continue
                before = len(self.runs)
                self.add(child, own, child if child.name == "textPath" else path, [*above, element])
                if len(self.runs) > before:
                    run = self.runs[before]
                    run.x, run.y = (
                        (run.x if run.x is not None else first["x"]),
                        (run.y if run.y is not None else first["y"]),
                    )
                    run.dx, run.dy = run.dx + (first["dx"] or 0.0), run.dy + (first["dy"] or 0.0)
                    first = dict.fromkeys(first)


def text_outlines(
    element: Element,
    style: Style,
    matrix: Matrix,
    tolerance_mm: float,
    sheet_style: Callable[[Element, Style, list[Element]], Style],
    path_curve: PathCurve,
    warn: Warn,
) -> list[Curve]:
    """Return the outlines of a <text> in mm; `matrix` places its user units.

    `sheet_style` gives the style of an element inside it, `path_curve` the path of a textPath in user units by its
    address. Raises JobError for letters that no font has.
    """
    letters = _Letters(sheet_style)
    letters.add(element, style, None, [])
    found: list[Curve] = []
    place = 0j
    for chunk in _chunks(letters.runs):
        place = _set_chunk(chunk, place, matrix, tolerance_mm, path_curve, warn, found)
    return found


def _first(element: Element, key: str) -> float | None:
    text = element.get(key).replace(",", " ").split()
    return length(text[0], 0.0, 0.0) if text else None


def _chunks(runs: list[_Run]) -> Iterator[list[_Run]]:
    """Yield the runs that an anchor moves together: up to the next one with a place of its own."""
    chunk: list[_Run] = []
    for run in runs:
        if chunk and (run.x is not None or run.y is not None or run.path is not chunk[-1].path):
            yield chunk
            chunk = []
        chunk.append(run)
    if chunk:
        yield chunk


def _set_chunk(
    chunk: list[_Run],
    place: complex,
    matrix: Matrix,
    tolerance_mm: float,
    path_curve: PathCurve,
    warn: Warn,
    found: list[Curve],
) -> complex:
    """Set the runs of one chunk; return where the next one goes on."""
    lines = []
    for run in chunk:
        font, text_style = _font(run.style, warn)
        glyphs, width = line_layout(font, text_style, run.text)
        lines.append((run, font, text_style, glyphs, width))
    start = chunk[0]
    x = start.x if start.x is not None else place.real
    y = start.y if start.y is not None else place.imag
    whole = sum(width for *_, width in lines)
    place = complex(x + ANCHORS.get(start.style.get("text-anchor", ""), 0.0) * whole, y)
    along = path_curve(start.path.get("href") or start.path.get("xlink:href")) if start.path is not None else None
    if along is not None and start.path is not None:
        place += length(start.path.get("startOffset"), along.length_mm, 0.0) - x
        place = complex(place.real, 0.0)
    for run, font, text_style, glyphs, width in lines:
        place += complex(run.dx, run.dy)
        for glyph in glyphs:
            own = _letter_matrix(place + glyph.x_mm, glyph.advance_mm, along)
            if own is not None:
                found.extend(_outlines(font, text_style, glyph.character, matrix @ own, tolerance_mm))
        place += width
    return place


def _letter_matrix(place: complex, advance: float, along: Curve | None) -> Matrix | None:
    """Return where a letter with Y up stands, in user units; None for one beyond the ends of its path."""
    flip = Matrix.of(1.0, 0.0, 0.0, -1.0, 0.0, 0.0)
    if along is None:
        return Matrix(shift=place) @ flip
    middle = place.real + advance / 2.0
    if not 0.0 <= middle <= along.length_mm:
        return None
    point, direction = along.at_length(middle)
    turn = complex(*direction.tolist())
    at = complex(*point.tolist()) + turn * (complex(-advance / 2.0, place.imag))
    return Matrix(turn, 0j, at) @ flip


def _outlines(font: Font, style: TextStyle, character: str, matrix: Matrix, tolerance_mm: float) -> list[Curve]:
    glyph, scale = font.glyph(character), scale_of(font, style)
    assert glyph is not None  # line_layout has seen to it
    placed = (matrix @ Matrix(complex(scale))).array
    curves = [path.transformed(placed).curve(tolerance_mm) for path in glyph.paths]
    return without_overlaps(oriented(curves), tolerance_mm)


def _font(style: Style, warn: Warn) -> tuple[Font, TextStyle]:
    """Return the first font of the list that the system has, and how it is set, in user units."""
    size = font_size(style)
    slanted = style.get("font-style", "") in ("italic", "oblique")
    bold = style.get("font-weight", "") in BOLD
    wanted = " ".join(word for word, is_so in (("Bold", bold), ("Italic", slanted)) if is_so)
    names = [name.strip(" '\"") for name in style.get("font-family", FALLBACK).split(",")]
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
                warn(f"{names[0]} {wanted}".strip())
            return font, TextStyle(height_mm=size, size="em", letter_spacing_mm=spacing)
    raise JobError("font-unknown", "the system has no font")


def font_size(style: Style) -> float:
    """Return the size of a style's font in user units; the sizes of elements around it are in it already."""
    text = style.get("font-size", "")
    size = SIZES.get(text.strip(), length(text, SIZE, SIZE))
    return size if 0.0 < size < 1e6 and math.isfinite(size) else SIZE
