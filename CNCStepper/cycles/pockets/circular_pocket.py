# SPDX-License-Identifier: LGPL-2.1-or-later
"""The circular pocket: a pocket given by centre and radius, cleared in one spiral where nothing else is asked for."""

from __future__ import annotations

from CNCStepper.cycles.cycle import Answer, Setup
from CNCStepper.cycles.pockets.pocket_parameters import CircularPocketParameters
from CNCStepper.cycles.pockets.shaped_pocket import ShapedPocket
from CNCStepper.geometry.curve import circle
from CNCStepper.toolpath import TableBuilder


class CircularPocket(CircularPocketParameters, ShapedPocket):
    """A circular pocket that can be cut."""

    def cut(self, setup: Setup, table: TableBuilder) -> Answer:
        """Append the pocket to `table`; raises CycleError before any row when it cannot be cut safely."""
        return self._as_pocket(circle(self.centre_mm, self.radius_mm)).cut(setup, table)
