# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part tile by tile as faces: for a part at another time only the changed tiles are drawn.

+------+------+        A tile that a move has reached is another object than before. Where heights of it differ,
|      |  /// |        the tiles are drawn again whose faces depend on them: walls stand between tiles, and a wall's
+------+--///-+        direction depends on the cells around. The faces of all tiles close the part.
|      |      |
+------+------+
"""

from __future__ import annotations

import numpy as np

from CNCStepper.simulation.meshes.mesh_faces import RIM, Cells, Faces, borders_mm, drawn_heights
from CNCStepper.simulation.removal.heightmap import Grid, Part, Tile
from CNCStepper.simulation.removal.tile_kernels import TILE


class ChangedTiles:
    """The heights of a part, of every `step`-th cell (a power of 2, at most TILE); uncut until it takes a part."""

    def __init__(self, grid: Grid, step: int = 1):
        self.grid, self.step = grid, step
        self.side = TILE // step
        tops = grid.stock.tops_mm(grid.centres_mm(0), grid.centres_mm(1)).astype(np.float32)
        self.uncut = drawn_heights(tops, grid.stock.bottom_mm, step)
        self.shape = self.uncut.shape
        self.heights = np.pad(self.uncut, RIM, constant_values=grid.stock.bottom_mm)
        self.x_mm, self.y_mm = borders_mm(grid.stock, self.shape)
        self._taken: dict[int, Tile] = {}

    def __len__(self) -> int:
        """The number of tiles."""
        return self.grid.shape[0] * self.grid.shape[1]

    def take(self, part: Part) -> list[int]:
        """Become a part on the same grid; returns the numbers of the tiles whose faces are others now, rising."""
        dirty: set[int] = set()
        for number in self._taken.keys() | part.tiles.keys():
            tile = part.tiles.get(number)
            if tile is not self._taken.get(number):
                dirty |= self._write(number, tile)
        self._taken = dict(part.tiles)
        return sorted(dirty)

    def faces(self, number: int) -> Faces:
        """Return the faces of a tile: its cells, and the walls to its west and south."""
        (south, north), (west, east) = self._ends(number)
        if south == north or west == east:  # larger cells have left none to a narrow last tile
            return Faces(np.zeros((0, 4, 3), np.float32), np.zeros((0, 3), np.float32))
        heights = self.heights[south : north + 2 * RIM, west : east + 2 * RIM]
        lines = self.x_mm[west : east + 1], self.y_mm[south : north + 1]
        last = east == self.shape[1], north == self.shape[0]
        return Cells(heights, *lines, self.grid.stock.bottom_mm, last).faces()

    def _ends(self, number: int) -> list[tuple[int, int]]:
        """Return first and last + 1 row, and first and last + 1 column, of a tile."""
        places = zip(divmod(number, self.grid.shape[1]), self.shape, strict=True)
        return [(k * self.side, min((k + 1) * self.side, count)) for k, count in places]

    def _write(self, number: int, tile: Tile | None) -> set[int]:
        """Write a tile's heights, None: uncut; returns the tiles that must be drawn again."""
        (south, north), (west, east) = self._ends(number)
        own = slice(south, north), slice(west, east)
        inner = self.heights[RIM:-RIM, RIM:-RIM][own]
        bottom_mm = self.grid.stock.bottom_mm
        new = self.uncut[own] if tile is None else drawn_heights(tile.heights, bottom_mm, self.step)
        rows, columns = np.nonzero(new != inner)
        if not len(rows):
            return set()
        inner[:] = new
        return self._around(south + rows.min(), south + rows.max(), west + columns.min(), west + columns.max())

    def _around(self, south: int, north: int, west: int, east: int) -> set[int]:
        """Return the tiles whose faces depend on a rectangle of cells, first and last row and column."""
        ranges = []
        for first, last, count in ((south, north, self.grid.shape[0]), (west, east, self.grid.shape[1])):
            ranges.append(range(max(first - RIM, 0) // self.side, min((last + RIM) // self.side, count - 1) + 1))
        return {row * self.grid.shape[1] + column for row in ranges[0] for column in ranges[1]}
