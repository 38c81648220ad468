# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pocket: any region with islands, cleared level by level by one of several patterns."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from pydantic import Field

from CNCStepper.cycles.clearing.engagement.bounded_engagement_pattern import engagement_pattern
from CNCStepper.cycles.clearing.offset_pattern import offset
from CNCStepper.cycles.clearing.pattern import Pattern
from CNCStepper.cycles.clearing.spiral_pattern import spiral
from CNCStepper.cycles.clearing.zigzag_pattern import zigzag
from CNCStepper.cycles.cycle import Answer, Setup
from CNCStepper.cycles.parameter_types import CurveField
from CNCStepper.cycles.pockets.area_cycle import AreaCycle
from CNCStepper.cycles.pockets.pocket_parameters import PatternName, PatternParameters, PocketParameters
from CNCStepper.quantities import MOST_ITEMS
from CNCStepper.toolpath import TableBuilder

PATTERNS: dict[PatternName, Callable[[PocketCycle], Pattern]] = {
    "offset": lambda pocket: offset,
    "zigzag": lambda pocket: partial(zigzag, angle_deg=pocket.angle_deg),
    "spiral": lambda pocket: spiral,
    "engagement": lambda pocket: engagement_pattern(pocket.engagement_max_deg),
}


class PocketCycle(PatternParameters, AreaCycle):
    """A pocket that a pattern clears."""


class Pocket(PocketParameters, PocketCycle):
    """A pocket that can be cut: what lies in any outline and in no island."""

    outlines: tuple[CurveField, ...] = Field(min_length=1, max_length=MOST_ITEMS["areas"])
    islands: tuple[CurveField, ...] = Field(default=(), max_length=MOST_ITEMS["areas"])

    def cut(self, setup: Setup, table: TableBuilder) -> Answer:
        """Append the pocket to `table`; raises CycleError before any row when it cannot be cut safely."""
        return self._clear(self.outlines, self.islands, PATTERNS[self.pattern](self), setup, table)
