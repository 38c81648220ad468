# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a turning cycle is given besides its own parameters, and what it answers."""

from __future__ import annotations

from dataclasses import dataclass, field

from CNCStepper.geometry.curve import Curve
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.tools.turning_tool import TurningTool


@dataclass(frozen=True)
class TurningSetup:
    """The tool, the stock and the speeds of one operation; lengths in mm in the part's coordinates.

    radius_mm, face_mm: of the raw bar and its end. bore_mm: diameter of what is hollow already, 0 for none. start: z
    and radius at which the tool stands before and after the operation. feed_mm_rev, rpm: of the operation. machine:
    whose axes must follow the spindle.
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

    @property
    def feed_mm_min(self) -> float:
        """The feed at the spindle's speed."""
        return self.feed_mm_rev * self.rpm


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
