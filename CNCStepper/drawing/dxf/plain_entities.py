# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines, arcs, circles and light polylines straight from the text of a DXF file, by columns; ezdxf reads all else.

    text ──► group codes, values ──► ordinary entities ──► columns of numbers ──► curves
                                  └► all else, with header, tables and blocks, as a shorter DXF text for ezdxf

An ordinary entity lies in the model space and is visible from above. Each value that it needs is there once and in
bounds, and no group code means anything else. Other entities stay in the text for ezdxf, so that both readers give the
same drawing. An ordinary entity has its number in the file by its place, another one by its handle.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple, overload

import numpy as np

from CNCStepper.drawing.dxf.group_text import CODES, GroupText, NotSplit, TextColumn, columns_joined
from CNCStepper.geometry.curve import LIMIT_MM, Curve
from CNCStepper.geometry.curve_bundle import Bundle, bundles_joined, runs
from CNCStepper.geometry.curve_columns import STRAIGHT_MM
from CNCStepper.tolerances import COINCIDENT_MM

LARGEST = 1e9  # units: beyond it nothing of a drawing can be told apart
FLAT = 1e-6  # units: heights that differ by less are one
OTHER, LINE, ARC, CIRCLE, POLYLINE = range(5)
KINDS = {b"LINE": LINE, b"ARC": ARC, b"CIRCLE": CIRCLE, b"LWPOLYLINE": POLYLINE}
ALWAYS = (0, 5, 6, 8, 39, 48, 62, 100, 210, 220, 230, 330, 347, 370, 390, 420)
NAMES = {kind: word.decode("ascii") for word, kind in KINDS.items()}
MEANT = {  # group codes beside ALWAYS
    LINE: (10, 20, 30, 11, 21, 31),
    ARC: (10, 20, 30, 40, 50, 51),
    CIRCLE: (10, 20, 30, 40),
    POLYLINE: (10, 20, 38, 40, 41, 42, 43, 70, 90, 91),
}
NEEDED = {LINE: (8, 10, 20, 11, 21), ARC: (8, 10, 20, 40, 50, 51), CIRCLE: (8, 10, 20, 40), POLYLINE: (8, 10, 20, 70)}
REPEATED = (0, 100)
PARTS = (b"VERTEX", b"SEQEND", b"ATTRIB")  # of the entity before them
BLOCK = 4_096  # entities that are taken apart at once
OF_VERTEX = (10, 20, 40, 41, 42, 91)
AFTER = {20: 10, 30: 20, 21: 11, 31: 21, 220: 210, 230: 220}  # a coordinate and the one right before it
NUMBERS = (10, 20, 30, 11, 21, 31, 38, 40, 41, 42, 50, 51, 62, 70, 420)
NAME_NEVER = frozenset(b'\\<>/":;?*=`|\t')  # in a layer's name: ezdxf decodes or corrects it


@dataclass(frozen=True)
class PlainEntity:
    """The curve of an ordinary entity in the unit of the file, its number among the entities, and its attributes."""

    number: int
    curve: Curve
    kind: str
    layer: bytes
    handle: str
    colour_index: int
    true_colour: int | None


class PlainEntities(Sequence[PlainEntity]):
    """Ordinary entities in columns; each is made when it is asked for."""

    def __init__(self, numbers: np.ndarray, curves: Bundle, texts: _Texts):
        self._numbers, self._curves, self._texts = numbers, curves, texts
        self._first = curves.first

    def __len__(self) -> int:
        return len(self._numbers)

    @overload
    def __getitem__(self, index: int) -> PlainEntity: ...

    @overload
    def __getitem__(self, index: slice) -> tuple[PlainEntity, ...]: ...

    def __getitem__(self, index: int | slice) -> PlainEntity | tuple[PlainEntity, ...]:
        rows = range(len(self))[index]
        return tuple(map(self._made, rows)) if isinstance(rows, range) else self._made(rows)

    def _made(self, row: int) -> PlainEntity:
        number, begin, count = int(self._numbers[row]), int(self._first[row]), int(self._curves.counts[row])
        xy, bulge, texts = self._curves.xy, self._curves.bulge, self._texts
        true_colour = int(texts.true_colour[number])
        return PlainEntity(
            number,
            Curve.trusted(xy[begin + row : begin + row + count + 1], bulge[begin : begin + count]),
            NAMES[texts.kinds[number]],
            texts.layers.of(number),
            texts.handles.of(number).decode("ascii", "replace"),
            int(texts.colour_index[number]),
            true_colour if true_colour >= 0 else None,
        )


