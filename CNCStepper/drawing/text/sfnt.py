# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of a font file (TrueType, OpenType, collections of them): found, bounded, and the few numbers needed.

    file ──► Faces: the offsets of its faces ──► Sfnt: tables by tag ──► name · OS/2 · head · hhea · hmtx · maxp

Each number is read where it is asked for; no table is expanded as a whole, so that a hostile file costs no more time
and memory than its own size. Source: the OpenType specification, version 1.9.1.
"""

from __future__ import annotations

import struct
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from CNCStepper.errors import JobError, Place, Text
from CNCStepper.input_file import read_input
from CNCStepper.safe_text import printable

MOST_BYTES = 64_000_000  # the largest faces with all of Unicode's Han take 30 MB
MOST_FACES = 64
MOST_TABLES = 256
MOST_NAMES = 4096
KINDS = (b"\x00\x01\x00\x00", b"OTTO", b"true")
FAMILY, STYLE, TYPOGRAPHIC_FAMILY, TYPOGRAPHIC_STYLE = 1, 2, 16, 17
WINDOWS, MACINTOSH, UNICODE, ENGLISH = 3, 1, 0, 0x409
MOST_UNITS = 65_535


class FontDamage(ValueError):
    """A place of a font file that does not hold what it should."""


@dataclass(frozen=True)
class Metrics:
    """The heights of a face in units of which `units` are one em."""

    units: int
    ascender: int
    descender: int
    line_gap: int
    cap_height: int  # 0 where the file does not say it


def font_file(path: Path) -> bytes:
    """Return the bytes of a font file; raises JobError for one that cannot be read or is no font."""
    content = read_input(path, MOST_BYTES)
    if content[:4] not in (*KINDS, b"ttcf"):
        raise JobError(
            "font-file",
            "not a TrueType or OpenType font",
            advice="name a file that ends in .ttf, .otf, .ttc or .otc; unpack a web font first",
            place=Place(str(path)),
        )
    return content


def face_offsets(head: bytes) -> list[int]:
    """Return where the faces of a file begin, which starts with `head`; raises FontDamage."""
    if head[:4] != b"ttcf":
        return [0]
    (count,) = unpacked(">L", head, 8)
    if not 1 <= count <= MOST_FACES:
        raise FontDamage(f"a collection of {count} faces")
    return list(unpacked(f">{count}L", head, 12))


def table_places(directory: bytes, offset: int = 0) -> dict[str, tuple[int, int]]:
    """Return offset and length of each table of the face at `offset`; raises FontDamage."""
    kind, count = unpacked(">4sH", directory, offset)
    if kind not in KINDS or count > MOST_TABLES:
        raise FontDamage("the table of tables is damaged")
    rows = (unpacked(">4sLLL", directory, offset + 12 + 16 * row) for row in range(count))
    return {tag.decode("latin-1"): (at, length) for tag, _, at, length in rows}


def unpacked(form: str, data: bytes, at: int) -> tuple[Any, ...]:
    """Return the numbers at a place of a table; raises FontDamage where it ends before."""
    if at < 0:
        raise FontDamage("a place before the begin of a table")
    try:
        return struct.unpack_from(form, data, at)
    except struct.error as error:
        raise FontDamage(str(error)) from error


def names_of(table: bytes) -> dict[int, str]:
    """Return the names of a `name` table by number, English ones first; raises FontDamage."""
    _, count, strings = unpacked(">HHH", table, 0)
    found: dict[int, tuple[int, str]] = {}
    for row in range(min(count, MOST_NAMES)):
        platform, _, language, number, length, at = unpacked(">6H", table, 6 + 12 * row)
        rank = {WINDOWS: 3, UNICODE: 2, MACINTOSH: 1}.get(platform, 0) + 4 * (language in (0, ENGLISH))
        if number in (FAMILY, STYLE, TYPOGRAPHIC_FAMILY, TYPOGRAPHIC_STYLE) and rank > found.get(number, (0, ""))[0]:
            raw = table[strings + at : strings + at + min(length, 512)]
            text = raw.decode("mac-roman" if platform == MACINTOSH else "utf-16-be", "replace")
            found[number] = rank, printable(text.strip(), 128)
    return {number: text for number, (_, text) in found.items()}


def family_and_style(table: bytes) -> tuple[str, str]:
    """Return family and style as a person knows them."""
    names = names_of(table)
    family = names.get(TYPOGRAPHIC_FAMILY) or names.get(FAMILY, "")
    return family, names.get(TYPOGRAPHIC_STYLE) or names.get(STYLE, "") or "Regular"


class Sfnt:
    """The tables of one face of a font file; raises JobError for one that is damaged."""

    def __init__(self, content: bytes, face: int, path: Path):
        self.path = path
        with damage_of(path):
            offsets = face_offsets(content)
            if not 0 <= face < len(offsets):
                raise FontDamage(f"it has no face {face}")
            self._places = table_places(content, offsets[face])
            self._content = content
            head, maxp, hhea = (self.table(tag) for tag in ("head", "maxp", "hhea"))
            self.long_offsets = bool(unpacked(">h", head, 50)[0])
            self.glyphs: int = unpacked(">H", maxp, 4)[0]
            self._advances: int = unpacked(">H", hhea, 34)[0]
            self._hmtx = self.table("hmtx")
            self.metrics = self._metrics(head, hhea)

    def table(self, tag: str) -> bytes:
        """Return a table, empty where there is none; raises FontDamage for one beyond the end of the file."""
        at, length = self._places.get(tag, (0, 0))
        if at + length > len(self._content):
            raise FontDamage(f"the table {printable(tag)} lies beyond the end of the file")
        return self._content[at : at + length]

    def has(self, tag: str) -> bool:
        """Return whether the face has a table."""
        return tag in self._places

    def advance(self, glyph: int) -> int:
        """Return how far the next glyph is, units; raises FontDamage."""
        if not self._advances:
            raise FontDamage("it has no widths")
        return int(unpacked(">H", self._hmtx, 4 * min(glyph, self._advances - 1))[0])

    def _metrics(self, head: bytes, hhea: bytes) -> Metrics:
        (units,) = unpacked(">H", head, 18)
        if not 16 <= units <= MOST_UNITS:
            raise FontDamage(f"{units} units an em")
        ascender, descender, line_gap = unpacked(">3h", hhea, 4)
        os2 = self.table("OS/2")
        has_cap_height = len(os2) >= 90 and unpacked(">H", os2, 0)[0] >= 2
        cap_height = unpacked(">h", os2, 88)[0] if has_cap_height else 0
        return Metrics(units, ascender, descender, line_gap, max(cap_height, 0))


class damage_of:
    """Turns what a damaged font file makes of its reader into a JobError that names the file."""

    def __init__(self, path: Path):
        self._path = path

    def __enter__(self) -> None:
        return None

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: object) -> None:
        if isinstance(
            error, FontDamage | ArithmeticError | AttributeError | LookupError | struct.error | AssertionError
        ):
            why = printable(str(error), 255) or type(error).__name__
            raise JobError(
                "font-damaged",
                Text("the font is damaged: {why}", why=why),
                advice="install it again, or choose another font",
                place=Place(str(self._path)),
            ) from error
