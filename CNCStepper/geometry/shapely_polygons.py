# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions of lines and arcs as shapely polygons of short chords, for display and measurement."""

from __future__ import annotations

import numpy as np
import shapely
from shapely import Polygon
from shapely.geometry.base import BaseGeometry

from CNCStepper.geometry.region import Region

FLAT_MM = 0.0004  # how far chords leave the arcs


def polygons_of(region: Region, flat_mm: float = FLAT_MM) -> BaseGeometry:
    """Return a region as polygon(s) whose boundary lies within `flat_mm` of its own."""
    return shapely.union_all([_polygon(part, flat_mm) for part in region.parts()])


def _polygon(part: Region, flat_mm: float) -> BaseGeometry:
    """Return one piece; chords of loops that touch may cross, then the holes are taken out one by one."""
    rings = [(loop.area_mm2 > 0, loop.points(flat_mm)) for loop in part.loops]
    outer = [ring for is_outer, ring in rings if is_outer and len(ring) > 3]
    holes = [ring for is_outer, ring in rings if not is_outer and len(ring) > 3]
    if not outer:
        return Polygon()
    whole = Polygon(outer[0], holes)
    if whole.is_valid:
        return whole
    return _valid(outer[0]).difference(shapely.union_all([_valid(hole) for hole in holes]))


def _valid(ring: np.ndarray) -> BaseGeometry:
    found = shapely.make_valid(Polygon(ring))
    return shapely.union_all([part for part in shapely.get_parts(found) if part.area > 0])