class _Texts(NamedTuple):
    """What entities have beside their curves, by their numbers."""

    kinds: np.ndarray
    layers: TextColumn
    handles: TextColumn
    colour_index: np.ndarray
    true_colour: np.ndarray


@dataclass(frozen=True)
class SplitText:
    """The ordinary entities of a file, the text of all else, and the number of each entity there by its handle."""

    plain: Sequence[PlainEntity]
    rest: bytes
    numbers: dict[str, int]


def split_text(content: bytes) -> SplitText:
    """Return the ordinary entities of a DXF text and the rest.

    Raises NotSplit for a binary or damaged file, for one without ordinary entities, and for one whose other entities
    have no handles.
    """
    text = GroupText(content)
    codes = text.codes()
    first, last = _section(codes, text)
    starts = first + np.flatnonzero(codes[first:last] == 0)
    if starts[0] != first:
        raise NotSplit  # the entities do not begin with one
    edges = [*starts[::BLOCK].tolist(), last]
    blocks = [_Entities(codes[begin:end], text, begin).found() for begin, end in itertools.pairwise(edges)]
    if not any(block.ordinary.any() for block in blocks):
        raise NotSplit  # there are no ordinary entities
    kept = np.ones(len(codes), bool)
    kept[first:last] = np.repeat(~np.concatenate([block.ordinary for block in blocks]), np.diff(starts, append=last))
    return SplitText(_plain(blocks), text.some(kept), _numbers_by_handle(blocks))


def _plain(blocks: Sequence[_Found]) -> PlainEntities:
    """Return the ordinary entities of blocks of BLOCK entities as one sequence."""
    numbers = np.concatenate([BLOCK * place + block.numbers for place, block in enumerate(blocks)])
    of_all = [block.texts for block in blocks]
    texts = _Texts(
        np.concatenate([texts.kinds for texts in of_all]),
        columns_joined([texts.layers for texts in of_all]),
        columns_joined([texts.handles for texts in of_all]),
        np.concatenate([texts.colour_index for texts in of_all]),
        np.concatenate([texts.true_colour for texts in of_all]),
    )
    return PlainEntities(numbers, bundles_joined([block.curves for block in blocks]), texts)


def _numbers_by_handle(blocks: Sequence[_Found]) -> dict[str, int]:
    """Return the number of each other entity by its handle; raises NotSplit where one has no handle of its own."""
    numbers: dict[str, int] = {}
    for place, block in enumerate(blocks):
        for number in np.flatnonzero(~block.ordinary).tolist():
            handle = block.texts.handles.of(number).decode("ascii", "replace").upper()
            if block.words[number] not in PARTS and (not handle or handle in numbers):
                raise NotSplit
            numbers[handle] = BLOCK * place + number
    return numbers


class _Found(NamedTuple):
    """What a block of entities holds: which are ordinary, their numbers in it and curves; words and texts of all."""

    ordinary: np.ndarray
    numbers: np.ndarray
    curves: Bundle
    words: list[bytes]
    texts: _Texts


