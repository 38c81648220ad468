# SPDX-License-Identifier: LGPL-2.1-or-later
"""Chuck, jaws and tailstock as regions of the half plane, in the part's coordinates, mm."""

from __future__ import annotations

import math

import shapely
from shapely.geometry.base import BaseGeometry

CHUCK_DEPTH_MM = 100.0  # how far a chuck reaches behind its face
TAILSTOCK_REACH_MM = 200.0  # how far a centre reaches away from the part


def chuck_region(length_mm: float, diameter_mm: float, depth_mm: float = CHUCK_DEPTH_MM) -> BaseGeometry:
    """Return a chuck from its face at z = -length_mm away from the part; jaws are one whose depth is theirs."""
    return shapely.box(-length_mm - depth_mm, 0.0, -length_mm, diameter_mm / 2)


def tailstock_region(face_mm: float, diameter_mm: float, angle_deg: float, hole_mm: float = 0.0) -> BaseGeometry:
    """Return a centre whose cone of angle_deg enters the end face at z = face_mm through a hole of hole_mm."""
    slope = math.tan(math.radians(angle_deg / 2))
    tip = face_mm - hole_mm / 2 / slope
    shoulder = tip + diameter_mm / 2 / slope
    end = face_mm + TAILSTOCK_REACH_MM
    cone = [(face_mm, hole_mm / 2), (shoulder, diameter_mm / 2), (end, diameter_mm / 2), (end, 0), (face_mm, 0)]
    return shapely.Polygon(cone)
