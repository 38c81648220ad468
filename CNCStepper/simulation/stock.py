# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is cut, in work coordinates: a block or sheet, a cylinder, or anything by its heights.

The top face of block, sheet and cylinder lies at z = 0.

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
from typing import ClassVar

import numpy as np
import shapely
from shapely.geometry import Polygon

from CNCStepper.errors import JobError, Text

CORNER_OF_ORIGIN = {"top-centre": (-0.5, -0.5), "top-left-front": (0.0, 0.0)}


@dataclass(frozen=True)
class Stock:
    """A box or sheet of `size_mm` (x, y, z) whose work zero is named by `origin`.

    Raises JobError for a size that is not three positive numbers and for an unknown origin.
    """

    size_mm: tuple[float, float, float]
    origin: str = "top-centre"
    is_level: ClassVar[bool] = True  # one height all over the box

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
                Text("'{origin}' is no origin of a stock", origin=self.origin),
                advice=Text("write one of: {corner_of_origin}", corner_of_origin=", ".join(CORNER_OF_ORIGIN)),
            )
        object.__setattr__(self, "size_mm", size_mm)

    def tops_mm(self, x_mm: np.ndarray, y_mm: np.ndarray) -> np.ndarray:
        """Return the height of the top at the centres of a grid of cells, float64[rows, columns], rows along y."""
        return np.full((len(y_mm), len(x_mm)), self.top_mm)

    def tops_at(self, points: np.ndarray) -> np.ndarray:
        """Return the height of the top at points float64[n, 2] within the outline, float64[n]."""
        return np.full(len(points), self.top_mm)

    def shares(self, x_mm: np.ndarray, y_mm: np.ndarray, cell_mm: tuple[float, float]) -> np.ndarray:
        """Return how much of each cell's area holds stock, 0 to 1, float64[rows, columns]."""
        return np.ones((len(y_mm), len(x_mm)))

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


@dataclass(frozen=True)
class Cylinder(Stock):
    """A standing cylinder; `size_mm` is that of the box around it, x and y both its diameter."""

    is_level: ClassVar[bool] = False

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.size_mm[0] != self.size_mm[1]:
            raise JobError(
                "stock-size",
                "a cylinder is as long in X as in Y",
                value=str(self.size_mm),
                advice="give its diameter for X and for Y",
            )

    @property
    def outline(self) -> Polygon:
        """The cylinder seen from above, a circle within 0.001 of its radius."""
        return shapely.Point(*self._axis_mm).buffer(self.size_mm[0] / 2, quad_segs=64)

    def tops_mm(self, x_mm: np.ndarray, y_mm: np.ndarray) -> np.ndarray:
        """Return the height of the top at the cells' centres; outside the cylinder it is the bottom."""
        steps = [float(c[1] - c[0]) if len(c) > 1 else self.size_mm[0] for c in (x_mm, y_mm)]
        return np.where(self.shares(x_mm, y_mm, (steps[0], steps[1])) > 0.0, self.top_mm, self.bottom_mm)

    def shares(self, x_mm: np.ndarray, y_mm: np.ndarray, cell_mm: tuple[float, float]) -> np.ndarray:
        """Return how much of each cell's area holds stock, 0 to 1, float64[rows, columns]."""
        x, y = np.meshgrid(x_mm - self._axis_mm[0], y_mm - self._axis_mm[1])
        out = np.hypot(x, y)
        width = (cell_mm[0] * np.abs(x) + cell_mm[1] * np.abs(y)) / np.maximum(out, 1e-12)
        return np.clip(0.5 + (self.size_mm[0] / 2 - out) / np.maximum(width, 1e-12), 0.0, 1.0)

    @property
    def _axis_mm(self) -> tuple[float, float]:
        low, high = self.low_mm, self.high_mm
        return (low[0] + high[0]) / 2, (low[1] + high[1]) / 2


@dataclass(frozen=True, eq=False)
class HeightField(Stock):
    """A stock by its heights over its bottom, float64[rows along y, columns along x], at points that reach its edges.

    size_mm: of the box around it, z its largest height; between the points heights are bilinear.
    Raises JobError for a field that is no such array, or that is not within its box.
    """

    heights_mm: np.ndarray | None = None
    is_level: ClassVar[bool] = False

    def __post_init__(self) -> None:
        super().__post_init__()
        field = np.array(self.heights_mm, float)
        if field.ndim != 2 or min(field.shape) < 2 or not np.isfinite(field).all():
            what = "a height field needs two rows and two columns of finite heights at least"
            advice = "give a height for each place of the stock"
            raise JobError("stock-heights", what, advice=advice)
        if field.min() < 0 or not math.isclose(field.max(), self.size_mm[2], rel_tol=1e-9):
            raise JobError(
                "stock-heights",
                "the heights do not fit their box",
                value=Text("{field:g} to {field2:g} mm", field=field.min(), field2=field.max()),
                limit=Text("0 to {size_mm:g} mm", size_mm=self.size_mm[2]),
                advice="give heights over the bottom, and the largest as the stock's Z",
            )
        object.__setattr__(self, "heights_mm", field)

    def tops_mm(self, x_mm: np.ndarray, y_mm: np.ndarray) -> np.ndarray:
        """Return the height of the top at the cells' centres, float64[rows, columns]."""
        x, y = np.meshgrid(x_mm, y_mm)
        return self.tops_at(np.column_stack([x.ravel(), y.ravel()])).reshape(x.shape)

    def tops_at(self, points: np.ndarray) -> np.ndarray:
        """Return the height of the top at points float64[n, 2] within the outline, float64[n]."""
        assert self.heights_mm is not None
        rows, columns = self.heights_mm.shape
        along_x = (points[:, 0] - self.low_mm[0]) / self.size_mm[0] * (columns - 1)
        along_y = (points[:, 1] - self.low_mm[1]) / self.size_mm[1] * (rows - 1)
        column = np.clip(along_x.astype(int), 0, columns - 2)
        row = np.clip(along_y.astype(int), 0, rows - 2)
        east, north = along_x - column, along_y - row
        corner = [[self.heights_mm[row + i, column + j] for j in (0, 1)] for i in (0, 1)]
        south_edge, north_edge = (low * (1 - east) + high * east for low, high in corner)
        return self.bottom_mm + south_edge * (1 - north) + north_edge * north

    def highest_mm(self, low_mm: np.ndarray, high_mm: np.ndarray) -> np.ndarray:
        """Return the highest top within rectangles seen from above, or a little beside them, float64[n].

        low_mm, high_mm: the rectangles' corners, float64[n, 2].
        """
        assert self.heights_mm is not None
        most = np.array(self.heights_mm.shape[::-1]) - 1
        scale = most / np.array(self.size_mm[:2])
        first = np.clip(np.floor((low_mm - self.low_mm[:2]) * scale), 0, most).astype(int)
        last = np.clip(np.ceil((high_mm - self.low_mm[:2]) * scale), 0, most).astype(int)
        tops = [self.heights_mm[a:b, c:d].max() for c, a, d, b in np.hstack([first, last + 1]).tolist()]
        return self.bottom_mm + np.array(tops)
