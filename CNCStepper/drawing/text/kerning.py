# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much nearer two glyphs of a font stand: pair adjustment of `GPOS`, or the older table `kern`.

Both are looked into for one pair at a time, by halving; nothing is expanded (see character_map.py for why).
Source: the OpenType specification, version 1.9.1, GPOS lookup types 2 and 9, kern format 0.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from CNCStepper.drawing.text.sfnt import FontDamage, Sfnt, unpacked

PAIR, EXTENSION = 2, 9
X_ADVANCE = 0x0004
MOST_LOOKUPS = 1024  # with their subtables: fonts of many scripts have some hundred
SCRIPTS = (b"latn", b"DFLT")


class Kerning:
    """The pairs of one face, each looked up once."""

    def __init__(self, font: Sfnt):
        self._pairs: dict[tuple[int, int], int] = {}
        gpos, kern = font.table("GPOS"), font.table("kern")
        self._gpos, self._subtables = gpos, tuple(_pair_subtables(gpos)) if gpos else ()
        self._kern, self._lists = kern, tuple(_pair_lists(kern)) if kern and not self._subtables else ()

    def units(self, left: int, right: int) -> int:
        """Return by how many units the distance of two glyphs changes, mostly below 0; raises FontDamage."""
        key = (left, right)
        if key not in self._pairs:
            self._pairs[key] = self._looked_up(left, right)
        return self._pairs[key]

    def _looked_up(self, left: int, right: int) -> int:
        total = 0
        for lookup in self._subtables:
            for at in lookup:
                found = _pair(self._gpos, at, left, right)
                if found is not None:  # the first subtable of a lookup that knows the pair settles it
                    total += found
                    break
        return total + sum(_listed(self._kern, at, count, left, right) for at, count in self._lists)


def _pair_subtables(gpos: bytes) -> Iterator[tuple[int, ...]]:
    """Yield the subtables of each lookup for pairs which the feature `kern` of the Latin or default script names."""
    scripts, features, lookups = unpacked(">HHH", gpos, 4)
    budget = MOST_LOOKUPS
    for number in _kern_lookups(gpos, scripts, features):
        if number >= unpacked(">H", gpos, lookups)[0]:
            continue
        at = lookups + unpacked(">H", gpos, lookups + 2 + 2 * number)[0]
        kind, _, count = unpacked(">HHH", gpos, at)
        budget -= count + 1
        if budget < 0:
            raise FontDamage("it has too many tables of pairs")
        subtables = [at + unpacked(">H", gpos, at + 6 + 2 * row)[0] for row in range(count)]
        if kind == EXTENSION:
            kinds = [unpacked(">HHL", gpos, subtable) for subtable in subtables]
            subtables = [
                subtable + offset for subtable, (_, kind, offset) in zip(subtables, kinds, strict=True) if kind == PAIR
            ]
        if kind in (PAIR, EXTENSION) and subtables:
            yield tuple(subtables)


def _kern_lookups(gpos: bytes, scripts: int, features: int) -> list[int]:
    """Return the numbers of the lookups, ascending, each once."""
    script = _script(gpos, scripts)
    if script is None:
        return []
    language = unpacked(">H", gpos, script)[0]
    if not language:
        return []
    required, count = unpacked(">HH", gpos, script + language + 2)
    numbers = [required, *unpacked(f">{count}H", gpos, script + language + 6)]
    found: set[int] = set()
    known = unpacked(">H", gpos, features)[0]
    for number in numbers[:MOST_LOOKUPS]:
        if number >= known:
            continue
        tag, offset = unpacked(">4sH", gpos, features + 2 + 6 * number)
        if tag == b"kern":
            lookups = unpacked(">H", gpos, features + offset + 2)[0]
            found |= set(unpacked(f">{min(lookups, MOST_LOOKUPS)}H", gpos, features + offset + 4))
    return sorted(found)


def _script(gpos: bytes, scripts: int) -> int | None:
    """Return where the Latin script, or the default one, is described."""
    count = min(unpacked(">H", gpos, scripts)[0], MOST_LOOKUPS)
    rows: dict[bytes, int] = dict(unpacked(">4sH", gpos, scripts + 2 + 6 * row)[:2] for row in range(count))
    offset = next((rows[tag] for tag in SCRIPTS if tag in rows), None)
    return None if offset is None else scripts + offset


