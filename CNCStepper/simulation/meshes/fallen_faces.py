# SPDX-License-Identifier: LGPL-2.1-or-later
"""The top faces of the pieces that a program cuts free of a sheet, each with the time at which it is free.

+-----------+       A face of a 3D view has no holes: a piece is cut into
|  .-----.  |       strips at the middle of each of its holes.
|--|     |--|
|  '-----'  |
+-----------+
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from shapely import Polygon

    from CNCStepper.simulation.exact.free_pieces import FreePiece

FLAT_MM = 0.05  # by so much a drawn edge may be off
ABOVE_MM = 0.02  # the sheet's top, whose faces are drawn a trifle larger than they are


@dataclass(frozen=True)
class FallenFaces:
    """Pieces as faces without holes, the first that comes free first.

    points: the corners of all faces, float32[n, 3], mm. counts: how many each face has, int32[faces]. piece: the number
    of the piece that each face is of, rising, int32[faces]. falls_s: when each piece comes free, rising,
    float64[pieces]; -inf before the program begins.
    """

    points: np.ndarray
    counts: np.ndarray
    piece: np.ndarray
    falls_s: np.ndarray

    def __len__(self) -> int:
        return len(self.falls_s)

    def __iter__(self) -> Iterator[tuple[np.ndarray, np.ndarray]]:
        """Yield the corners of each piece and how many each of its faces has."""
        ends = np.cumsum(self.counts)
        bounds = np.searchsorted(self.piece, np.arange(len(self) + 1))
        for first, last in zip(bounds[:-1].tolist(), bounds[1:].tolist(), strict=True):
            counts = self.counts[first:last]
            begin = int(ends[first - 1]) if first else 0
            yield self.points[begin : begin + int(counts.sum())], counts

    def fallen_at(self, time_s: float) -> int:
        """Return how many pieces, from the first on, are free at a time."""
        return int(np.searchsorted(self.falls_s, time_s, side="right"))

    def save(self, path: Path) -> None:
        """Write them as a file of arrays."""
        np.savez(path, **{entry.name: getattr(self, entry.name) for entry in fields(self)})

    @classmethod
    def load(cls, path: Path) -> FallenFaces:
        """Return the faces that `save` wrote."""
        with np.load(path, allow_pickle=False) as arrays:
            return cls(**{entry.name: arrays[entry.name] for entry in fields(cls)})


def fallen_faces(pieces: Sequence[FreePiece], top_mm: float) -> FallenFaces:
    """Return the top faces of pieces; top_mm: the height of the sheet's top."""
    import shapely  # here, because a window that only reads faces does without

    falls_s = np.nan_to_num(np.array([piece.end_s for piece in pieces], float), nan=-np.inf)
    order = np.argsort(falls_s, kind="stable")
    rings = [(number, ring) for number, place in enumerate(order.tolist())
             for polygon in shapely.get_parts(shapely.simplify(pieces[place].shape, FLAT_MM)).tolist()
             for ring in _without_holes(polygon)]  # fmt: skip
    points = np.concatenate([np.zeros((0, 2)), *(ring for _, ring in rings)])
    high = np.full(len(points), top_mm + ABOVE_MM)
    counts = np.array([len(ring) for _, ring in rings], np.int32)
    return FallenFaces(
        np.column_stack([points, high]).astype(np.float32),
        counts,
        np.array([number for number, _ in rings], np.int32),
        falls_s[order],
    )


def _without_holes(polygon: Polygon) -> Iterator[np.ndarray]:
    """Yield the outlines, float64[k, 2], of strips of a polygon that have no hole."""
    import shapely

    low_x, low_y, high_x, high_y = polygon.bounds
    middles = [(hole.bounds[1] + hole.bounds[3]) / 2.0 for hole in polygon.interiors]
    levels = np.unique([low_y, *middles, high_y])
    strips = shapely.box(low_x, levels[:-1], high_x, levels[1:])
    parts = shapely.get_parts(shapely.get_parts(shapely.intersection(polygon, strips)))
    for part in parts[shapely.get_type_id(parts) == shapely.GeometryType.POLYGON].tolist():
        yield shapely.get_coordinates(part.exterior)[:-1]
