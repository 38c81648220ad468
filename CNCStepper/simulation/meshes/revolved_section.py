# SPDX-License-Identifier: LGPL-2.1-or-later
"""A half section turned about the axis as strips of triangles for a 3D view, cut open towards the viewer.

      Y ^ open       The part is taken out between the angles 0 and `open_deg`: 90 leaves three quarters of it,
        |   .        180 a half, 0 the whole. X is the radius, Z the axis. Seen from +Y with Z to the right and
--------+--------> X X upwards, the section at angle 0 lies in the plane in which the tool moves.
        |
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

DRAWN_MM = 0.005  # how far a drawn outline may be from the true one
STEP_DEG = 5.0  # of the turn
SMOOTH = 0.97  # cosine of the angle at which two edges of an outline still look like one surface
ON_AXIS_MM = 1e-6


@dataclass(frozen=True)
class Strips:
    """Strips of triangles, counter-clockwise from outside: points, normals float32[n, 3], counts int32[k] of points."""

    points: np.ndarray
    normals: np.ndarray
    counts: np.ndarray


@dataclass(frozen=True)
class Edges:
    """The edges of a region's outline that are not on the axis, the material to their left.

    begin, end: float64[n, 2], z and r; begin_normal, end_normal: outwards at both ends.
    """

    begin: np.ndarray
    end: np.ndarray
    begin_normal: np.ndarray
    end_normal: np.ndarray

    @property
    def middles(self) -> np.ndarray:
        """Their middles, float64[n, 2]."""
        return (self.begin + self.end) / 2

    def __getitem__(self, which: np.ndarray) -> Edges:
        return Edges(self.begin[which], self.end[which], self.begin_normal[which], self.end_normal[which])


def drawn(region: BaseGeometry) -> BaseGeometry:
    """Return a region with as few corners as a view needs."""
    return shapely.simplify(region, DRAWN_MM)


def edges_of(region: BaseGeometry) -> Edges:
    """Return the edges of a region's outline."""
    parts = shapely.orient_polygons(shapely.get_parts(region), exterior_cw=False)
    columns: list[list[np.ndarray]] = [[], [], [], []]
    for ring in shapely.get_rings(parts):
        for column, values in zip(columns, _of_ring(np.asarray(ring.coords, float)[:, :2]), strict=True):
            column.append(values)
    empty = np.zeros((0, 2))
    found = Edges(*(np.concatenate([empty, *column]) for column in columns))
    return found[(found.begin[:, 1] > ON_AXIS_MM) | (found.end[:, 1] > ON_AXIS_MM)]


def _of_ring(corners: np.ndarray) -> tuple[np.ndarray, ...]:
    begin, end = corners[:-1], corners[1:]
    way = end - begin
    normal = np.column_stack([way[:, 1], -way[:, 0]]) / np.maximum(np.hypot(*way.T), 1e-12)[:, None]
    before, after = np.roll(normal, 1, axis=0), np.roll(normal, -1, axis=0)
    smooth = [np.einsum("ij,ij->i", normal, other) > SMOOTH for other in (before, after)]
    ends = [np.where(own[:, None], normal + other, normal) for own, other in zip(smooth, (before, after), strict=True)]
    return begin, end, *(each / np.hypot(*each.T)[:, None] for each in ends)


def revolved_edges(edges: Edges, open_deg: float) -> Strips:
    """Return the surface that edges sweep when they turn about the axis, a strip each."""
    count = max(int(np.ceil((360.0 - open_deg) / STEP_DEG)), 3)
    angle = np.radians(np.linspace(open_deg, 360.0, count + 1))
    ends = (edges.begin, edges.end), (edges.begin_normal, edges.end_normal)
    points, normals = (
        np.stack([_around(side, angle) for side in both], axis=2).reshape(-1, 3).astype(np.float32) for both in ends
    )
    return Strips(points, normals, np.full(len(edges.begin), 2 * len(angle), np.int32))


