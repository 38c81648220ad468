# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Kernels: whether any of many lines and arcs lies nearer to a place than a limit; rows as in box_tree.py.

spines  float64[2 k, 6]   middle x y, direction x y and half the length of a chord, and how far the rows below
                          the node leave it at most, below 0 where there are none; nodes as in box_tree.py

     . - - - - .          A chain lies close along its chords, whatever their direction, and so does its
   /_ _ _ _ _ _ \         parallel: almost every node is told from the place's disc at once, where a box
  begin        end        would reach into it with a corner.
"""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.geometry.box_tree import DEEPEST, LEAF
from CNCStepper.kernels import njit

DEAD, NEAR, FAR = 0, 1, 2  # results of a look


@njit
def distance(rows, row, x, y):
    """Return the distance of a place to a row.

    The place as seen from the begin along the tangent is l: with the curvature k, | |k l - i| - 1 | / k is its
    distance to the circle, written so that a line (k = 0) is no case of its own.
    """
    dx, dy = x - rows[row, 0], y - rows[row, 1]
    lx, ly = dx * rows[row, 6] + dy * rows[row, 7], dy * rows[row, 6] - dx * rows[row, 7]
    ex, ey = x - rows[row, 2], y - rows[row, 3]
    ahead, behind = lx >= 0.0, ex * rows[row, 8] + ey * rows[row, 9] <= 0.0
    if (ahead and behind) if abs(rows[row, 4]) <= math.pi else (ahead or behind):
        k = rows[row, 5]
        return abs(k * (lx * lx + ly * ly) - 2.0 * ly) / (math.sqrt((k * lx) ** 2 + (k * ly - 1.0) ** 2) + 1.0)
    return math.sqrt(min(dx * dx + dy * dy, ex * ex + ey * ey))


@njit
def spines_of(rows):
    """Return the spines of rows."""
    leaves = 1
    while leaves * LEAF < len(rows):
        leaves *= 2
    spines, ends = np.zeros((2 * leaves, 6)), np.zeros((2 * leaves, 4))
    spines[:, 5] = -1.0
    for leaf in range((len(rows) + LEAF - 1) // LEAF):
        first, last = leaf * LEAF, min(leaf * LEAF + LEAF, len(rows)) - 1
        node = leaves + leaf
        ends[node, 0:2], ends[node, 2:4] = rows[first, 0:2], rows[last, 2:4]
        _lay(spines, node, ends)
        for row in range(first, last + 1):
            _widen(spines, node, rows, row, _rise(rows, row))
    for node in range(leaves - 1, 0, -1):
        left, right = 2 * node, 2 * node + 1
        if spines[left, 5] < 0.0:
            continue
        both = spines[right, 5] >= 0.0
        ends[node, 0:2], ends[node, 2:4] = ends[left, 0:2], ends[right if both else left, 2:4]
        _lay(spines, node, ends)
        _widen(spines, node, ends, left, spines[left, 5])
        if both:
            _widen(spines, node, ends, right, spines[right, 5])
    return spines


@njit
def _rise(rows, row):
    """Return how far a row leaves its chord, or twice its radius at most where it is more than a half circle."""
    chord = math.hypot(rows[row, 2] - rows[row, 0], rows[row, 3] - rows[row, 1])
    rise = abs(math.tan(rows[row, 4] / 4.0)) * chord / 2.0
    return rise if abs(rows[row, 4]) <= math.pi else 2.0 * rise


@njit
def _lay(spines, node, ends):
    """Lay the chord of a node between its ends."""
    wx, wy = ends[node, 2] - ends[node, 0], ends[node, 3] - ends[node, 1]
    size = math.sqrt(wx * wx + wy * wy)
    spines[node, 0], spines[node, 1] = ends[node, 0] + wx / 2.0, ends[node, 1] + wy / 2.0
    spines[node, 2], spines[node, 3] = (wx / size, wy / size) if size > 0.0 else (1.0, 0.0)
    spines[node, 4] = size / 2.0


@njit
def _widen(spines, node, ends, row, rise):
    """Let a node hold a chord with its begin x y and end x y, and what leaves that by `rise`."""
    begin = square_to(spines, node, ends[row, 0], ends[row, 1])
    end = square_to(spines, node, ends[row, 2], ends[row, 3])
    spines[node, 5] = max(spines[node, 5], math.sqrt(max(begin, end)) + rise)


@njit
def square_to(spines, node, x, y):
    """Return the square of the distance of a place to a node's chord."""
    dx, dy = x - spines[node, 0], y - spines[node, 1]
    along = max(abs(dx * spines[node, 2] + dy * spines[node, 3]) - spines[node, 4], 0.0)
    aside = dx * spines[node, 3] - dy * spines[node, 2]
    return along * along + aside * aside


@njit
def _reaches(spines, node, square, limit):
    """Return whether something below a node may lie nearer than a limit, its chord being so far."""
    rise = spines[node, 5]
    return rise >= 0.0 and square < (limit + rise) * (limit + rise)


@njit
def look(rows, spines, x, y, limit, dead, stack):
    """Return FAR when no row lies nearer to a place than `limit`, DEAD when one does than `dead` <= limit, else NEAR.

    `stack`, int64[DEEPEST], is room to walk.
    """
    if limit <= 0.0:
        return FAR
    leaves, answer = len(spines) // 2, FAR
    stack[0], height = 1, 1
    while height:
        height -= 1
        node = stack[height]
        if node >= leaves:
            first = (node - leaves) * LEAF
            for row in range(first, min(first + LEAF, len(rows))):
                away = distance(rows, row, x, y)
                if away < dead:
                    return DEAD
                if away < limit:  # from here only rows nearer than `dead` matter
                    answer, limit = NEAR, max(dead, 0.0)
            continue
        left, right = square_to(spines, 2 * node, x, y), square_to(spines, 2 * node + 1, x, y)
        nearer, farther = (2 * node, 2 * node + 1) if left <= right else (2 * node + 1, 2 * node)
        if _reaches(spines, farther, max(left, right), limit):
            stack[height] = farther
            height += 1
        if _reaches(spines, nearer, min(left, right), limit):
            stack[height] = nearer
            height += 1
    return answer


@njit
def near_neighbours(rows, own, x, y, limit):
    """Return whether a neighbour of the row `own` lies nearer to a place than a limit: mostly they are what does."""
    return (own > 0 and distance(rows, own - 1, x, y) < limit) or (
        own + 1 < len(rows) and distance(rows, own + 1, x, y) < limit
    )


@njit
def looks(rows, spines, places, own, limit, dead):
    """Return the result of `look` for each place, float64[m, 2], with its own `dead`, float64[m], and row, int64[m]."""
    found, stack = np.empty(len(places), np.int64), np.empty(DEEPEST, np.int64)
    for place in range(len(places)):
        x, y = places[place, 0], places[place, 1]
        if near_neighbours(rows, own[place], x, y, min(limit, dead[place])):
            found[place] = DEAD
        else:
            found[place] = look(rows, spines, x, y, limit, dead[place], stack)
    return found
