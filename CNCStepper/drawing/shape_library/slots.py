# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slots and holes for fastening and for keys."""

from __future__ import annotations

import math

from CNCStepper.drawing.shape_library.declaration import Figure, angle, length, require_above, shape
from CNCStepper.drawing.shape_library.outlines import HALF, bulge_of, bulged, on_circle, polygon

LENGTH, WIDTH = "the length", "the width"


@shape("Slot", "A straight slot with round ends along X, about the zero; the length is over all.",
       length_mm=length("Length", 40.0), width_mm=length("Width", 12.0))  # fmt: skip
def slot(length_mm: float, width_mm: float) -> Figure:
    """Draw two lines and two half circles."""
    require_above(length_mm, width_mm, LENGTH, WIDTH)
    x, y = (length_mm - width_mm) / 2.0, width_mm / 2.0
    return Figure(bulged([(-x, -y, 0.0), (x, -y, HALF), (x, y, 0.0), (-x, y, HALF)]))


@shape("Arc slot", "A slot with round ends along an arc about the zero, from X counter-clockwise.",
       circle_diameter_mm=length("Diameter of its middle line", 60.0), width_mm=length("Width", 10.0),
       angle_deg=angle("Angle", 80.0, 1.0, 340.0))  # fmt: skip
def arc_slot(circle_diameter_mm: float, width_mm: float, angle_deg: float) -> Figure:
    """Draw two arcs and two half circles."""
    require_above(circle_diameter_mm, width_mm, "the diameter of its middle line", WIDTH)
    outer, inner, half = (circle_diameter_mm + width_mm) / 2.0, (circle_diameter_mm - width_mm) / 2.0, angle_deg / 2.0
    bulge = bulge_of(half)
    return Figure(bulged([
        (outer, 0.0, bulge), (*on_circle(outer, half), bulge), (*on_circle(outer, angle_deg), HALF),
        (*on_circle(inner, angle_deg), -bulge), (*on_circle(inner, half), -bulge), (inner, 0.0, HALF),
    ]))  # fmt: skip


@shape("Keyhole", "A hole to hang a part on a screw: a circle about the zero for its head, a slot above for its shank.",
       head_diameter_mm=length("Hole for the head", 12.0), slot_width_mm=length("Width of the slot", 6.0),
       height_mm=length("From the circle's middle to the slot's end", 18.0))  # fmt: skip
def keyhole(head_diameter_mm: float, slot_width_mm: float, height_mm: float) -> Figure:
    """Draw the arc of the circle, two lines and a half circle."""
    require_above(head_diameter_mm, slot_width_mm, "the hole for the head", "the slot's width")
    radius_mm, x = head_diameter_mm / 2.0, slot_width_mm / 2.0
    y, top = math.sqrt(radius_mm**2 - x**2), height_mm - x
    require_above(top, y, "the height", "the circle's share of it")
    bulge = bulge_of(180.0 - math.degrees(math.asin(x / radius_mm)))
    return Figure(bulged([(x, top, HALF), (-x, top, 0.0), (-x, y, bulge), (0.0, -radius_mm, bulge), (x, y, 0.0)]))


@shape("Keyway bore", "A bore about the zero with a keyway above (DIN 6885: bore and key's depth over all).",
       diameter_mm=length("Bore", 20.0), key_width_mm=length("Width of the key", 6.0),
       over_key_mm=length("From the bore's bottom to the keyway's", 22.8))  # fmt: skip
def keyway_bore(diameter_mm: float, key_width_mm: float, over_key_mm: float) -> Figure:
    """Draw the arc of the bore and the keyway."""
    require_above(diameter_mm, key_width_mm, "the bore", "the key's width")
    require_above(over_key_mm, diameter_mm, "the depth over the key", "the bore")
    radius_mm, x = diameter_mm / 2.0, key_width_mm / 2.0
    y, top = math.sqrt(radius_mm**2 - x**2), over_key_mm - radius_mm
    bulge = bulge_of(180.0 - math.degrees(math.asin(x / radius_mm)))
    return Figure(bulged([(x, top, 0.0), (-x, top, 0.0), (-x, y, bulge), (0.0, -radius_mm, bulge), (x, y, 0.0)]))


@shape("T-slot", "A slot in the edge of a plate for a bolt's head: open below, the zero at its mouth's middle.",
       slot_width_mm=length("Width of the mouth", 6.0), neck_mm=length("Length of the neck", 10.0),
       head_width_mm=length("Width of the head", 12.0), head_height_mm=length("Height of the head", 5.0))  # fmt: skip
def t_slot(slot_width_mm: float, neck_mm: float, head_width_mm: float, head_height_mm: float) -> Figure:
    """Draw the polygon."""
    require_above(head_width_mm, slot_width_mm, "the head's width", "the mouth's")
    x, wide, high = slot_width_mm / 2.0, head_width_mm / 2.0, neck_mm + head_height_mm
    return Figure(polygon([
        (-x, 0.0), (x, 0.0), (x, neck_mm), (wide, neck_mm), (wide, high), (-wide, high), (-wide, neck_mm), (-x, neck_mm)
    ]))  # fmt: skip
