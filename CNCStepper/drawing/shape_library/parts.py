# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of machines and signs: ratchet wheels, hooks, hearts, tags, drops."""

from __future__ import annotations

import math

from CNCStepper.drawing.shape_library.declaration import Figure, count, length, require_above, shape
from CNCStepper.drawing.shape_library.outlines import (
    HALF,
    bulge_of,
    bulged,
    disc,
    hull_of_circles,
    on_circle,
    polygon,
    rounded,
)


@shape("Ratchet wheel", "A wheel about the zero with saw teeth and a bore.",
       teeth=count("Teeth", 12, 3), outer_diameter_mm=length("Outer diameter", 60.0),
       tooth_height_mm=length("Height of the teeth", 6.0), bore_diameter_mm=length("Bore", 10.0))  # fmt: skip
def ratchet_wheel(teeth: int, outer_diameter_mm: float, tooth_height_mm: float, bore_diameter_mm: float) -> Figure:
    """Draw two lines a tooth, and the bore."""
    require_above(outer_diameter_mm, 2.0 * tooth_height_mm + bore_diameter_mm, "the outer diameter", "teeth and bore")
    outer, root, step_deg = outer_diameter_mm / 2.0, outer_diameter_mm / 2.0 - tooth_height_mm, 360.0 / teeth
    corners = [on_circle(radius, number * step_deg) for number in range(teeth) for radius in (root, outer)]
    return Figure(polygon(corners), (disc(bore_diameter_mm),))


@shape("Locking wheel", "A disc about the zero with round notches in its rim and a bore.",
       outer_diameter_mm=length("Outer diameter", 60.0), notches=count("Notches", 8, 2),
       notch_diameter_mm=length("Diameter of the notches", 8.0), bore_diameter_mm=length("Bore", 12.0))  # fmt: skip
def locking_wheel(outer_diameter_mm: float, notches: int, notch_diameter_mm: float, bore_diameter_mm: float) -> Figure:
    """Draw an arc of the rim and one of each notch."""
    outer, notch, step_deg = outer_diameter_mm / 2.0, notch_diameter_mm / 2.0, 360.0 / notches
    require_above(2.0 * outer, notch, "the outer diameter", "half a notch")
    half_deg = 2.0 * math.degrees(math.asin(notch / 2.0 / outer))  # of the rim that a notch takes
    require_above(step_deg, 2.0 * half_deg, "the step of the notches", "a notch", "°")
    turn_deg = 180.0 - half_deg  # of the notch's own circle, whose middle lies on the rim
    rows = []
    for number in range(notches):
        begin, end = number * step_deg + half_deg, (number + 1) * step_deg - half_deg
        rows += [(*on_circle(outer, begin), bulge_of(end - begin)), (*on_circle(outer, end), -bulge_of(turn_deg))]
    return Figure(bulged(rows), (disc(bore_diameter_mm),))


@shape("Hook", "A hook to hang things on: a plate with two holes above, the hook's round inside about the zero.",
       inner_diameter_mm=length("Inside of the hook", 24.0), width_mm=length("Width of the bar", 10.0),
       height_mm=length("Height of the plate above the middle", 60.0),
       hole_diameter_mm=length("Holes", 4.5))  # fmt: skip
def hook(inner_diameter_mm: float, width_mm: float, height_mm: float, hole_diameter_mm: float) -> Figure:
    """Draw the plate, the bend and its round end."""
    require_above(height_mm, 3.0 * width_mm, "the height", "three times the bar's width")
    inner, outer = inner_diameter_mm / 2.0, inner_diameter_mm / 2.0 + width_mm
    middle = (inner + outer) / 2.0
    outline = bulged([
        (-outer, height_mm, 0.0), (-outer, 0.0, HALF), (outer, 0.0, HALF), (inner, 0.0, -HALF), (-inner, 0.0, 0.0),
        (-inner, height_mm, 0.0),
    ])  # fmt: skip
    holes = (disc(hole_diameter_mm, (-middle, height_mm - width_mm / 2.0)),
             disc(hole_diameter_mm, (-middle, height_mm - 2.0 * width_mm)))  # fmt: skip
    return Figure(outline, holes)


@shape("Heart", "A heart of two half circles over a rounded tip, the zero in its notch.",
       width_mm=length("Width", 50.0), height_mm=length("Height below the notch", 40.0))  # fmt: skip
