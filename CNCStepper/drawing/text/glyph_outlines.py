# SPDX-License-Identifier: LGPL-2.1-or-later
"""The outlines of a font's glyphs as paths, in the font's units: `glyf`, `CFF ` and `CFF2` at their default.

fonttools takes apart the one glyph that is asked for; the tables that list the glyphs are looked into here, and what a
glyph may hold is counted, so that no font takes longer than its size allows:

    parts of composite glyphs   MOST_PARTS, DEEPEST       a glyph of ten of itself, ten times over
    calls of subroutines        MOST_CALLS                the same in CFF
    segments                    MOST_SEGMENTS
"""

from __future__ import annotations

import itertools
import logging
import struct
from collections.abc import Iterator
from typing import Any, Protocol

import numpy as np

from CNCStepper.drawing.text.sfnt import FontDamage, Sfnt, unpacked
from CNCStepper.geometry.fitting.bezier_path import BezierPath, PathPen

MOST_PARTS = 256
DEEPEST = 8
MOST_CALLS = 4096
MOST_SEGMENTS = 50_000
ON_CURVE = 1
logging.getLogger("fontTools").addHandler(logging.NullHandler())


class Outlines(Protocol):
    """Gives the paths of a glyph by its number."""

    def paths(self, glyph: int) -> tuple[BezierPath, ...]:
        """Return the closed paths of a glyph, units; raises FontDamage and what damage_of knows."""


def outlines_of(font: Sfnt) -> Outlines:
    """Return the outlines of a font; raises FontDamage for one that has only bitmaps or SVG."""
    if font.has("glyf") and font.has("loca"):
        return _TrueType(font)
    for tag, two in (("CFF2", True), ("CFF ", False)):
        if font.has(tag):
            return _Compact(font.table(tag), two)
    raise FontDamage("it has no outlines")


class _TrueType:
    """Glyphs of quadratic curves: `glyf`, with `loca` for their places."""

    extended = False  # as fonttools asks the table of glyphs

    def __init__(self, font: Sfnt):
        self._glyf, self._loca = font.table("glyf"), font.table("loca")
        self._long, self._count = font.long_offsets, font.glyphs

    def getGlyphName(self, glyph: int) -> int:
        """Return the number of a part as its name; fonttools asks for it."""
        return glyph

    def paths(self, glyph: int) -> tuple[BezierPath, ...]:
        """Return the paths of a glyph with those of its parts."""
        parts = itertools.count()
        return tuple(self._paths(glyph, np.eye(2, 3), 0, parts))

    def _paths(self, number: int, matrix: np.ndarray, depth: int, parts: Iterator[int]) -> Iterator[BezierPath]:
        from fontTools.ttLib.tables._g_l_y_f import Glyph

        if depth > DEEPEST or next(parts) > MOST_PARTS:
            raise FontDamage("a glyph has too many parts")
        glyph = Glyph(self._data(number))
        glyph.expand(self)
        if glyph.isComposite():
            for part in glyph.components:
                name, (a, b, c, d, e, f) = part.getComponentInfo()
                own = np.array([(a, c, e), (b, d, f), (0.0, 0.0, 1.0)])
                yield from self._paths(int(name), matrix @ own, depth + 1, parts)
        elif glyph.numberOfContours > 0:
            points = np.array(list(glyph.coordinates), float) @ (1.0, 1j)
            on = np.frombuffer(bytes(glyph.flags), np.uint8) & ON_CURVE
            first = 0
            for last in glyph.endPtsOfContours:
                contour = _contour(points[first : last + 1].tolist(), on[first : last + 1].tolist())
                if contour is not None:
                    yield contour.transformed(matrix)
                first = last + 1

    def _data(self, glyph: int) -> bytes:
        if not 0 <= glyph < self._count:
            raise FontDamage(f"it has no glyph {glyph}")
        form, size, factor = (">LL", 4, 1) if self._long else (">HH", 2, 2)
        begin, end = unpacked(form, self._loca, size * glyph)
        return self._glyf[factor * begin : factor * end]


def _contour(points: list[complex], on: list[int]) -> BezierPath | None:
    """Return a closed contour: between two control points in a row lies a point of the curve."""
    if len(points) < 2:
        return None
    if 1 in on:
        first = on.index(1)
        points, on = points[first:] + points[:first], on[first:] + on[:first]
        start = points[0]
    else:
        start = (points[-1] + points[0]) / 2.0
        points, on = [start, *points], [1, *on]
    pen, control = PathPen(start), None
    for point, is_on in [*zip(points[1:], on[1:], strict=True), (start, 1)]:
        if control is not None:
            end = point if is_on else (control + point) / 2.0
            pen.quadratic(control, end)
        elif is_on:
            pen.line(point)
        control = None if is_on else point
    pen.close()
    return pen.path() if len(pen) else None


