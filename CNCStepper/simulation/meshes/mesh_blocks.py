# SPDX-License-Identifier: LGPL-2.1-or-later
"""Squares of cells merged into one face, and triangles that meet their neighbours' at every point.

+-------+---+---+     Where many cells lie in one plane a square of 2, 4, 8 ... is one fan about its middle. A fan goes
| \\   / | x | x |     by every point that a smaller neighbour has on its border, so that no edge ends in the middle of
|   x---+---+---+     another one: the mesh stays closed to the bit.
| /   \\ | x | x |
+-------+---+---+
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

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
