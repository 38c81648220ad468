# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cut part as a closed mesh of triangles that encloses exactly its volume, and as a binary STL file.

b-----c      Each cell with material is four triangles about its middle, which has the cell's mean height;
|\\   /|      a corner has the mean of the cells around it that hold material. So every cell counts with
|  m  |      its own volume. Where cells end, at the stock's side and round a hole, stands a wall.
|/   \\|      Cells that lie in one level plane make larger squares.
a-----d

Squares of cells merged into one face, and triangles that meet their neighbours' at every point.

+-------+---+---+     Where many cells lie in one plane a square of 2, 4, 8 ... is one fan about its middle. A fan goes
| \\   / | x | x |     by every point that a smaller neighbour has on its border, so that no edge ends in the middle of
|   x---+---+---+     another one: the mesh stays closed to the bit.
| /   \\ | x | x |
+-------+---+---+
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np

from CNCStepper.atomic_file import whole_file
from CNCStepper.simulation.removal.heightmap import HeightMap
from CNCStepper.tolerances import NO_MATERIAL_MM

LARGEST = 64  # cells along the side of a square


class Squares(NamedTuple):
    """Squares of one size: first rows and columns, int64[n], and cells along a side."""

    row: np.ndarray
    column: np.ndarray
    side: int


def squares_of(solid: np.ndarray, plane: np.ndarray) -> list[Squares]:
    """Return squares that fill the `solid` cells; larger than a cell only where all their cells are `plane`."""
    levels = [plane & solid]
    while 2 ** len(levels) <= LARGEST:
        rows, columns = (length + length % 2 for length in levels[-1].shape)
        fours = np.zeros((rows, columns), bool)
        fours[: levels[-1].shape[0], : levels[-1].shape[1]] = levels[-1]
        levels.append(fours[::2, ::2] & fours[1::2, ::2] & fours[::2, 1::2] & fours[1::2, 1::2])
    levels[0] = solid
    found = []
    for level, here in enumerate(levels):
        own = here.copy()
        if level + 1 < len(levels):
            rows, columns = here.shape
            own &= ~levels[level + 1].repeat(2, axis=0).repeat(2, axis=1)[:rows, :columns]
        row, column = np.nonzero(own)
        found.append(Squares(row * 2**level, column * 2**level, 2**level))
    return [squares for squares in found if len(squares.row)]


def corners_used(squares: list[Squares], used: np.ndarray) -> None:
    """Mark the corners of the squares in `used`, bool[rows + 1, columns + 1]."""
    for row, column, side in squares:
        for r in (0, side):
            for c in (0, side):
                used[row + r, column + c] = True


def fans(squares: Squares, used: np.ndarray, numbers: np.ndarray, middles: np.ndarray) -> np.ndarray:
    """Return the triangles of squares about their middles, counter-clockwise from above, int64[n, 3].

    used, numbers: which of the cells' corners are points, and their numbers. middles: numbers of the middles.
    """
    row, column, side = squares
    up, still = np.arange(side), np.zeros(side, int)
    r = np.concatenate([still, up, still + side, side - up])
    c = np.concatenate([up, still + side, side - up, still])
    around = numbers[row[:, None] + r, column[:, None] + c]
    which, place = np.nonzero(used[row[:, None] + r, column[:, None] + c])
    point = around[which, place]
    last = np.append(which[1:] != which[:-1], True)
    first = np.flatnonzero(np.append(True, which[1:] != which[:-1]))
    following = np.append(point[1:], 0)
    following[last] = point[first]
    return np.column_stack([point, following, middles[which]])


CORNERS = ((0, 0), (0, 1), (1, 1), (1, 0))  # row and column, counter-clockwise from above
STL_FACET = np.dtype([("normal", "<f4", 3), ("points", "<f4", (3, 3)), ("zero", "<u2")])


@dataclass(frozen=True)
class Mesh:
    """points_mm: float64[n, 3]. triangles: int64[m, 3], counter-clockwise from outside."""

    points_mm: np.ndarray
    triangles: np.ndarray

    @property
    def volume_mm3(self) -> float:
        """The volume that is enclosed."""
        a, b, c = (self.points_mm[self.triangles[:, k]] for k in range(3))
        return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)

    def save_stl(self, path: Path) -> None:
        """Write the mesh as binary STL, in mm."""
        facets = np.zeros(len(self.triangles), STL_FACET)
        corners = self.points_mm[self.triangles]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        facets["normal"] = normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
        facets["points"] = corners
        with whole_file(path) as file:
            file.write(b"CNCStepper, binary STL, mm".ljust(80))
            file.write(np.array([len(facets)], "<u4").tobytes())
            file.write(facets.tobytes())


