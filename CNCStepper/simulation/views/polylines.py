# SPDX-License-Identifier: LGPL-2.1-or-later
"""Polylines as two arrays, as a 3D view takes them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Lines:
    """Polylines one after another: points float32[n, 3] in work coordinates, counts int32[k] of points in each."""

    points: np.ndarray
    counts: np.ndarray

    def pieces(self, most: int) -> Iterator[Lines]:
        """Yield the same polylines, at most `most` points at a time; one that is cut goes on from its last point."""
        ends = np.cumsum(self.counts)
        for first in range(0, max(len(self.points) - 1, 0), most - 1):
            last = min(first + most, len(self.points))
            within = ends[(ends > first) & (ends < last)]
            yield Lines(self.points[first:last], np.diff([first, *within, last]).astype(np.int32))
