# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kernels: which moves reach which tiles, and the cutting of one tile by its moves."""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.kernels import njit
from CNCStepper.simulation.removal.arc_kernels import bounds, cut_arc
from CNCStepper.simulation.removal.line_kernels import cut_line, stored
from CNCStepper.simulation.removal.row_kernels import columns_between

TILE = 128  # cells along a tile's side: its two arrays of float32 fit a core's cache
BLOCK = 8  # cells along the side of a block, of which a tile knows how high it is at most
MOST_UNASKED = 63  # moves that are cut without a look at the blocks, while these have something to cut


@njit
def reached(begin, end, arc, arcs, form, forms, first, last, grid, shape, offsets, entries):
    """Count the moves [first, last) that reach each tile, or where `entries` has room write their indices there.

    grid: low x, y and lengths of a cell. shape: tiles along y and x. offsets: int64[tiles], counted up: to begin
    with zeros, or where each tile's entries begin.
    """
    tile_x, tile_y = grid[2] * TILE, grid[3] * TILE
    around = 0.5 * math.hypot(tile_x, tile_y)
    for k in range(first, last):
        wide = forms[form[k], 0] + 0.5 * (grid[2] + grid[3])
        a, b = begin[k], end[k]
        if arc[k] >= 0:
            x_low, y_low, x_high, y_high = bounds(a, b, arcs[arc[k]])
        else:
            x_low, y_low, x_high, y_high = min(a[0], b[0]), min(a[1], b[1]), max(a[0], b[0]), max(a[1], b[1])
        south, north = tiles_between(y_low - wide, y_high + wide, grid[1], tile_y, shape[0])
        west, east = tiles_between(x_low - wide, x_high + wide, grid[0], tile_x, shape[1])
        several = (north - south) * (east - west) > 0
        for i in range(south, north + 1):
            for j in range(west, east + 1):
                x, y = grid[0] + (j + 0.5) * tile_x, grid[1] + (i + 0.5) * tile_y
                if several and not is_near(x, y, a, b, arc[k], arcs, wide + around):
                    continue
                tile = i * shape[1] + j
                if len(entries):
                    entries[offsets[tile]] = k
                offsets[tile] += 1


@njit
def tiles_between(first, last, low, size, count):
    """Return the first and last tile that the range [first, last] touches."""
    return columns_between(first - size, last, low, 1.0 / size, count)


@njit
def is_near(x, y, a, b, arc, arcs, distance):
    """Return whether a move comes as near as `distance` to a point; an arc counts as its whole circle."""
    if arc >= 0:
        out = math.hypot(x - arcs[arc, 0], y - arcs[arc, 1])
        return min(arcs[arc, 4], arcs[arc, 5]) - distance <= out <= max(arcs[arc, 4], arcs[arc, 5]) + distance
    ex, ey = b[0] - a[0], b[1] - a[1]
    square = ex * ex + ey * ey
    share = ((x - a[0]) * ex + (y - a[1]) * ey) / square if square > 0.0 else 0.0
    share = min(max(share, 0.0), 1.0)
    return math.hypot(x - a[0] - share * ex, y - a[1] - share * ey) <= distance


@njit
def tile_after(old, tops, bottom, grid, begin, end, arc, arcs, form, forms, joined, which):
    """Return a tile after the moves `which`: its heights, and places and values of the means apart from them.

    old: the same of the tile before. The whole of a tile's work is one call, during which other threads run.
    """
    lowest = np.float32(bottom)
    heights = old[0].copy()
    means = np.maximum(heights, lowest)
    means.ravel()[old[1]] = old[2]
    cut_tile((heights, means, tops, bottom), grid, begin, end, arc, arcs, form, forms, joined, which)
    places, values = means_apart(heights, means, lowest)
    return heights, places, values


@njit
def means_apart(heights, means, lowest):
    """Return places, uint16, and values of those means that are not the height, or the bottom where that is lower."""
    places = np.flatnonzero(means != np.maximum(heights, lowest))
    return places.astype(np.uint16), means.ravel()[places]


