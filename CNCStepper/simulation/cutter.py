# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cutter as simulation sees it: a solid of revolution above its tip.

  flat            ball
|      |        |      |
|      |        |      |     radius_at(height): the widest from the tip up to that height
|      |         \\    /      gap(d, drop): distance from a point `drop` below the tip and
+------+          `--'       d beside the axis to the cutter
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from CNCStepper.machine.tool import Tool

BALL_STEP_MM = 0.002  # spacing of the discs that stand for a ball when its penetration is judged
SIMULATED = ("flat", "ball")  # every other shape is taken as a flat of its diameter


@dataclass(frozen=True)
class Cutter:
    """A cutter of `radius_mm`, with a flat or a ball end."""

    radius_mm: float
    ball: bool = False

    def discs(self) -> tuple[np.ndarray, np.ndarray]:
        """Return heights above the tip and radii of the discs that stand for the cutter, rising."""
        if not self.ball:
            return np.zeros(1), np.array([self.radius_mm])
        count = int(np.ceil(self.radius_mm * np.pi / 2 / BALL_STEP_MM)) + 1
        angle = np.linspace(0.0, np.pi / 2, count)
        return self.radius_mm * (1 - np.cos(angle)), self.radius_mm * np.sin(angle)

    def radius_at(self, height_mm: np.ndarray) -> np.ndarray:
        """Return the radius that the cutter has at heights above its tip."""
        if not self.ball:
            return np.full_like(height_mm, self.radius_mm)
        height = np.clip(height_mm, 0.0, self.radius_mm)
        return np.sqrt(height * (2 * self.radius_mm - height))

    def gap(self, beside_mm: np.ndarray, drop_mm: float) -> np.ndarray:
        """Return the distance to the cutter from points `drop_mm` (not negative) below its tip, beside its axis."""
        if self.ball:
            return np.maximum(np.hypot(beside_mm, self.radius_mm + drop_mm) - self.radius_mm, 0.0)
        return np.hypot(np.maximum(beside_mm - self.radius_mm, 0.0), drop_mm)


POINT = Cutter(0.0)
Tools = Mapping[int, Tool] | Tool  # a tool alone stands for every number


def tool_numbered(tools: Tools | None, number: int) -> Tool | None:
    """Return the tool with that number, or None."""
    if isinstance(tools, Tool):
        return tools
    return tools.get(number) if tools else None


def cutter_numbered(tools: Tools, number: int) -> Cutter | None:
    """Return the cutter of the tool with that number, or None."""
    tool = tool_numbered(tools, number)
    return None if tool is None else Cutter(tool.radius_mm, tool.shape == "ball")
