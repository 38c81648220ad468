# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cut part as faces for a 3D view: level rectangles and upright walls, few where it is flat.

one row of cells, from the side          Cells of one height are one rectangle; between two heights stands a
 ____        ____                        wall. The normals are those of the smooth surface that the cells
     |  ____|                            sample, so that a curved wall looks curved and a ramp like a ramp.
     |_|
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from CNCStepper.simulation.removal.heightmap import HeightMap
from CNCStepper.simulation.stock import Stock
from CNCStepper.tolerances import SAME_HEIGHT_MM

MOST_FACES = 40_000  # a part that needs more is drawn from larger cells
BLUR = 2  # cells on each side over which a wall's direction is averaged
RIM = BLUR + 2  # cells around a rectangle of cells that its walls' directions depend on
UPRIGHT = 0.2  # a wall's normal leans at least that much towards its open side


@dataclass(frozen=True)
class Faces:
    """corners: float32[n, 4, 3], mm, work coordinates, counter-clockwise from outside. normals: float32[n, 3]."""

    corners: np.ndarray
    normals: np.ndarray

    def __len__(self) -> int:
        return len(self.normals)


def faces_of(part: HeightMap, most: int = MOST_FACES) -> Faces:
    """Return the faces of a part, from its own cells or, where those make more than `most`, from larger ones."""
    return _faces_and_step(part, most)[0]


def step_of(part: HeightMap, most: int = MOST_FACES) -> int:
    """Return of how many cells along x and y the larger ones of `faces_of` are made, a power of 2."""
    return _faces_and_step(part, most)[1]


def _faces_and_step(part: HeightMap, most: int) -> tuple[Faces, int]:
    step = 1
    while True:
        heights = drawn_heights(part.heights_mm, part.stock.bottom_mm, step)
        x_mm, y_mm = borders_mm(part.stock, heights.shape)
        padded = np.pad(heights, RIM, constant_values=part.stock.bottom_mm)
        faces = Cells(padded, x_mm, y_mm, part.stock.bottom_mm).faces()
        if len(faces) <= most or step >= min(part.heights_mm.shape):
            return faces, step
        step *= 2


