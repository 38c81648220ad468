# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameters of cutting parts out of sheet, named as in a job file.

A table that is left out has the values of the process (`process_rules.py`); one that is given has its own.
"""

from dataclasses import replace
from typing import Annotated, Any, Literal

from CNCStepper.cycles.contours.contour_parameters import IN, OUT, LeadParameters
from CNCStepper.cycles.parameter import CUT, OFFSET, PATH, TABS, TOLERANCE, Parameter, Parameters, Table
from CNCStepper.quantities import (
    Bounds,
    Coordinate,
    CutTolerance,
    DepthOr0,
    FeedOr0,
    LengthOr0,
    SpeedOr0,
    TimeOr0,
    ToolReference,
    Width,
    WidthOr0,
)

RULES = "Rules"
MOST_PASSES = 100
Share = Annotated[float, Bounds("share", 0.01, 1.0)]


class SmallHoleParameters(Parameters):
    """The keys of the rule for small holes; a hole is small where any of the three bounds says so.

    The torch goes off torch_off_mm before the cut closes and runs over_run_mm on without power.
    """

    diameter_mm: Annotated[
        WidthOr0, Parameter(RULES, "Holes below", "Holes of a smaller diameter are cut slowly; 0: none by diameter")
    ] = 32.0
    thickness_ratio: Annotated[
        float,
        Bounds("factor", 0.1, 100.0, zero=True),
        Parameter(RULES, "Below thickness times", "As a multiple of the thickness; 0: none by thickness"),
    ] = 0.0  # fmt: skip
    length_mm: Annotated[
        LengthOr0, Parameter(RULES, "Shorter than", "Holes with a shorter outline are cut slowly; 0: none by length")
    ] = 0.0
    feed_share: Annotated[Share, Parameter(RULES, "Feed of holes", "The share of the feed with which they are cut")] = (
        0.6
    )
    torch_off_mm: Annotated[
        WidthOr0, Parameter(RULES, "Torch off before", "How far before its end the cut runs on without power")
    ] = 0.0  # fmt: skip
    over_run_mm: Annotated[
        WidthOr0, Parameter(RULES, "Over-burn", "How far the torch runs on over the begin of the cut without power")
    ] = 4.0  # fmt: skip


class ArcRuleParameters(Parameters):
    """The keys of the rule for narrow arcs: those of a smaller radius are cut with a share of the feed."""

    radius_mm: Annotated[WidthOr0, Parameter(RULES, "Arcs below", "Arcs of a smaller radius are cut slowly; 0: none")]
    feed_share: Annotated[Share, Parameter(RULES, "Feed of arcs", "The share of the feed with which they are cut")] = (
        0.7
    )


class CornerRuleParameters(Parameters):
    """The keys of the rule for corners: near those that turn by more, the feed is lower."""

    angle_deg: Annotated[
        float,
        Bounds("angle", 1.0, 180.0, zero=True),
        Parameter(RULES, "Corners above", "Corners that turn by more are cut slowly; 0: none"),
    ]
    distance_mm: Annotated[Width, Parameter(RULES, "Corner distance", "How far before and behind a corner")] = 2.0
    feed_share: Annotated[Share, Parameter(RULES, "Feed at corners", "The share of the feed there")] = 0.5


class LoopParameters(Parameters):
    """The keys of loops in the scrap at outside corners that turn by more than angle_deg, so that they become sharp."""

    radius_mm: Annotated[Width, Parameter(RULES, "Loop radius", "The radius of loops at sharp outside corners")]
    angle_deg: Annotated[
        float,
        Bounds("angle", 10.0, 179.0),
        Parameter(RULES, "Loops above", "Outside corners that turn by more get a loop"),
    ] = 60.0


class MicroJointParameters(Parameters):
    """The keys of joints that hold a part: how many on each outline, or how far apart at most, and how wide."""

    count: Annotated[int, Bounds("count", 0, 1000), Parameter(TABS, "Count", "How many joints on each outline")] = 0
    spacing_mm: Annotated[LengthOr0, Parameter(TABS, "Spacing", "How far apart joints are at most")] = 0.0
    width_mm: Annotated[Width, Parameter(TABS, "Width", "How wide the material is that stays")] = 0.5


class PowerRampParameters(Parameters):
    """The keys of a laser's power ramp: behind the pierce it rises from begin_share to all of the power."""

    length_mm: Annotated[Width, Parameter(RULES, "Ramp length", "How far behind the pierce the power is full")]
    begin_share: Annotated[Share, Parameter(RULES, "Ramp begin", "The share of the power at the pierce")] = 0.5


