# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact distances between the tool's path and the wall of a region, through an index of its edges."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.simulation.segments import Segments

ZOOM = np.stack(np.meshgrid(*[np.linspace(-1, 1, 15)] * 2), axis=2).reshape(-1, 2)
CLOSER = 0.4  # each look goes into this share of the one before
ENOUGH_GAIN = 0.1  # of the step; less is no progress, and the step is halved


class EdgeTree:
    """Segments in the plane, float64[n, 2, 2], that answer which of them is nearest, and how far."""

    def __init__(self, edges: np.ndarray):
        self.edges = shapely.linestrings(edges)
        self.tree = shapely.STRtree(self.edges)

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

    def nearest(self, shapes: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return for each of the shapely shapes the index of the nearest edge and the distance; ."""
        if not len(self.edges) or not len(shapes):
            return np.zeros(len(shapes), np.int64), np.full(len(shapes), np.inf)
        found, distance = self.tree.query_nearest(shapes, return_distance=True, all_matches=False)
        return found[1], distance

    def distance(self, points: np.ndarray) -> np.ndarray:
        """Return the distance of points float64[n, 2] to the nearest edge."""
        return self.nearest(shapely.points(points))[1]


def flat_edges(pieces: Segments) -> np.ndarray:
    """Return the segments seen from above, float64[n, 2, 2]."""
    return np.stack([pieces.begin[:, :2], pieces.end[:, :2]], axis=1)


class Region:
    """A plane region that answers how deep inside it a piece of path lies, and how far beyond it a point."""

    def __init__(self, area: BaseGeometry):
        self.area = area
        self.edges = EdgeTree.of_geometry(area)
        shapely.prepare(area)

    def inside(self, pieces: Segments, enough_mm: float) -> np.ndarray:
        """Return the distance of each piece to the wall, float64[n]: positive inside, negative outside.

        Pieces that lie deeper than `enough_mm` may be given as infinite. A piece that crosses the wall
        counts with its end farthest outside.
        """
        result = np.full(len(pieces), np.inf)
        near = np.flatnonzero(~self._surely_deep(pieces, enough_mm))
        pieces = pieces[near]
        distance = self.edges.nearest(shapely.linestrings(flat_edges(pieces)))[1]
        beyond = np.maximum(self.beyond(pieces.begin[:, :2]), self.beyond(pieces.end[:, :2]))
        result[near] = np.where(beyond > 0, -beyond, distance)
        return result

    def beyond(self, points: np.ndarray) -> np.ndarray:
        """Return how far the points float64[n, 2] lie outside; 0 inside."""
        outside = ~shapely.contains_xy(self.area, points)
        result = np.zeros(len(points))
        result[outside] = self.edges.distance(points[outside])
        return result

    def _surely_deep(self, pieces: Segments, enough_mm: float) -> np.ndarray:
        """Say which pieces are short and have both ends far from the wall; the margin of 10 % covers their length."""
        core = self.area.buffer(-1.1 * enough_mm)
        shapely.prepare(core)
        short = np.hypot(*(pieces.end - pieces.begin)[:, :2].T) < 0.1 * enough_mm
        ends = (pieces.begin, pieces.end)
        return short & np.logical_and.reduce([shapely.contains_xy(core, end[:, :2]) for end in ends])


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
