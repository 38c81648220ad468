# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Engrave: the tool's tip follows the lines of a drawing at one depth."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.features.base import DISTANCE, ENUMERATION, Property, values
from CNCStepper.workbench.features.common import CUT, LEVELS, RESULT
from CNCStepper.workbench.features.operation import OPERATION, Operation, drawn, drawn_lines
from CNCStepper.workbench.services.translation import later

LINES = later("Lines")


class Engrave(Operation):
    """The proxy of an engraving of a sketch, a Draft wire, a B-spline or a freehand line."""

    Type = "CNCStepper_Engrave"
    CYCLE = "engrave"
    PROPERTIES = (
        *OPERATION,
        *drawn(LINES, later("The sketch, wire, B-spline or freehand line to follow")),
        Property("tolerance_mm", "Tolerance", DISTANCE, LINES, later("Tolerance"),
                 later("How far the path may be off an ellipse or a B-spline; lines and arcs are exact"), 0.01),
        Property("simplify_mm", "Simplify", DISTANCE, LINES, later("Simplify"),
                 later("How far the cut line may leave the drawn one, to be of fewer moves; 0: not at all"), 0.0),
        Property("order", "Order", ENUMERATION, LINES, later("Order"), later("The order in which the lines are cut"),
                 "drawn", choices=("drawn", "short")),
        Property("depth_mm", "Depth", DISTANCE, CUT, later("Depth"),
                 later("The depth below the top of the stock"), 1.0),
        Property("stepdown_mm", "Stepdown", DISTANCE, CUT, later("Stepdown ap"),
                 later("The depth of one pass at most; 0: all at once"), 0.0),
        *LEVELS,
        Property("length_mm", "LineLength", DISTANCE, RESULT, later("Line length"),
                 later("The length of all lines"), 0.0, output=True),
    )  # fmt: skip

    def cycle_values(self, obj: Any, origin_mm: tuple[float, ...]) -> dict[str, Any]:
        """Return the parameters and the drawings' curves."""
        curves = drawn_lines(obj, origin_mm, "choose a sketch, wire, B-spline or freehand line for it").curves
        return {**self.given(values(obj)), "curves": tuple(each.curve for each in curves)}
