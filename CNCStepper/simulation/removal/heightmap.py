# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cut part as a map of heights: what pictures, meshes and the removed volume are made from.

Each cell's height is that of the material at its centre, cut by the cutter's own profile along the
move's own line, arc or helix; `cutter_solid.py` and the `removal_` modules say how.

A part as tiles of cells that are made when a move reaches them, and shared between moments of the part.

A cell holds two heights: that of the material at its centre, and the mean over its area, in which the
part of a cell that lies beyond a wall counts as uncut. The mean makes the volume independent of where
the cells' centres fall; of several walls in one cell the one that takes most counts.
"""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from functools import cached_property, lru_cache

import numpy as np

from CNCStepper.kernels import COMPILED
from CNCStepper.machine.tools.tool_profile import Form
from CNCStepper.simulation.cutter_solid import Tools
from CNCStepper.simulation.removal.removal_moves import Moves, moves_of
from CNCStepper.simulation.removal.tile_kernels import TILE, bins, means_apart, tile_after
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.tip_segments import Segments
from CNCStepper.toolpath import Toolpath

BATCH = 262_144  # moves are sorted into tiles that many at a time
THREADS = min(os.cpu_count() or 1, 8) if COMPILED else 1
FEW = 2000  # moves that are not worth a second thread


class Tile:
    """Heights at the cells' centres and means over the cells, float32[rows, columns], mm.

    Most cells' mean is their height, or the stock's bottom where that is lower; only the others are kept.
    """

    __slots__ = ("_bottom", "columns")

    def __init__(self, columns: tuple[np.ndarray, np.ndarray, np.ndarray], bottom_mm: float):
        """columns: the heights, and the places and values of the means that are kept, as `tile_after` has them."""
        self.columns, self._bottom = columns, np.float32(bottom_mm)

    @classmethod
    def of(cls, heights: np.ndarray, means: np.ndarray, bottom_mm: float) -> Tile:
        """Return the tile that has these heights and means."""
        return cls((heights, *means_apart(heights, means, np.float32(bottom_mm))), bottom_mm)

    @property
    def heights(self) -> np.ndarray:
        """The heights at the cells' centres; not to be written to."""
        return self.columns[0]

    @property
    def means(self) -> np.ndarray:
        """The means, an array of its own at each call."""
        heights, places, values = self.columns
        means = np.maximum(heights, self._bottom)
        means.ravel()[places] = values
        return means

    @property
    def nbytes(self) -> int:
        """Memory of the arrays."""
        return sum(column.nbytes for column in self.columns)


@dataclass(frozen=True)
class Grid:
    """The cells that fill a stock exactly: `cells` along x and y, in tiles of TILE."""

    stock: Stock
    cells: tuple[int, int]

    @classmethod
    def of(cls, stock: Stock, cell_mm: float) -> Grid:
        """Return the grid whose cells have sides of at most `cell_mm`."""
        x, y = (max(math.ceil(length / cell_mm - 1e-9), 1) for length in stock.size_mm[:2])
        return cls(stock, (x, y))

    @property
    def cell_mm(self) -> tuple[float, float]:
        """Length of a cell along x and y."""
        return self.stock.size_mm[0] / self.cells[0], self.stock.size_mm[1] / self.cells[1]

    @property
    def shape(self) -> tuple[int, int]:
        """Tiles along y and along x."""
        return math.ceil(self.cells[1] / TILE), math.ceil(self.cells[0] / TILE)

    @property
    def frame(self) -> tuple[float, float, float, float]:
        """Low x and y of the grid, and the lengths of a cell."""
        return (*self.stock.low_mm[:2], *self.cell_mm)  # type: ignore[return-value]

    def centres_mm(self, axis: int, first: int = 0, last: int | None = None) -> np.ndarray:
        """Return the centres of the cells [first, last) along an axis; not to be written to."""
        return self._centres_mm[axis][first:last]

    @cached_property
    def _centres_mm(self) -> list[np.ndarray]:
        cells = zip(self.stock.low_mm, self.cells, self.cell_mm, strict=False)
        return [low_mm + (np.arange(count) + 0.5) * cell_mm for low_mm, count, cell_mm in cells]

    def tile_centres_mm(self, number: int) -> tuple[np.ndarray, np.ndarray]:
        """Return x and y of the cells of a tile."""
        row, column = divmod(number, self.shape[1])
        x, y = (self.centres_mm(axis, k * TILE, (k + 1) * TILE) for axis, k in ((0, column), (1, row)))
        return x, y

    def tile_tops_mm(self, number: int) -> np.ndarray:
        """Return the tops of the cells of a tile, float32[rows, columns]; not to be written to."""
        x_mm, y_mm = self.tile_centres_mm(number)
        if self.stock.is_level:
            return _level_tops_mm(self.stock.top_mm, len(y_mm), len(x_mm))
        return self.stock.tops_mm(x_mm, y_mm).astype(np.float32)

    def window(self, number: int) -> tuple[slice, slice]:
        """Return where a tile lies in the array of all cells."""
        row, column = divmod(number, self.shape[1])
        return slice(row * TILE, (row + 1) * TILE), slice(column * TILE, (column + 1) * TILE)


@lru_cache(maxsize=4)  # inner tiles, and those at the two edges and in the corner
def _level_tops_mm(top_mm: float, rows: int, columns: int) -> np.ndarray:
    return np.full((rows, columns), top_mm, np.float32)


