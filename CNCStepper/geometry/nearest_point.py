# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kernels: the nearest place on lines and arcs, exact; rows as in box_tree.py, spines as in proximity_tree.py.

A node's chord at distance d from a place, which the rows below leave by at most s, proves that none of them is
nearer than d - s: nodes that cannot hold anything nearer than the best so far are skipped.
"""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.geometry.box_tree import DEEPEST, LEAF, push_children
from CNCStepper.geometry.proximity_tree import distance, square_to
from CNCStepper.kernels import njit


@njit
def nearest(rows, spines, places):
    """Return how far each place, float64[m, 2], is from the rows, which of them is nearest, and the length on it."""
    away, row, at = np.empty(len(places)), np.empty(len(places), np.int64), np.empty(len(places))
    stack, least = np.empty(DEEPEST, np.int64), np.empty(DEEPEST)
    for place in range(len(places)):
        x, y = places[place, 0], places[place, 1]
        away[place], row[place] = _nearest_row(rows, spines, x, y, math.inf, stack, least)
        at[place] = _length_at(rows, row[place], x, y)
    return away, row, at


@njit
def nearest_of(rows, spines, places, limit_mm):
    """Return which of the places, float64[m, 2], is nearest to the rows, how far, the row and the length on it.

    -1 where none is nearer than a limit.
    """
    stack, least = np.empty(DEEPEST, np.int64), np.empty(DEEPEST)
    best, found, row = limit_mm, -1, 0
    for place in range(len(places)):
        away, at = _nearest_row(rows, spines, places[place, 0], places[place, 1], best, stack, least)
        if away < best:
            best, found, row = away, place, at
    return found, best, row, _length_at(rows, row, places[found, 0], places[found, 1])


@njit
def _nearest_row(rows, spines, x, y, limit, stack, least):
    """Return how far a place is from the nearest row and which that is, where it is nearer than a limit.

    `stack` and `least` are room to walk.
    """
    best, found, leaves = limit, 0, len(spines) // 2
    stack[0], least[0], height = 1, 0.0, 1
    while height:
        height -= 1
        node = stack[height]
        if least[height] >= best:
            continue
        if node >= leaves:
            first = (node - leaves) * LEAF
            for row in range(first, min(first + LEAF, len(rows))):
                away = distance(rows, row, x, y)
                if away < best:
                    best, found = away, row
            continue
        left, right = _least(spines, 2 * node, x, y), _least(spines, 2 * node + 1, x, y)
        height = push_children(stack, least, height, node, left, right, best)
    return best, found


@njit
def _least(spines, node, x, y):
    """Return how far a place is at least from the rows below a node."""
    rise = spines[node, 5]
    return max(math.sqrt(square_to(spines, node, x, y)) - rise, 0.0) if rise >= 0.0 else math.inf


@njit
def _length_at(rows, row, x, y):
    """Return the length along a row at which it is nearest to a place."""
    dx, dy, k = x - rows[row, 0], y - rows[row, 1], rows[row, 5]
    lx, ly = dx * rows[row, 6] + dy * rows[row, 7], dy * rows[row, 6] - dx * rows[row, 7]
    ex, ey = x - rows[row, 2], y - rows[row, 3]
    ahead, behind = lx >= 0.0, ex * rows[row, 8] + ey * rows[row, 9] <= 0.0
    if not ((ahead and behind) if abs(rows[row, 4]) <= math.pi else (ahead or behind)):
        return rows[row, 10] if ex * ex + ey * ey < dx * dx + dy * dy else 0.0
    if k == 0.0:
        return min(lx, rows[row, 10])
    turn = math.atan2(k * lx, 1.0 - k * ly)
    if turn * k < 0.0:
        turn += math.copysign(2.0 * math.pi, k)
    return min(turn / k, rows[row, 10])
