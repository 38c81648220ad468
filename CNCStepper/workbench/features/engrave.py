# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Engrave: the tool's tip follows the lines of a drawing at one depth."""

from __future__ import annotations

from typing import Any

from CNCStepper.errors import CycleError
from CNCStepper.workbench.features.base import DISTANCE, INTEGER, Property
from CNCStepper.workbench.features.operation import CUT, OPERATION, RESULT, Operation, drawn, parameters
from CNCStepper.workbench.words import later

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
        Property("depth_mm", "Depth", DISTANCE, CUT, later("Depth"),
                 later("The depth below the top of the stock"), 1.0),
        Property("stepdown_mm", "Stepdown", DISTANCE, CUT, later("Stepdown ap"),
                 later("The depth of one pass at most; 0: all at once"), 0.0),
        Property("ap_mm", "StepdownUsed", DISTANCE, RESULT, later("Stepdown ap"),
                 later("ap, recalculated to whole passes"), 0.0, output=True),
        Property("levels", "Levels", INTEGER, RESULT, later("Levels"), later("How many passes in depth"), 0,
                 output=True),
        Property("length_mm", "LineLength", DISTANCE, RESULT, later("Line length"),
                 later("The length of all lines"), 0.0, output=True),
    )  # fmt: skip

    def cycle_values(self, obj: Any, origin_mm: tuple[float, ...]) -> dict[str, Any]:
        """Return the parameters and the drawing's curves."""
        from CNCStepper.workbench.curves import curves_of

        if obj.Drawing is None:
            raise CycleError(
                "drawing-missing",
                f"{obj.Label} has no drawing",
                advice="choose a sketch, wire, B-spline or freehand line for it",
            )
        curves = curves_of(obj.Drawing, origin_mm, float(obj.Tolerance))
        return {**parameters(obj), "curves": curves}
