# SPDX-License-Identifier: LGPL-2.1-or-later
"""The block that is cut, in work coordinates; its top face lies at z = 0.

top-centre                 top-left-front
+-----------+              +-----------+
|           |  y           |           |  y
|     o     |  ^           |           |  ^
|           |  |           |           |  |
+-----------+  +--> x      o-----------+  +--> x
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import shapely
from shapely.geometry import Polygon

from CNCStepper.errors import JobError

CORNER_OF_ORIGIN = {"top-centre": (-0.5, -0.5), "top-left-front": (0.0, 0.0)}


@dataclass(frozen=True)
class Stock:
    """A box of `size_mm` (x, y, z) whose work zero is named by `origin`.

    Raises JobError for a size that is not three positive numbers and for an unknown origin.
    """

    size_mm: tuple[float, float, float]
    origin: str = "top-centre"

    def __post_init__(self) -> None:
        size_mm = tuple(float(length) for length in self.size_mm)
        if len(size_mm) != 3 or not all(math.isfinite(length) and length > 0 for length in size_mm):
            raise JobError(
                "stock-size",
                "the stock needs three lengths above zero",
                value=str(tuple(self.size_mm)),
                advice="give X,Y,Z in mm, for example 100,70,20",
            )
        if self.origin not in CORNER_OF_ORIGIN:
            raise JobError(
                "stock-origin",
                f"'{self.origin}' is no origin of a stock",
                advice=f"write one of: {', '.join(CORNER_OF_ORIGIN)}",
            )
        object.__setattr__(self, "size_mm", size_mm)

    @property
    def low_mm(self) -> tuple[float, float, float]:
        """The corner with the smallest coordinates."""
        shares = CORNER_OF_ORIGIN[self.origin]
        return shares[0] * self.size_mm[0], shares[1] * self.size_mm[1], -self.size_mm[2]

    @property
    def high_mm(self) -> tuple[float, float, float]:
        """The corner with the largest coordinates."""
        low = self.low_mm
        return low[0] + self.size_mm[0], low[1] + self.size_mm[1], 0.0

    @property
    def top_mm(self) -> float:
        """Height of the top face."""
        return 0.0

    @property
    def bottom_mm(self) -> float:
        """Height of the bottom face."""
        return -self.size_mm[2]

    @property
    def outline(self) -> Polygon:
        """The box seen from above."""
        return shapely.box(*self.low_mm[:2], *self.high_mm[:2])
