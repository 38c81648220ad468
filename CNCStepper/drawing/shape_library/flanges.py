# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flanges and plates with holes."""

from __future__ import annotations

from CNCStepper.drawing.shape_library.declaration import Figure, angle, count, length, require_above, shape
from CNCStepper.drawing.shape_library.outlines import bolt_holes, corner_holes, disc, hull_of_circles, rounded

BORE = length("Bore; 0: none", 30.0, zero=True)
HOLE = length("Diameter of the holes", 6.5)
CORNER = length("Corner radius", 6.0, zero=True)


def _bore(diameter_mm: float) -> tuple:
    return (disc(diameter_mm),) if diameter_mm else ()


def _square(side_mm: float, corner_radius_mm: float):
    half = side_mm / 2.0
    return rounded([(-half, -half), (half, -half), (half, half), (-half, half)], corner_radius_mm)


@shape("Flange", "A round flange about the zero with a bore and a circle of bolt holes.",
       outer_diameter_mm=length("Outer diameter", 80.0), bore_diameter_mm=BORE,
       bolt_circle_mm=length("Diameter of the bolt circle", 60.0), hole_diameter_mm=HOLE,
       holes=count("Holes", 6, 1), start_deg=angle("First hole at", 0.0, -360.0, 360.0))  # fmt: skip
def flange(
    outer_diameter_mm: float, bore_diameter_mm: float, bolt_circle_mm: float, hole_diameter_mm: float, holes: int,
    start_deg: float,
) -> Figure:  # fmt: skip
    """Draw the circle, the bore and the holes."""
    bolts = bolt_holes(bolt_circle_mm, hole_diameter_mm, holes, start_deg)
    return Figure(disc(outer_diameter_mm), (*_bore(bore_diameter_mm), *bolts))


@shape("Oval flange", "A flange of two bolts along X: a disc about the zero with an ear on each side.",
       disc_diameter_mm=length("Diameter of the disc", 44.0), bore_diameter_mm=length("Bore; 0: none", 24.0, zero=True),
       hole_distance_mm=length("Distance of the holes", 60.0), ear_diameter_mm=length("Width of the ears", 18.0),
       hole_diameter_mm=length("Diameter of the holes", 8.5))  # fmt: skip
def oval_flange(
    disc_diameter_mm: float, bore_diameter_mm: float, hole_distance_mm: float, ear_diameter_mm: float,
    hole_diameter_mm: float,
) -> Figure:  # fmt: skip
    """Draw the band around three circles, the bore and two holes."""
    require_above(disc_diameter_mm, ear_diameter_mm, "the disc", "the ears")
    x, ear = hole_distance_mm / 2.0, ear_diameter_mm / 2.0
    middle = disc_diameter_mm / 2.0
    outline = hull_of_circles([(-x, 0.0, ear), (0.0, 0.0, middle), (x, 0.0, ear), (0.0, 0.0, middle)])
    bolts = (disc(hole_diameter_mm, (-x, 0.0)), disc(hole_diameter_mm, (x, 0.0)))
    return Figure(outline, (*_bore(bore_diameter_mm), *bolts))


@shape("Square flange", "A square plate about the zero with a bore and a hole near each corner.",
       side_mm=length("Side", 70.0), corner_radius_mm=CORNER, bore_diameter_mm=BORE,
       hole_distance_mm=length("Distance of the holes", 52.0), hole_diameter_mm=HOLE)  # fmt: skip
def square_flange(
    side_mm: float, corner_radius_mm: float, bore_diameter_mm: float, hole_distance_mm: float, hole_diameter_mm: float
) -> Figure:
    """Draw the square, the bore and four holes."""
    bolts = corner_holes(hole_distance_mm, hole_distance_mm, hole_diameter_mm)
    return Figure(_square(side_mm, corner_radius_mm), (*_bore(bore_diameter_mm), *bolts))