def _section(codes: np.ndarray, text: GroupText) -> tuple[int, int]:
    """Return the first group of the entities and the group that ends them."""
    first = None
    for group in np.flatnonzero(codes == 0).tolist():
        word = text.value(group).strip()
        if first is not None and word in (b"ENDSEC", b"SECTION", b"EOF"):
            if word != b"ENDSEC" or group == first:
                break
            return first, group
        if word == b"SECTION" and group + 2 < len(codes) and codes[group + 1] == 2:
            first = group + 2 if text.value(group + 1).strip() == b"ENTITIES" else first
    raise NotSplit  # there is no whole section of entities


class _Entities:
    """The groups of some entities as columns: code, value, and the number of the entity that each belongs to."""

    def __init__(self, codes: np.ndarray, text: GroupText, first: int):
        self._codes, self._text, self._first = codes, text, first
        self._owner = np.cumsum(codes == 0, dtype=np.int32) - 1
        known: dict[bytes, bytes] = {}
        self._words = [known.setdefault(word, word) for word in map(bytes.strip, self._values(self._at(0)))]
        self._kinds = np.array([KINDS.get(word, OTHER) for word in self._words], np.int8)
        self._count = len(self._words)
        self._parsed: dict[int, tuple[np.ndarray, np.ndarray]] = {}

    def found(self) -> _Found:
        """Return the ordinary ones, and the texts of all."""
        ordinary = self._ordinary()
        colours = self._column(62, 256.0), self._column(420, -1.0)
        texts = _Texts(self._kinds, self._texts(8), self._texts(5), *colours)
        return _Found(ordinary, *self._curves(ordinary), self._words, texts)

    def _values(self, at: np.ndarray) -> Iterable[bytes]:
        return self._text.values(at + self._first)

    def _ordinary(self) -> np.ndarray:
        """Return which entities are ordinary, bool[n]."""
        allowed = np.zeros((len(KINDS) + 1, CODES), bool)
        for meaning, meant in MEANT.items():
            allowed[meaning, [*ALWAYS, *meant]] = True
        kind = self._kinds[self._owner]
        odd = ~allowed[kind, self._codes]
        for code, needed in AFTER.items():
            odd[1:] |= (self._codes[1:] == code) & (self._codes[:-1] != needed)
        ordinary = self._kinds != OTHER
        ordinary[self._owner[odd]] = False
        once = ~np.isin(self._codes, REPEATED) & ~((kind == POLYLINE) & np.isin(self._codes, OF_VERTEX))
        keys = self._owner[once] * CODES + self._codes[once]
        keys.sort()
        ordinary[keys[1:][keys[1:] == keys[:-1]] // CODES] = False
        for kind_number, needs in NEEDED.items():
            for code in needs:
                ordinary[(self._kinds == kind_number) & ~self._has(code)] = False
        ordinary &= self._is_level() & self._is_within() & self._is_named() & self._has_bulges_behind_vertices()
        return ordinary & self._is_measurable(ordinary)

    def _at(self, code: int) -> np.ndarray:
        return np.flatnonzero(self._codes == code)

    def _has(self, code: int) -> np.ndarray:
        found = np.zeros(self._count, bool)
        found[self._owner[self._at(code)]] = True
        return found

    def _numbers(self, code: int) -> tuple[np.ndarray, np.ndarray]:
        """Return the values of a code as numbers and their entities; raises NotSplit for what is no number."""
        if code not in self._parsed:
            at = self._at(code)
            try:
                numbers = np.fromiter(map(float, self._values(at)), float, len(at))
            except ValueError as error:
                raise NotSplit from error  # a value is no number
            self._parsed[code] = numbers, self._owner[at]
        return self._parsed[code]

    def _column(self, code: int, otherwise: float = 0.0) -> np.ndarray:
        """Return the value of a code for each entity, float64[n]."""
        column = np.full(self._count, otherwise)
        values, owner = self._numbers(code)
        column[owner] = values
        return column

    def _texts(self, code: int) -> TextColumn:
        """Return the value of a code for each entity."""
        at = self._at(code)
        return self._text.column(at + self._first, self._owner[at], self._count)

    def _is_level(self) -> np.ndarray:
        """Return which entities are seen from above, and lines of one height, bool[n]."""
        above = (self._column(210) == 0.0) & (self._column(220) == 0.0) & (self._column(230, 1.0) == 1.0)
        level = np.abs(self._column(30) - self._column(31)) <= FLAT
        return above & (level | (self._kinds != LINE))

    def _is_within(self) -> np.ndarray:
        """Return which entities have all numbers in bounds, bool[n]; false for NaN."""
        within = np.ones(self._count, bool)
        for code in NUMBERS:
            values, owner = self._numbers(code)
            within[owner[~(np.abs(values) <= LARGEST)]] = False
        return within

    def _vertices_of_bulges(self) -> np.ndarray:
        """Return the number of the vertex of each bulge, -1 where its entity has none before it, int[n]."""
        vertices, bulges = self._at(10), self._at(42)
        before = np.searchsorted(vertices, bulges) - 1
        owner_before = np.append(self._owner[vertices], -1)[before]
        return np.where(owner_before == self._owner[bulges], before, -1)

    def _has_bulges_behind_vertices(self) -> np.ndarray:
        """Return which entities have no bulge before their first vertex, bool[n]."""
        fine = np.ones(self._count, bool)
        fine[self._owner[self._at(42)[self._vertices_of_bulges() < 0]]] = False
        return fine

    def _is_named(self) -> np.ndarray:
        """Return which entities have a layer's name that needs no decoding, bool[n]."""
        plain: dict[bytes, bool] = {}
        named = np.ones(self._count, bool)
        layers = self._texts(8)
        for number in range(self._count):
            layer = layers.of(number)
            if layer not in plain:
                plain[layer] = layer.strip() == layer != b"" and not NAME_NEVER.intersection(layer)
            named[number] = plain[layer]
        return named

    def _is_measurable(self, ordinary: np.ndarray) -> np.ndarray:
        """Return which of the ordinary entities are curves in bounds, no part of them without length, bool[n]."""
        fine = np.ones(self._count, bool)
        reach = np.maximum(np.abs(self._column(10)), np.abs(self._column(20)))
        run = np.hypot(self._column(11) - self._column(10), self._column(21) - self._column(20))
        far = np.maximum(reach, np.maximum(np.abs(self._column(11)), np.abs(self._column(21))))
        fine[(self._kinds == LINE) & ~((run > COINCIDENT_MM) & (far <= LIMIT_MM))] = False
        radius, sweep = np.abs(self._column(40)), np.where(self._kinds == ARC, self._sweeps()[1], math.tau)
        rise = radius * (1.0 - np.cos(np.minimum(sweep, math.pi) / 2.0))
        round_ones = (self._kinds == ARC) | (self._kinds == CIRCLE)
        fine[round_ones & ~((rise > STRAIGHT_MM) & (reach + radius <= LIMIT_MM))] = False
        fine[self._kinds == POLYLINE] = False
        numbers, polylines = self._polylines(np.flatnonzero((self._kinds == POLYLINE) & ordinary))
        fine[numbers[_are_chains(polylines)]] = True
        return fine

    def _sweeps(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the first angle of each arc and how far it turns, rad."""
        first, last = np.radians(self._column(50)), np.radians(self._column(51))
        sweep = (last - first) % math.tau
        return first, np.where(sweep == 0.0, math.tau, sweep)

    def _polylines(self, numbers: np.ndarray) -> tuple[np.ndarray, Bundle]:
        """Return light polylines that have sides, and their numbers; a closed one ends with its first vertex."""
        x, owner = self._numbers(10)
        y, _ = self._numbers(20)
        if len(x) != len(y):
            return numbers[:0], bundles_joined([])
        bulge = np.zeros(len(x))
        values, _ = self._numbers(42)
        vertex = self._vertices_of_bulges()
        bulge[vertex[vertex >= 0]] = values[vertex >= 0]
        begin, end = np.searchsorted(owner, numbers), np.searchsorted(owner, numbers, "right")
        sides = end - begin - 1 + (self._column(70).astype(int)[numbers] & 1)
        has_sides = (end > begin) & (sides > 0)
        numbers, begin, end, sides = (column[has_sides] for column in (numbers, begin, end, sides))
        vertices = np.minimum(runs(begin, sides + 1), np.repeat(end, sides + 1))
        last = np.cumsum(sides + 1) - 1
        vertices[last] = np.where(vertices[last] == end, begin, vertices[last])
        return numbers, Bundle(np.column_stack([x, y])[vertices], bulge[runs(begin, sides)], sides)

    def _curves(self, ordinary: np.ndarray) -> tuple[np.ndarray, Bundle]:
        """Return the numbers of the ordinary entities, ascending, and their curves."""
        x, y = self._column(10), self._column(20)
        lines = np.flatnonzero(ordinary & (self._kinds == LINE))
        ends = np.stack([np.column_stack([x, y]), np.column_stack([self._column(11), self._column(21)])], axis=1)
        straight = Bundle(ends[lines].reshape(-1, 2), np.zeros(len(lines)), np.ones(len(lines), int))
        numbers = np.flatnonzero(ordinary & ((self._kinds == ARC) | (self._kinds == CIRCLE)))
        first, sweep = self._sweeps()
        circle = self._kinds == CIRCLE
        first, sweep = np.where(circle, 0.0, first), np.where(circle, math.tau, sweep)
        arcs = _arcs(numbers, np.column_stack([x, y]), np.abs(self._column(40)), first, sweep)
        found = [(lines, straight), *arcs, self._polylines(np.flatnonzero(ordinary & (self._kinds == POLYLINE)))]
        mixed = np.concatenate([own for own, _ in found])
        order = np.argsort(mixed)
        return mixed[order], bundles_joined([bundle for own, bundle in found if len(own)]).taken(order)


def _are_chains(polylines: Bundle) -> np.ndarray:
    """Return which polylines are in bounds, have no side without a length and no arc that is nearly straight."""
    if not len(polylines.counts):
        return np.empty(0, bool)
    last = np.cumsum(polylines.counts + 1) - 1
    sides = np.delete(np.hypot(*np.diff(polylines.xy, axis=0).T), last[:-1])
    rise = np.abs(polylines.bulge) * sides / 2.0
    level = (polylines.bulge == 0.0) | ((rise > STRAIGHT_MM) & (rise <= LIMIT_MM))
    within = (np.abs(polylines.xy) <= LIMIT_MM).all(axis=1)
    near = np.logical_and.reduceat(within, last - polylines.counts)
    return near & np.logical_and.reduceat((sides > COINCIDENT_MM) & level, polylines.first)


def _arcs(
    numbers: np.ndarray, centres: np.ndarray, radii: np.ndarray, first_rad: np.ndarray, sweep_rad: np.ndarray
) -> list[tuple[np.ndarray, Bundle]]:
    """Return arcs in parts of at most a half turn with their numbers, exactly closed where they are whole ones."""
    found = []
    parts = np.where(sweep_rad > math.pi + 1e-9 * math.pi, 2, 1)
    for count in (1, 2):
        chosen = numbers[parts[numbers] == count]
        angles = first_rad[chosen, None] + sweep_rad[chosen, None] * np.linspace(0.0, 1.0, count + 1)
        ways = np.stack([np.cos(angles), np.sin(angles)], axis=2)
        xy = centres[chosen, None] + radii[chosen, None, None] * ways
        whole = np.isclose(sweep_rad[chosen], math.tau, rtol=1e-12, atol=0.0)
        xy[whole, -1] = xy[whole, 0]
        bulges = np.repeat(np.tan(sweep_rad[chosen] / count / 4.0), count)
        found.append((chosen, Bundle(xy.reshape(-1, 2), bulges, np.full(len(chosen), count))))
    return found
