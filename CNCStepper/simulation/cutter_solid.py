# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cutter as the exact judge sees it: a solid of revolution about the tool's axis, by its form.

     radius                        beside
|<----------->|              +------------------>  from the axis to a point
|             |              |
|            .'   height     |  cutter
|         .-'                '----.
'--------'  tip               drop|  gap
                                  x   the point, below the tip
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.cutter_profile import Form

DISC_STEP_MM = 0.001  # along the profile, between the discs that stand for it when a gouge is judged
BEAM = ("jet", "wire")  # cut through the whole stock wherever their height is


@dataclass(frozen=True)
class Cutter:
    """A cutter by its form; convex and never narrower higher up."""

    form: Form

    @property
    def radius_mm(self) -> float:
        """The largest radius."""
        return self.form.radius_mm

    @property
    def floor_mm(self) -> float:
        """The radius of the flat floor at the tip; 0 where there is none."""
        return self.form.tip_mm

    @property
    def is_flat(self) -> bool:
        """Whether it is a cylinder, as wide at its tip as anywhere."""
        return self.floor_mm >= self.radius_mm

    @property
    def rise_mm(self) -> float:
        """The height over the tip from which it is as wide as anywhere."""
        if self.is_flat:
            return 0.0
        return self.form.corner_mm or (self.radius_mm - self.floor_mm) * self.form.slope

    def discs(self, up_to_mm: float = np.inf, step_mm: float = DISC_STEP_MM) -> tuple[np.ndarray, np.ndarray]:
        """Return heights above the tip and radii of discs that approximate the cutter, rising.

        up_to_mm: higher ones are left out, but for the next one. step_mm: along the profile.
        """
        top_mm = max(min(up_to_mm, self.rise_mm), 0.0)
        if self.is_flat:
            return np.zeros(1), np.array([self.radius_mm])
        corner_mm = self.form.corner_mm
        if corner_mm:
            turn = np.arccos(1 - top_mm / corner_mm)
            angle = np.linspace(0.0, turn, int(np.ceil(corner_mm * turn / step_mm)) + 1)
            return corner_mm * (1 - np.cos(angle)), self.floor_mm + corner_mm * np.sin(angle)
        count = int(np.ceil(top_mm * np.hypot(1.0, 1 / self.form.slope) / step_mm)) + 1
        height = np.linspace(0.0, top_mm, count)
        return height, self.radius_at(height)

    def radius_at(self, height_mm: np.ndarray) -> np.ndarray:
        """Return the radius that the cutter has at heights above its tip."""
        height = np.clip(height_mm, 0.0, self.rise_mm)
        if self.is_flat:
            return np.full_like(height, self.radius_mm)
        if self.form.corner_mm:
            return self.floor_mm + np.sqrt(height * (2 * self.form.corner_mm - height))
        return self.floor_mm + height / self.form.slope

    def heights_at(self, beside_mm: np.ndarray) -> np.ndarray:
        """Return the height over the tip of its lower face at distances from the axis; infinite beyond its radius."""
        beyond = np.clip(beside_mm - self.floor_mm, 0.0, self.radius_mm - self.floor_mm)
        height = beyond * self.form.slope
        if self.form.corner_mm:
            height = self.form.corner_mm - np.sqrt(np.maximum(self.form.corner_mm**2 - beyond**2, 0.0))
        return np.where(beside_mm <= self.radius_mm, height, np.inf)

    def gap(self, beside_mm: np.ndarray, drop_mm: float) -> np.ndarray:
        """Return the distance to the cutter from points beside its axis, `drop_mm` below its tip.

        Negative: above its tip; there a round corner counts as if the point lay at the tip's height.
        """
        beyond = np.maximum(beside_mm - self.floor_mm, 0.0)
        if self.is_flat:
            return np.hypot(beyond, max(drop_mm, 0.0))
        if self.form.corner_mm:
            corner_mm = self.form.corner_mm
            return np.maximum(np.hypot(beyond, corner_mm + max(drop_mm, 0.0)) - corner_mm, 0.0)
        wide, high = self.radius_mm - self.floor_mm, self.rise_mm
        drop_mm = max(drop_mm, -high)
        share = np.clip((beyond * wide - drop_mm * high) / (wide**2 + high**2), 0.0, 1.0)
        beside_cone = np.hypot(beyond - share * wide, drop_mm + share * high)
        return np.where(beyond * high <= -drop_mm * wide, 0.0, beside_cone)


POINT = Cutter(Form(0.0, 0.0))
Tools = Mapping[int, Tool] | Tool  # a tool alone stands for every number


def tool_numbered(tools: Tools | None, number: int) -> Tool | None:
    """Return the tool with that number, or None."""
    if isinstance(tools, Tool):
        return tools
    return tools.get(number) if tools else None
