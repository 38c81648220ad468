# SPDX-License-Identifier: LGPL-2.1-or-later
"""The point of a tool: the cone of a drill, a V or an engraver; any other shape has none."""

from __future__ import annotations

import math
from dataclasses import dataclass

from CNCStepper.machine.tools.tool import Tool

DRILL_POINT_DEG = 118.0  # the standard point


@dataclass(frozen=True)
class Cone:
    """From `tip_mm` at the tip to `radius_mm`, `height_mm` above it; a tool without a point has the height 0."""

    radius_mm: float
    tip_mm: float
    height_mm: float

    def radius_at(self, height_mm: float) -> float:
        """Return the radius at a height above the tip."""
        if height_mm >= self.height_mm:
            return self.radius_mm
        return self.tip_mm + (self.radius_mm - self.tip_mm) * max(height_mm, 0.0) / self.height_mm


def cone_of(tool: Tool) -> Cone:
    """Return the point of a tool; the angles are those between its two sides."""
    radius_mm, tip_mm = tool.radius_mm, (tool.tip_diameter_mm or 0.0) / 2
    angle_deg = tool.tip_angle_deg
    if tool.shape == "drill":
        angle_deg, tip_mm = tool.point_angle_deg or DRILL_POINT_DEG, 0.0
    if not angle_deg:
        return Cone(radius_mm, radius_mm, 0.0)
    return Cone(radius_mm, tip_mm, (radius_mm - tip_mm) / math.tan(math.radians(angle_deg / 2)))
