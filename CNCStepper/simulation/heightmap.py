# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cut part as a map of heights: what pictures and the removed volume are made from.

Each cell holds the height of the material at its centre, cut exactly: for a segment the part of it
that has the centre within the tool's radius gives the lowest height of the tool there,

    flat: the lower end of that part        ball: z(t) + R - sqrt(R² - d(t)²) at its lowest
"""

from __future__ import annotations

import math

import numpy as np
import shapely

from CNCStepper.kernels import COMPILED, njit
from CNCStepper.simulation.cutter import Cutter, Tools
from CNCStepper.simulation.segments import Segments, chains
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.sweep import cutting_path
from CNCStepper.toolpath import Toolpath

CELLS = 600 if COMPILED else 150  # along the stock's longer side; plain Python is 200 times slower
THIN_SHARE = 0.02  # of a cell: how far level path may be simplified before it is cut


class HeightMap:
    """Heights of the material over a stock, float64[rows, columns], rows along y; z = 0 is the stock's top.

    cell_mm: the longest side a cell may have; the cells fill the stock exactly.
    """

    def __init__(self, stock: Stock, cell_mm: float = 0.0):
        cell_mm = cell_mm or max(stock.size_mm[:2]) / CELLS
        self.stock = stock
        self.x_mm, self.y_mm = (
            _centres(stock.low_mm[axis], stock.size_mm[axis], max(math.ceil(stock.size_mm[axis] / cell_mm - 1e-9), 1))
            for axis in range(2)
        )
        self.heights_mm = np.full((len(self.y_mm), len(self.x_mm)), stock.top_mm)

    @property
    def cell_mm(self) -> tuple[float, float]:
        """Length of a cell along x and y."""
        return self.stock.size_mm[0] / len(self.x_mm), self.stock.size_mm[1] / len(self.y_mm)

    @property
    def removed_volume_mm3(self) -> float:
        """The volume that was cut from the stock; below its bottom there is nothing to cut."""
        depth = self.stock.top_mm - np.maximum(self.heights_mm, self.stock.bottom_mm)
        return float(depth.sum()) * self.cell_mm[0] * self.cell_mm[1]

    def cut(self, cutter: Cutter, pieces: Segments) -> None:
        """Cut along the segments."""
        pieces = thinned(pieces, THIN_SHARE * max(self.cell_mm))
        grid = np.array([self.x_mm[0], self.y_mm[0], *self.cell_mm])
        _cut(self.heights_mm, grid, pieces.begin, pieces.end, cutter.radius_mm, cutter.ball)


def height_map(toolpath: Toolpath, tools: Tools, stock: Stock, cell_mm: float = 0.0) -> HeightMap:
    """Return the stock after the whole program; rows with a tool that is not among `tools` cut nothing."""
    result = HeightMap(stock, cell_mm)
    for cutter, pieces in cutting_path(toolpath, tools, stock.top_mm):
        result.cut(cutter, pieces)
    return result


def thinned(pieces: Segments, tolerance_mm: float) -> Segments:
    """Return the segments with level runs simplified within the tolerance; ramps stay as they are."""
    level = pieces.begin[:, 2] == pieces.end[:, 2]
    begins, ends = [pieces.begin[~level]], [pieces.end[~level]]
    for chain in chains(pieces[level]):
        points = shapely.get_coordinates(shapely.LineString(chain[:, :2]).simplify(tolerance_mm))
        points = np.column_stack([points, np.full(len(points), chain[0, 2])])
        begins.append(points[:-1])
        ends.append(points[1:])
    begin, end = np.vstack(begins), np.vstack(ends)
    return Segments(begin, end, np.zeros(len(begin), np.int64))


def _centres(low_mm: float, size_mm: float, count: int) -> np.ndarray:
    return low_mm + (np.arange(count) + 0.5) * (size_mm / count)


@njit
def _cut(heights, grid, begin, end, radius, ball):
    """Lower `heights` along segments begin[n, 3] -> end[n, 3]; grid: first centre x, y and cell lengths.

    Along the segment, s runs from 0 to its length; the centre (x, y) has foot s and distance p, and the
    tool covers it for s in [foot - half, foot + half], half = sqrt(R² - p²).
    """
    rows, columns = heights.shape
    x0, y0, dx, dy = grid[0], grid[1], grid[2], grid[3]
    for k in range(len(begin)):
        ax, ay, az = begin[k, 0], begin[k, 1], begin[k, 2]
        length = math.hypot(end[k, 0] - ax, end[k, 1] - ay)
        rise = end[k, 2] - az
        ux = (end[k, 0] - ax) / length if length > 0 else 1.0
        uy = (end[k, 1] - ay) / length if length > 0 else 0.0
        slope = rise / length if length > 0 else 0.0
        low_z = min(az, end[k, 2])
        first = max(math.ceil((min(ay, end[k, 1]) - radius - y0) / dy), 0)
        last = min(math.floor((max(ay, end[k, 1]) + radius - y0) / dy), rows - 1)
        for row in range(first, last + 1):
            y = y0 + row * dy - ay
            s0, s1 = 0.0, length
            if abs(uy) > 1e-12:  # only the part of the segment within the radius of this row
                s0 = max(s0, min((y - radius) / uy, (y + radius) / uy))
                s1 = min(s1, max((y - radius) / uy, (y + radius) / uy))
            west = ax + min(s0 * ux, s1 * ux) - radius
            east = ax + max(s0 * ux, s1 * ux) + radius
            for column in range(
                max(math.ceil((west - x0) / dx), 0), min(math.floor((east - x0) / dx), columns - 1) + 1
            ):
                if heights[row, column] <= low_z:
                    continue
                x = x0 + column * dx - ax
                foot = x * ux + y * uy
                p = x * uy - y * ux
                room = radius * radius - p * p
                if room < 0.0:
                    continue
                half = math.sqrt(room)
                from_s, to_s = max(foot - half, 0.0), min(foot + half, length)
                if from_s > to_s:
                    continue
                if ball:
                    s = min(max(foot - slope * half / math.sqrt(1 + slope * slope), from_s), to_s)
                    z = az + slope * s + radius - math.sqrt(max(room - (s - foot) * (s - foot), 0.0))
                else:
                    z = az + slope * (from_s if slope > 0 else to_s)
                if length == 0.0:
                    z += min(rise, 0.0)
                if z < heights[row, column]:
                    heights[row, column] = z
