# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gussets, and brackets in the form of letters."""

from __future__ import annotations

from CNCStepper.drawing.shape_library.declaration import Figure, length, require_above, shape
from CNCStepper.drawing.shape_library.outlines import disc, polygon, rounded

WIDTH, HEIGHT, THICK = length("Width", 60.0), length("Height", 60.0), length("Width of the legs", 16.0)
INNER = length("Radius of the inner corner", 4.0, zero=True)
HOLE = length("Holes; 0: none", 5.0, zero=True)
LEGS = "two legs"


def _holes(diameter_mm: float, *places: tuple[float, float]) -> tuple:
    return tuple(disc(diameter_mm, place) for place in places) if diameter_mm else ()


@shape("Gusset", "A right-angled stiffening plate, its right angle at the zero, cut off there to clear a weld.",
       width_mm=length("Width", 60.0), height_mm=length("Height", 60.0),
       weld_clearance_mm=length("Cut off at the right angle", 10.0),
       nose_mm=length("Ends of the legs", 8.0))  # fmt: skip
def gusset(width_mm: float, height_mm: float, weld_clearance_mm: float, nose_mm: float) -> Figure:
    """Draw six lines."""
    require_above(min(width_mm, height_mm), weld_clearance_mm, "width and height", "material that is cut off")
    require_above(min(width_mm, height_mm), nose_mm, "width and height", "the ends of the legs")
    c, n = weld_clearance_mm, nose_mm
    return Figure(polygon([(c, 0.0), (width_mm, 0.0), (width_mm, n), (n, height_mm), (0.0, height_mm), (0.0, c)]))


@shape("L-bracket", "An angle of two legs, its outer corner at the zero, a hole near the end of each leg.",
       width_mm=WIDTH, height_mm=HEIGHT, leg_mm=THICK, inner_radius_mm=INNER, hole_diameter_mm=HOLE)  # fmt: skip
def l_bracket(
    width_mm: float, height_mm: float, leg_mm: float, inner_radius_mm: float, hole_diameter_mm: float
) -> Figure:
    """Draw the outline and two holes."""
    require_above(min(width_mm, height_mm), leg_mm, "width and height", "the legs' width")
    corners = [(0.0, 0.0), (width_mm, 0.0), (width_mm, leg_mm), (leg_mm, leg_mm), (leg_mm, height_mm), (0.0, height_mm)]
    half = leg_mm / 2.0
    holes = _holes(hole_diameter_mm, (width_mm - half, half), (half, height_mm - half))
    return Figure(rounded(corners, [0.0, 0.0, 0.0, inner_radius_mm, 0.0, 0.0]), holes)


@shape("T-bracket", "A bar above and a stem below, the zero in the middle of the bar's upper edge; three holes.",
       width_mm=length("Width", 80.0), height_mm=HEIGHT, leg_mm=THICK, inner_radius_mm=INNER,
       hole_diameter_mm=HOLE)  # fmt: skip
def t_bracket(
    width_mm: float, height_mm: float, leg_mm: float, inner_radius_mm: float, hole_diameter_mm: float
) -> Figure:
    """Draw the outline and three holes."""
    require_above(min(width_mm, height_mm), leg_mm, "width and height", "the legs' width")
    x, s, t = width_mm / 2.0, leg_mm / 2.0, -leg_mm
    corners = [(-s, -height_mm), (s, -height_mm), (s, t), (x, t), (x, 0.0), (-x, 0.0), (-x, t), (-s, t)]
    holes = _holes(hole_diameter_mm, (s - x, -s), (x - s, -s), (0.0, s - height_mm))
    return Figure(rounded(corners, [0.0, 0.0, inner_radius_mm, 0.0, 0.0, 0.0, 0.0, inner_radius_mm]), holes)


@shape("U-bracket", "Two legs up from a base, the zero in the middle of the base's lower edge; a hole in each leg.",
       width_mm=WIDTH, height_mm=HEIGHT, leg_mm=THICK, inner_radius_mm=INNER, hole_diameter_mm=HOLE)  # fmt: skip
def u_bracket(
    width_mm: float, height_mm: float, leg_mm: float, inner_radius_mm: float, hole_diameter_mm: float
) -> Figure:
    """Draw the outline and two holes."""
    require_above(width_mm, 2.0 * leg_mm, "the width", LEGS)
    require_above(height_mm, leg_mm, "the height", "the base's")
    x, i, t = width_mm / 2.0, width_mm / 2.0 - leg_mm, leg_mm
    corners = [(-x, 0.0), (x, 0.0), (x, height_mm), (i, height_mm), (i, t), (-i, t), (-i, height_mm), (-x, height_mm)]
    radii = [0.0, 0.0, 0.0, 0.0, inner_radius_mm, inner_radius_mm, 0.0, 0.0]
    place = (x - leg_mm / 2.0, height_mm - leg_mm / 2.0)
    return Figure(rounded(corners, radii), _holes(hole_diameter_mm, place, (-place[0], place[1])))


@shape("Z-bracket", "Two flanges that an offset web joins, its left lower corner at the zero; a hole in each flange.",
       width_mm=length("Width of each flange", 40.0), height_mm=HEIGHT, leg_mm=THICK, inner_radius_mm=INNER,
       hole_diameter_mm=HOLE)  # fmt: skip
def z_bracket(
    width_mm: float, height_mm: float, leg_mm: float, inner_radius_mm: float, hole_diameter_mm: float
) -> Figure:
    """Draw the outline and two holes."""
    require_above(height_mm, 2.0 * leg_mm, "the height", LEGS)
    require_above(width_mm, leg_mm, "the flanges' width", "the web's")
    w, h, t = width_mm, height_mm, leg_mm
    corners = [(0.0, 0.0), (w, 0.0), (w, h - t), (2 * w - t, h - t), (2 * w - t, h), (w - t, h), (w - t, t), (0.0, t)]
    radii = [0.0, 0.0, inner_radius_mm, 0.0, 0.0, 0.0, inner_radius_mm, 0.0]
    holes = _holes(hole_diameter_mm, (t / 2.0, t / 2.0), (2 * w - 1.5 * t, h - t / 2.0))
    return Figure(rounded(corners, radii), holes)


@shape("H-profile", "The section of a beam, about the zero.",
       width_mm=length("Width", 50.0), height_mm=length("Height", 60.0), web_mm=length("Thickness of the web", 8.0),
       flange_mm=length("Thickness of the flanges", 10.0), inner_radius_mm=INNER)  # fmt: skip
def h_profile(width_mm: float, height_mm: float, web_mm: float, flange_mm: float, inner_radius_mm: float) -> Figure:
    """Draw twelve lines and four arcs."""
    require_above(width_mm, web_mm, "the width", "the web's thickness")
    require_above(height_mm, 2.0 * flange_mm, "the height", "two flanges")
    x, y, s, f = width_mm / 2.0, height_mm / 2.0, web_mm / 2.0, height_mm / 2.0 - flange_mm
    corners = [
        (-x, -y),
        (x, -y),
        (x, -f),
        (s, -f),
        (s, f),
        (x, f),
        (x, y),
        (-x, y),
        (-x, f),
        (-s, f),
        (-s, -f),
        (-x, -f),
    ]
    return Figure(rounded(corners, [inner_radius_mm if number in (3, 4, 9, 10) else 0.0 for number in range(12)]))