def drawn_heights(heights_mm: np.ndarray, bottom_mm: float, step: int) -> np.ndarray:
    """Return the heights that are drawn, of every `step`-th cell along x and y: none below the bottom, and rounded."""
    heights = np.maximum(heights_mm[step // 2 :: step, step // 2 :: step], bottom_mm)
    return np.round(heights.astype(float) / SAME_HEIGHT_MM) * SAME_HEIGHT_MM


def borders_mm(stock: Stock, shape: tuple[int, ...]) -> tuple[np.ndarray, np.ndarray]:
    """Return the x and the y of the lines between the cells that fill a stock, its sides included."""
    low, size = stock.low_mm, stock.size_mm
    y_mm, x_mm = (low[k] + np.arange(n + 1) * size[k] / n for k, n in zip((1, 0), shape, strict=True))
    return x_mm, y_mm


class Cells:
    """A rectangle of a part's cells, drawn: tops and bottom, the walls west and south of every cell, and the part's
    last walls where the rectangle reaches to its east (`last[0]`) or north (`last[1]`).

    heights: float64[rows + 2 RIM, columns + 2 RIM], mm, with the cells around, which are at the bottom beside the
    part. x_mm, y_mm: the lines between the cells, from the rectangle's west and south side to its east and north.
    """

    def __init__(
        self,
        heights: np.ndarray,
        x_mm: np.ndarray,
        y_mm: np.ndarray,
        bottom_mm: float,
        last: tuple[bool, bool] = (True, True),
    ):
        self.bottom_mm = bottom_mm
        self.heights, self.inner = heights, heights[RIM:-RIM, RIM:-RIM]
        self.x_mm, self.y_mm, self.last = x_mm, y_mm, last
        self.cell_mm = (x_mm[1] - x_mm[0], y_mm[1] - y_mm[0])
        self.sums = np.pad(heights, ((1, 0), (1, 0))).cumsum(axis=0).cumsum(axis=1)

    def faces(self) -> Faces:
        """Return the tops, the walls across x, the walls across y and the bottom."""
        parts = [self._tops(), self._walls(0), self._walls(1), self._bottom()]
        return Faces(*(np.concatenate([getattr(part, name) for part in parts]) for name in ("corners", "normals")))

    def _tops(self) -> Faces:
        row, first, last, count = _rectangles(self.inner)
        z = self.inner[row, first]
        open_ = z > self.bottom_mm
        row, first, last, count, z = (column[open_] for column in (row, first, last, count, z))
        west, east, south, north = self.x_mm[first], self.x_mm[last], self.y_mm[row], self.y_mm[row + count]
        corners = _quads((west, south, z), (east, south, z), (east, north, z), (west, north, z))
        gentle = [self._gentle(row + RIM, first + RIM, axis) for axis in range(2)]
        return Faces(corners, _unit(np.stack([-gentle[0], -gentle[1], np.ones(len(z))], axis=1)))

    def _walls(self, axis: int) -> Faces:
        """Return the walls between neighbours along an axis (0 is x), joined where they continue unchanged."""
        along_axis = self.heights if axis == 0 else self.heights.T
        lines = along_axis.shape[1] - 2 * RIM + self.last[axis]
        here, there = (along_axis[RIM:-RIM, RIM + k : RIM + k + lines] for k in (-1, 0))
        line, first, last = _runs_of_walls(here, there)
        a, b = here[first, line], there[first, line]
        across = (self.x_mm, self.y_mm)[axis][line]
        along = (self.y_mm, self.x_mm)[axis]
        begin, end = along[first], along[last]
        low, high, sense = np.minimum(a, b), np.maximum(a, b), np.sign(a - b)
        turn = (sense > 0) == (axis == 0)
        begin, end = np.where(turn, begin, end), np.where(turn, end, begin)
        places = [(across, at) if axis == 0 else (at, across) for at in (begin, end)]
        corners = _quads((*places[0], low), (*places[1], low), (*places[1], high), (*places[0], high))
        normals = self._wall_normals(axis, (first + last - 1) // 2 + RIM, line + RIM)
        leaning = normals[:, axis] * sense < UPRIGHT
        normals[leaning] = 0.0
        normals[leaning, axis] = sense[leaning]
        return Faces(corners, normals)

    def _wall_normals(self, axis: int, along: np.ndarray, line: np.ndarray) -> np.ndarray:
        """Return the normals of the blurred heights on the lines between two cells."""
        sides = [(along, line - k) if axis == 0 else (line - k, along) for k in (0, 1)]
        slopes = [-sum(self._slope(*side, part) for side in sides) / 2 for part in range(2)]
        return _unit(np.column_stack([*slopes, np.ones(len(line))]))

    def _bottom(self) -> Faces:
        """Return the underside, open where the part is cut through."""
        solid = self.inner > self.bottom_mm
        row, first, last, count = _rectangles(solid)
        there = solid[row, first]
        row, first, last, count = (column[there] for column in (row, first, last, count))
        west, east, south, north = self.x_mm[first], self.x_mm[last], self.y_mm[row], self.y_mm[row + count]
        z = np.full(len(row), self.bottom_mm)
        corners = _quads((west, south, z), (west, north, z), (east, north, z), (east, south, z))
        return Faces(corners, np.tile(np.array([0, 0, -1], np.float32), (len(row), 1)))

    def _gentle(self, row: np.ndarray, column: np.ndarray, axis: int) -> np.ndarray:
        """Return the slope of cells along x (0) or y (1): the gentler of its two sides, 0 beside an edge or ridge."""
        down, east = (axis, 1 - axis)
        middle = self.heights[row, column]
        before = (middle - self.heights[row - down, column - east]) / self.cell_mm[axis]
        after = (self.heights[row + down, column + east] - middle) / self.cell_mm[axis]
        return np.where(before * after > 0, np.sign(before) * np.minimum(abs(before), abs(after)), 0.0)

    def _slope(self, row: np.ndarray, column: np.ndarray, axis: int) -> np.ndarray:
        """Return the slope of the blurred heights at cells, along x (0) or y (1)."""
        down, east = (axis, 1 - axis)
        rise = self._blurred(row + down, column + east) - self._blurred(row - down, column - east)
        return rise / (2 * self.cell_mm[axis])

    def _blurred(self, row: np.ndarray, column: np.ndarray) -> np.ndarray:
        """Return the mean of the cells around each cell."""
        south, north, west, east = row - BLUR, row + BLUR + 1, column - BLUR, column + BLUR + 1
        total = self.sums[north, east] - self.sums[south, east] - self.sums[north, west] + self.sums[south, west]
        return total / (2 * BLUR + 1) ** 2


def _rectangles(heights: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return first row, first and last + 1 column, number of rows of rectangles of one value that fill an array."""
    rows, columns = heights.shape
    begins = np.ones((rows, columns), bool)
    begins[:, 1:] = heights[:, 1:] != heights[:, :-1]
    row, first = _places(begins)
    ends = np.append(row[1:] != row[:-1], True)
    last = np.where(ends, columns, np.append(first[1:], columns))
    z = heights[row, first]
    order = np.lexsort((row, z, last, first))
    row, first, last, z = row[order], first[order], last[order], z[order]
    goes_on = (first[1:] == first[:-1]) & (last[1:] == last[:-1]) & (z[1:] == z[:-1]) & (row[1:] == row[:-1] + 1)
    new = np.flatnonzero(np.append(True, ~goes_on))
    count = np.diff(np.append(new, len(row)))
    return row[new], first[new], last[new], count


def _runs_of_walls(here: np.ndarray, there: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the line (column), first and last + 1 row of runs in which neither of two different heights changes."""
    wall = here != there
    begins = wall.copy()
    begins[1:] &= (here[1:] != here[:-1]) | (there[1:] != there[:-1])
    ends = wall.copy()
    ends[:-1] &= begins[1:] | ~wall[1:]
    line, first = _places(begins.T)
    _, last = _places(ends.T)
    return line, first, last + 1


def _places(mask: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return row and column of set cells, as `np.nonzero` does, in a third of its time for few cells."""
    flat = np.flatnonzero(mask)
    row = flat // max(mask.shape[1], 1)
    return row, flat - row * mask.shape[1]


def _quads(*corners: tuple[np.ndarray, np.ndarray, np.ndarray]) -> np.ndarray:
    return np.stack([np.stack(corner, axis=1) for corner in corners], axis=1).astype(np.float32)


def _unit(vectors: np.ndarray) -> np.ndarray:
    return (vectors / np.linalg.norm(vectors, axis=1, keepdims=True)).astype(np.float32)
