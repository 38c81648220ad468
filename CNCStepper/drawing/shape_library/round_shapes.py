# SPDX-License-Identifier: LGPL-2.1-or-later
"""Discs, rings, sectors and segments of a circle."""

from __future__ import annotations

import math

from CNCStepper.drawing.shape_library.declaration import Figure, angle, length, require_above, shape
from CNCStepper.drawing.shape_library.outlines import bulge_of, bulged, disc, on_circle

DIAMETER, OUTER, INNER = "diameter_mm", "the outer diameter", "the inner one"


@shape("Circle", "A circle about the zero.", diameter_mm=length("Diameter", 40.0))
def circle(diameter_mm: float) -> Figure:
    """Draw the circle."""
    return Figure(disc(diameter_mm))


@shape("Ring", "A ring, or a washer, about the zero.",
       outer_diameter_mm=length("Outer diameter", 40.0), inner_diameter_mm=length("Inner diameter", 20.0))  # fmt: skip
def ring(outer_diameter_mm: float, inner_diameter_mm: float) -> Figure:
    """Draw both circles."""
    require_above(outer_diameter_mm, inner_diameter_mm, OUTER, INNER)
    return Figure(disc(outer_diameter_mm), (disc(inner_diameter_mm),))


@shape("Sector", "A slice of a disc about the zero, from X counter-clockwise.",
       diameter_mm=length("Diameter", 60.0), angle_deg=angle("Angle", 75.0, 1.0, 350.0))  # fmt: skip
def sector(diameter_mm: float, angle_deg: float) -> Figure:
    """Draw two lines and the arc."""
    radius_mm = diameter_mm / 2.0
    bulge = bulge_of(angle_deg / 2.0)
    middle, end = on_circle(radius_mm, angle_deg / 2.0), on_circle(radius_mm, angle_deg)
    return Figure(bulged([(0.0, 0.0, 0.0), (radius_mm, 0.0, bulge), (*middle, bulge), (*end, 0.0)]))


@shape("Ring sector", "A piece of a ring about the zero, from X counter-clockwise.",
       outer_diameter_mm=length("Outer diameter", 60.0), inner_diameter_mm=length("Inner diameter", 30.0),
       angle_deg=angle("Angle", 100.0, 1.0, 350.0))  # fmt: skip
def ring_sector(outer_diameter_mm: float, inner_diameter_mm: float, angle_deg: float) -> Figure:
    """Draw two arcs and two lines."""
    require_above(outer_diameter_mm, inner_diameter_mm, OUTER, INNER)
    outer, inner, half = outer_diameter_mm / 2.0, inner_diameter_mm / 2.0, angle_deg / 2.0
    bulge = bulge_of(half)
    return Figure(bulged([
        (inner, 0.0, 0.0), (outer, 0.0, bulge), (*on_circle(outer, half), bulge), (*on_circle(outer, angle_deg), 0.0),
        (*on_circle(inner, angle_deg), -bulge), (*on_circle(inner, half), -bulge),
    ]))  # fmt: skip


@shape("Segment", "A disc about the zero, cut off straight above.",
       diameter_mm=length("Diameter", 50.0), height_mm=length("Height", 35.0))  # fmt: skip
def segment(diameter_mm: float, height_mm: float) -> Figure:
    """Draw the chord and the arc below it."""
    require_above(diameter_mm, height_mm, "the diameter", "the height")
    radius_mm = diameter_mm / 2.0
    y = height_mm - radius_mm
    begin_deg = math.degrees(math.asin(y / radius_mm))
    half_deg = (180.0 + 2.0 * begin_deg) / 2.0
    bulge = bulge_of(half_deg)
    left = on_circle(radius_mm, 180.0 - begin_deg)
    return Figure(bulged([(*left, bulge), (0.0, -radius_mm, bulge), (*on_circle(radius_mm, begin_deg), 0.0)]))


@shape("D-hole", "A round hole with one flat side above, for shafts with a flat; about the circle's middle.",
       diameter_mm=length("Diameter", 10.0), across_flat_mm=length("Across the flat", 8.5))  # fmt: skip
def d_hole(diameter_mm: float, across_flat_mm: float) -> Figure:
    """Draw the segment."""
    return segment(diameter_mm, across_flat_mm)


@shape("Double D-hole", "A round hole with flat sides above and below, about the zero.",
       diameter_mm=length("Diameter", 16.0), across_flats_mm=length("Across the flats", 12.0))  # fmt: skip
def double_d_hole(diameter_mm: float, across_flats_mm: float) -> Figure:
    """Draw two lines and two arcs."""
    require_above(diameter_mm, across_flats_mm, "the diameter", "the width across the flats")
    y, radius_mm = across_flats_mm / 2.0, diameter_mm / 2.0
    x, half_deg = math.sqrt(radius_mm**2 - y**2), math.degrees(math.asin(y / radius_mm))
    bulge = bulge_of(2.0 * half_deg)
    return Figure(bulged([(x, -y, bulge), (x, y, 0.0), (-x, y, bulge), (-x, -y, 0.0)]))


@shape("Crescent", "A disc about the zero less another one beside it, like a moon.",
       diameter_mm=length("Diameter", 50.0), cut_diameter_mm=length("Diameter cut away", 44.0),
       distance_mm=length("Distance of both", 14.0))  # fmt: skip
def crescent(diameter_mm: float, cut_diameter_mm: float, distance_mm: float) -> Figure:
    """Draw the outer and the inner arc."""
    outer, inner = diameter_mm / 2.0, cut_diameter_mm / 2.0
    require_above(outer + inner, distance_mm, "half of both diameters", "their distance")
    require_above(distance_mm, abs(outer - inner), "their distance", "half the difference of the diameters")
    x = (distance_mm**2 + outer**2 - inner**2) / (2.0 * distance_mm)
    y = math.sqrt(outer**2 - x**2)
    out_deg, in_deg = math.degrees(math.atan2(y, x)), math.degrees(math.atan2(y, x - distance_mm))
    out, back = bulge_of(180.0 - out_deg), -bulge_of(180.0 - in_deg)
    return Figure(bulged([(x, y, out), (-outer, 0.0, out), (x, -y, back), (distance_mm - inner, 0.0, back)]))
