# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Engrave: the tool's tip follows the lines of a drawing at one depth."""

from __future__ import annotations

from typing import Any

from CNCStepper.cycles.contours.contour_parameters import LINES, EngraveParameters
from CNCStepper.workbench.features.base import DISTANCE, Property, values
from CNCStepper.workbench.features.cycle_operation import OPERATION, drawn
from CNCStepper.workbench.features.operation import Operation, drawn_lines
from CNCStepper.workbench.features.parameters import LEVELS, RESULT, properties_of
from CNCStepper.workbench.services.translation import later


class Engrave(Operation):
    """The proxy of an engraving of a sketch, a Draft wire, a B-spline or a freehand line."""

    Type = "CNCStepper_Engrave"
    CYCLE = "engrave"
    PROPERTIES = (
        *OPERATION,
        *drawn(LINES, later("The sketch, wire, B-spline or freehand line to follow")),
        *properties_of(EngraveParameters),
        *LEVELS,
        Property("length_mm", "LineLength", DISTANCE, RESULT, later("Line length"),
                 later("The length of all lines"), 0.0, output=True),
    )  # fmt: skip

    def cycle_values(self, obj: Any, origin_mm: tuple[float, ...]) -> dict[str, Any]:
        """Return the parameters and the drawings' curves."""
        curves = drawn_lines(obj, origin_mm, "choose a sketch, wire, B-spline or freehand line for it").curves
        return {**self.given(values(obj)), "curves": tuple(each.curve for each in curves)}
