# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Engrave: the tool's tip follows the lines of a drawing at one depth."""

from __future__ import annotations

from typing import Any

from CNCStepper.errors import CycleError
from CNCStepper.workbench.features.base import DISTANCE, INTEGER, Property
from CNCStepper.workbench.features.operation import OPERATION, Operation, drawn, parameters


class Engrave(Operation):
    """The proxy of an engraving of a sketch, a Draft wire, a B-spline or a freehand line."""

    Type = "CNCStepper_Engrave"
    CYCLE = "engrave"
    PROPERTIES = (
        *OPERATION,
        *drawn("Lines", "The sketch, wire, B-spline or freehand line to follow"),
        Property("tolerance_mm", "Tolerance", DISTANCE, "Lines",
                 "How far the path may be off an ellipse or a B-spline; lines and arcs are exact", 0.01),
        Property("depth_mm", "Depth", DISTANCE, "Cut", "The depth below the top of the stock", 1.0),
        Property("stepdown_mm", "Stepdown", DISTANCE, "Cut", "The depth of one pass at most; 0: all at once", 0.0),
        Property("ap_mm", "StepdownUsed", DISTANCE, "Result", "ap, recalculated to whole passes", 0.0, output=True),
        Property("levels", "Levels", INTEGER, "Result", "How many passes in depth", 0, output=True),
        Property("length_mm", "LineLength", DISTANCE, "Result", "The length of all lines", 0.0, output=True),
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
