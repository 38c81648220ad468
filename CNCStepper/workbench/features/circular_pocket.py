# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_CircularPocket: from a drawing that holds one circle, or from numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from CNCStepper.cycles.pockets.pocket_parameters import CIRCLE, CircularPocketParameters
from CNCStepper.errors import GeometryError, Text
from CNCStepper.workbench.features.base import edit
from CNCStepper.workbench.features.cycle_operation import OPERATION, drawn
from CNCStepper.workbench.features.operation import Operation, the_drawing
from CNCStepper.workbench.features.parameters import PASSES, REST, properties_of
from CNCStepper.workbench.services.translation import later

if TYPE_CHECKING:
    from CNCStepper.workbench.drawings.ellipses import EllipseFound


class CircularPocket(Operation):
    """The proxy of a circular pocket; with a drawing its centre and radius follow the circle in it."""

    Type = "CNCStepper_CircularPocket"
    CYCLE = "circular_pocket"
    NO_DRAWING = later("by numbers")
    SHAPE = ("centre_mm", "radius_mm")
    PROPERTIES = (
        *OPERATION,
        *drawn(CIRCLE, later("A sketch or wire that holds one circle; without it the numbers count")),
        *properties_of(CircularPocketParameters),
        *PASSES,
        *REST,
    )

    @classmethod
    def look(cls, drawing: Any, picked: tuple[str, ...]) -> None:
        """Raise GeometryError unless the drawing holds one circle."""
        _circle_of(drawing, picked)

    def follow(self, obj: Any, origin_mm: tuple[float, ...]) -> None:
        """Take centre and radius from the drawing where there is one."""
        if pair := the_drawing(obj):
            found = _circle_of(*pair)
            x, y = found.centre_mm
            edit(obj, centre_mm=(x - origin_mm[0], y - origin_mm[1]), radius_mm=found.radius_x_mm)


def _circle_of(drawing: Any, picked: tuple[str, ...]) -> EllipseFound:
    from CNCStepper.workbench.drawings.ellipses import ellipse_of

    found = ellipse_of(drawing, picked)
    if abs(found.radius_x_mm - found.radius_y_mm) > 1e-6:
        raise GeometryError(
            "circle-missing",
            Text("the drawing '{drawing}' holds an ellipse and no circle", drawing=drawing.Label),
            advice="draw a circle, or cut it as an elliptical pocket",
        )
    return found