def heart(width_mm: float, height_mm: float) -> Figure:
    """Draw two half circles and, along their tangents, two lines to the tip."""
    radius_mm = width_mm / 4.0
    require_above(height_mm, radius_mm, "the height", "a quarter of the width")
    tip, centre = complex(0.0, -height_mm), complex(radius_mm, 0.0)
    reach = abs(centre - tip)
    leaves = (tip - centre) / reach * complex(radius_mm / reach, math.sqrt(1.0 - (radius_mm / reach) ** 2))
    begin_deg = math.degrees(math.atan2(leaves.imag, leaves.real))
    bulge = bulge_of((180.0 - begin_deg) / 2.0)
    right = centre + radius_mm * leaves
    middle = on_circle(radius_mm, begin_deg + (180.0 - begin_deg) / 2.0, (radius_mm, 0.0))
    return Figure(bulged([
        (0.0, -height_mm, 0.0), (right.real, right.imag, bulge), (*middle, bulge), (0.0, 0.0, bulge),
        (-middle[0], middle[1], bulge), (-right.real, right.imag, 0.0),
    ]))  # fmt: skip


@shape("Drop", "A drop: a disc about the zero and a point above.",
       diameter_mm=length("Diameter", 30.0), height_mm=length("From the middle to the point", 36.0))  # fmt: skip
def drop(diameter_mm: float, height_mm: float) -> Figure:
    """Draw the arc and, along its tangents, two lines."""
    radius_mm = diameter_mm / 2.0
    require_above(height_mm, radius_mm, "the height", "half the diameter")
    half_deg = math.degrees(math.asin(radius_mm / height_mm))
    left, right = on_circle(radius_mm, 180.0 - half_deg), on_circle(radius_mm, half_deg)
    bulge = bulge_of(90.0 + half_deg)
    return Figure(bulged([(0.0, height_mm, 0.0), (*left, bulge), (0.0, -radius_mm, bulge), (*right, 0.0)]))


@shape("Tag", "A label about the zero: round corners, cut off on the left, with a hole for a string.",
       width_mm=length("Width", 70.0), height_mm=length("Height", 34.0), corner_radius_mm=length("Corner radius", 4.0),
       hole_diameter_mm=length("Hole", 5.0))  # fmt: skip
def tag(width_mm: float, height_mm: float, corner_radius_mm: float, hole_diameter_mm: float) -> Figure:
    """Draw six sides with round corners, and the hole."""
    require_above(width_mm, height_mm, "the width", "the height")
    x, y, c = width_mm / 2.0, height_mm / 2.0, height_mm / 3.0
    corners = [(c - x, -y), (x, -y), (x, y), (c - x, y), (-x, y - c), (-x, c - y)]
    return Figure(
        rounded(corners, corner_radius_mm), (disc(hole_diameter_mm, (c / 2.0 + hole_diameter_mm / 2.0 - x, 0.0)),)
    )


@shape("Shield", "A shield, the zero in the middle of its upper edge: straight sides, round below.",
       width_mm=length("Width", 50.0), height_mm=length("Height", 64.0))  # fmt: skip
def shield(width_mm: float, height_mm: float) -> Figure:
    """Draw the upper edge, two sides and two arcs about the opposite upper ends of these."""
    x = width_mm / 2.0
    below_mm = width_mm * math.sin(math.pi / 3.0)  # of two arcs of 60° whose radius is the width
    require_above(height_mm, below_mm, "the height", "0.87 times the width")
    y, bulge = below_mm - height_mm, bulge_of(60.0)
    return Figure(bulged([(x, 0.0, 0.0), (-x, 0.0, 0.0), (-x, y, bulge), (0.0, -height_mm, bulge), (x, y, 0.0)]))


@shape("Eye plate", "A plate to hang a load: a base below, an eye about the zero above.",
       eye_diameter_mm=length("Eye", 40.0), hole_diameter_mm=length("Hole", 20.0), base_mm=length("Base", 70.0),
       height_mm=length("From the base to the eye's middle", 50.0))  # fmt: skip
def eye_plate(eye_diameter_mm: float, hole_diameter_mm: float, base_mm: float, height_mm: float) -> Figure:
    """Draw the band around the eye and the corners of the base."""
    x, tiny = base_mm / 2.0, 0.0
    outline = hull_of_circles([(-x, -height_mm, tiny), (x, -height_mm, tiny), (0.0, 0.0, eye_diameter_mm / 2.0)])
    return Figure(outline, (disc(hole_diameter_mm),))
