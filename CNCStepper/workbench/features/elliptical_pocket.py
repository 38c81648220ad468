# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_EllipticalPocket: from a drawing that holds one ellipse, or from numbers."""

from __future__ import annotations

from typing import Any

from CNCStepper.cycles.pockets.pocket_parameters import ELLIPSE, EllipticalPocketParameters
from CNCStepper.workbench.features.base import DISTANCE, Property, edit
from CNCStepper.workbench.features.cycle_operation import OPERATION, drawn
from CNCStepper.workbench.features.operation import Operation, the_drawing
from CNCStepper.workbench.features.parameters import PASSES, RESULT, properties_of
from CNCStepper.workbench.services.translation import later


class EllipticalPocket(Operation):
    """The proxy of an elliptical pocket; with a drawing its centre, radii and rotation follow the ellipse in it."""

    Type = "CNCStepper_EllipticalPocket"
    CYCLE = "elliptical_pocket"
    NO_DRAWING = later("by numbers")
    SHAPE = ("centre_mm", "radius_x_mm", "radius_y_mm", "rotation_deg")
    PROPERTIES = (
        *OPERATION,
        *drawn(ELLIPSE, later("A sketch or wire that holds one ellipse; without it the numbers count")),
        *properties_of(EllipticalPocketParameters),
        *PASSES,
        Property("unreachable_mm", "Unreachable", DISTANCE, RESULT, later("Unreachable"),
                 later("Material that a round tool leaves at the ends of the long axis"), 0.0, output=True),
    )  # fmt: skip

    @classmethod
    def look(cls, drawing: Any, picked: tuple[str, ...]) -> None:
        """Raise GeometryError unless the drawing holds one ellipse."""
        from CNCStepper.workbench.drawings.ellipses import ellipse_of

        ellipse_of(drawing, picked)

    def follow(self, obj: Any, origin_mm: tuple[float, ...]) -> None:
        """Take centre, radii and rotation from the drawing where there is one."""
        if not (pair := the_drawing(obj)):
            return
        from CNCStepper.workbench.drawings.ellipses import ellipse_of

        ellipse = ellipse_of(*pair)
        x, y = ellipse.centre_mm
        edit(
            obj,
            centre_mm=(x - origin_mm[0], y - origin_mm[1]),
            radius_x_mm=ellipse.radius_x_mm,
            radius_y_mm=ellipse.radius_y_mm,
            rotation_deg=ellipse.rotation_deg,
        )
