# SPDX-License-Identifier: LGPL-2.1-or-later
"""The form of a cutter as material removal sees it: one profile, the height over the tip at a radius.

             |           |
      corner '.         .'  corner    a flat floor of `tip_mm`, then either a round corner (flat: none,
               `-------'              ball: no floor, bull-nose: both) or a cone of `slope` (V, drill,
               |<-tip->|              engraver, jet and wire with taper), up to `radius_mm`

The profile is convex and never falls: along a straight move the lowest height over a point is
therefore one minimum, and `lead` says where it lies.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from CNCStepper.kernels import njit
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_point import DRILL_POINT_DEG

NEWTON = 60  # steps at most; three are usual
WIDER = 1.01  # what is `CLOSE` only is taken that much larger where nothing may be left out
CLOSE = 1e-2  # a step of that share is the last: the next would be its square, and the height is at its minimum


class Form(NamedTuple):
    """The profile: 0 up to tip_mm, then a corner of that radius or `slope` mm a mm, up to radius_mm."""

    radius_mm: float
    tip_mm: float
    corner_mm: float = 0.0
    slope: float = 0.0


def form_of(tool: Tool, through_mm: float = 0.0) -> Form:
    """Return the form of a tool; one whose shape's own keys are not given is a flat of its diameter.

    through_mm: the thickness that a jet or a wire goes through; its tip is then the lower end of the kerf.
    """
    radius = tool.radius_mm
    if tool.shape == "ball":
        return Form(radius, 0.0, radius)
    if tool.shape == "bullnose" and tool.corner_radius_mm:
        return Form(radius, radius - tool.corner_radius_mm, tool.corner_radius_mm)
    if tool.shape == "drill":
        return _cone(radius, 0.0, tool.point_angle_deg or DRILL_POINT_DEG)
    if tool.shape in ("v", "engraver") and tool.tip_angle_deg:
        return _cone(radius, (tool.tip_diameter_mm or 0.0) / 2, tool.tip_angle_deg)
    if tool.taper_deg:
        narrow = max(radius - through_mm * math.tan(math.radians(tool.taper_deg)), 0.0)
        return _cone(radius, narrow, 2 * tool.taper_deg)
    return Form(radius, radius)


def _cone(radius_mm: float, tip_mm: float, angle_deg: float) -> Form:
    return Form(radius_mm, tip_mm, slope=1 / math.tan(math.radians(angle_deg / 2)))


@njit
def height_at(distance, form):
    """Return the height of the cutter over its tip at a distance from its axis, at most its radius."""
    _, tip, corner, slope = form
    beyond = distance - tip
    if beyond <= 0.0:
        return 0.0
    if corner > 0.0:
        return corner - math.sqrt(max(corner * corner - beyond * beyond, 0.0))
    return beyond * slope


@njit
def reach(rise, form):
    """Return two lengths: a cell that has a `lead` l on a move of slope `rise`, l mm behind the tip or ahead of it,

    lies there at most the first away, or within the second of the tip.
    """
    radius, tip, corner, slope = form
    steep = abs(rise)
    if steep == 0.0:
        return 0.0, 0.0
    if corner > 0.0:
        plain = tip + corner * steep / math.sqrt(1.0 + steep * steep)
        if tip == 0.0:
            return plain, 0.0
        beside = WIDER * _corner_lead(plain, steep, tip, corner)
        return beside, math.sqrt(plain * plain + beside * beside)
    if slope > steep:
        return radius * steep / slope, tip
    return 0.0, radius


@njit
def lead(beside, rise, form):
    """Return how far along a move of slope `rise` from the foot of a point `beside` it the cutter is lowest.

    Positive ahead (the move falls), negative behind (it climbs). There the profile's slope along the
    move is as steep as the move itself, or its floor ends.
    """
    radius, tip, corner, slope = form
    steep = abs(rise)
    if steep == 0.0:
        return 0.0
    if corner > 0.0:
        ahead = _corner_lead(abs(beside), steep, tip, corner)
    else:
        ahead = math.sqrt(max(tip * tip - beside * beside, 0.0))
        if slope > steep:
            ahead = max(ahead, steep * abs(beside) / math.sqrt(slope * slope - steep * steep))
        elif slope > 0.0:
            ahead = radius
    return ahead if rise < 0.0 else -ahead


@njit
def _corner_lead(beside, steep, tip, corner):
    """Return where the round corner touches its envelope: at the angle of cosine c from the move's direction

    it does so at the radius out = tip + corner * steep / sqrt(steep² + c²), as far beside as out * sqrt(1 - c²).
    The square of c is looked for by Newton's method between bounds: out lies between its value at c = 1 and tip +
    corner, and is at least `beside`.
    """
    if tip == 0.0:
        return steep * math.sqrt(max(corner * corner - beside * beside, 0.0)) / math.sqrt(1.0 + steep * steep)
    if beside >= tip + corner:
        return 0.0
    least = tip + corner * steep / math.sqrt(1.0 + steep * steep)
    low, high = max(1.0 - (beside / least) * (beside / least), 0.0), 1.0
    square = low
    if beside > least:
        share = corner / (beside - tip)
        high = min(steep * steep * (share * share - 1.0), 1.0)
        square = high * (beside - tip) / corner
    for _ in range(NEWTON):
        root, rest = math.sqrt(steep * steep + square), math.sqrt(1.0 - square)
        out = tip + corner * steep / root
        over = out * rest - beside
        if over > 0.0:
            low = square
        else:
            high = square
        slope = -0.5 * (corner * steep * rest / (root * root * root) + out / max(rest, 1e-9))
        step = over / slope
        square -= step
        if not low <= square <= high:
            square = 0.5 * (low + high)
        elif abs(step) <= CLOSE * square:
            break
    return (tip + corner * steep / math.sqrt(steep * steep + square)) * math.sqrt(square)