NEMA = {  # size: side of the plate, distance of the holes, their diameter, hole for the pilot, mm (NEMA ICS 16-2001)
    8: (20.3, 16.0, 2.4, 15.5),
    11: (28.2, 23.0, 2.9, 22.5),
    14: (35.2, 26.0, 3.4, 22.5),
    17: (42.3, 31.0, 3.4, 22.5),
    23: (56.4, 47.14, 5.3, 38.6),
    34: (86.0, 69.6, 6.6, 73.5),
}


@shape("NEMA motor plate", "A plate about the zero for a stepper motor of NEMA size 8, 11, 14, 17, 23 or 34.",
       size=count("NEMA size", 17, 8, 34), margin_mm=length("Margin around the motor", 4.0, zero=True),
       corner_radius_mm=length("Corner radius", 4.0, zero=True))  # fmt: skip
def nema_plate(size: int, margin_mm: float, corner_radius_mm: float) -> Figure:
    """Draw the plate, the hole for the pilot and four holes; raises JobError for a size that is none."""
    if size not in NEMA:
        require_above(0.0, size, "the NEMA size", "one of 8, 11, 14, 17, 23, 34, but it")
    side_mm, distance_mm, hole_mm, pilot_mm = NEMA[size]
    outline = _square(side_mm + 2.0 * margin_mm, corner_radius_mm)
    return Figure(outline, (disc(pilot_mm), *corner_holes(distance_mm, distance_mm, hole_mm)))


@shape("Mounting plate", "A rectangular plate about the zero with a hole near each corner.",
       width_mm=length("Width", 100.0), height_mm=length("Height", 60.0), corner_radius_mm=CORNER,
       edge_mm=length("From the edges to the holes", 8.0),
       hole_diameter_mm=length("Diameter of the holes", 5.0))  # fmt: skip
def mounting_plate(
    width_mm: float, height_mm: float, corner_radius_mm: float, edge_mm: float, hole_diameter_mm: float
) -> Figure:
    """Draw the rectangle and four holes."""
    require_above(min(width_mm, height_mm), 2.0 * edge_mm, "the shorter side", "twice the holes' distance from it")
    x, y = width_mm / 2.0, height_mm / 2.0
    outline = rounded([(-x, -y), (x, -y), (x, y), (-x, y)], corner_radius_mm)
    return Figure(outline, corner_holes(width_mm - 2.0 * edge_mm, height_mm - 2.0 * edge_mm, hole_diameter_mm))


@shape("Lever", "Two eyes and the bar that joins them along X; the first eye's hole is at the zero.",
       distance_mm=length("Distance of the holes", 60.0), first_diameter_mm=length("First eye", 30.0),
       second_diameter_mm=length("Second eye", 18.0), first_hole_mm=length("First hole", 14.0),
       second_hole_mm=length("Second hole", 8.0))  # fmt: skip
def lever(
    distance_mm: float, first_diameter_mm: float, second_diameter_mm: float, first_hole_mm: float, second_hole_mm: float
) -> Figure:
    """Draw the band around both eyes and the holes."""
    outline = hull_of_circles([(0.0, 0.0, first_diameter_mm / 2.0), (distance_mm, 0.0, second_diameter_mm / 2.0)])
    return Figure(outline, (disc(first_hole_mm), disc(second_hole_mm, (distance_mm, 0.0))))


@shape("Triangular plate", "A plate about the zero with an eye and a hole at each of three corners.",
       circle_diameter_mm=length("Diameter through the holes", 60.0), eye_diameter_mm=length("Eyes", 20.0),
       hole_diameter_mm=HOLE, bore_diameter_mm=length("Bore; 0: none", 20.0, zero=True))  # fmt: skip
def triangular_plate(
    circle_diameter_mm: float, eye_diameter_mm: float, hole_diameter_mm: float, bore_diameter_mm: float
) -> Figure:
    """Draw the band around three eyes, the holes and the bore."""
    holes = bolt_holes(circle_diameter_mm, hole_diameter_mm, 3, 90.0)
    eyes = [(*hole.centres[0].tolist(), eye_diameter_mm / 2.0) for hole in holes]
    return Figure(hull_of_circles(eyes), (*_bore(bore_diameter_mm), *holes))
