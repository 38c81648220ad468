# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kernels: where lines and arcs meet each other, rows and tree as in box_tree.py.

A row is the zero of f(p) = k |p - b|² - 2 n (p - b), with its curvature k, its begin b and its left normal n there.
For two rows, k2 f1 - k1 f2 is linear in p: the straight line through both crossings. That line meets the row of
the greater curvature where a quadratic is zero. Where rows touch or run along each other their ends are crossings.
"""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.geometry.box_tree import DEEPEST, LEAF
from CNCStepper.geometry.proximity_tree import FAR, distance, look, near_neighbours
from CNCStepper.kernels import njit
from CNCStepper.tolerances import SAME_MM

FOUND = 12  # most crossings of two rows: two, and four ends, with room


@njit
def crossings(rows, own, boxes, tree, near, spines, limit):
    """Return the crossings, float64[c, 6]: row, its length up to there, other row, its length up to there, x, y.

    Left out are crossings at an end of both rows, and those nearer than `limit` to the rows `near`, of which `own`,
    int64[n], names that of each row.
    """
    found, count, pair = np.empty((1024, 6)), 0, np.empty((FOUND, 2))
    leaves = len(tree) // 2
    stack, room = np.empty((DEEPEST, 2), np.int64), np.empty(DEEPEST, np.int64)
    stack[0], height = 1, 1
    while height:
        height -= 1
        one, other = stack[height, 0], stack[height, 1]
        if not overlap(tree, one, tree, other):
            continue
        if one < leaves:
            for a in range(2 * one, 2 * one + 2):
                for b in range(a if one == other else 2 * other, 2 * other + 2):
                    stack[height, 0], stack[height, 1] = a, b
                    height += 1
            continue
        first, second = (one - leaves) * LEAF, (other - leaves) * LEAF
        for i in range(first, min(first + LEAF, len(rows))):
            for j in range(max(second, i + 1), min(second + LEAF, len(rows))):
                if not overlap(boxes, i, boxes, j) or _one_side(rows, i, j) or _one_side(rows, j, i):
                    continue
                for index in range(_meet(rows, i, j, boxes, pair)):
                    x, y = pair[index, 0], pair[index, 1]
                    if not (_inside(boxes, i, x, y) and _inside(boxes, j, x, y)):
                        continue
                    if _at_end(rows, i, x, y) and _at_end(rows, j, x, y):
                        continue
                    a, b = place_on(rows, i, x, y), place_on(rows, j, x, y)
                    ends = (a == 0.0 or a == rows[i, 10]) and (b == 0.0 or b == rows[j, 10])
                    if ends or a < 0.0 or b < 0.0:
                        continue
                    if (
                        near_neighbours(near, own[i], x, y, limit)
                        or near_neighbours(near, own[j], x, y, limit)
                        or look(near, spines, x, y, limit, limit, room) != FAR
                    ):
                        continue
                    if count == len(found):
                        found = np.concatenate((found, np.empty_like(found)))
                    found[count, 0], found[count, 1], found[count, 2] = i, a, j
                    found[count, 3], found[count, 4], found[count, 5] = b, x, y
                    count += 1
    return found[:count]


@njit
def overlap(a, i, b, j):
    """Return whether box i of a and box j of b touch; a box: low x, low y, high x, high y."""
    return a[i, 0] <= b[j, 2] and b[j, 0] <= a[i, 2] and a[i, 1] <= b[j, 3] and b[j, 1] <= a[i, 3]


@njit
def _one_side(rows, i, j):
    """Return whether row j keeps to one side of the line or circle of row i, and so does not meet it.

    The distance to that is above r where |f| > 2 r + |k| r². Along the chord of j, f leaves its straight way between
    the ends by |k| chord² / 4 at most, and j leaves the chord by its rise, of at most as much with its own curvature.
    """
    k, nx, ny = rows[i, 5], -rows[i, 7], rows[i, 6]
    bx, by, ex, ey = rows[j, 0] - rows[i, 0], rows[j, 1] - rows[i, 1], rows[j, 2] - rows[i, 0], rows[j, 3] - rows[i, 1]
    begin = k * (bx * bx + by * by) - 2.0 * (nx * bx + ny * by)
    end = k * (ex * ex + ey * ey) - 2.0 * (nx * ex + ny * ey)
    if (begin > 0.0) != (end > 0.0) or abs(rows[j, 4]) > math.pi:
        return False
    square = (ex - bx) ** 2 + (ey - by) ** 2
    reach = 0.25 * abs(rows[j, 5]) * square + 2.0 * SAME_MM
    return min(abs(begin), abs(end)) > 0.25 * abs(k) * square + reach * (2.0 + abs(k) * reach)


@njit
def place_on(rows, row, x, y):
    """Return the length along a row at which a place on its line or circle lies; -1 where beyond its ends."""
    dx, dy = x - rows[row, 0], y - rows[row, 1]
    lx, ly = dx * rows[row, 6] + dy * rows[row, 7], dy * rows[row, 6] - dx * rows[row, 7]
    k, whole = rows[row, 5], rows[row, 10]
    way = lx
    if k != 0.0:
        turn = math.atan2(k * lx, 1.0 - k * ly)
        if abs(turn) > SAME_MM * abs(k) and turn * k < 0.0:
            turn += math.copysign(2.0 * math.pi, k)
        way = turn / k
    if abs(way) <= SAME_MM:
        return 0.0
    if abs(way - whole) <= SAME_MM:
        return whole
    return way if 0.0 < way < whole else -1.0


@njit
def _at_end(rows, row, x, y):
    """Return whether a place on a row is certainly one of its ends: a fast test, since most neighbours meet there."""
    begin = abs(x - rows[row, 0]) + abs(y - rows[row, 1])
    end = abs(x - rows[row, 2]) + abs(y - rows[row, 3])
    return min(begin, end) <= 0.5 * SAME_MM


@njit
def _meet(rows, i, j, boxes, pair):
    """Write the places where two rows may meet into `pair`; return how many."""
    count = 0
    for one, other in ((i, j), (j, i)):
        for end in (0, 2):
            x, y = rows[one, end], rows[one, end + 1]
            if _inside(boxes, other, x, y) and distance(rows, other, x, y) <= SAME_MM:
                pair[count, 0], pair[count, 1] = x, y
                count += 1
    if rows[i, 5] == 0.0 and rows[j, 5] == 0.0:
        return _lines_meet(rows, i, j, pair, count)
    return _circles_meet(rows, i, j, pair, count)


@njit
def _inside(boxes, row, x, y):
    """Return whether a place is no farther than SAME_MM from a row's box."""
    across = boxes[row, 0] - SAME_MM <= x <= boxes[row, 2] + SAME_MM
    return across and boxes[row, 1] - SAME_MM <= y <= boxes[row, 3] + SAME_MM


