# SPDX-License-Identifier: LGPL-2.1-or-later
"""In how many other closed curves each one lies: 0 for an outline, 1 for a hole in it, 2 for an island in the hole."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely

from CNCStepper.geometry.curve import Curve

CHORD_MM = 0.01


def nesting_levels(curves: Sequence[Curve]) -> np.ndarray:
    """Return the level of each closed curve, int64[n]; an open one lies in none and holds none.

    Curves that cross are judged by a place within the smaller one.
    """
    levels = np.zeros(len(curves), np.int64)
    closed = [number for number, curve in enumerate(curves) if curve.closed and len(curve) > 1]
    if len(closed) < 2:
        return levels
    polygons = np.array([shapely.Polygon(curves[number].points(CHORD_MM)) for number in closed])
    polygons = shapely.buffer(polygons, 0.0)
    areas = np.abs([curves[number].area_mm2 for number in closed])
    places = shapely.point_on_surface(polygons)
    inner, outer = shapely.STRtree(polygons).query(places, predicate="within")
    inside = areas[outer] > areas[inner]
    levels[closed] = np.bincount(inner[inside], minlength=len(closed))
    return levels