class _Compact:
    """Glyphs of cubic curves: `CFF ` and `CFF2`. Source: Adobe's technical notes 5176 and 5177, OpenType's CFF2."""

    def __init__(self, table: bytes, two: bool):
        self._data, self._two = table, two
        header = unpacked(">B", table, 2)[0]
        if two:
            length = unpacked(">H", table, 3)[0]
            top, after = _dictionary(table[header : header + length]), header + length
        else:
            names = _Index(table, header, False)
            tops = _Index(table, names.end, False)
            strings = _Index(table, tops.end, False)
            top, after = _dictionary(tops[0]), strings.end
        self._global = _Programs(_Index(table, after, two))
        self._glyphs = _Index(table, _offset(top, "CharStrings"), two)
        self._faces = _Index(table, int(top["FDArray"][0]), two) if top.get("FDArray") else None
        self._select = int(top["FDSelect"][0]) if top.get("FDSelect") else None
        self._regions = int(top["vstore"][0]) if top.get("vstore") else None
        self._top = top
        self._private: dict[int, _Private] = {}

    def paths(self, glyph: int) -> tuple[BezierPath, ...]:
        """Return the paths of a glyph."""
        from fontTools.misc.psCharStrings import T2CharString

        private = self._private_of(self._face(glyph))
        pen = _CubicPen()
        extractor = _extractor()(pen, private.subroutines, self._global, 0, 0, private, None)
        extractor.execute(T2CharString(self._glyphs[glyph], private=private, globalSubrs=self._global))
        return pen.finished()

    def _face(self, glyph: int) -> int:
        """Return which private dictionary a glyph has (FDSelect, formats 0, 3 and 4)."""
        at = self._select
        if at is None or self._faces is None:
            return 0
        (form,) = unpacked(">B", self._data, at)
        if form == 0:
            return int(unpacked(">B", self._data, at + 1 + glyph)[0])
        head, row = (">H", ">HB") if form == 3 else (">L", ">LH")
        low, high = 0, unpacked(head, self._data, at + 1)[0]
        first, size = at + 1 + struct.calcsize(head), struct.calcsize(row)
        while high - low > 1:
            middle = (low + high) // 2
            if unpacked(row, self._data, first + size * middle)[0] <= glyph:
                low = middle
            else:
                high = middle
        return int(unpacked(row, self._data, first + size * low)[1])

    def _private_of(self, face: int) -> _Private:
        if face not in self._private:
            top = self._top if self._faces is None else _dictionary(self._faces[face])
            size, offset = (int(number) for number in top.get("Private", (0, 0)))
            own = _dictionary(self._data[offset : offset + size])
            subroutines = _Index(self._data, offset + int(own["Subrs"][0]), self._two) if own.get("Subrs") else None
            vsindex = int(own.get("vsindex", (0,))[0])
            self._private[face] = _Private(_Programs(subroutines), self._data, self._regions, vsindex)
        return self._private[face]


class _Private:
    """What a glyph's program takes from its private dictionary."""

    def __init__(self, subroutines: _Programs, data: bytes, regions: int | None, vsindex: int):
        self.subroutines, self.vsindex = subroutines, vsindex
        self._data, self._regions = data, regions

    def getNumRegions(self, vsindex: int | None = None) -> int:
        """Return how many deltas follow each default of a blend; fonttools asks for it."""
        if self._regions is None:
            return 0
        store = self._regions + 2  # behind its length
        row = self.vsindex if vsindex is None else vsindex
        if not 0 <= row < unpacked(">H", self._data, store + 6)[0]:
            raise FontDamage("a variation that is not there")
        offset = unpacked(">L", self._data, store + 8 + 4 * row)[0]
        return int(unpacked(">H", self._data, store + offset + 4)[0])


class _Index:
    """An INDEX of CFF: pieces of data by number; raises FontDamage for one that is longer than the table."""

    def __init__(self, data: bytes, at: int, wide: bool):
        self._data = data
        count = unpacked(">L" if wide else ">H", data, at)[0]
        at += 4 if wide else 2
        self._count, self._size, self._offsets = count, 1, at + 1
        if not count:
            self.end = at
            return
        self._size = unpacked(">B", data, at)[0]
        self._base = self._offsets + (count + 1) * self._size - 1
        if not 1 <= self._size <= 4 or self._base > len(data):
            raise FontDamage("a list of glyphs is longer than its table")
        self.end = self._base + self._offset(count)

    def __len__(self) -> int:
        return int(self._count)

    def __getitem__(self, number: int) -> bytes:
        if not 0 <= number < self._count:
            raise FontDamage(f"a list has no entry {number}")
        return self._data[self._base + self._offset(number) : self._base + self._offset(number + 1)]

    def _offset(self, number: int) -> int:
        at = self._offsets + number * self._size
        return int.from_bytes(self._data[at : at + self._size], "big")


