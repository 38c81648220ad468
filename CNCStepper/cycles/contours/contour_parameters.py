# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameters of contours and engravings, named as in a job file."""

from dataclasses import replace
from typing import Annotated, Any, Literal

from CNCStepper.cycles.parameter import (
    CUT,
    DEPTH,
    DIRECTION,
    FINISH_FEED,
    FINISH_STEPDOWN,
    FINISH_STEPOVER,
    LEADS,
    OFFSET,
    PATH,
    STEPDOWN,
    STOCK_TO_LEAVE,
    TABS,
    TOLERANCE,
    Direction,
    Parameter,
    Parameters,
    Table,
)
from CNCStepper.quantities import (
    Bounds,
    Coordinate,
    CutTolerance,
    Depth,
    DepthOr0,
    FeedOr0,
    LengthOr0,
    ToolReference,
    Width,
    WidthOr0,
)

LINES = "Lines"
MOST_TABS = 1000  # on one contour
WITH_TABS = ("by", ("count", "spacing"))  # "by" is a choice of the window: a job file has one of the two keys
Side = Literal["on", "inside", "outside", "left", "right"]
Dogbones = Literal["none", "corner", "side"]


class TabParameters(Parameters):
    """The keys of bridges that hold a part: how many on each contour, or how far apart at most.

    width_mm is what stays between the two cuts beside a tab; height_mm is measured from the contour's depth upwards.
    """

    count: Annotated[
        int,
        Bounds("count", 0, MOST_TABS),
        Parameter(TABS, "Count", "How many tabs on each line", 4, only=("by", ("count",))),
    ] = 0
    spacing_mm: Annotated[
        LengthOr0, Parameter(TABS, "Spacing", "How far apart tabs are at most", 50.0, only=("by", ("spacing",)))
    ] = 0.0
    width_mm: Annotated[Width, Parameter(TABS, "Width", "How wide a tab is at its top", 6.0, only=WITH_TABS)]
    height_mm: Annotated[
        Depth, Parameter(TABS, "Height", "How high a tab is above the bottom of the cut", 1.5, only=WITH_TABS)
    ]


class LeadParameters(Parameters):
    """The keys of a lead-in or lead-out, in the scrap beside the contour.

    A line of length_mm meets the contour at angle_deg (90: square to it); an arc of radius_mm meets it along its
    tangent and turns by angle_deg.
    """

    kind: Annotated[Literal["none", "line", "arc"], Parameter(LEADS, "", "How the tool comes or leaves")] = "none"
    radius_mm: Annotated[
        WidthOr0, Parameter(LEADS, "", "The radius of the lead's arc", 3.0, only=("kind", ("arc",)))
    ] = 0.0  # fmt: skip
    length_mm: Annotated[
        WidthOr0, Parameter(LEADS, "", "The length of the lead's line", 3.0, only=("kind", ("line",)))
    ] = 0.0  # fmt: skip
    angle_deg: Annotated[
        float,
        Bounds("angle", 0.01, 180.0),
        Parameter(LEADS, "", "How far an arc turns, or how far a line leans away from the contour",
                  only=("kind", ("line", "arc"))),
    ] = 90.0  # fmt: skip


IN = {
    "kind": ("Lead-in", "How the tool comes to the contour"),
    "radius_mm": ("Radius in", ""),
    "length_mm": ("Length in", ""),
    "angle_deg": ("Angle in", ""),
}
OUT = {
    "kind": ("Lead-out", "How the tool leaves the contour"),
    "radius_mm": ("Radius out", ""),
    "length_mm": ("Length out", ""),
    "angle_deg": ("Angle out", ""),
}


class ContourParameters(Parameters):
    """The keys of a contour.

    side: left and right are seen along an open curve. Closed outlines that lie in each other are part and hole in turn.
    """

    cycle: Literal["contour"] = "contour"
    tool: ToolReference
    curves: Any
    offset_mm: Annotated[tuple[Coordinate, Coordinate], OFFSET] = (0.0, 0.0)
    side: Annotated[
        Side,
        Parameter(CUT, "Side", "On which side of the lines the tool runs",
                  choices=("outside", "inside", "on", "left", "right")),
    ] = "outside"  # fmt: skip
    depth_mm: Annotated[Depth, DEPTH]
    stepdown_mm: Annotated[DepthOr0, STEPDOWN] = 0.0
    finish_stepdown_mm: Annotated[DepthOr0, FINISH_STEPDOWN] = 0.0
    finish_stepover_mm: Annotated[WidthOr0, FINISH_STEPOVER] = 0.0
    finish_feed_mm_min: Annotated[FeedOr0, FINISH_FEED] = 0.0
    stock_to_leave_mm: Annotated[WidthOr0, STOCK_TO_LEAVE] = 0.0
    direction: Annotated[Direction, DIRECTION] = "climb"
    ramp_deg: Annotated[
        float,
        Bounds("slope", 0.1, 45.0, zero=True),
        Parameter(PATH, "Ramp", "How steeply the tool goes down along the line; 0: straight down"),
    ] = 0.0
    tabs: Annotated[Any, Table(TabParameters)]
    lead_in: Annotated[Any, Table(LeadParameters, IN)]
    lead_out: Annotated[Any, Table(LeadParameters, OUT)]
    overcut_mm: Annotated[
        WidthOr0, Parameter(PATH, "Overcut", "How far a closed line is followed beyond its begin")
    ] = 0.0  # fmt: skip
    dogbones: Annotated[
        Dogbones,
        Parameter(PATH, "Dog-bones", "Whether inner corners are opened, so that a square corner fits in"),
    ] = "none"
    kerf_mm: Annotated[
        WidthOr0,
        Parameter(PATH, "Kerf", "The width of the cut where it is not the tool's diameter; 0: the tool's own"),
    ] = 0.0
    tolerance_mm: Annotated[CutTolerance, TOLERANCE] = 0.01


class EngraveParameters(Parameters):
    """The keys of an engraving; `curves` are in drawing order.

    A curve with `closed` runs back to its first point. simplify_mm: what is cut becomes the fewest lines, or lines and
    arcs. order "short" takes the curves, and open ones from either end, so that rapids are short.
    """

    cycle: Literal["engrave"] = "engrave"
    tool: ToolReference
    curves: Any
    offset_mm: Annotated[tuple[Coordinate, Coordinate], OFFSET] = (0.0, 0.0)
    depth_mm: Annotated[Depth, replace(DEPTH, new=1.0)]
    stepdown_mm: Annotated[
        DepthOr0, replace(STEPDOWN, help="Stepdown (ap): the depth of one pass at most; 0: all at once", new=None)
    ] = 0.0  # fmt: skip
    closed: Annotated[bool, Parameter("", "", "Whether each line must end where it begins")]
    simplify_mm: Annotated[
        WidthOr0,
        Parameter(LINES, "Simplify",
                  "Tolerance of the cut line, which reduces the number of moves; 0: none", row=1),
    ] = 0.0  # fmt: skip
    tolerance_mm: Annotated[
        float,
        Bounds("tolerance", most=1.0),
        Parameter(LINES, "Tolerance", "How far the path may be off an ellipse or a B-spline; lines and arcs are exact"),
    ] = 0.01
    order: Annotated[
        Literal["drawn", "short"], Parameter(LINES, "Order", "The order in which the lines are cut", row=1)
    ] = "drawn"
