# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shapes of cutters, and which keys of a tool belong to which; without pydantic, so that a window may ask early."""

from __future__ import annotations

from typing import Literal, get_args

Shape = Literal["flat", "ball", "bullnose", "v", "drill", "engraver", "jet", "wire"]
SHAPES: tuple[str, ...] = get_args(Shape)

OWN_KEYS = {  # the keys that say more of a shape than its diameter; no other shape may have them
    "bullnose": {"corner_radius_mm"},
    "v": {"tip_angle_deg", "tip_diameter_mm"},
    "engraver": {"tip_angle_deg", "tip_diameter_mm"},
    "drill": {"point_angle_deg"},
    "jet": {"taper_deg"},
    "wire": {"taper_deg"},
}

MILLS = ("flat", "ball", "bullnose")
BEAMS = ("jet", "wire")  # they turn no teeth and cut through
MILLS_KEYS = {"core_diameter_mm"}
POINTED = ("v", "engraver")

FLAT_FLOOR = ("flat",)
SIDEWAYS = tuple(shape for shape in SHAPES if shape != "drill")
SUITED = {  # the shapes that can cut each milling cycle, those that a shop takes first at the front
    "bore": FLAT_FLOOR,
    "circular_pocket": FLAT_FLOOR,
    "contour": SIDEWAYS,
    "drill": ("drill", "flat", *POINTED),
    "elliptical_pocket": FLAT_FLOOR,
    "engrave": SIDEWAYS,
    "face": FLAT_FLOOR,
    "pocket": FLAT_FLOOR,
    "rectangular_pocket": FLAT_FLOOR,
    "thread": ("flat", *POINTED),
}


def foreign_keys(shape: str) -> set[str]:
    """Return the keys that no tool of this shape has."""
    foreign = set.union(*OWN_KEYS.values()) - OWN_KEYS.get(shape, set())
    return foreign if shape in MILLS else foreign | MILLS_KEYS
