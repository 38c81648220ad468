# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves with their attributes in columns: a drawing of 100 000 lines takes some 100 bytes a line.

    bundle   xy, bulge, counts   the curves, one after the other (curve_bundle.py)
    look     int32[c]            layer, colour, groups and filled of each curve: its number in `looks`
    names    list[str]           the name of each curve

A `Chain` is made when it is asked for; its curve is two slices of the columns.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, overload

import numpy as np

from CNCStepper.drawing.drawing import Attributes, Chain, Piece
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.curve_bundle import Bundle

BLOCK = 4_096  # chains that are made at once where all are gone through


class ChainColumns(Sequence[Chain]):
    """Chains, or pieces that are not joined yet, as a sequence; see the module's text."""

    __slots__ = ("_first", "bundle", "look", "looks", "names")

    def __init__(self, bundle: Bundle, look: np.ndarray, looks: Sequence[Attributes], names: Sequence[str]):
        self.bundle, self.look, self.looks, self.names = bundle, look, looks, names
        self._first = bundle.first

    def __len__(self) -> int:
        return len(self.names)

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
        first, counts = self._first[rows], self.bundle.counts[rows]
        for row, begin, count, look in zip(
            rows.tolist(), first.tolist(), counts.tolist(), self.look[rows].tolist(), strict=True
        ):
            curve = Curve.trusted(xy[begin + row : begin + row + count + 1], bulge[begin : begin + count])
            alike = self.looks[look]
            yield Chain(curve, Attributes(alike.layer, alike.colour, self.names[row], alike.groups, alike.filled))

    def where(self, rows: np.ndarray, bundle: Bundle) -> ChainColumns:
        """Return other curves with the attributes of some rows, int64[k]."""
        return ChainColumns(bundle, self.look[rows], self.looks, [self.names[row] for row in rows.tolist()])


class ChainGatherer:
    """Gathers curves, and gives their columns, which grow in place: no two copies of them are there at once."""

    def __init__(self) -> None:
        self._xy, self._bulge, self._counts = array("d"), array("d"), array("q")
        self._looks: dict[tuple[Any, ...], int] = {}
        self._look = array("i")
        self._names: list[str] = []

    def __len__(self) -> int:
        return len(self._names)

    def add(self, curve: Curve, attributes: Attributes) -> None:
        """Add a curve."""
        self._xy.frombytes(curve.xy.tobytes())
        self._bulge.frombytes(curve.bulge.tobytes())
        self._counts.append(len(curve.bulge))
        self._add_attributes(attributes)

    def add_bundle(self, bundle: Bundle, attributes: Iterable[Attributes]) -> None:
        """Add the curves of a bundle, with the attributes of each."""
        self._xy.frombytes(bundle.xy.tobytes())
        self._bulge.frombytes(bundle.bulge.tobytes())
        self._counts.frombytes(bundle.counts.astype(np.int64).tobytes())
        for own in attributes:
            self._add_attributes(own)

    def columns(self) -> ChainColumns:
        """Return all that was added; nothing can be added after."""
        xy = np.frombuffer(self._xy, float).reshape(-1, 2)
        bundle = Bundle(xy, np.frombuffer(self._bulge, float), np.frombuffer(self._counts, np.int64))
        looks = [Attributes(*look) for look in self._looks]
        return ChainColumns(bundle, np.frombuffer(self._look, np.int32), looks, self._names)

    def _add_attributes(self, own: Attributes) -> None:
        look = own.layer, own.colour, "", own.groups, own.filled
        self._look.append(self._looks.setdefault(look, len(self._looks)))
        self._names.append(own.name)


def columns_of(pieces: Iterable[Piece | Chain]) -> ChainColumns:
    """Return pieces or chains as columns; those that are columns already as they are."""
    if isinstance(pieces, ChainColumns):
        return pieces
    gathered = ChainGatherer()
    for piece in pieces:
        gathered.add(piece.curve, piece.attributes)
    return gathered.columns()
