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

from CNCStepper.simulation.heightmap import HeightMap

MOST_FACES = 40_000  # a part that needs more is drawn from larger cells
SAME_MM = 1e-4  # heights that differ by less are one
BLUR = 2  # cells on each side over which a wall's direction is averaged
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
    step = 1
    while True:
        faces = _Cells(part, step).faces()
        if len(faces) <= most or step >= min(part.heights_mm.shape):
            return faces
        step *= 2


class _Cells:
    """Every `step`-th cell of a part, with a rim of air around."""

    def __init__(self, part: HeightMap, step: int):
        bottom_mm, low, size = part.stock.bottom_mm, part.stock.low_mm, part.stock.size_mm
        heights = np.maximum(part.heights_mm[step // 2 :: step, step // 2 :: step], bottom_mm)
        heights = np.round(heights / SAME_MM) * SAME_MM
        rows, columns = heights.shape
        self.bottom_mm = bottom_mm
        self.heights = np.pad(heights, 1, constant_values=bottom_mm)
        self.x_mm = low[0] + np.arange(columns + 1) * size[0] / columns
        self.y_mm = low[1] + np.arange(rows + 1) * size[1] / rows
        self.cell_mm = (size[0] / columns, size[1] / rows)
        self.slope = _slope(_blurred(self.heights), self.cell_mm)

    def faces(self) -> Faces:
        """Return the tops, the walls across x, the walls across y and the bottom."""
        parts = [self._tops(), self._walls(0), self._walls(1), self._bottom()]
        return Faces(*(np.concatenate([getattr(part, name) for part in parts]) for name in ("corners", "normals")))

    def _tops(self) -> Faces:
        heights = self.heights[1:-1, 1:-1]
        row, first, last, count = _rectangles(heights)
        z = heights[row, first]
        open_ = z > self.bottom_mm
        row, first, last, count, z = (column[open_] for column in (row, first, last, count, z))
        west, east, south, north = self.x_mm[first], self.x_mm[last], self.y_mm[row], self.y_mm[row + count]
        corners = _quads((west, south, z), (east, south, z), (east, north, z), (west, north, z))
        gentle = [_gentle(self.heights, axis, self.cell_mm[axis])[row + 1, first + 1] for axis in range(2)]
        return Faces(corners, _unit(np.stack([-gentle[0], -gentle[1], np.ones(len(z))], axis=1)))

    def _walls(self, axis: int) -> Faces:
        """Return the walls between neighbours along an axis (0 is x), joined where they go on unchanged."""
        heights = self.heights[1:-1, :] if axis == 0 else self.heights[:, 1:-1].T
        slope = [part[1:-1, :] if axis == 0 else part[:, 1:-1].T for part in self.slope]
        here, there = heights[:, :-1], heights[:, 1:]
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
        middle = (first + last - 1) // 2
        smooth = np.stack([-(part[middle, line] + part[middle, line + 1]) / 2 for part in slope], axis=1)
        normals = _unit(np.column_stack([smooth, np.ones(len(line))]))
        leaning = normals[:, axis] * sense < UPRIGHT
        normals[leaning] = 0.0
        normals[leaning, axis] = sense[leaning]
        return Faces(corners, normals)

    def _bottom(self) -> Faces:
        """Return the underside, open where the part is cut through."""
        solid = self.heights[1:-1, 1:-1] > self.bottom_mm
        row, first, last, count = _rectangles(solid)
        there = solid[row, first]
        row, first, last, count = (column[there] for column in (row, first, last, count))
        west, east, south, north = self.x_mm[first], self.x_mm[last], self.y_mm[row], self.y_mm[row + count]
        z = np.full(len(row), self.bottom_mm)
        corners = _quads((west, south, z), (west, north, z), (east, north, z), (east, south, z))
        return Faces(corners, np.tile(np.array([0, 0, -1], np.float32), (len(row), 1)))


def _rectangles(heights: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return first row, first and last + 1 column, number of rows of rectangles of one value that fill an array."""
    rows, columns = heights.shape
    begins = np.ones((rows, columns), bool)
    begins[:, 1:] = heights[:, 1:] != heights[:, :-1]
    row, first = np.nonzero(begins)
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
    line, first = np.nonzero(begins.T)
    _, last = np.nonzero(ends.T)
    return line, first, last + 1


def _gentle(heights: np.ndarray, axis: int, cell_mm: float) -> np.ndarray:
    """Return the slope along x (0) or y (1) at every cell: the gentler of its two sides, 0 beside an edge or ridge."""
    rise = np.diff(heights, axis=1 - axis) / cell_mm
    pad = [(0, 0), (0, 0)]
    pad[1 - axis] = (1, 0)
    before = np.pad(rise, pad)
    pad[1 - axis] = (0, 1)
    after = np.pad(rise, pad)
    return np.where(before * after > 0, np.sign(before) * np.minimum(abs(before), abs(after)), 0.0)


def _blurred(heights: np.ndarray) -> np.ndarray:
    """Return the mean of the cells around each cell."""
    for axis in range(2):
        pad = [(0, 0), (0, 0)]
        pad[axis] = (BLUR + 1, BLUR)
        total = np.cumsum(np.pad(heights, pad, mode="edge"), axis=axis)
        width, count = 2 * BLUR + 1, heights.shape[axis]
        heights = (total.take(np.arange(width, width + count), axis) - total.take(np.arange(count), axis)) / width
    return heights


def _slope(heights: np.ndarray, cell_mm: tuple[float, float]) -> list[np.ndarray]:
    along_y, along_x = np.gradient(heights, cell_mm[1], cell_mm[0])
    return [along_x, along_y]


def _quads(*corners: tuple[np.ndarray, np.ndarray, np.ndarray]) -> np.ndarray:
    return np.stack([np.stack(corner, axis=1) for corner in corners], axis=1).astype(np.float32)


def _unit(vectors: np.ndarray) -> np.ndarray:
    return (vectors / np.linalg.norm(vectors, axis=1, keepdims=True)).astype(np.float32)