def mesh_of(part: HeightMap) -> Mesh:
    """Return the part as a mesh; a cell that a wall crosses has the mean height of its two sides."""
    heights = _thickness_mm(part)
    solid = _joined(heights)
    corner_mm = _corners(heights, solid)
    grid = np.arange(corner_mm.size).reshape(corner_mm.shape)
    level = np.logical_and.reduce([_at_corner(corner_mm, r, c) == heights for r, c in CORNERS])
    above, below = squares_of(solid, level), squares_of(solid, solid)
    edge = _edge(solid)
    triangles, middles = _walls(solid, grid, grid + grid.size), 2 * grid.size
    for squares, numbers, sense in ((above, grid, 1), (below, grid + grid.size, -1)):
        used = edge.copy()
        corners_used(squares, used)
        for some in squares:
            named = np.arange(middles, middles + len(some.row))
            triangles.append(fans(some, used, numbers, named)[:, ::sense])
            middles += len(named)
    return _compact(_points(part, corner_mm, heights, above, below), np.vstack(triangles))


def _at_corner(corners: np.ndarray, row: int, column: int) -> np.ndarray:
    """Return for every cell the height at one of its corners."""
    return corners[row : corners.shape[0] - 1 + row, column : corners.shape[1] - 1 + column]


def _edge(solid: np.ndarray) -> np.ndarray:
    """Return which corners lie where cells with material end."""
    around = np.pad(solid, 1).astype(np.int8)
    count = around[:-1, :-1] + around[:-1, 1:] + around[1:, :-1] + around[1:, 1:]
    return (count > 0) & (count < 4)


def _thickness_mm(part: HeightMap) -> np.ndarray:
    """Return the mean height of the material over the bottom, in every cell."""
    shares = part.stock.shares(part.x_mm, part.y_mm, part.cell_mm)
    return np.maximum(part.part.means_mm() - part.stock.bottom_mm, 0.0) * shares


def _joined(heights: np.ndarray) -> np.ndarray:
    """Return which cells hold material; of two that would touch only at a corner a third one joins them."""
    solid = heights > NO_MATERIAL_MM
    while True:
        a, b, c, d = solid[:-1, :-1], solid[:-1, 1:], solid[1:, :-1], solid[1:, 1:]
        rising, falling = a & d & ~b & ~c, b & c & ~a & ~d
        if not (rising.any() or falling.any()):
            return solid
        solid = solid.copy()
        solid[:-1, 1:] |= rising
        solid[:-1, :-1] |= falling


def _corners(heights: np.ndarray, solid: np.ndarray) -> np.ndarray:
    """Return the mean height of the cells with material around each corner."""
    total, count = (np.zeros((solid.shape[0] + 1, solid.shape[1] + 1)) for _ in range(2))
    rows, columns = solid.shape
    for r, c in CORNERS:
        total[r : r + rows, c : c + columns] += np.where(solid, heights, 0.0)
        count[r : r + rows, c : c + columns] += solid
    return total / np.maximum(count, 1)


def _walls(solid: np.ndarray, grid: np.ndarray, floor: np.ndarray) -> list[np.ndarray]:
    """Return the triangles of the walls on the four sides of the cells that have no neighbour there."""
    walls = []
    open_ = np.pad(~solid, 1, constant_values=True)
    rows, columns = solid.shape
    for k, (row, column) in enumerate(((-1, 0), (0, 1), (1, 0), (0, -1))):
        r, c = np.nonzero(solid & open_[1 + row : 1 + row + rows, 1 + column : 1 + column + columns])
        (r0, c0), (r1, c1) = CORNERS[k], CORNERS[(k + 1) % 4]
        a, b = grid[r + r0, c + c0], grid[r + r1, c + c1]
        below_a, below_b = floor[r + r0, c + c0], floor[r + r1, c + c1]
        walls += [np.column_stack([b, a, below_a]), np.column_stack([b, below_a, below_b])]
    return walls


def _points(
    part: HeightMap, corner_mm: np.ndarray, heights: np.ndarray, above: list[Squares], below: list[Squares]
) -> np.ndarray:
    """Return the corners of the top and the bottom, and the middles of the squares there."""
    low, size, bottom_mm = part.stock.low_mm, part.stock.size_mm, part.stock.bottom_mm
    rows, columns = heights.shape
    cell_mm = (size[0] / columns, size[1] / rows)
    x, y = np.meshgrid(low[0] + np.arange(columns + 1) * cell_mm[0], low[1] + np.arange(rows + 1) * cell_mm[1])
    points = [
        np.column_stack([x.ravel(), y.ravel(), bottom_mm + corner_mm.ravel()]),
        np.column_stack([x.ravel(), y.ravel(), np.full(x.size, bottom_mm)]),
    ]
    for squares, factor in ((above, 1.0), (below, 0.0)):
        for row, column, side in squares:
            z = bottom_mm + factor * heights[row, column]
            half = side / 2
            points.append(
                np.column_stack([low[0] + (column + half) * cell_mm[0], low[1] + (row + half) * cell_mm[1], z])
            )
    return np.vstack(points)


def _compact(points: np.ndarray, triangles: np.ndarray) -> Mesh:
    """Return the mesh without the points that no triangle has."""
    used = np.zeros(len(points), bool)
    used[triangles] = True
    number = np.cumsum(used) - 1
    return Mesh(points[used], number[triangles])
