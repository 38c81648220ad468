# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contours of a field of greys at a level, closed, the dark on their left: marching squares with interpolation.

    8 --T-- 4     a cell has four pixels at its corners; a contour goes in and out over its edges, from the edge
    |       |     of `FIRST` to that of `LAST` for each pattern of dark corners. Two diagonal dark corners are one
    L       R     area where the mean of the four is dark.
    |       |
    1 --B-- 2     (Lorensen and Cline 1987, in the plane)

Rows are taken in strips, so that memory grows with the contours and not with the picture.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from CNCStepper.cancellation import checkpoint
from CNCStepper.errors import JobError
from CNCStepper.kernels import njit

STRIP = 128  # rows
MOST_POINTS = 3_000_000
LIGHT = 255
BOTTOM, RIGHT, TOP, LEFT = range(4)
DIAGONAL = (5, 10)
CODES = {  # dark corners: edges from which and to which the contour goes
    1: (BOTTOM, LEFT), 2: (RIGHT, BOTTOM), 4: (TOP, RIGHT), 8: (LEFT, TOP), 3: (RIGHT, LEFT), 6: (TOP, BOTTOM),
    12: (LEFT, RIGHT), 9: (BOTTOM, TOP), 7: (TOP, LEFT), 14: (LEFT, BOTTOM), 13: (BOTTOM, RIGHT), 11: (RIGHT, TOP),
}  # fmt: skip
SADDLES = {  # dark corners, whether the middle is dark: both stretches
    (5, False): ((BOTTOM, LEFT), (TOP, RIGHT)), (5, True): ((BOTTOM, RIGHT), (TOP, LEFT)),
    (10, False): ((RIGHT, BOTTOM), (LEFT, TOP)), (10, True): ((LEFT, BOTTOM), (RIGHT, TOP)),
}  # fmt: skip


def contours_of(values: np.ndarray, level: float) -> list[np.ndarray]:
    """Return the closed contours of greys uint8[rows, columns], in pixels from the centre of the first one.

    level: no whole number, so that no grey lies on it. What is below is dark, what is around the picture light. Each
    is float64[n, 2], its first point not repeated. Raises JobError for more than MOST_POINTS.
    """
    columns = values.shape[1] + 2
    parts = list(_strips(values, level, columns))
    if not parts:
        return []
    first, last, points = (np.concatenate(column) for column in zip(*parts, strict=True))
    order = np.argsort(first, kind="stable")
    following = np.searchsorted(first[order], last[order])
    walk, ends = loops_of(following)
    places = points[order][walk]
    return np.split(places, ends[:-1])


def _strips(values: np.ndarray, level: float, columns: int) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """Yield for strips of rows the stretches in their cells: first edge, last edge, and the point on the first one."""
    rows, count = values.shape[0] + 2, 0
    for low in range(0, rows - 1, STRIP):
        checkpoint()
        high = min(low + STRIP, rows - 1)
        strip = np.full((high - low + 1, columns), float(LIGHT))
        inner = slice(max(low - 1, 0), min(high, values.shape[0]))
        strip[inner.start - low + 1 : inner.stop - low + 1, 1:-1] = values[inner]
        found = _stretches(strip, level, low, columns)
        count += len(found[0])
        if count > MOST_POINTS:
            advice = "blur the picture, scale it down, or choose another threshold"
            raise JobError("picture-noisy", "the picture has too many contours", limit=f"{MOST_POINTS} points",
                           advice=advice)  # fmt: skip
        if len(found[0]):
            yield found


def _stretches(strip: np.ndarray, level: float, low: int, columns: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    dark = (strip < level).astype(np.int8)
    code = dark[:-1, :-1] + 2 * dark[:-1, 1:] + 4 * dark[1:, 1:] + 8 * dark[1:, :-1]
    row, column = np.nonzero((code > 0) & (code < 15))
    codes = code[row, column]
    begins, ends, cells = [], [], []
    for pattern, (first, last) in CODES.items():
        own = np.flatnonzero(codes == pattern)
        begins.append(np.full(len(own), first))
        ends.append(np.full(len(own), last))
        cells.append(own)
    four = strip[row, column] + strip[row, column + 1] + strip[row + 1, column + 1] + strip[row + 1, column]
    for (pattern, is_dark), stretches in SADDLES.items():
        own = np.flatnonzero((codes == pattern) & ((four < 4.0 * level) == is_dark))
        for first, last in stretches:
            begins.append(np.full(len(own), first))
            ends.append(np.full(len(own), last))
            cells.append(own)
    cell = np.concatenate(cells)
    begin, end = np.concatenate(begins), np.concatenate(ends)
    at_row, at_column = row[cell], column[cell]
    points = _points(strip, level, at_row, at_column, begin) + np.array([-1.0, low - 1.0])
    edges = (_edges(at_row + low, at_column, side, columns) for side in (begin, end))
    return (*edges, points)  # type: ignore[return-value]


def _edges(row: np.ndarray, column: np.ndarray, side: np.ndarray, columns: int) -> np.ndarray:
    """Return the numbers of edges of cells: 2 n for the one right of pixel n, 2 n + 1 for the one above it."""
    pixel = (row + (side == TOP)) * columns + column + (side == RIGHT)
    return 2 * pixel + ((side == LEFT) | (side == RIGHT))  # type: ignore[no-any-return]


def _points(strip: np.ndarray, level: float, row: np.ndarray, column: np.ndarray, side: np.ndarray) -> np.ndarray:
    """Return where the level is crossed on edges of cells, by interpolation, float64[n, 2]."""
    upright = (side == LEFT) | (side == RIGHT)
    one_row, one_column = row + (side == TOP), column + (side == RIGHT)
    other_row, other_column = one_row + upright, one_column + ~upright
    one, other = strip[one_row, one_column], strip[other_row, other_column]
    share = (level - one) / (other - one)
    return np.column_stack([one_column + share * ~upright, one_row + share * upright])


@njit
def loops_of(following):
    """Return the stretches in the order in which they follow each other, int64[n], and where each loop ends."""
    count = len(following)
    walk, ends = np.empty(count, np.int64), np.empty(count, np.int64)
    done = np.zeros(count, np.bool_)
    place, loops = 0, 0
    for begin in range(count):
        at = begin
        while not done[at]:
            done[at] = True
            walk[place] = at
            place += 1
            at = following[at]
        if place > (ends[loops - 1] if loops else 0):
            ends[loops] = place
            loops += 1
    return walk, ends[:loops].copy()
