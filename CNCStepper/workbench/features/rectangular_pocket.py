# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_RectangularPocket: from a drawing that holds one rectangle, or by its diagonal."""

from __future__ import annotations

from typing import Any

from CNCStepper.cycles.pockets.pocket_parameters import RECTANGLE, RectangularPocketParameters
from CNCStepper.workbench.features.base import edit
from CNCStepper.workbench.features.cycle_operation import OPERATION, drawn
from CNCStepper.workbench.features.operation import Operation, the_drawing
from CNCStepper.workbench.features.parameters import PASSES, REST, properties_of
from CNCStepper.workbench.services.translation import later


class RectangularPocket(Operation):
    """The proxy of a rectangular pocket; with a drawing all that makes its shape follows the rectangle in it."""

    Type = "CNCStepper_RectangularPocket"
    CYCLE = "rectangular_pocket"
    NO_DRAWING = later("by numbers")
    SHAPE = ("corner_a_mm", "corner_b_mm", "corner_radius_mm", "rotation_deg")
    PROPERTIES = (
        *OPERATION,
        *drawn(RECTANGLE, later("A sketch or wire that holds one rectangle; without it the numbers count")),
        *properties_of(RectangularPocketParameters),
        *PASSES,
        *REST,
    )

    @classmethod
    def look(cls, drawing: Any, picked: tuple[str, ...]) -> None:
        """Raise GeometryError unless the drawing holds one rectangle."""
        from CNCStepper.workbench.drawings.rectangles import rectangle_of

        rectangle_of(drawing, picked)

    def follow(self, obj: Any, origin_mm: tuple[float, ...]) -> None:
        """Take diagonal, corner radius and rotation from the drawing where there is one."""
        if not (pair := the_drawing(obj)):
            return
        from CNCStepper.workbench.drawings.rectangles import rectangle_of

        found = rectangle_of(*pair)
        x, y = found.corner_mm[0] - origin_mm[0], found.corner_mm[1] - origin_mm[1]
        edit(
            obj,
            corner_a_mm=(x, y),
            corner_b_mm=(x + found.size_mm[0], y + found.size_mm[1]),
            corner_radius_mm=found.corner_radius_mm,
            rotation_deg=found.rotation_deg,
        )
