# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far segments are from the nearest of many other ones in space: a tree of boxes over them.

    edges   float64[n, 2, 3]   begin and end of each, mm, in the order of a Z curve through their middles
    tree    float64[2 k, 6]    least x y z and greatest x y z of the LEAF edges below; as in geometry/box_tree.py

Segments that are asked for one after another lie close together: the edge that was nearest to the last one bounds
the search for the next.
"""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.geometry.box_tree import DEEPEST, LEAF, push_children
from CNCStepper.kernels import njit
from CNCStepper.simulation.tip_segments import Segments

CURVE_BITS = 16  # of each axis along the Z curve


class SegmentTree:
    """Segments that say how far others are from them; there is at least one."""

    def __init__(self, segments: Segments):
        edges = np.stack([segments.begin, segments.end], axis=1)
        self._edges = np.ascontiguousarray(edges[_curve_order(edges.mean(axis=1))], float)
        self._tree = grown(self._edges)

    def distances(self, others: Segments, enough_mm: float) -> tuple[np.ndarray, np.ndarray]:
        """Return how far each other segment is at its begin, middle or end, the farthest of these, and which it is.

        Distances float64[m] mm, places float64[m, 3] mm. enough_mm: nearer is not searched: such a distance may be
        anything up to it.
        """
        begin, end = np.ascontiguousarray(others.begin, float), np.ascontiguousarray(others.end, float)
        return farthest(self._edges, self._tree, begin, end, enough_mm)  # type: ignore[no-any-return]


def _curve_order(middles: np.ndarray) -> np.ndarray:
    """Return the indices of points float64[n, 3] along a Z curve through their box, so that neighbours are near."""
    low = middles.min(axis=0)
    size = max(float((middles.max(axis=0) - low).max()), 1e-9)
    cells = ((middles - low) * ((1 << CURVE_BITS) - 1) / size).astype(np.int64)
    code = np.zeros(len(cells), np.int64)
    for bit in range(CURVE_BITS):
        for axis in range(3):
            code |= ((cells[:, axis] >> bit) & 1) << (3 * bit + axis)
    return np.argsort(code, kind="stable")


@njit
def grown(edges):
    """Return the tree over the edges' boxes.

    `box_tree.grown` in space: one kernel for any number of axes takes four times as long to build either.
    """
    leaves = 1
    while leaves * LEAF < len(edges):
        leaves *= 2
    tree = np.empty((2 * leaves, 6))
    tree[:, :3], tree[:, 3:] = np.inf, -np.inf
    for edge in range(len(edges)):
        node = leaves + edge // LEAF
        for axis in range(3):
            tree[node, axis] = min(tree[node, axis], edges[edge, 0, axis], edges[edge, 1, axis])
            tree[node, 3 + axis] = max(tree[node, 3 + axis], edges[edge, 0, axis], edges[edge, 1, axis])
    for node in range(leaves - 1, 0, -1):
        for axis in range(3):
            tree[node, axis] = min(tree[2 * node, axis], tree[2 * node + 1, axis])
            tree[node, 3 + axis] = max(tree[2 * node, 3 + axis], tree[2 * node + 1, 3 + axis])
    return tree


@njit
def farthest(edges, tree, begin, end, enough_mm):
    """Return the greatest distance of begin, middle and end of each segment from the edges, and where it is."""
    away, places = np.empty(len(begin)), np.empty((len(begin), 3))
    stack, least, place = np.empty(DEEPEST, np.int64), np.empty(DEEPEST), np.empty(3)
    guess, last_mm = 0, np.inf
    for k in range(len(begin)):
        joined = (
            k > 0 and begin[k, 0] == end[k - 1, 0] and begin[k, 1] == end[k - 1, 1] and begin[k, 2] == end[k - 1, 2]
        )
        away[k] = -1.0
        for part in range(3):
            for axis in range(3):
                place[axis] = begin[k, axis] + (end[k, axis] - begin[k, axis]) * part / 2.0
            if part > 0 or not joined:
                guess, last_mm = _nearest(edges, tree, place, guess, stack, least, enough_mm)
            if last_mm > away[k]:
                away[k], places[k] = last_mm, place
    return away, places


@njit
def _nearest(edges, tree, place, guess, stack, least, enough_mm):
    """Return the nearest edge to a place and how far it is, from a guess on; `stack` and `least` are room to walk."""
    best, found, leaves = from_edge(edges[guess], place), guess, len(tree) // 2
    stack[0], least[0], height = 1, 0.0, 1
    while height and best > enough_mm:
        height -= 1
        node = stack[height]
        if least[height] >= best:
            continue
        if node >= leaves:
            first = (node - leaves) * LEAF
            for edge in range(first, min(first + LEAF, len(edges))):
                away = from_edge(edges[edge], place)
                if away < best:
                    best, found = away, edge
            continue
        left, right = _from_box(tree[2 * node], place), _from_box(tree[2 * node + 1], place)
        height = push_children(stack, least, height, node, left, right, best)
    return found, best


@njit
def _from_box(box, place):
    square = 0.0
    for axis in range(3):
        gap = max(box[axis] - place[axis], place[axis] - box[3 + axis], 0.0)
        square += gap * gap
    return math.sqrt(square)


@njit
def from_edge(edge, place):
    """Return the distance of a place from an edge, float64[2, 3]."""
    along, square = 0.0, 0.0
    for axis in range(3):
        way = edge[1, axis] - edge[0, axis]
        along += (place[axis] - edge[0, axis]) * way
        square += way * way
    share = min(max(along / square, 0.0), 1.0) if square > 0.0 else 0.0
    away = 0.0
    for axis in range(3):
        gap = place[axis] - edge[0, axis] - share * (edge[1, axis] - edge[0, axis])
        away += gap * gap
    return math.sqrt(away)
