# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Contour: along the lines of a drawing, on them or beside them, with tabs and leads."""

from __future__ import annotations

from typing import Any

from CNCStepper.cycles.contours.contour_parameters import LINES, ContourParameters
from CNCStepper.cycles.parameter import TABS
from CNCStepper.workbench.features.base import DISTANCE, ENUMERATION, INTEGER, Property, values
from CNCStepper.workbench.features.cycle_operation import OPERATION, drawn
from CNCStepper.workbench.features.operation import Operation, drawn_lines
from CNCStepper.workbench.features.parameters import LEVELS, RESULT, properties_of
from CNCStepper.workbench.services.translation import later

TABS_BY = Property(
    "tabs_by", "Tabs", ENUMERATION, TABS, later("Tabs"), later("Bridges that hold the part until it is broken out"),
    "none", choices=("none", "count", "spacing"),
)  # fmt: skip


class Contour(Operation):
    """The proxy of a contour of all chains of lines in a drawing."""

    Type = "CNCStepper_Contour"
    CYCLE = "contour"
    TABLES = ("tabs", "lead_in", "lead_out")
    OWN = ("tabs_by",)
    PROPERTIES = (
        *OPERATION,
        *drawn(LINES, later("The sketch, wires or faces to follow")),
        *properties_of(ContourParameters, TABS_BY),
        *LEVELS,
        Property("tabs", "TabsMade", INTEGER, RESULT, later("Tabs"), later("How many tabs hold the part"), 0,
                 output=True),
        Property("rest_mm", "RestCorner", DISTANCE, RESULT, later("Rest at most"),
                 later("The thickest material left in inner corners"), 0.0, output=True),
        Property("length_mm", "LineLength", DISTANCE, RESULT, later("Line length"), later("The length of all lines"),
                 0.0, output=True),
    )  # fmt: skip

    def cycle_values(self, obj: Any, origin_mm: tuple[float, ...]) -> dict[str, Any]:
        """Return the parameters and the drawings' curves."""
        curves = drawn_lines(obj, origin_mm, "choose a sketch, wires or faces for it").curves
        return {**self.given(values(obj)), "curves": tuple(each.curve for each in curves)}
