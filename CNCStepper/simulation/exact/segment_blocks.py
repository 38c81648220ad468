# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path of a cutter in blocks, which are computed or read again at each iteration.

A short path is held and is one block; of a long one, one block is in memory at a time.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from CNCStepper.simulation.cutter_solid import Cutter
from CNCStepper.simulation.exact.edge_tree import EdgeTree
from CNCStepper.simulation.tip_segments import Segments

MOST_HELD = 1_000_000  # segments of one path that are held, and so many in the trees over its levels


@dataclass(frozen=True)
class Blocks:
    """The blocks of a source, each changed on its way; a whole path is one block."""

    source: Iterable[Segments]
    change: Callable[[Segments], Segments] = lambda pieces: pieces

    def __iter__(self) -> Iterator[Segments]:
        for pieces in self.source:
            yield self.change(pieces)

    def held(self) -> Blocks:
        """Return the same as one block where it is short."""
        found: list[Segments] = []
        for pieces in self:
            found.append(pieces)
            if sum(map(len, found)) > MOST_HELD:
                return self
        return self if not found else Blocks([joined(found)])


Cuts = list[tuple[Cutter, Blocks]]  # the path below the stock's top, by cutter


class Trees:
    """What answers how near a path is: trees over its blocks, held until MOST_HELD segments are, then grown each time.

    room: how many more segments all paths together may hold in memory.
    """

    def __init__(self, blocks: Blocks, room: list[int]):
        self.blocks = blocks
        self._held: list[tuple[EdgeTree, np.ndarray]] | None = []
        for one in self._grown():
            self._held.append(one)
            if sum(len(rows) for _, rows in self._held) > room[0]:
                self._held = None
                return
        room[0] -= sum(len(rows) for _, rows in self._held)

    def __iter__(self) -> Iterator[tuple[EdgeTree, np.ndarray]]:
        """Yield the tree over each block, and its rows."""
        return self._grown() if self._held is None else iter(self._held)

    def distance(self, points: np.ndarray) -> np.ndarray:
        """Return the distance of points float64[n, 2] to the path seen from above."""
        nearest = np.full(len(points), np.inf)
        for tree, _ in self if len(points) else ():
            np.minimum(nearest, tree.distance(points), out=nearest)
        return nearest

    def nearest(self, point: np.ndarray) -> tuple[float, int] | None:
        """Return how far the nearest segment is from a point float64[2], and its row; None for no path."""
        best: tuple[float, int] | None = None
        for tree, rows in self:
            index, distance = tree.nearest(np.array([[point, point]]))
            if len(rows) and (best is None or distance[0] < best[0]):
                best = float(distance[0]), int(rows[index[0]])
        return best

    def _grown(self) -> Iterator[tuple[EdgeTree, np.ndarray]]:
        for pieces in self.blocks:
            yield EdgeTree.of_pieces(pieces), pieces.row


def joined(parts: list[Segments]) -> Segments:
    """Return parts of a path as one."""
    if len(parts) == 1:
        return parts[0]
    return Segments(*(np.concatenate([getattr(part, name) for part in parts]) for name in ("begin", "end", "row")))
