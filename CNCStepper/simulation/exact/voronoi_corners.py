# SPDX-License-Identifier: LGPL-2.1-or-later
"""The corners of the Voronoi diagram of a path's points, within an area, however many points there are.

Few points have one diagram. Many lie on the disk, and the area is halved until few can matter to a half:

    u in the box, c the middle of its cell:  distance(u, points) <= distance(c, points) + |u - c| <= reach

So the points about a corner in the box lie within `reach` of the box, and those farther away are left out.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterator
from typing import IO

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

MOST_POINTS = 30_000  # that have one diagram
DECIMALS = 3  # of the points' coordinates, mm
SMALLEST_MM = 1e-3  # a box is not halved any more
CELLS = 16  # along each side of a box, at most
CELL_MM = 0.5  # cells are not made smaller
TURN = np.array([[0.8, 0.6], [-0.6, 0.8]])
Reach = Callable[[np.ndarray], np.ndarray]  # places float64[n, 2] -> at most so far from each is the nearest point


class Places:
    """Points seen from above, rounded; of those close together in their order each counts once.

    Beyond MOST_POINTS they lie in a file without a name, which goes with them. Raises OSError on a full disk.
    """

    def __init__(self) -> None:
        self._held = np.zeros((0, 2))
        self._file: IO[bytes] | None = None
        self._blocks = 0

    def add(self, points: np.ndarray) -> None:
        """Take further points, float64[n, 2]."""
        for first in range(0, len(points), MOST_POINTS):
            self._held = np.vstack([self._held, np.round(points[first : first + MOST_POINTS], DECIMALS)])
            if len(self._held) > MOST_POINTS:
                self._held = np.unique(self._held, axis=0)
            if len(self._held) > MOST_POINTS:
                self._write(self._held[:MOST_POINTS])
                self._held = self._held[MOST_POINTS:]

    def _write(self, block: np.ndarray) -> None:
        if self._file is None:
            self._file = tempfile.TemporaryFile(prefix="cncstepper-points-")  # noqa: SIM115  goes with its owner
        self._file.seek(0, 2)
        self._file.write(block.tobytes())
        self._blocks += 1

    def __iter__(self) -> Iterator[np.ndarray]:
        for block in range(self._blocks):
            assert self._file
            self._file.seek(16 * MOST_POINTS * block)
            yield np.frombuffer(self._file.read(16 * MOST_POINTS)).reshape(-1, 2)
        yield self._held

    @property
    def are_few(self) -> bool:
        """Whether one diagram is made of them."""
        return not self._blocks

    def near(self, box: np.ndarray, reach_mm: float) -> Places:
        """Return those within a distance of a box (least x y, greatest x y)."""
        found = Places()
        for block in self:
            beside = np.maximum(np.maximum(box[:2] - block, block - box[2:]), 0.0)
            found.add(block[np.hypot(*beside.T) <= reach_mm])
        return found


def corners_within(area: BaseGeometry, places: Places, reach: Reach) -> np.ndarray:
    """Return the corners of the places' Voronoi diagram that lie within an area, float64[n, 2]."""
    if area.is_empty:
        return np.zeros((0, 2))
    shapely.prepare(area)
    if places.are_few:
        return _of_few(area, places)
    low_x, low_y, high_x, high_y = area.bounds
    return _corners(area, places, reach, np.array([low_x - 1, low_y - 1, high_x + 1, high_y + 1]))


def _of_few(area: BaseGeometry, places: Places) -> np.ndarray:
    corners = voronoi_corners(np.vstack(list(places)))
    return corners[shapely.contains_xy(area, corners)]


def _corners(area: BaseGeometry, places: Places, reach: Reach, box: np.ndarray) -> np.ndarray:
    """Return the corners within the area in a half-open box."""
    inside = shapely.clip_by_rect(area, *box)
    if inside.is_empty:
        return np.zeros((0, 2))
    tight = np.array(inside.bounds)
    near = places.near(tight, _reach_mm(inside, reach))
    size = tight[2:] - tight[:2]
    if near.are_few or size.max() <= SMALLEST_MM:
        corners = _of_few(area, near)
        return corners[(corners >= box[:2]).all(axis=1) & (corners < box[2:]).all(axis=1)]
    axis = int(size.argmax())
    low, high = box.copy(), box.copy()
    low[2 + axis] = high[axis] = tight[axis] + size[axis] / 2
    return np.vstack([_corners(area, near, reach, half) for half in (low, high)])


def _reach_mm(inside: BaseGeometry, reach: Reach) -> float:
    """Return how far the point nearest to any place within a geometry can be."""
    low_x, low_y, high_x, high_y = inside.bounds
    sides = [np.linspace(a, b, _cells(b - a) + 1) for a, b in ((low_x, high_x), (low_y, high_y))]
    x, y = (values.ravel() for values in np.meshgrid(sides[0][:-1], sides[1][:-1]))
    step = np.array([side[1] - side[0] for side in sides])
    meets = shapely.intersects(shapely.box(x, y, x + step[0], y + step[1]), inside)
    middles = np.column_stack([x, y])[meets] + step / 2
    return float(reach(middles).max(initial=0.0)) + float(np.linalg.norm(step)) / 2 + 10.0**-DECIMALS


def _cells(length_mm: float) -> int:
    return int(np.clip(length_mm / CELL_MM, 1, CELLS))


def voronoi_corners(points: np.ndarray) -> np.ndarray:
    """Return the corners of the points' Voronoi diagram: the circumcentres of their Delaunay triangles."""
    points = np.unique(np.round(points, DECIMALS), axis=0)
    triangles = _delaunay(points)
    a, b, c = shapely.get_coordinates(triangles).reshape(-1, 4, 2)[:, :3].transpose(1, 0, 2)
    b, c = b - a, c - a
    cross = 2 * (b[:, 0] * c[:, 1] - b[:, 1] * c[:, 0])
    b2, c2 = (b**2).sum(axis=1), (c**2).sum(axis=1)
    arm = np.stack([c[:, 1] * b2 - b[:, 1] * c2, b[:, 0] * c2 - c[:, 0] * b2], axis=1)
    proper = np.abs(cross) > 1e-12
    return a[proper] + arm[proper] / cross[proper, None]


def _delaunay(points: np.ndarray) -> np.ndarray:
    """Return the Delaunay triangles of points.

    GEOS now and then loses its way among many points on parallel lines, but not when the plane is turned.
    """
    try:
        return shapely.get_parts(shapely.delaunay_triangles(shapely.multipoints(points)))
    except shapely.errors.GEOSException:
        turned = shapely.delaunay_triangles(shapely.multipoints(points @ TURN))
        return shapely.get_parts(shapely.transform(turned, lambda places: places @ TURN.T))