def _pair(gpos: bytes, at: int, left: int, right: int) -> int | None:
    """Return what a subtable says of two glyphs, None where it does not know them."""
    form, coverage, first_format, second_format = unpacked(">HHHH", gpos, at)
    row = _covered(gpos, at + coverage, left)
    if row is None:
        return None
    first_bytes, second_bytes = (2 * (form & 0xFF).bit_count() for form in (first_format, second_format))
    before = 2 * (first_format & (X_ADVANCE - 1)).bit_count()
    if form == 1:
        place = _in_set(gpos, at, row, right, 2 + first_bytes + second_bytes)
    elif form == 2:
        place = _of_classes(gpos, at, left, right, first_bytes + second_bytes)
    else:
        return None
    if place is None:
        return None
    return int(unpacked(">h", gpos, place + before)[0]) if first_format & X_ADVANCE else 0


def _in_set(gpos: bytes, at: int, row: int, right: int, size: int) -> int | None:
    """Format 1: return where the values for a pair of glyphs are."""
    if row >= unpacked(">H", gpos, at + 8)[0]:
        return None
    pairs = at + unpacked(">H", gpos, at + 10 + 2 * row)[0]
    found = _halved(gpos, pairs + 2, unpacked(">H", gpos, pairs)[0], size, lambda place: _compare(gpos, place, right))
    return None if found is None else pairs + 2 + size * found + 2


def _of_classes(gpos: bytes, at: int, left: int, right: int, size: int) -> int | None:
    """Format 2: return where the values for a pair of classes are."""
    first_classes, second_classes, firsts, seconds = unpacked(">HHHH", gpos, at + 8)
    first, second = _class(gpos, at + first_classes, left), _class(gpos, at + second_classes, right)
    if first >= firsts or second >= seconds:
        return None
    return int(at + 16 + (first * seconds + second) * size)


def _covered(gpos: bytes, at: int, glyph: int) -> int | None:
    """Return the row of a glyph in a coverage table."""
    form, count = unpacked(">HH", gpos, at)
    if form == 1:
        return _halved(gpos, at + 4, count, 2, lambda place: _compare(gpos, place, glyph))
    row = _halved(gpos, at + 4, count, 6, lambda place: _compare_range(gpos, place, glyph))
    if row is None:
        return None
    first, _, index = unpacked(">HHH", gpos, at + 4 + 6 * row)
    return int(index + glyph - first)


def _class(gpos: bytes, at: int, glyph: int) -> int:
    """Return the class of a glyph, 0 where the table does not name it."""
    form, start = unpacked(">HH", gpos, at)
    if form == 1:
        count = unpacked(">H", gpos, at + 4)[0]
        return int(unpacked(">H", gpos, at + 6 + 2 * (glyph - start))[0]) if start <= glyph < start + count else 0
    row = _halved(gpos, at + 4, start, 6, lambda place: _compare_range(gpos, place, glyph))
    return 0 if row is None else int(unpacked(">H", gpos, at + 4 + 6 * row + 4)[0])


def _compare(data: bytes, place: int, glyph: int) -> int:
    return glyph - int(unpacked(">H", data, place)[0])


def _compare_range(data: bytes, place: int, glyph: int) -> int:
    first, last = unpacked(">HH", data, place)
    return min(glyph - first, 0) or max(glyph - last, 0)


def _halved(data: bytes, at: int, count: int, size: int, compare: Callable[[int], int]) -> int | None:
    """Return the row, of rows in ascending order, with which `compare` finds no difference."""
    low, high = 0, count
    while low < high:
        middle = (low + high) // 2
        difference = compare(at + size * middle)
        if not difference:
            return middle
        if difference < 0:
            high = middle
        else:
            low = middle + 1
    return None


def _pair_lists(kern: bytes) -> Iterator[tuple[int, int]]:
    """Yield where the pairs of each horizontal table of `kern` are, and how many; Windows' and Apple's headers."""
    version, count = unpacked(">HH", kern, 0)
    wide = version == 1
    at = 8 if wide else 4
    for _ in range(min(unpacked(">L", kern, 4)[0] if wide else count, MOST_LOOKUPS)):
        length, coverage = unpacked(">LH", kern, at) if wide else unpacked(">HH", kern, at + 2)
        header = 8 if wide else 6
        horizontal = coverage & 0xE0FF == 0 if wide else coverage & 0xFF07 == 1
        if horizontal:
            yield at + header + 8, unpacked(">H", kern, at + header)[0]
        at += max(length, header)


def _listed(kern: bytes, at: int, count: int, left: int, right: int) -> int:
    """Return the value of a pair in a list of `kern`, 0 where it has none."""

    def compare(place: int) -> int:
        one, other = unpacked(">HH", kern, place)
        return ((left << 16) + right) - ((one << 16) + other)

    row = _halved(kern, at, count, 6, compare)
    return 0 if row is None else int(unpacked(">h", kern, at + 6 * row + 4)[0])
