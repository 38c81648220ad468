# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh of triangles as lines: its section at a height, and its whole outline seen from above.

A corner at the height of the section counts as above it, so that every section is closed where the mesh is.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import shapely

from CNCStepper.cancellation import checkpoint
from CNCStepper.geometry.chain_joining import chained
from CNCStepper.geometry.curve import Curve, from_points
from CNCStepper.tolerances import SAME_MM

GRID_MM = 1e-6  # to which corners are rounded before triangles are united
SLIVER_MM = 4 * GRID_MM  # rings that are narrower are what rounding leaves between two triangles
AT_ONCE = 100_000  # triangles
STRAIGHT_MM = 1e-6  # a corner that is nearer to the line between its neighbours goes


def at_height(triangles: np.ndarray, height_mm: float) -> list[Curve]:
    """Return the outline of the triangles, float64[n, 3, 3] in mm, that lie level at a height, else their section."""
    level = triangles[(np.abs(triangles[:, :, 2] - height_mm) <= SAME_MM).all(axis=1)]
    return outline(level[:, :, :2]) if len(level) else section(triangles, height_mm)


def section(triangles: np.ndarray, height_mm: float) -> list[Curve]:
    """Return the lines in which triangles, float64[n, 3, 3] in mm, meet a level plane, as chains."""
    above = triangles[:, :, 2] >= height_mm
    crossing = triangles[above.any(axis=1) & ~above.all(axis=1)]
    above = crossing[:, :, 2] >= height_mm
    alone = np.where(above.sum(axis=1) == 1, above.argmax(axis=1), above.argmin(axis=1))
    rows = np.arange(len(crossing))
    ends = [_at_height(crossing[rows, alone], crossing[rows, (alone + step) % 3], height_mm) for step in (1, 2)]
    pieces = [Curve.trusted(pair, np.zeros(1)) for pair in np.stack(ends, axis=1)]
    chains, _ = chained([piece for piece in pieces if np.ptp(piece.xy, axis=0).max() > SAME_MM])
    return [straightened(chain) for chain in chains]


def _at_height(begin: np.ndarray, end: np.ndarray, height_mm: float) -> np.ndarray:
    """Return where edges meet a height, float64[n, 2]: from the lower end, so that both triangles find one place."""
    swap = (begin[:, 2] > end[:, 2])[:, None]
    low, high = np.where(swap, end, begin), np.where(swap, begin, end)
    share = (height_mm - low[:, 2]) / (high[:, 2] - low[:, 2])
    return low[:, :2] + share[:, None] * (high - low)[:, :2]  # type: ignore[no-any-return]


def outline(triangles: np.ndarray) -> list[Curve]:
    """Return the outline of triangles, float64[n, 3, 2] in mm: outer rings and holes as closed chains."""
    return [straightened(from_points(ring.coords, closed=True)) for ring in _rings(_united(triangles))]


def outline_area_mm2(triangles: np.ndarray) -> float:
    """Return the area that triangles, float64[n, 3, 2] in mm, cover."""
    return float(_united(triangles).area)


def _united(triangles: np.ndarray) -> shapely.Geometry:
    turns = _cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    seen = triangles[np.abs(turns) > GRID_MM**2]
    parts = []
    for first in range(0, len(seen), AT_ONCE):
        checkpoint()
        parts.append(shapely.union_all(shapely.polygons(seen[first : first + AT_ONCE]), grid_size=GRID_MM))
    return shapely.union_all(parts, grid_size=GRID_MM)


def _rings(area: shapely.Geometry) -> Iterator[shapely.LinearRing]:
    for polygon in shapely.get_parts(area):
        if polygon.geom_type == "Polygon":
            rings = (polygon.exterior, *polygon.interiors)
            yield from (ring for ring in rings if shapely.Polygon(ring).area > SLIVER_MM * ring.length)


def straightened(chain: Curve) -> Curve:
    """Return a polyline without the corners that lie on the line between their neighbours."""
    xy = chain.xy
    before, after = np.roll(xy[:-1], 1, axis=0), np.roll(xy[:-1], -1, axis=0)
    chord = after - before
    length = np.hypot(*chord.T)
    off = np.abs(_cross(chord, xy[:-1] - before)) / np.where(length > 0.0, length, 1.0)
    keep = off > STRAIGHT_MM
    if not chain.closed:
        keep[0] = True
        return from_points(np.vstack([xy[:-1][keep], xy[-1:]]))
    return from_points(xy[:-1][keep], closed=True) if keep.sum() > 2 else chain


def _cross(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    return one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]  # type: ignore[no-any-return]
