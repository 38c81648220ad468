# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact distances between the tool's path and the wall of a region, and the search for where one is largest."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.simulation.exact.edge_tree import EdgeTree, flat_edges
from CNCStepper.simulation.tip_segments import Segments

ZOOM = np.stack(np.meshgrid(*[np.linspace(-1, 1, 15)] * 2), axis=2).reshape(-1, 2)
CLOSER = 0.4  # each look goes into this share of the one before
ENOUGH_GAIN = 0.1  # of the step; less is no progress, and the step is halved


class Region:
    """A plane region that answers how deep inside it a piece of path lies, and how far beyond it a point."""

    def __init__(self, area: BaseGeometry):
        self.area = area
        self.edges = EdgeTree.of_geometry(area)
        shapely.prepare(area)

    def inside(self, pieces: Segments) -> np.ndarray:
        """Return the distance of each piece to the wall, float64[n]: positive inside, negative outside.

        A piece that crosses the wall counts with its end farthest outside.
        """
        distance = self.edges.nearest(flat_edges(pieces))[1]
        beyond = np.maximum(self.beyond(pieces.begin[:, :2]), self.beyond(pieces.end[:, :2]))
        return np.where(beyond > 0, -beyond, distance)

    def beyond(self, points: np.ndarray) -> np.ndarray:
        """Return how far the points float64[n, 2] lie outside; 0 inside."""
        outside = ~shapely.contains_xy(self.area, points)
        result = np.zeros(len(points))
        result[outside] = self.edges.distance(points[outside])
        return result


def climbed(
    points: np.ndarray, height: Callable[[np.ndarray], np.ndarray], step_mm: float, stop_mm: float
) -> np.ndarray:
    """Return the points float64[n, 2] moved uphill by pattern search until no step above `stop_mm` gains.

    height: function of points float64[m, 2] that returns float64[m]; it rises by at most 1 mm a mm.
    """
    angle = np.arange(8) * np.pi / 4
    ways = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    points, heights, steps = points.copy(), height(points), np.full(len(points), step_mm)
    while (open_ := np.flatnonzero(steps > stop_mm)).size:
        trials = points[open_, None, :] + steps[open_, None, None] * ways
        found = height(trials.reshape(-1, 2)).reshape(len(open_), -1)
        best, highest = found.argmax(axis=1), found.max(axis=1)
        gain = highest > heights[open_] + ENOUGH_GAIN * steps[open_]
        points[open_[gain]] = trials[gain, best[gain]]
        heights[open_[gain]] = highest[gain]
        steps[open_[~gain]] /= 2
    return points


def zoomed(point: np.ndarray, height: Callable[[np.ndarray], np.ndarray], step_mm: float, stop_mm: float) -> np.ndarray:
    """Return the highest place near the point float64[2], looked for in squares of ever smaller sides.

    Slower than `climbed`, but it goes along ridges too. height: function of points float64[m, 2].
    """
    while step_mm > stop_mm:
        places = np.vstack([point[None, :], point + step_mm * ZOOM])
        point = places[height(places).argmax()]
        step_mm *= CLOSER
    return point
