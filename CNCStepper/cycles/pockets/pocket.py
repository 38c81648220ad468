# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pocket: any region with islands, cleared level by level by one of several patterns."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Annotated, Literal

from pydantic import Field

from CNCStepper.cycles.clearing.engagement.engagement_pattern import engagement_pattern
from CNCStepper.cycles.clearing.offset_pattern import offset
from CNCStepper.cycles.clearing.pattern import Pattern
from CNCStepper.cycles.clearing.spiral_pattern import spiral
from CNCStepper.cycles.clearing.zigzag_pattern import zigzag
from CNCStepper.cycles.cycle import Answer, Setup
from CNCStepper.cycles.parameter_types import CurveField
from CNCStepper.cycles.pockets.area_cycle import AreaCycle
from CNCStepper.quantities import MOST_ITEMS, Bounds, Turn
from CNCStepper.toolpath import TableBuilder

PatternName = Literal["offset", "zigzag", "spiral", "engagement"]
PATTERNS: dict[PatternName, Callable[[PocketCycle], Pattern]] = {
    "offset": lambda pocket: offset,
    "zigzag": lambda pocket: partial(zigzag, angle_deg=pocket.angle_deg),
    "spiral": lambda pocket: spiral,
    "engagement": lambda pocket: engagement_pattern(pocket.engagement_max_deg),
}


class PocketCycle(AreaCycle):
    """The keys of every pocket that a pattern clears.

    angle_deg: of the rows of the pattern "zigzag". engagement_max_deg: of the pattern "engagement".
    """

    pattern: PatternName = "offset"
    angle_deg: Turn = 0.0
    engagement_max_deg: Annotated[float, Bounds("angle", 20.0, 180.0)] = 60.0


class Pocket(PocketCycle):
    """Parameters of the pocket, named as in a job file: what lies in any outline and in no island is cut."""

    cycle: Literal["pocket"] = "pocket"
    outlines: tuple[CurveField, ...] = Field(min_length=1, max_length=MOST_ITEMS["areas"])
    islands: tuple[CurveField, ...] = Field(default=(), max_length=MOST_ITEMS["areas"])

    def cut(self, setup: Setup, table: TableBuilder) -> Answer:
        """Append the pocket to `table`; raises CycleError before any row when it cannot be cut safely."""
        return self._clear(self.outlines, self.islands, PATTERNS[self.pattern](self), setup, table)
