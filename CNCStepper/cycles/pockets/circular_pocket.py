# SPDX-License-Identifier: LGPL-2.1-or-later
"""The circular pocket: a pocket given by centre and radius, cleared in one spiral where nothing else is asked for."""

from __future__ import annotations

from typing import Literal

from CNCStepper.cycles.cycle import Answer, Setup
from CNCStepper.cycles.pockets.pocket import PatternName
from CNCStepper.cycles.pockets.shaped_pocket import ShapedPocket
from CNCStepper.geometry.curve import circle
from CNCStepper.quantities import Coordinate, Length
from CNCStepper.toolpath import TableBuilder


class CircularPocket(ShapedPocket):
    """Parameters of the circular pocket, named as in a job file."""

    cycle: Literal["circular_pocket"] = "circular_pocket"
    centre_mm: tuple[Coordinate, Coordinate] = (0.0, 0.0)
    radius_mm: Length
    pattern: PatternName = "spiral"

    def cut(self, setup: Setup, table: TableBuilder) -> Answer:
        """Append the pocket to `table`; raises CycleError before any row when it cannot be cut safely."""
        return self._as_pocket(circle(self.centre_mm, self.radius_mm)).cut(setup, table)
