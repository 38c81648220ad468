# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines, arcs, circles and light polylines straight from the text of a DXF file, by columns; ezdxf reads all else.

    text ──► group codes, values ──► ordinary entities ──► columns of numbers ──► curves
                                  └► all else, with header, tables and blocks, as a shorter DXF text for ezdxf

An ordinary entity lies in the model space and is visible from above. Each value that it needs is there once and in
bounds, and no group code means anything else. Other entities stay in the text for ezdxf, so that both readers give the
same drawing. An ordinary entity has its number in the file by its place, another one by its handle.
"""

from __future__ import annotations

import math
from array import array
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple, overload

import numpy as np

from CNCStepper.drawing.chain_columns import Names
from CNCStepper.drawing.dxf.attributes import MOST_CHARACTERS
from CNCStepper.drawing.dxf.group_text import CODES, GroupText, NotSplit, windows
from CNCStepper.geometry.curve import LIMIT_MM, Curve
from CNCStepper.geometry.curve_bundle import Bundle, bundles_joined, runs
from CNCStepper.geometry.curve_columns import STRAIGHT_MM
from CNCStepper.safe_text import printable
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
SECTION_ENDS = (b"ENDSEC", b"SECTION", b"EOF")
OF_VERTEX = (10, 20, 40, 41, 42, 91)
AFTER = {20: 10, 30: 20, 21: 11, 31: 21, 220: 210, 230: 220}  # a coordinate and the one right before it
NUMBERS = (10, 20, 30, 11, 21, 31, 38, 40, 41, 42, 50, 51, 62, 70, 420)
NAME_NEVER = frozenset(b'\\<>/":;?*=`|\t')  # in a layer's name: ezdxf decodes or corrects it


class Looks(NamedTuple):
    """What many ordinary entities share: kind, layer as the file writes it, colours as PlainEntity has them."""

    kind: int
    layer: bytes
    colour_index: int
    true_colour: int | None


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
    """Ordinary entities in columns that grow in place; an entity is made when it is asked for.

    `looks` are those of all; `columns` returns the rest.
    """

    def __init__(self) -> None:
        self._numbers, self._look = array("i"), array("i")
        self._xy, self._bulge, self._counts = array("d"), array("d"), array("q")
        self._looks: dict[Looks, int] = {}
        self._handles, self._ends = bytearray(), array("i")
        self._first: np.ndarray | None = None

    def add(self, numbers: np.ndarray, curves: Bundle, looks: Iterable[Looks], handles: Iterable[bytes]) -> None:
        """Add entities in the order of the file."""
        self._numbers.frombytes(numbers.astype(np.int32).tobytes())
        self._xy.frombytes(curves.xy.tobytes())
        self._bulge.frombytes(curves.bulge.tobytes())
        self._counts.frombytes(curves.counts.astype(np.int64, copy=False).tobytes())
        self._look.extend([self._looks.setdefault(look, len(self._looks)) for look in looks])
        for handle in handles:
            self._handles += handle if handle.isalnum() and len(handle) < MOST_CHARACTERS else _printable(handle)
            self._ends.append(len(self._handles))

    @property
    def looks(self) -> list[Looks]:
        """The looks of all, by their numbers."""
        return list(self._looks)

    def look(self, row: int) -> int:
        """Return which of `looks` an entity has."""
        return self._look[row]

    def columns(self) -> tuple[np.ndarray, np.ndarray, Bundle, Names]:
        """Return the numbers, int32[n], which of `looks`, int32[n], curves and handles of all; none is added after."""
        ends = np.frombuffer(self._ends, np.int32)
        names = Names(self._handles, np.concatenate([[0], ends[:-1]]).astype(np.int32)[: len(ends)], ends)
        curves = Bundle(
            np.frombuffer(self._xy).reshape(-1, 2), np.frombuffer(self._bulge), np.frombuffer(self._counts, np.int64)
        )
        return np.frombuffer(self._numbers, np.int32), np.frombuffer(self._look, np.int32), curves, names

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
        numbers, look, curves, handles = self.columns()
        if self._first is None:
            self._first = curves.first
        kind, layer, *colours = self.looks[look[row]]
        begin, count = int(self._first[row]), int(curves.counts[row])
        curve = Curve.trusted(curves.xy[begin + row : begin + row + count + 1], curves.bulge[begin : begin + count])
        return PlainEntity(
            int(numbers[row]), curve, NAMES[kind], layer, handles.of(np.array([row]))[0], colours[0], colours[1]
        )


def _printable(handle: bytes) -> bytes:
    return printable(handle.decode("ascii", "replace"), MOST_CHARACTERS).encode("utf-8")


@dataclass(frozen=True)
class SplitText:
    """The ordinary entities of a file, the text of all else, and the number of each entity there by its handle."""

    plain: PlainEntities
    rest: bytes
    numbers: dict[str, int]


def split_text(chunks: Iterable[bytes]) -> SplitText:
    """Return the ordinary entities of a DXF text, given in pieces, and the rest.

    Raises NotSplit for a binary or damaged file, for one without ordinary entities, and for one whose other entities
    have no handles.
    """
    splitter = _Splitter()
    for text in windows(chunks):
        splitter.add(text)
    if not splitter.is_whole or not len(splitter.plain):
        raise NotSplit  # there is no whole section of entities, or no ordinary ones are in it
    return SplitText(splitter.plain, bytes(splitter.rest), splitter.numbers)


class _Splitter:
    """Takes a text window by window: see SplitText; `is_whole`: its section of entities has begun and ended."""

    def __init__(self) -> None:
        self.plain, self.rest = PlainEntities(), bytearray()
        self.numbers: dict[str, int] = {}
        self.is_whole = self._inside = False
        self._count = 0  # of the entities so far

    def add(self, text: GroupText) -> None:
        """Take the next groups."""
        kept = np.ones(len(text.codes), bool)
        zeros = np.flatnonzero(text.codes == 0)
        words = list(map(bytes.strip, text.values(zeros)))
        begin, end = self._section(text, zeros.tolist(), words)
        if begin < end:
            inside = slice(*np.searchsorted(zeros, [begin, end]).tolist())
            if text.codes[begin]:
                raise NotSplit  # the entities do not begin with one
            entities = _Entities(text.codes[begin:end], text, begin, words[inside])
            ordinary = self._taken(entities, words[inside])
            kept[begin:end] = np.repeat(~ordinary, np.diff(zeros[inside], append=end))
        self.rest += text.some(kept)

    def _section(self, text: GroupText, zeros: Sequence[int], words: Sequence[bytes]) -> tuple[int, int]:
        """Return the first group of the entities here and the group that ends them."""
        begin = 0
        if self.is_whole:
            return 0, 0
        for group, word in zip(zeros, words, strict=True):
            if self._inside and word in SECTION_ENDS:
                if word != b"ENDSEC":
                    raise NotSplit
                self._inside, self.is_whole = False, True
                return begin, group
            is_named = word == b"SECTION" and text.codes[group + 1 : group + 2].tolist() == [2]
            if is_named and text.value(group + 1).strip() == b"ENTITIES":
                self._inside, begin = True, group + 2
        return (begin, len(text.codes)) if self._inside else (0, 0)

    def _taken(self, entities: _Entities, words: Sequence[bytes]) -> np.ndarray:
        """Take the ordinary entities of a window; return which they are, bool[n]."""
        ordinary = entities.ordinary()
        numbers, curves = entities.curves(ordinary)
        handles, rows = entities.texts(5), numbers.tolist()
        self.plain.add(numbers + self._count, curves, entities.looks(rows), (handles[row] for row in rows))
        for number in np.flatnonzero(~ordinary).tolist():
            handle = handles[number].decode("ascii", "replace").upper()
            if words[number] not in PARTS and (not handle or handle in self.numbers):
                raise NotSplit
            self.numbers[handle] = self._count + number
        self._count += len(words)
        return ordinary


class _Entities:
    """The groups of some entities as columns: code, value, and the number of the entity that each belongs to."""

    def __init__(self, codes: np.ndarray, text: GroupText, first: int, words: Sequence[bytes]):
        self._codes, self._text, self._first = codes, text, first
        self._owner = np.cumsum(codes == 0, dtype=np.int32) - 1
        self._kinds = np.array([KINDS.get(word, OTHER) for word in words], np.int8)
        self._count = len(words)
        self._parsed: dict[int, tuple[np.ndarray, np.ndarray]] = {}
        self._layers = self.texts(8)

    def looks(self, rows: Sequence[int]) -> Iterator[Looks]:
        """Yield the looks of some ordinary ones."""
        columns = (self._kinds, self._column(62, 256.0), self._column(420, -1.0))
        chosen = (column[np.array(rows, int)].tolist() for column in columns)
        for row, kind, index, true_colour in zip(rows, *chosen, strict=True):
            yield Looks(kind, self._layers[row], int(index), int(true_colour) if true_colour >= 0 else None)

    def texts(self, code: int) -> list[bytes]:
        """Return the value of a code for each, as GroupText does."""
        at = self._at(code)
        return self._text.texts(at + self._first, self._owner[at], self._count)

    def _values(self, at: np.ndarray) -> Iterable[bytes]:
        return self._text.values(at + self._first)

    def ordinary(self) -> np.ndarray:
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
        for layer in set(self._layers):
            plain[layer] = layer.strip() == layer != b"" and not NAME_NEVER.intersection(layer)
        return np.array([plain[layer] for layer in self._layers], bool)

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
        fine[numbers[are_chains(polylines)]] = True
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

    def curves(self, ordinary: np.ndarray) -> tuple[np.ndarray, Bundle]:
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
        order = np.argsort(mixed, kind="stable")
        return mixed[order], bundles_joined([bundle for own, bundle in found if len(own)]).taken(order)


def are_chains(polylines: Bundle) -> np.ndarray:
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