@njit
def _lines_meet(rows, i, j, pair, count):
    dx, dy = rows[j, 0] - rows[i, 0], rows[j, 1] - rows[i, 1]
    cross = rows[i, 6] * rows[j, 7] - rows[i, 7] * rows[j, 6]
    if abs(cross) > 1e-12:
        way = (dx * rows[j, 7] - dy * rows[j, 6]) / cross
        if -SAME_MM <= way <= rows[i, 10] + SAME_MM:
            pair[count, 0], pair[count, 1] = rows[i, 0] + way * rows[i, 6], rows[i, 1] + way * rows[i, 7]
            return count + 1
    return count


@njit
def _circles_meet(rows, i, j, pair, count):
    if abs(rows[i, 5]) < abs(rows[j, 5]):
        i, j = j, i
    k, other = rows[i, 5], rows[j, 5]
    nx, ny, mx, my = -rows[i, 7], rows[i, 6], -rows[j, 7], rows[j, 6]
    dx, dy = rows[j, 0] - rows[i, 0], rows[j, 1] - rows[i, 1]
    gx, gy = k * other * dx - other * nx + k * mx, k * other * dy - other * ny + k * my
    size = math.sqrt(gx * gx + gy * gy)
    if size <= 1e-12 * abs(k):
        return count  # they have one centre
    away = (0.5 * k * other * (dx * dx + dy * dy) + k * (mx * dx + my * dy)) / size
    gx, gy = gx / size, gy / size
    x, y, ux, uy = away * gx, away * gy, -gy, gx  # the line, seen from the begin of i
    half = k * (x * ux + y * uy) - (nx * ux + ny * uy)
    rest = k * (x * x + y * y) - 2.0 * (nx * x + ny * y)
    square = half * half - k * rest
    if square < 0.0:
        return count
    q = -(half + math.copysign(math.sqrt(square), half))
    for way in (q / k, rest / q if q != 0.0 else 0.0):
        pair[count, 0], pair[count, 1] = rows[i, 0] + x + way * ux, rows[i, 1] + y + way * uy
        count += 1
    return count
