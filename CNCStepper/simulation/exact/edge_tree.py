# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which of many straight edges is nearest to a place or to another edge, and how far: an index of boxes over them.

    edges   float64[n, 2, 2]   begin and end of each, x y, mm
    tree    as in geometry/box_tree.py, over the edges' boxes

Places that are asked for one after another lie close together: the edge that was nearest to the last one bounds the
search for the next, so that hardly more of the tree is walked than what holds the answer.
"""

from __future__ import annotations

import math
from functools import cached_property
from typing import Any

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper import kernels
from CNCStepper.geometry.box_tree import DEEPEST, LEAF, grown, push_children
from CNCStepper.kernels import njit
from CNCStepper.simulation.tip_segments import Segments


class EdgeTree:
    """Segments in the plane, float64[n, 2, 2], that answer which of them is nearest, and how far."""

    def __init__(self, edges: np.ndarray):
        self.edges = np.ascontiguousarray(edges, float)

    @classmethod
    def of_pieces(cls, pieces: Segments) -> EdgeTree:
        """Return the tree of the segments seen from above."""
        return cls(flat_edges(pieces))

    @classmethod
    def of_geometry(cls, geometry: BaseGeometry) -> EdgeTree:
        """Return the tree of a region's boundary, or of lines themselves."""
        lines = geometry.boundary if geometry.area > 0 else geometry
        coordinates, index = shapely.get_coordinates(shapely.get_parts(lines), return_index=True)
        edges = np.stack([coordinates[:-1], coordinates[1:]], axis=1)
        return cls(edges[index[:-1] == index[1:]])

    def nearest(self, others: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return for each of other edges, float64[m, 2, 2], the index of the nearest of these and the distance."""
        if not len(self.edges) or not len(others):
            return np.zeros(len(others), np.int64), np.full(len(others), np.inf)
        if not kernels.compiles():  # plain Python would take a hundred times longer than shapely
            return self._nearest_of_shapely(others)
        return nearest_edges(self.edges, self._tree, np.ascontiguousarray(others, float))  # type: ignore[no-any-return]

    def distance(self, points: np.ndarray) -> np.ndarray:
        """Return the distance of points float64[n, 2] to the nearest edge."""
        return self.nearest(np.stack([points, points], axis=1))[1]

    @cached_property
    def _tree(self) -> np.ndarray:
        return grown(np.hstack([self.edges.min(axis=1), self.edges.max(axis=1)]))  # type: ignore[no-any-return]

    @cached_property
    def _shapely_tree(self) -> Any:
        return shapely.STRtree(shapely.linestrings(self.edges))

    def _nearest_of_shapely(self, others: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        lines = shapely.linestrings(others)
        found, distance = self._shapely_tree.query_nearest(lines, return_distance=True, all_matches=False)
        return found[1], distance


def flat_edges(pieces: Segments) -> np.ndarray:
    """Return the segments seen from above, float64[n, 2, 2]."""
    return np.stack([pieces.begin[:, :2], pieces.end[:, :2]], axis=1)


@njit
def nearest_edges(edges, tree, others):
    """Return for each of `others`, float64[m, 2, 2], the index of the nearest edge and how far that is."""
    found, away = np.empty(len(others), np.int64), np.empty(len(others))
    stack, least = np.empty(DEEPEST, np.int64), np.empty(DEEPEST)
    last = 0
    for k in range(len(others)):
        last, away[k] = _nearest(edges, tree, others[k], last, stack, least)
        found[k] = last
    return found, away


@njit
def _nearest(edges, tree, other, guess, stack, least):
    """Return the nearest edge to another one and its distance, searching only nearer than a guess.

    `stack` and `least` are room to walk.
    """
    best, found, leaves = _between(edges[guess], other), guess, len(tree) // 2
    stack[0], least[0], height = 1, 0.0, 1
    while height:
        height -= 1
        node = stack[height]
        if least[height] >= best:
            continue
        if node >= leaves:
            first = (node - leaves) * LEAF
            for edge in range(first, min(first + LEAF, len(edges))):
                away = _between(edges[edge], other)
                if away < best:
                    best, found = away, edge
            continue
        left, right = _least(tree, 2 * node, other), _least(tree, 2 * node + 1, other)
        height = push_children(stack, least, height, node, left, right, best)
    return found, best


@njit
def _least(tree, node, edge):
    """Return the least distance of an edge from those below a node: that of their boxes."""
    square = 0.0
    for axis in range(2):
        low, high = min(edge[0, axis], edge[1, axis]), max(edge[0, axis], edge[1, axis])
        gap = max(tree[node, axis] - high, low - tree[node, 2 + axis], 0.0)
        square += gap * gap
    return math.sqrt(square)


@njit
def _between(one, other):
    """Return the distance between two edges: 0 where they cross, else that of the nearest end."""
    if _cross(one, other):
        return 0.0
    ends = min(square_from(one, other[0, 0], other[0, 1]), square_from(one, other[1, 0], other[1, 1]))
    return math.sqrt(min(ends, square_from(other, one[0, 0], one[0, 1]), square_from(other, one[1, 0], one[1, 1])))


@njit
def _cross(one, other):
    """Return whether two edges that are not parallel cross, each between its ends."""
    ux, uy = one[1, 0] - one[0, 0], one[1, 1] - one[0, 1]
    vx, vy = other[1, 0] - other[0, 0], other[1, 1] - other[0, 1]
    turn = ux * vy - uy * vx
    if turn == 0.0:
        return False
    wx, wy = other[0, 0] - one[0, 0], other[0, 1] - one[0, 1]
    on_one, on_other = (wx * vy - wy * vx) / turn, (wx * uy - wy * ux) / turn
    return 0.0 <= on_one <= 1.0 and 0.0 <= on_other <= 1.0


@njit
def square_from(edge, x, y):
    """Return the squared distance of a place from an edge."""
    x, y, dx, dy = x - edge[0, 0], y - edge[0, 1], edge[1, 0] - edge[0, 0], edge[1, 1] - edge[0, 1]
    length = dx * dx + dy * dy
    share = min(max((x * dx + y * dy) / length, 0.0), 1.0) if length > 0.0 else 0.0
    return (x - share * dx) ** 2 + (y - share * dy) ** 2