def _around(pairs: np.ndarray, angle: np.ndarray) -> np.ndarray:
    """Return pairs (z, r) turned about the axis, float64[n, angles, 3]."""
    z, r = pairs[:, 0, None], pairs[:, 1, None]
    return np.stack([r * np.cos(angle), r * np.sin(angle), np.broadcast_to(z, (len(pairs), len(angle)))], axis=2)


def section_faces(region: BaseGeometry, open_deg: float) -> Strips:
    """Return the two plane faces at which a part is cut open, of triangles; none where it is whole."""
    corners = triangles_of(region) if open_deg else np.zeros((0, 3, 2))
    found = []
    for angle_deg, order, turn in ((open_deg, [0, 2, 1], -1.0), (360.0, [0, 1, 2], 1.0)):
        angle = np.radians(angle_deg)
        points = _around(corners[:, order].reshape(-1, 2), np.array([angle])).reshape(-1, 3)
        normal = turn * np.array([-np.sin(angle), np.cos(angle), 0.0])
        found.append((points, np.tile(normal, (len(points), 1))))
    points, normals = (np.concatenate(each).astype(np.float32) for each in zip(*found, strict=True))
    return Strips(points, normals, np.full(2 * len(corners), 3, np.int32))


def triangles_of(region: BaseGeometry) -> np.ndarray:
    """Return a region as triangles, counter-clockwise in (z, r): float64[n, 3, 2]."""
    parts = shapely.get_parts(shapely.constrained_delaunay_triangles(region))
    corners = np.array([np.asarray(part.exterior.coords, float)[:3, :2] for part in parts]).reshape(-1, 3, 2)
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    clockwise = first[:, 0] * second[:, 1] < first[:, 1] * second[:, 0]
    corners[clockwise] = corners[clockwise][:, ::-1]
    return corners


def revolved_strips(region: BaseGeometry, open_deg: float) -> Strips:
    """Return a region turned about the axis with its section faces, all of one colour."""
    return together([revolved_edges(edges_of(region), open_deg), section_faces(region, open_deg)])


def plate(region: BaseGeometry, top_mm: float, thickness_mm: float) -> Strips:
    """Return a flat body of an outline in the plane of Z and X, from Y = top_mm down."""
    corners, edges = triangles_of(region).reshape(-1, 2), edges_of(shapely.transform(region, _off_axis))
    flat = np.column_stack([corners[:, 1], np.full(len(corners), top_mm), corners[:, 0]])
    begin, end = edges.begin - OFF_AXIS, edges.end - OFF_AXIS
    levels = np.array([top_mm - thickness_mm, top_mm])
    sides = np.stack([_at_levels(begin, levels), _at_levels(end, levels)], axis=2).reshape(-1, 3)
    outwards = np.stack(
        [_at_levels(edges.begin_normal, np.zeros(2)), _at_levels(edges.end_normal, np.zeros(2))], axis=2
    )
    top = Strips(flat.astype(np.float32), np.tile(UP, (len(flat), 1)), _threes(len(corners)))
    counts = np.full(len(begin), 4, np.int32)
    return together([top, Strips(sides.astype(np.float32), outwards.reshape(-1, 3).astype(np.float32), counts)])


UP = np.array([0.0, 1.0, 0.0], np.float32)
OFF_AXIS = np.array([0.0, 1e4])  # a tool's outline may lie across the axis: no edge of it is left out


def _off_axis(points: np.ndarray) -> np.ndarray:
    return points + OFF_AXIS  # type: ignore[no-any-return]


def _threes(corners: int) -> np.ndarray:
    return np.full(corners // 3, 3, np.int32)


def _at_levels(pairs: np.ndarray, levels: np.ndarray) -> np.ndarray:
    """Return pairs (z, r) at heights of Y, float64[n, levels, 3]."""
    shape = (len(pairs), len(levels))
    columns = (pairs[:, 1, None], np.broadcast_to(levels, shape), pairs[:, 0, None])
    return np.stack([np.broadcast_to(each, shape) for each in columns], axis=2)


def together(parts: list[Strips]) -> Strips:
    """Return several bodies as one."""
    return Strips(
        *(np.concatenate([getattr(part, name) for part in parts]) for name in ("points", "normals", "counts"))
    )
