# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a packer of strips is asked and answers, and which of its parts a sheet of limited length takes.

............................
|  aa  bbb | c  dd    e    |     strip: height given, length as short as the packer finds
|aa bbb  dd|dd cc   eee    |
`----------+---------------'
 first window: what ends within the sheet's length; the rest is packed anew on the next one
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from shapely import Polygon

from CNCStepper.nesting.nesting_model import Budget, turned


@dataclass(frozen=True)
class StripPart:
    """An item as a packer of strips takes it: its outline without holes, count and rotations (None: any)."""

    item: int
    outline: Polygon
    count: int
    rotations_deg: tuple[float, ...] | None


@dataclass(frozen=True)
class StripPlace:
    """Where one part of an item lies on a strip, turned about its origin and then moved, mm."""

    item: int
    x_mm: float
    y_mm: float
    rotation_deg: float


class StripPacker(Protocol):
    """Packs all parts on a strip of a height, as short as it can within the budget; None where it found nothing."""

    def __call__(
        self, parts: Sequence[StripPart], height_mm: float, budget: Budget, seed: int
    ) -> list[StripPlace] | None: ...


def extents_mm(parts: Sequence[StripPart], places: Sequence[StripPlace]) -> np.ndarray:
    """Return where each place begins and ends along X and its area, float64[n, 3]."""
    outlines = {part.item: part.outline for part in parts}
    rows = []
    for place in places:
        low, _, high, _ = turned(outlines[place.item], place.rotation_deg).bounds
        rows.append((place.x_mm + low, place.x_mm + high, outlines[place.item].area))
    return np.array(rows).reshape(-1, 3)


def fullest_window(extents: np.ndarray, length_mm: float) -> tuple[float, np.ndarray]:
    """Return where the window of a length begins that holds the most area, and which places are in it, bool[n]."""
    begins = np.unique(extents[:, 0])
    inside = (extents[None, :, 0] >= begins[:, None]) & (extents[None, :, 1] <= begins[:, None] + length_mm)
    best = int(np.argmax((inside * extents[None, :, 2]).sum(axis=1)))
    return float(begins[best]), inside[best]


def first_windows(extents: np.ndarray, length_mm: float) -> int:
    """Return onto how many sheets of a length a strip is cut: each begins with the first part that is left."""
    left, sheets = extents, 0
    while len(left):
        begin = left[:, 0].min()
        fits = left[:, 1] <= begin + length_mm
        if not fits.any():
            return sheets + len(left)
        left, sheets = left[~fits], sheets + 1
    return sheets