@dataclass(frozen=True)
class Part:
    """An immutable stock at one time: the tiles that moves have reached, by number."""

    grid: Grid
    tiles: Mapping[int, Tile] = field(default_factory=dict)

    def after(self, moves: Moves, first: int = 0, last: int | None = None) -> Part:
        """Return the part after the moves [first, last); tiles that none of them reaches are shared."""
        tiles = dict(self.tiles)
        last = len(moves) if last is None else last
        for begin in range(first, last, BATCH):
            work = list(bins(moves, begin, min(begin + BATCH, last), self.grid.frame, self.grid.shape).items())
            if THREADS == 1 or last - first < FEW:
                tiles.update(self._cut(moves, tiles, work))
                continue
            work.sort(key=lambda item: -len(item[1]))  # by turns, so that the threads end together
            shares = [work[number::THREADS] for number in range(THREADS)]
            with ThreadPoolExecutor(THREADS) as threads:
                for done in threads.map(lambda share: self._cut(moves, tiles, share), shares):
                    tiles.update(done)
        return Part(self.grid, tiles)

    def _cut(self, moves: Moves, tiles: Mapping[int, Tile], work: Iterable[tuple[int, np.ndarray]]) -> dict[int, Tile]:
        """Return the tiles that are cut; work: their numbers, and which of the moves reach each."""
        return {number: self._cut_tile(moves, number, which, tiles.get(number)) for number, which in work}

    def _cut_tile(self, moves: Moves, number: int, which: np.ndarray, old: Tile | None) -> Tile:
        x_mm, y_mm = self.grid.tile_centres_mm(number)
        tops = self.grid.tile_tops_mm(number)
        bottom_mm = self.grid.stock.bottom_mm
        old = old or Tile.of(tops, tops, bottom_mm)
        frame = (float(x_mm[0]), float(y_mm[0]), *self.grid.cell_mm)
        columns = (moves.begin, moves.end, moves.arc, moves.arcs, moves.form, moves.forms, moves.joined)
        return Tile(tile_after(old.columns, tops, bottom_mm, frame, *columns, which), bottom_mm)

    def changed_since(self, other: Part) -> set[int]:
        """Return the numbers of the tiles in which this part may differ from it at another time; tiles are shared."""
        numbers = self.tiles.keys() | other.tiles.keys()
        return {number for number in numbers if self.tiles.get(number) is not other.tiles.get(number)}

    def heights_mm(self) -> np.ndarray:
        """Return the heights at all centres, float64[rows, columns], rows along y."""
        return self._whole("heights")

    def means_mm(self) -> np.ndarray:
        """Return the mean heights of all cells, float64[rows, columns]; through a cut they are the bottom."""
        return self._whole("means")

    def _whole(self, which: str) -> np.ndarray:
        grid = self.grid
        whole = grid.stock.tops_mm(grid.centres_mm(0), grid.centres_mm(1))
        for number, tile in self.tiles.items():
            whole[grid.window(number)] = getattr(tile, which)
        return whole

    @property
    def removed_volume_mm3(self) -> float:
        """The volume that was cut from the stock; below its bottom there is nothing to cut."""
        depths = 0.0
        for number in sorted(self.tiles):
            x_mm, y_mm = self.grid.tile_centres_mm(number)
            tops = self.grid.stock.tops_mm(x_mm, y_mm)
            shares = self.grid.stock.shares(x_mm, y_mm, self.grid.cell_mm)
            depths += float(((tops.astype(np.float32) - self.tiles[number].means.astype(float)) * shares).sum())
        return depths * self.grid.cell_mm[0] * self.grid.cell_mm[1]


CELLS = 600 if COMPILED else 150  # along the stock's longer side; plain Python is 200 times slower


class HeightMap:
    """Heights of the material over a stock; z = 0 is the stock's top.

    stock; x_mm, y_mm: the cells' centres. cell_mm: lengths of a cell along x and y; the cells fill the stock exactly.
    part: the tiles behind it.
    """

    def __init__(self, stock: Stock, cell_mm: float = 0.0, part: Part | None = None):
        """cell_mm: the longest side a cell may have. part: an already cut part, whose own cells are used then."""
        self.part = part or Part(Grid.of(stock, cell_mm or max(stock.size_mm[:2]) / CELLS))
        self.stock = stock
        self.cell_mm = self.part.grid.cell_mm
        self.x_mm, self.y_mm = (self.part.grid.centres_mm(axis) for axis in range(2))

    @cached_property
    def heights_mm(self) -> np.ndarray:
        """Heights at the centres, float64[rows, columns], rows along y; below the stock where a tool went through."""
        return self.part.heights_mm()

    @property
    def removed_volume_mm3(self) -> float:
        """The volume that was cut from the stock; below its bottom there is nothing to cut."""
        return self.part.removed_volume_mm3

    def cut(self, form: Form, pieces: Segments) -> None:
        """Cut along the segments, in their order, with a cutter of that form."""
        self.part = self.part.after(Moves.lines(pieces.begin, pieces.end, form))
        self.__dict__.pop("heights_mm", None)


def height_map(toolpath: Toolpath, tools: Tools, stock: Stock, cell_mm: float = 0.0) -> HeightMap:
    """Return the stock after the whole program; rows with a tool that is not among `tools` cut nothing."""
    uncut = HeightMap(stock, cell_mm)
    return HeightMap(stock, part=uncut.part.after(moves_of(toolpath, tools, stock)))
