# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_CircularPocket: from a drawing that holds one circle, or from numbers."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from CNCStepper.errors import GeometryError, Text
from CNCStepper.workbench.features.base import DISTANCE, POSITION, Property, edit
from CNCStepper.workbench.features.common import ANY_POCKET, PATTERN
from CNCStepper.workbench.features.operation import OPERATION, Operation, drawn, the_drawing
from CNCStepper.workbench.services.translation import later

if TYPE_CHECKING:
    from CNCStepper.workbench.drawings.ellipses import EllipseFound

CIRCLE = later("Circle")
SPIRALLING = tuple(replace(entry, default="spiral") if entry is PATTERN else entry for entry in ANY_POCKET)


class CircularPocket(Operation):
    """The proxy of a circular pocket; with a drawing its centre and radius follow the circle in it."""

    Type = "CNCStepper_CircularPocket"
    CYCLE = "circular_pocket"
    NO_DRAWING = later("by numbers")
    SHAPE = ("centre_mm", "radius_mm")
    PROPERTIES = (
        *OPERATION,
        *drawn(CIRCLE, later("A sketch or wire that holds one circle; without it the numbers count")),
        Property("centre_mm", "Centre", POSITION, CIRCLE, later("Centre"), later("The centre, from the work zero"),
                 (0.0, 0.0), plane=True),
        Property("radius_mm", "Radius", DISTANCE, CIRCLE, later("Radius"), later("Half the width of the pocket"), 20.0),
        *SPIRALLING,
    )  # fmt: skip

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
