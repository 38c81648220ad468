# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rectangles, triangles, regular polygons, stars, crosses and arrows."""

from __future__ import annotations

from CNCStepper.drawing.shape_library.declaration import Figure, angle, count, length, require_above, shape
from CNCStepper.drawing.shape_library.outlines import on_circle, polygon, rounded

SIDES = {"width_mm": length("Width", 60.0), "height_mm": length("Height", 40.0)}


@shape("Rectangle", "A rectangle about the zero, its corners sharp or round.",
       **SIDES, corner_radius_mm=length("Corner radius", 0.0, zero=True))  # fmt: skip
def rectangle(width_mm: float, height_mm: float, corner_radius_mm: float) -> Figure:
    """Draw lines and quarter circles."""
    x, y = width_mm / 2.0, height_mm / 2.0
    return Figure(rounded([(-x, -y), (x, -y), (x, y), (-x, y)], corner_radius_mm))


@shape("Chamfered rectangle", "A rectangle about the zero with its corners cut off at 45°.",
       **SIDES, chamfer_mm=length("Chamfer along each side", 8.0))  # fmt: skip
def chamfered_rectangle(width_mm: float, height_mm: float, chamfer_mm: float) -> Figure:
    """Draw eight lines."""
    require_above(min(width_mm, height_mm), 2.0 * chamfer_mm, "the shorter side", "two chamfers")
    x, y, c = width_mm / 2.0, height_mm / 2.0, chamfer_mm
    return Figure(polygon([
        (c - x, -y), (x - c, -y), (x, c - y), (x, y - c), (x - c, y), (c - x, y), (-x, y - c), (-x, c - y)
    ]))  # fmt: skip


@shape("Isosceles triangle", "A triangle with two equal sides, the zero in the middle of its base.",
       base_mm=length("Base", 50.0), height_mm=length("Height", 40.0),
       corner_radius_mm=length("Corner radius", 0.0, zero=True))  # fmt: skip
def triangle(base_mm: float, height_mm: float, corner_radius_mm: float) -> Figure:
    """Draw three lines and the arcs of the corners."""
    return Figure(rounded([(-base_mm / 2.0, 0.0), (base_mm / 2.0, 0.0), (0.0, height_mm)], corner_radius_mm))


@shape("Trapezoid", "A trapezoid, the zero in the middle of its base.",
       base_mm=length("Base", 60.0), top_mm=length("Top", 36.0), height_mm=length("Height", 30.0),
       corner_radius_mm=length("Corner radius", 0.0, zero=True))  # fmt: skip
def trapezoid(base_mm: float, top_mm: float, height_mm: float, corner_radius_mm: float) -> Figure:
    """Draw four lines and the arcs of the corners."""
    x, u = base_mm / 2.0, top_mm / 2.0
    return Figure(rounded([(-x, 0.0), (x, 0.0), (u, height_mm), (-u, height_mm)], corner_radius_mm))


@shape("Parallelogram", "A parallelogram, its left lower corner at the zero.",
       width_mm=length("Width", 50.0), height_mm=length("Height", 30.0),
       angle_deg=angle("Angle", 65.0, 5.0, 175.0))  # fmt: skip
def parallelogram(width_mm: float, height_mm: float, angle_deg: float) -> Figure:
    """Draw four lines."""
    across, up = on_circle(1.0, angle_deg)
    shift = height_mm * across / up
    return Figure(polygon([(0.0, 0.0), (width_mm, 0.0), (width_mm + shift, height_mm), (shift, height_mm)]))


@shape("Regular polygon", "A polygon of equal sides about the zero, one side below; the size is across the flats.",
       sides=count("Sides", 6, 3, 100), across_flats_mm=length("Twice from the middle to a side", 40.0),
       corner_radius_mm=length("Corner radius", 0.0, zero=True))  # fmt: skip
def regular_polygon(sides: int, across_flats_mm: float, corner_radius_mm: float) -> Figure:
    """Draw the sides and the arcs of the corners."""
    half_deg = 180.0 / sides
    radius_mm = across_flats_mm / 2.0 / on_circle(1.0, half_deg)[0]
    corners = [on_circle(radius_mm, half_deg * (2 * number + 1) - 90.0) for number in range(sides)]
    return Figure(rounded(corners, corner_radius_mm))


@shape("Star", "A star about the zero, one point above.",
       points=count("Points", 5, 3, 100), outer_diameter_mm=length("Diameter of the points", 60.0),
       inner_diameter_mm=length("Diameter of the inner corners", 26.0))  # fmt: skip
def star(points: int, outer_diameter_mm: float, inner_diameter_mm: float) -> Figure:
    """Draw two lines a point."""
    require_above(outer_diameter_mm, inner_diameter_mm, "the diameter of the points", "that of the inner corners")
    diameters = (outer_diameter_mm, inner_diameter_mm)
    step_deg = 180.0 / points
    return Figure(polygon(on_circle(diameters[n % 2] / 2.0, 90.0 + n * step_deg) for n in range(2 * points)))


@shape("Cross", "A cross of two bars about the zero.",
       width_mm=length("Width", 50.0), height_mm=length("Height", 50.0), bar_mm=length("Width of the bars", 16.0),
       inner_radius_mm=length("Radius of the inner corners", 0.0, zero=True))  # fmt: skip
def cross(width_mm: float, height_mm: float, bar_mm: float, inner_radius_mm: float) -> Figure:
    """Draw twelve lines and the arcs of the inner corners."""
    require_above(min(width_mm, height_mm), bar_mm, "width and height", "the bars' width")
    x, y, b = width_mm / 2.0, height_mm / 2.0, bar_mm / 2.0
    corners = [
        (-b, -y),
        (b, -y),
        (b, -b),
        (x, -b),
        (x, b),
        (b, b),
        (b, y),
        (-b, y),
        (-b, b),
        (-x, b),
        (-x, -b),
        (-b, -b),
    ]
    return Figure(rounded(corners, [inner_radius_mm if number % 3 == 2 else 0.0 for number in range(12)]))


@shape("Arrow", "An arrow along X, its tip at the zero.",
       length_mm=length("Length", 60.0), shaft_mm=length("Width of the shaft", 12.0),
       head_length_mm=length("Length of the head", 22.0), head_width_mm=length("Width of the head", 30.0))  # fmt: skip
def arrow(length_mm: float, shaft_mm: float, head_length_mm: float, head_width_mm: float) -> Figure:
    """Draw seven lines."""
    require_above(length_mm, head_length_mm, "the length", "the head's")
    require_above(head_width_mm, shaft_mm, "the head's width", "the shaft's")
    s, h = shaft_mm / 2.0, head_width_mm / 2.0
    return Figure(polygon([
        (0.0, 0.0), (-head_length_mm, h), (-head_length_mm, s), (-length_mm, s),
        (-length_mm, -s), (-head_length_mm, -s), (-head_length_mm, -h),
    ]))  # fmt: skip