@njit
def cut_tile(tile, grid, begin, end, arc, arcs, form, forms, joined, which):
    """Cut a tile by the moves `which`; grid: x and y of its first cell's centre, lengths of a cell.

    Lines go row by row over the cells that they cut. A short level one along x has many rows of few cells each, so it
    is cut with x and y exchanged: the cells are the same, and so is what is cut. (Of a ramp, or of a line that a climb
    goes on from, each row also has the cells between two ranges, which are others by columns.)
    A level line over cells that are as low already is passed over; where lines do cut, ever fewer are asked.
    """
    heights, means, tops, bottom = tile
    mirrored = heights.T, means.T, tops.T, bottom
    mirrored_grid = grid[1], grid[0], grid[3], grid[2]
    across = (TILE + BLOCK - 1) // BLOCK
    ceilings, seen = np.full((across, across, 2), np.inf, np.float32), np.full((across, across), -1, np.int64)
    cuts, unasked, run = 0, 0, 0
    for k in which:
        if unasked > 0:
            unasked -= 1
        elif arc[k] < 0 and begin[k][2] == end[k][2]:
            if _is_done(tile, grid, begin[k], end[k], forms[form[k], 0], ceilings, seen, cuts):
                run = 0
                continue
            run = min(2 * run + 1, MOST_UNASKED)
            unasked = run
        cuts += 1
        own = forms[form[k], 0], forms[form[k], 1], forms[form[k], 2], forms[form[k], 3]
        if arc[k] >= 0:
            cut_arc(tile, grid, begin[k], end[k], arcs[arc[k]], own)
        else:
            a, b, c = begin[k], end[k], end[min(k + 1, len(end) - 1)]
            along_x, along_y = abs(b[0] - a[0]), abs(b[1] - a[1])
            if along_y < along_x < 2.0 * own[0] and a[2] == b[2] >= c[2]:
                exchanged = (a[1], a[0], a[2]), (b[1], b[0], b[2]), (c[1], c[0], c[2])
                cut_line(mirrored, mirrored_grid, exchanged[0], exchanged[1], exchanged[2], joined[k], own)
            else:
                ends = (a[0], a[1], a[2]), (b[0], b[1], b[2]), (c[0], c[1], c[2])
                cut_line(tile, grid, ends[0], ends[1], ends[2], joined[k], own)


@njit
def _is_done(tile, grid, a, b, radius, ceilings, seen, cuts):
    """Return whether a level line has nothing to cut in a tile, as far as its blocks say.

    ceilings: float32[blocks, blocks, 2], at least the heights and the means of each block; seen: int64[blocks, blocks],
    how many cuts there were when they were found; cuts: how many there are now.
    """
    heights, means, _, bottom = tile
    rows, columns = heights.shape
    wide, half_x, half_y = radius + 0.5 * (grid[2] + grid[3]), 0.5 * grid[2], 0.5 * grid[3]
    height, mean = stored(a[2]), stored(max(a[2], bottom))
    south, north = columns_between(
        min(a[1], b[1]) - wide - half_y, max(a[1], b[1]) + wide + half_y, grid[1], 1.0 / grid[3], rows
    )
    west, east = columns_between(
        min(a[0], b[0]) - wide - half_x, max(a[0], b[0]) + wide + half_x, grid[0], 1.0 / grid[2], columns
    )
    for i in range(south // BLOCK, north // BLOCK + 1):
        for j in range(west // BLOCK, east // BLOCK + 1):
            if ceilings[i, j, 0] <= height and ceilings[i, j, 1] <= mean:
                continue
            if seen[i, j] == cuts:
                return False
            ceilings[i, j, 0] = _highest(heights, i * BLOCK, j * BLOCK)
            ceilings[i, j, 1] = _highest(means, i * BLOCK, j * BLOCK)
            seen[i, j] = cuts
            if ceilings[i, j, 0] > height or ceilings[i, j, 1] > mean:
                return False
    return True


@njit
def _highest(cells, first_row, first_column):
    """Return the greatest value of a block of cells."""
    highest = cells[first_row, first_column]
    for row in range(first_row, min(first_row + BLOCK, cells.shape[0])):
        for column in range(first_column, min(first_column + BLOCK, cells.shape[1])):
            highest = max(highest, cells[row, column])
    return highest


def bins(moves, first: int, last: int, grid: tuple[float, ...], shape: tuple[int, int]) -> dict[int, np.ndarray]:
    """Return the indices of the moves [first, last) that reach each tile, by the tile's number row by row."""
    columns = (moves.begin, moves.end, moves.arc, moves.arcs, moves.form, moves.forms, first, last, grid, shape)
    counts = np.zeros(shape[0] * shape[1], np.int64)
    reached(*columns, counts, np.zeros(0, np.int32))
    starts = np.cumsum(counts) - counts
    entries = np.zeros(int(counts.sum()), np.int32)
    reached(*columns, starts.copy(), entries)
    return {int(tile): entries[starts[tile] : starts[tile] + counts[tile]] for tile in np.flatnonzero(counts)}
