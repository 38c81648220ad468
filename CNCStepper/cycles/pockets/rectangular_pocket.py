# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rectangular pocket: given by the corners of its diagonal, as the machine's own cycle of part C.

  +-----------B        rotation_deg turns it counter-clockwise about A. Corners sharper than the tool
 /           /         stay as rest corners; the answer says how many there are and how thick they are.
A-----------+
"""

from __future__ import annotations

from CNCStepper.cycles.cycle import Answer, Setup
from CNCStepper.cycles.pockets.pocket_parameters import RectangularPocketParameters
from CNCStepper.cycles.pockets.shaped_pocket import ShapedPocket
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.shapes.rectangle import rectangle
from CNCStepper.toolpath import TableBuilder


class RectangularPocket(RectangularPocketParameters, ShapedPocket):
    """A rectangular pocket that can be cut."""

    def outline(self) -> Curve:
        """Return the rectangle, turned about its first corner; `offset_mm` moves it further."""
        x, y = self.corner_a_mm
        drawn = rectangle(self.corner_a_mm, self.corner_b_mm, self.corner_radius_mm)
        return drawn.moved(-x, -y).rotated(self.rotation_deg).moved(x, y)

    def cut(self, setup: Setup, table: TableBuilder) -> Answer:
        """Append the pocket to `table`; raises CycleError before any row when it cannot be cut safely."""
        return self._as_pocket(self.outline()).cut(setup, table)
