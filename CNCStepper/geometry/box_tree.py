# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kernels: lines and arcs as rows of a table, and a tree of boxes over the rows.

    rows   float64[n, 11]   begin x y, end x y, sweep rad, curvature 1/mm, unit direction at begin x y and at end x y,
                            length mm
    tree   float64[2 k, 4]  least x y and greatest x y of the LEAF rows below; node i has 2 i and 2 i + 1 below it

Neighbours in a chain are neighbours in the tree: a chain is its own index and nothing is sorted. No centre comes
in: that of a nearly straight arc is so far away that nothing could be computed from it.
"""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.kernels import njit

WIDTH = 11  # columns of a row
LEAF = 4  # rows below a lowest node
DEEPEST = 128  # places on the stack of a walk through a tree


@njit
def write_row(rows, row, bx, by, ex, ey, sweep):
    """Write a segment into the table: its begin, its end and the angle it turns by."""
    wx, wy = ex - bx, ey - by
    size = math.sqrt(wx * wx + wy * wy)
    ux, uy = (wx / size, wy / size) if size > 0.0 else (1.0, 0.0)
    cos, sin = math.cos(sweep / 2.0), math.sin(sweep / 2.0)
    rows[row, 0], rows[row, 1], rows[row, 2], rows[row, 3], rows[row, 4] = bx, by, ex, ey, sweep
    rows[row, 5] = 2.0 * sin / size if size > 0.0 else 2.0 * sin
    rows[row, 6], rows[row, 7] = ux * cos + uy * sin, uy * cos - ux * sin
    rows[row, 8], rows[row, 9] = ux * cos - uy * sin, uy * cos + ux * sin
    rows[row, 10] = size * (sweep / 2.0 / sin) if sweep != 0.0 else size


@njit
def rows_of(xy, bulge):
    """Return the table of one chain: its vertices, float64[n + 1, 2], and bulges, float64[n]."""
    rows = np.empty((len(bulge), WIDTH))
    for row in range(len(bulge)):
        sweep = 4.0 * math.atan(bulge[row])
        write_row(rows, row, xy[row, 0], xy[row, 1], xy[row + 1, 0], xy[row + 1, 1], sweep)
    return rows


@njit
def place_at(rows, row, length_mm):
    """Return the place at a length along a row, x and y."""
    half = rows[row, 5] * length_mm / 2.0
    chord = length_mm * math.sin(half) / half if half != 0.0 else length_mm
    cos, sin = chord * math.cos(half), chord * math.sin(half)
    ux, uy = rows[row, 6], rows[row, 7]
    return rows[row, 0] + ux * cos - uy * sin, rows[row, 1] + uy * cos + ux * sin


@njit
def direction_at(rows, row, length_mm):
    """Return the unit direction of a row at a length along it, x and y."""
    turn = rows[row, 5] * length_mm
    cos, sin = math.cos(turn), math.sin(turn)
    return rows[row, 6] * cos - rows[row, 7] * sin, rows[row, 7] * cos + rows[row, 6] * sin


@njit
def tree_of(rows, margin_mm):
    """Return the box of each row, float64[n, 4], wider by a margin, and the tree over them."""
    boxes = np.empty((len(rows), 4))
    for row in range(len(rows)):
        chord = math.hypot(rows[row, 2] - rows[row, 0], rows[row, 3] - rows[row, 1])
        rise = abs(math.tan(rows[row, 4] / 4.0)) * chord / 2.0
        wide = margin_mm + (rise if abs(rows[row, 4]) <= math.pi else 2.0 * max(rise, chord))
        for side in range(2):
            boxes[row, side] = min(rows[row, side], rows[row, 2 + side]) - wide
            boxes[row, 2 + side] = max(rows[row, side], rows[row, 2 + side]) + wide
    return boxes, grown(boxes)


@njit
def grown(boxes):
    """Return the tree over boxes."""
    leaves = 1
    while leaves * LEAF < len(boxes):
        leaves *= 2
    tree = np.empty((2 * leaves, 4))
    tree[:, :2], tree[:, 2:] = np.inf, -np.inf
    for row in range(len(boxes)):
        _widen(tree, leaves + row // LEAF, boxes, row)
    for node in range(leaves - 1, 0, -1):
        _widen(tree, node, tree, 2 * node)
        _widen(tree, node, tree, 2 * node + 1)
    return tree


@njit
def _widen(tree, node, boxes, row):
    for side in range(2):
        tree[node, side] = min(tree[node, side], boxes[row, side])
        tree[node, 2 + side] = max(tree[node, 2 + side], boxes[row, 2 + side])


@njit
def push_children(stack, least, height, node, left, right, best):
    """Lay both nodes below a node on the stack of a walk, the nearer one on top, and return its new height.

    left, right: how far they are at least; what is no nearer than the best found so far is left out.
    """
    nearer = 2 * node if left <= right else 2 * node + 1
    for child, far in ((4 * node + 1 - nearer, max(left, right)), (nearer, min(left, right))):
        if far < best:
            stack[height], least[height] = child, far
            height += 1
    return height
