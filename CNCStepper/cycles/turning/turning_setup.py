# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a turning cycle is given besides its own parameters, and what it answers."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import pi

from CNCStepper.geometry.curve import Curve
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.tools.turning_tool import TurningTool

SMALLEST_MM = 1e-6  # of a radius


@dataclass(frozen=True)
class TurningSetup:
    """The tool, the stock and the speeds of one operation; lengths in mm in the part's coordinates.

    radius_mm, face_mm: of the raw bar and its end. bore_mm: diameter of what is hollow already, 0 for none. start: z
    and radius at which the tool stands before and after the operation. feed_mm_rev, rpm: of the operation. machine:
    whose axes must follow the spindle. surface_m_min: that the spindle keeps, up to largest_rpm; 0 where rpm is fixed.
    is_mirrored: in z, for a left-hand tool.
    """

    tool: TurningTool
    radius_mm: float
    face_mm: float
    bore_mm: float
    start: tuple[float, float]
    feed_mm_rev: float
    rpm: float
    profile: Curve | None = None
    machine: Machine | None = None
    surface_m_min: float = 0.0
    largest_rpm: float = 0.0
    is_mirrored: bool = False

    def rpm_at(self, r_mm: float) -> float:
        """Return the spindle's speed at a radius of the control point."""
        if not self.surface_m_min:
            return self.rpm
        return min(self.surface_m_min * 1000.0 / (2.0 * pi * max(abs(r_mm), SMALLEST_MM)), self.largest_rpm)


@dataclass(frozen=True)
class TurningAnswer:
    """What an operation wants: its number from 1, tool, the profile in (z, r) and how much it leaves, normal to it.

    inside: the material lies at larger radii. figures: by name, for the report. warnings: for a person.
    """

    number: int
    cycle: str
    tool: int
    profile: Curve | None = None
    stock_to_leave_mm: float = 0.0
    inside: bool = False
    figures: dict[str, float] = field(default_factory=dict)
    warnings: tuple[str, ...] = ()
