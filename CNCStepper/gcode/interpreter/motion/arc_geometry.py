# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arithmetic of program arcs in their plane, once for the interpreter and for the kernel that compiles it.

Only + - * / and sqrt make what goes into the table, so that both give the same bits. Lengths are mm.
"""

from __future__ import annotations

from math import atan2, pi, sqrt

FULL_TURN = 2 * pi


def length(x: float, y: float) -> float:
    """Return the length of a vector."""
    return sqrt(x * x + y * y)


def centre_by_radius(
    begin_x: float, begin_y: float, end_x: float, end_y: float, radius: float, clockwise: bool
) -> tuple[float, float]:
    """Return the centre of the arc with this radius (R word) between two points that differ.

    It lies on the perpendicular over the middle of the chord; a negative radius is more than half a circle, one that
    is shorter than half the chord makes half a circle.
    """
    x, y = end_x - begin_x, end_y - begin_y
    chord = sqrt(x * x + y * y)
    height = sqrt(max(0.0, radius * radius - chord * chord / 4))
    left = -1.0 if clockwise == (radius > 0) else 1.0
    return begin_x + x / 2 - left * height * y / chord, begin_y + y / 2 + left * height * x / chord


def radii_agree(radius: float, at_end: float, slack: float, gap: float, relative: float) -> bool:
    """Return whether the radii at both ends of an arc are so alike that a controller takes it (`ArcRule`)."""
    difference = abs(radius - at_end)
    too_much = difference > gap or difference > relative * max(radius, at_end)
    return not (difference > slack and too_much)


def sweep_rad(x1: float, y1: float, x2: float, y2: float, clockwise: bool) -> float:
    """Return the angle from one vector to another in (0, 2 pi]."""
    angle = atan2(x1 * y2 - y1 * x2, x1 * x2 + y1 * y2)
    angle = -angle if clockwise else angle
    return angle if angle > 0 else angle + FULL_TURN
