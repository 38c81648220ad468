# SPDX-License-Identifier: LGPL-2.1-or-later
"""Outlines of one glyph that cross each other or themselves, as the outlines of what they fill together.

Fonts draw a cedilla over its letter, and variable fonts whole strokes over each other: filled, that is one area; cut
along, it would be a part in pieces.
"""

from __future__ import annotations

import itertools

import shapely

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.region import Region


def without_overlaps(outlines: list[Curve], tolerance_mm: float) -> list[Curve]:
    """Return outlines that bound the same area and do not cross; counter-clockwise ones fill, clockwise ones are holes.

    Outlines that do not cross are returned as they are.
    """
    if not outlines or not _cross(outlines, tolerance_mm):
        return outlines
    filled = [outline for outline in outlines if outline.area_mm2 > 0.0]
    holes = [outline for outline in outlines if outline.area_mm2 <= 0.0]
    try:
        return list(Region.of(filled, holes).loops)
    except GeometryError:  # a tangle finer than the tolerance: as the font draws it
        return outlines


def _cross(outlines: list[Curve], tolerance_mm: float) -> bool:
    rings = [shapely.LinearRing(outline.points(tolerance_mm)) for outline in outlines if len(outline) > 1]
    if not all(ring.is_simple for ring in rings):
        return True
    return any(one.intersects(other) for one, other in itertools.combinations(rings, 2))
