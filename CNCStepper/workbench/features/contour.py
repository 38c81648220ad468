# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Contour: along the lines of a drawing, on them or beside them, with tabs and leads."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.features.base import ANGLE, DISTANCE, ENUMERATION, INTEGER, Property, values
from CNCStepper.workbench.features.common import (
    CUT,
    DEPTH,
    DIRECTION,
    FINISHING,
    LEVELS,
    PATH,
    RESULT,
    STEPDOWN,
    STOCK_TO_LEAVE,
    TOLERANCE,
)
from CNCStepper.workbench.features.operation import OPERATION, Operation, drawn, drawn_lines
from CNCStepper.workbench.services.translation import later

TABS, LEADS = later("Tabs"), later("Leads")
SIDES = ("outside", "inside", "on", "left", "right")
WITH_TABS = ("tabs_by", ("count", "spacing"))


IN, OUT = "lead_in_kind", "lead_out_kind"
RADIUS = later("The radius of the lead's arc")
LENGTH = later("The length of the lead's line")
ANGLE_TEXT = later("How far an arc turns, or how far a line leans away from the contour")


class Contour(Operation):
    """The proxy of a contour of all chains of lines in a drawing."""

    Type = "CNCStepper_Contour"
    CYCLE = "contour"
    TABLES = ("tabs", "lead_in", "lead_out")
    OWN = ("tabs_by",)
    PROPERTIES = (
        *OPERATION,
        *drawn(later("Lines"), later("The sketch, wires or faces whose lines are followed")),
        Property("side", "Side", ENUMERATION, CUT, later("Side"), later("On which side of the lines the tool runs"),
                 "outside", choices=SIDES),
        DEPTH,
        STEPDOWN,
        DIRECTION,
        Property("tabs_by", "Tabs", ENUMERATION, TABS, later("Tabs"),
                 later("Bridges that hold the part until it is broken out"), "none",
                 choices=("none", "count", "spacing")),
        Property("tabs_count", "TabsCount", INTEGER, TABS, later("Count"), later("How many tabs on each line"), 4,
                 only=("tabs_by", ("count",))),
        Property("tabs_spacing_mm", "TabsSpacing", DISTANCE, TABS, later("Spacing"),
                 later("How far apart tabs are at most"), 50.0, only=("tabs_by", ("spacing",))),
        Property("tabs_width_mm", "TabsWidth", DISTANCE, TABS, later("Width"), later("How wide a tab is at its top"),
                 6.0, only=WITH_TABS),
        Property("tabs_height_mm", "TabsHeight", DISTANCE, TABS, later("Height"),
                 later("How high a tab is above the bottom of the cut"), 1.5, only=WITH_TABS),
        Property(IN, "LeadInKind", ENUMERATION, LEADS, later("Lead-in"), later("How the tool comes to the contour"),
                 "none", choices=("none", "line", "arc")),
        Property("lead_in_radius_mm", "LeadInRadius", DISTANCE, LEADS, later("Radius in"), RADIUS, 3.0,
                 only=(IN, ("arc",))),
        Property("lead_in_length_mm", "LeadInLength", DISTANCE, LEADS, later("Length in"), LENGTH, 3.0,
                 only=(IN, ("line",))),
        Property("lead_in_angle_deg", "LeadInAngle", ANGLE, LEADS, later("Angle in"), ANGLE_TEXT, 90.0,
                 only=(IN, ("line", "arc"))),
        Property(OUT, "LeadOutKind", ENUMERATION, LEADS, later("Lead-out"), later("How the tool leaves the contour"),
                 "none", choices=("none", "line", "arc")),
        Property("lead_out_radius_mm", "LeadOutRadius", DISTANCE, LEADS, later("Radius out"), RADIUS, 3.0,
                 only=(OUT, ("arc",))),
        Property("lead_out_length_mm", "LeadOutLength", DISTANCE, LEADS, later("Length out"), LENGTH, 3.0,
                 only=(OUT, ("line",))),
        Property("lead_out_angle_deg", "LeadOutAngle", ANGLE, LEADS, later("Angle out"), ANGLE_TEXT, 90.0,
                 only=(OUT, ("line", "arc"))),
        *FINISHING,
        STOCK_TO_LEAVE,
        Property("ramp_deg", "Ramp", ANGLE, PATH, later("Ramp"),
                 later("How steeply the tool goes down along the line; 0: straight down"), 0.0),
        Property("overcut_mm", "Overcut", DISTANCE, PATH, later("Overcut"),
                 later("How far a closed line is followed beyond its begin"), 0.0),
        Property("dogbones", "Dogbones", ENUMERATION, PATH, later("Dog-bones"),
                 later("Whether inner corners are opened, so that a square corner fits in"), "none",
                 choices=("none", "corner", "side")),
        Property("kerf_mm", "Kerf", DISTANCE, PATH, later("Kerf"),
                 later("The width of the cut where it is not the tool's diameter; 0: the tool's own"), 0.0),
        TOLERANCE,
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