class _Programs:
    """An INDEX of subroutines as fonttools takes them."""

    def __init__(self, index: _Index | None):
        self._index = index
        self._made: dict[int, Any] = {}

    def __len__(self) -> int:
        return len(self._index) if self._index else 0

    def __getitem__(self, number: int) -> Any:
        from fontTools.misc.psCharStrings import T2CharString

        if self._index is None:
            raise FontDamage("it has no subroutines")
        if number not in self._made:
            self._made[number] = T2CharString(self._index[number])
        return self._made[number]


_OPERATORS = {
    17: "CharStrings",
    18: "Private",
    19: "Subrs",
    22: "vsindex",
    24: "vstore",
    1236: "FDArray",
    1237: "FDSelect",
}
_REAL = "0123456789.E? -"


def _dictionary(data: bytes) -> dict[str, list[float]]:
    """Return the operands of a DICT of CFF by the operators that are needed."""
    found: dict[str, list[float]] = {}
    operands: list[float] = []
    at = 0
    while at < len(data):
        first = data[at]
        if first >= 28 and first not in (31, 255):
            number, at = _number(data, at)
            operands.append(number)
            continue
        operator, at = (1200 + unpacked(">B", data, at + 1)[0], at + 2) if first == 12 else (first, at + 1)
        if operator in _OPERATORS:
            found[_OPERATORS[operator]] = operands
        operands = []
    return found


def _number(data: bytes, at: int) -> tuple[float, int]:
    """Return a number of a DICT and where the next thing is; a real one is passed over: none is needed."""
    first = data[at]
    if first == 28:
        return unpacked(">h", data, at + 1)[0], at + 3
    if first == 29:
        return unpacked(">i", data, at + 1)[0], at + 5
    if first == 30:
        end = at + 1
        while end < len(data) and data[end] & 0x0F != 0x0F and data[end] >> 4 != 0x0F:
            end += 1
        return 0.0, end + 1
    if first <= 246:
        return first - 139, at + 1
    (second,) = unpacked(">B", data, at + 1)
    return ((first - 247) * 256 + second + 108 if first <= 250 else -(first - 251) * 256 - second - 108), at + 2


def _offset(top: dict[str, list[float]], name: str) -> int:
    if not top.get(name):
        raise FontDamage(f"it has no {name}")
    return int(top[name][0])


class _CubicPen:
    """Takes what fonttools draws of a CFF glyph, and counts it."""

    def __init__(self) -> None:
        self._pen: PathPen | None = None
        self._paths: list[BezierPath] = []
        self._count = 0

    def moveTo(self, point: tuple[float, float]) -> None:
        """Begin a path."""
        self.closePath()
        self._pen = PathPen(complex(*point))

    def lineTo(self, point: tuple[float, float]) -> None:
        """Draw a line."""
        self._counted().line(complex(*point))

    def curveTo(self, *points: tuple[float, float]) -> None:
        """Draw a Bezier curve."""
        self._counted().cubic(*(complex(*point) for point in points))

    def closePath(self) -> None:
        """End the path where it began."""
        if self._pen is not None and len(self._pen):
            self._pen.close()
            self._paths.append(self._pen.path())
        self._pen = None

    endPath = closePath

    def finished(self) -> tuple[BezierPath, ...]:
        """Return the paths."""
        self.closePath()
        return tuple(self._paths)

    def _counted(self) -> PathPen:
        self._count += 1
        if self._count > MOST_SEGMENTS or self._pen is None:
            raise FontDamage("a glyph has too many segments")
        return self._pen


def _extractor() -> type:
    """Return fonttools' extractor of outlines with its calls counted."""
    from fontTools.misc.psCharStrings import T2OutlineExtractor

    class Counted(T2OutlineExtractor):  # type: ignore[misc]
        calls = 0
        bytes = 0

        def execute(self, charString: Any) -> None:
            self.calls += 1
            self.bytes += len(charString.bytecode or charString.program)
            if self.calls > MOST_CALLS or self.bytes > MOST_SEGMENTS * 8 or self.subrLevel > DEEPEST + 4:
                raise FontDamage("a glyph calls too many subroutines")
            super().execute(charString)

    return Counted
