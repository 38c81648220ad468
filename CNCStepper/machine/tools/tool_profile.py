# SPDX-License-Identifier: LGPL-2.1-or-later
"""The profile of a tool: its radius by the height above its tip, declared here alone.

             |           |
      corner '.         .'  corner    a flat floor of `tip_mm`, then either a round corner (flat: none,
               `-------'              ball: no floor, bull-nose: both) or a cone of `slope` (V, drill,
               |<-tip->|              engraver, jet and wire with taper), up to `radius_mm`

Cycles ask it for the width of their cuts; the simulation removes and judges material by it
(`simulation/cutter_solid.py`), and the tool that is shown has its outline.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from CNCStepper.machine.tools.tool import Tool

DRILL_POINT_DEG = 118.0  # the standard point


class Form(NamedTuple):
    """The profile: 0 up to tip_mm, then a corner of that radius or `slope` mm a mm, up to radius_mm."""

    radius_mm: float
    tip_mm: float
    corner_mm: float = 0.0
    slope: float = 0.0

    @property
    def is_flat(self) -> bool:
        """Whether it is a cylinder, as wide at its tip as anywhere."""
        return self.tip_mm >= self.radius_mm

    @property
    def rise_mm(self) -> float:
        """The height over the tip from which it is as wide as anywhere; 0 for a cylinder."""
        if self.is_flat:
            return 0.0
        return self.corner_mm or (self.radius_mm - self.tip_mm) * self.slope

    def radius_at(self, height_mm: Any) -> Any:
        """Return the radius in mm at a height above the tip, or at float64[n] heights."""
        height = np.clip(height_mm, 0.0, self.rise_mm)
        if self.is_flat:
            return np.full_like(height, self.radius_mm)
        if self.corner_mm:
            return self.tip_mm + np.sqrt(height * (2 * self.corner_mm - height))
        return self.tip_mm + height / self.slope


def form_of(tool: Tool, through_mm: float = 0.0) -> Form:
    """Return the profile of a tool; one whose shape's own keys are not given is a flat of its diameter.

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
    """Return a cone; the angle is that between its two sides."""
    return Form(radius_mm, tip_mm, slope=1 / math.tan(math.radians(angle_deg / 2)))
