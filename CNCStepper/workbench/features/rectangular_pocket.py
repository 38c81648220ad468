# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_RectangularPocket: from a drawing that holds one rectangle, or by its diagonal."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.features.base import ANGLE, DISTANCE, POSITION, Property, edit
from CNCStepper.workbench.features.common import ANY_POCKET
from CNCStepper.workbench.features.operation import OPERATION, Operation, drawn, the_drawing
from CNCStepper.workbench.services.translation import later

RECTANGLE = later("Rectangle")


class RectangularPocket(Operation):
    """The proxy of a rectangular pocket; with a drawing all that makes its shape follows the rectangle in it."""

    Type = "CNCStepper_RectangularPocket"
    CYCLE = "rectangular_pocket"
    NO_DRAWING = later("by numbers")
    SHAPE = ("corner_a_mm", "corner_b_mm", "corner_radius_mm", "rotation_deg")
    PROPERTIES = (
        *OPERATION,
        *drawn(RECTANGLE, later("A sketch or wire that holds one rectangle; without it the numbers count")),
        Property("corner_a_mm", "CornerA", POSITION, RECTANGLE, later("First corner"),
                 later("One end of the diagonal, from the work zero"), (-30.0, -20.0), plane=True),
        Property("corner_b_mm", "CornerB", POSITION, RECTANGLE, later("Other corner"),
                 later("The other end of the diagonal, before the rectangle is rotated"), (30.0, 20.0), plane=True),
        Property("corner_radius_mm", "CornerRadius", DISTANCE, RECTANGLE, later("Corner radius"),
                 later("Of the corners seen from above; 0: as round as the tool"), 0.0),
        Property("rotation_deg", "Rotation", ANGLE, RECTANGLE, later("Rotation"),
                 later("About the first corner, counter-clockwise"), 0.0),
        *ANY_POCKET,
    )  # fmt: skip

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
