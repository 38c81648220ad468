# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves with their attributes in columns: a drawing of 100 000 lines takes some 100 bytes a line.

    bundle   xy, bulge, counts   the curves, one after the other (curve_bundle.py)
    look     int32[c]            layer, colour, groups and filled of each curve: its number in `looks`
    names    Names               the name of each curve: its place in one text

A `Chain` is made when it is asked for; its curve is two slices of the columns.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, NamedTuple, overload

import numpy as np

from CNCStepper.drawing.drawing import Attributes, Chain, Piece
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.curve_bundle import Bundle, bundles_joined

BLOCK = 4_096  # chains that are made at once where all are gone through


class Names(NamedTuple):
    """Texts as places in one, int32[n] both."""

    content: bytearray  # UTF-8
    begin: np.ndarray
    end: np.ndarray

    def of(self, rows: np.ndarray) -> list[str]:
        """Return the texts of some rows, int64[k]."""
        places = zip(self.begin[rows].tolist(), self.end[rows].tolist(), strict=True)
        return [self.content[begin:end].decode("utf-8", "surrogatepass") for begin, end in places]

    def where(self, rows: np.ndarray) -> Names:
        """Return the texts of some rows, int64[k]."""
        return Names(self.content, self.begin[rows], self.end[rows])


def names_joined(one: Names, other: Names) -> Names:
    """Return the texts of both, one after the other."""
    begin, end = (
        np.concatenate([places, others + len(one.content)]).astype(np.int32)
        for places, others in ((one.begin, other.begin), (one.end, other.end))
    )
    return Names(one.content + other.content, begin, end)


class ChainColumns(Sequence[Chain]):
    """Chains, or pieces that are not joined yet, as a sequence; see the module's text."""

    __slots__ = ("_first", "bundle", "look", "looks", "names")

    def __init__(self, bundle: Bundle, look: np.ndarray, looks: Sequence[Attributes], names: Names):
        self.bundle, self.look, self.looks, self.names = bundle, look, looks, names
        self._first: np.ndarray | None = None

    def __len__(self) -> int:
        return len(self.look)

    @overload
    def __getitem__(self, index: int) -> Chain: ...

    @overload
    def __getitem__(self, index: slice) -> tuple[Chain, ...]: ...

    def __getitem__(self, index: int | slice) -> Chain | tuple[Chain, ...]:
        rows = range(len(self))[index]
        return tuple(self._made(np.array(rows, int))) if isinstance(rows, range) else next(self._made(np.array([rows])))

    def __iter__(self) -> Iterator[Chain]:
        for first in range(0, len(self), BLOCK):
            yield from self._made(np.arange(first, min(first + BLOCK, len(self))))

    def _made(self, rows: np.ndarray) -> Iterator[Chain]:
        """Yield the chains of some rows, int64[k]."""
        xy, bulge, _ = self.bundle
        if self._first is None:
            self._first = self.bundle.first
        first, counts = self._first[rows], self.bundle.counts[rows]
        columns = (column.tolist() for column in (rows, first, counts, self.look[rows]))
        for row, begin, count, look, name in zip(*columns, self.names.of(rows), strict=True):
            curve = Curve.trusted(xy[begin + row : begin + row + count + 1], bulge[begin : begin + count])
            alike = self.looks[look]
            yield Chain(curve, Attributes(alike.layer, alike.colour, name, alike.groups, alike.filled))

    def where(self, rows: np.ndarray, bundle: Bundle) -> ChainColumns:
        """Return other curves with the attributes of some rows, int64[k]."""
        return ChainColumns(bundle, self.look[rows], self.looks, self.names.where(rows))


def columns_joined(one: ChainColumns, other: ChainColumns) -> ChainColumns:
    """Return the curves of both, one after the other; those of one alone are not copied."""
    if not len(other) or not len(one):
        return one if len(one) else other
    look = np.concatenate([one.look, other.look + len(one.looks)]).astype(np.int32)
    bundle = bundles_joined([one.bundle, other.bundle])
    return ChainColumns(bundle, look, [*one.looks, *other.looks], names_joined(one.names, other.names))


class ChainGatherer:
    """Gathers curves, and gives their columns, which grow in place: no two copies of them are there at once."""

    def __init__(self) -> None:
        self._xy, self._bulge, self._counts = array("d"), array("d"), array("q")
        self._looks: dict[tuple[Any, ...], int] = {}
        self._look = array("i")
        self._names, self._name_ends = bytearray(), array("i")

    def __len__(self) -> int:
        return len(self._look)

    def add(self, curve: Curve, attributes: Attributes) -> None:
        """Add a curve."""
        self._xy.frombytes(curve.xy.astype(float, copy=False).tobytes())
        self._bulge.frombytes(curve.bulge.astype(float, copy=False).tobytes())
        self._counts.append(len(curve.bulge))
        self._add_attributes(attributes)

    def add_bundle(self, bundle: Bundle, attributes: Iterable[Attributes]) -> None:
        """Add the curves of a bundle, with the attributes of each."""
        self._xy.frombytes(bundle.xy.tobytes())
        self._bulge.frombytes(bundle.bulge.tobytes())
        self._counts.frombytes(bundle.counts.astype(np.int64, copy=False).tobytes())
        for own in attributes:
            self._add_attributes(own)

    def columns(self) -> ChainColumns:
        """Return all that was added; nothing can be added after."""
        xy = np.frombuffer(self._xy, float).reshape(-1, 2)
        bundle = Bundle(xy, np.frombuffer(self._bulge, float), np.frombuffer(self._counts, np.int64))
        looks = [Attributes(*look) for look in self._looks]
        return ChainColumns(bundle, np.frombuffer(self._look, np.int32), looks, self._all_names())

    def _all_names(self) -> Names:
        ends = np.frombuffer(self._name_ends, np.int32)
        return Names(self._names, np.concatenate([[0], ends[:-1]]).astype(np.int32)[: len(ends)], ends)

    def _add_attributes(self, own: Attributes) -> None:
        look = own.layer, own.colour, "", own.groups, own.filled
        self._look.append(self._looks.setdefault(look, len(self._looks)))
        self._names += own.name.encode("utf-8", "surrogatepass")
        self._name_ends.append(len(self._names))


def columns_of(pieces: Iterable[Piece | Chain]) -> ChainColumns:
    """Return pieces or chains as columns; those that are columns already as they are."""
    if isinstance(pieces, ChainColumns):
        return pieces
    gathered = ChainGatherer()
    for piece in pieces:
        gathered.add(piece.curve, piece.attributes)
    return gathered.columns()