class SheetParameters(Parameters):
    """The keys of cutting parts out of sheet.

    Closed curves that lie in each other are part and hole in turn. Open curves are cut on their line. `marks` are
    marked before anything is cut. Left out, `lead_in` and the rules are those of the process.
    """

    cycle: Literal["sheet_cut"] = "sheet_cut"
    tool: ToolReference = 1
    curves: Any
    marks: Any
    offset_mm: Annotated[tuple[Coordinate, Coordinate], OFFSET] = (0.0, 0.0)
    good_side: Annotated[
        Literal["right", "left"],
        Parameter(CUT, "Good side", "On which side of the cut the part lies, seen along it"),
    ] = "right"
    kerf_mm: Annotated[
        WidthOr0, Parameter(CUT, "Kerf", "The width of the cut; 0: that of the cut chart or the tool")
    ] = 0.0
    pierce_mm: Annotated[
        WidthOr0,
        Parameter(CUT, "Pierce distance", "How far a pierce stays from parts and cut edges; 0: that of the cut chart"),
    ] = 0.0
    pierce_delay_s: Annotated[
        TimeOr0, Parameter(CUT, "Pierce delay", "Time of the tool at rest with power; 0: from the cut chart")
    ] = 0.0
    depth_mm: Annotated[
        DepthOr0, Parameter(CUT, "Depth", "How deep a knife or point goes; 0: through the sheet, a point 0.2 mm")
    ] = 0.0  # fmt: skip
    passes: Annotated[
        int, Bounds("count", 1, MOST_PASSES), Parameter(CUT, "Passes", "How often each line is cut")
    ] = 1  # fmt: skip
    dynamic_power: Annotated[
        bool, Parameter(CUT, "Dynamic power", "Whether a laser's power follows its speed (M4)", False)
    ]  # fmt: skip
    lead_in: Annotated[Any, Table(LeadParameters, IN)]
    lead_out: Annotated[Any, Table(LeadParameters, OUT)]
    overcut_mm: Annotated[
        WidthOr0, Parameter(PATH, "Overcut", "How far a closed cut is followed with power beyond its begin")
    ] = 0.0  # fmt: skip
    blade_offset_mm: Annotated[
        WidthOr0, Parameter(PATH, "Blade offset", "How far a drag knife's edge trails behind its axis")
    ] = 0.0  # fmt: skip
    small_holes: Annotated[Any, Table(SmallHoleParameters)]
    arcs: Annotated[Any, Table(ArcRuleParameters)]
    corners: Annotated[Any, Table(CornerRuleParameters)]
    loops: Annotated[Any, Table(LoopParameters)]
    tabs: Annotated[Any, Table(MicroJointParameters)]
    power_ramp: Annotated[Any, Table(PowerRampParameters)]
    mark_power: Annotated[
        SpeedOr0, Parameter(RULES, "Marking power", "A laser's S word for marks; 0: a twentieth of its power")
    ] = 0.0
    mark_feed_mm_min: Annotated[
        FeedOr0, Parameter(RULES, "Marking feed", "The feed of marks; 0: that of the cut")
    ] = 0.0  # fmt: skip
    spot_below_mm: Annotated[
        WidthOr0, Parameter(RULES, "Spot holes below", "Holes of a smaller diameter get a spot at their centre, no cut")
    ] = 0.0
    spot_s: Annotated[TimeOr0, Parameter(RULES, "Spot time", "How long a spot has power")] = 0.2
    tolerance_mm: Annotated[CutTolerance, replace(TOLERANCE, help="How far the cut may be off the drawing")] = 0.01
