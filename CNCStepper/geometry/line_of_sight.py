# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Kernels: whether a straight way stays in a region, which it may leave by no more than an edge.

  - - - - - - .       The raw parallel of the boundary, an edge beyond it, holds all of the true one: a way that
------------.  .      begins in the region and crosses none of it stays within the edge. Where the raw one has more,
   region    \  .     in gaps narrower than the edge, a way may be refused that could be gone.
"""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.geometry.box_tree import DEEPEST, LEAF, tree_of
from CNCStepper.geometry.intersections import overlap, place_on
from CNCStepper.geometry.nearest_point import nearest
from CNCStepper.geometry.offset import raw_parallel, source_of
from CNCStepper.geometry.winding_number import windings
from CNCStepper.kernels import njit
from CNCStepper.tolerances import SAME_MM


@njit
def barrier_of(xy, bulge, counts, edge_mm):
    """Return the rows that a way out of the region of a bundle must cross, their boxes and the tree over these."""
    rows, follower, _ = source_of(xy, bulge, counts, SAME_MM)
    barrier, _ = raw_parallel(rows, follower, -edge_mm)
    boxes, tree = tree_of(barrier, SAME_MM)
    return barrier, boxes, tree


@njit
def within(rows, spines, places, edge_mm):
    """Return which places, float64[m, 2], lie in a region or no farther from it than an edge."""
    away, _, _ = nearest(rows, spines, places)
    return (windings(rows, places) > 0) | (away <= edge_mm)


@njit
def sees(barrier, boxes, tree, hx, hy, tx, ty):
    """Return whether the straight way from h to t crosses no row of a barrier."""
    way, leaves = np.array([[min(hx, tx), min(hy, ty), max(hx, tx), max(hy, ty)]]), len(tree) // 2
    stack, height = np.ones(DEEPEST, np.int64), 1
    while height:
        height -= 1
        node = stack[height]
        if not overlap(tree, node, way, 0):
            continue
        if node < leaves:
            stack[height], stack[height + 1] = 2 * node, 2 * node + 1
            height += 2
            continue
        first = (node - leaves) * LEAF
        for row in range(first, min(first + LEAF, len(barrier))):
            if overlap(boxes, row, way, 0) and _crosses(barrier, row, hx, hy, tx - hx, ty - hy):
                return False
    return True


@njit
def _crosses(rows, row, hx, hy, dx, dy):
    """Return whether a row meets the straight line d from h: a quadratic equation in the share of the line."""
    k, nx, ny, bx, by = rows[row, 5], -rows[row, 7], rows[row, 6], hx - rows[row, 0], hy - rows[row, 1]
    a, half = k * (dx * dx + dy * dy), k * (bx * dx + by * dy) - (nx * dx + ny * dy)
    rest = k * (bx * bx + by * by) - 2.0 * (nx * bx + ny * by)
    square = half * half - a * rest
    if square < 0.0:
        return False
    q = -(half + math.copysign(math.sqrt(square), half))
    for above, below in ((q, a), (rest, q)):
        share = above / below if below != 0.0 else -1.0
        if 0.0 <= share <= 1.0 and place_on(rows, row, hx + share * dx, hy + share * dy) >= 0.0:
            return True
    return False


@njit
def shortened(held, barrier, boxes, tree, xy):
    """Return the vertices that stay of a way with straight ones in place of stretches, as long ones as are found.

    held: which vertices lie in the region, bool[n].
    """
    stay, count, last = np.zeros(len(xy), np.int64), 1, len(xy) - 1
    while stay[count - 1] < last:
        here = stay[count - 1]
        far = last - here
        (hx, hy), there = xy[here], xy[here + far]
        while far > 1 and not (held[here] and sees(barrier, boxes, tree, hx, hy, there[0], there[1])):
            far //= 2
            there = xy[here + far]
        stay[count] = here + far
        count += 1
    return stay[:count]
