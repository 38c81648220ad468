# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which glyph of a font a character is: the `cmap` table, formats 0, 4, 6, 10, 12 and 13, looked into as it is.

A table of a few bytes may map a million characters: each character is looked for by halving.
"""

from __future__ import annotations

from CNCStepper.drawing.text.sfnt import FontDamage, unpacked

RANKS = {(3, 10): 6, (0, 4): 5, (0, 6): 5, (3, 1): 4, (0, 3): 4, (0, 2): 3, (0, 1): 3, (0, 0): 3, (3, 0): 2, (1, 0): 1}
MOST_TABLES = 64
SYMBOL = (3, 0)
SYMBOLS = 0xF000  # where fonts of symbols have their characters


class CharacterMap:
    """The best table of a font's `cmap`; raises FontDamage where there is none that is known."""

    def __init__(self, table: bytes):
        _, count = unpacked(">HH", table, 0)
        found = []
        for row in range(min(count, MOST_TABLES)):
            platform, encoding, at = unpacked(">HHL", table, 4 + 8 * row)
            (form,) = unpacked(">H", table, at)
            rank = RANKS.get((platform, encoding), 0)
            if rank and form in _FORMS:
                found.append((rank, -row, form, at, (platform, encoding)))
        if not found:
            raise FontDamage("it maps no characters")
        _, _, form, at, kind = max(found)
        self._look, self._data, self._symbol = _FORMS[form], table[at:], kind == SYMBOL

    def glyph(self, character: str) -> int:
        """Return the glyph of a character, 0 where the font has none; raises FontDamage."""
        code = ord(character)
        found = self._look(self._data, code)
        if not found and self._symbol and code < 256:
            found = self._look(self._data, SYMBOLS + code)
        return found


def _bytes(data: bytes, code: int) -> int:
    return int(unpacked(">B", data, 6 + code)[0]) if code < 256 else 0


def _segments(data: bytes, code: int) -> int:
    """Format 4: segments of the first 65 536 characters, by their last ones."""
    if code > 0xFFFF:
        return 0
    double = unpacked(">H", data, 6)[0] & ~1
    low, high = 0, double // 2
    while low < high:
        middle = (low + high) // 2
        if unpacked(">H", data, 14 + 2 * middle)[0] < code:
            low = middle + 1
        else:
            high = middle
    if low == double // 2:
        return 0
    starts, deltas, offsets = (16 + double * part + 2 * low for part in (1, 2, 3))
    (start,), (delta,), (offset,) = (unpacked(">H", data, at) for at in (starts, deltas, offsets))
    if code < start:
        return 0
    glyph = code if not offset else unpacked(">H", data, offsets + offset + 2 * (code - start))[0]
    return int(glyph + delta) & 0xFFFF if glyph else 0


def _trimmed(data: bytes, code: int) -> int:
    first, count = unpacked(">HH", data, 6)
    return int(unpacked(">H", data, 10 + 2 * (code - first))[0]) if first <= code < first + count else 0


def _trimmed_wide(data: bytes, code: int) -> int:
    first, count = unpacked(">LL", data, 12)
    return int(unpacked(">H", data, 20 + 2 * (code - first))[0]) if first <= code < first + count else 0


def _groups(data: bytes, code: int) -> int:
    return _group(data, code, 1)


def _one_glyph_groups(data: bytes, code: int) -> int:
    return _group(data, code, 0)


def _group(data: bytes, code: int, step: int) -> int:
    """Formats 12 and 13: groups of characters, whose glyphs follow each other or are one."""
    low, high = 0, unpacked(">L", data, 12)[0]
    while low < high:
        middle = (low + high) // 2
        first, last, glyph = unpacked(">LLL", data, 16 + 12 * middle)
        if first <= code <= last:
            return int(glyph + step * (code - first))
        if code < first:
            high = middle
        else:
            low = middle + 1
    return 0


_FORMS = {0: _bytes, 4: _segments, 6: _trimmed, 10: _trimmed_wide, 12: _groups, 13: _one_glyph_groups}
