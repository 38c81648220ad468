# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameters of cycles that make holes and of the patterns of holes, named as in a job file."""

from dataclasses import replace
from typing import Annotated, Any, Literal

from CNCStepper.cycles.parameter import (
    CUT,
    DEPTH,
    DIRECTION,
    FINISH_FEED,
    FINISH_STEPOVER,
    OFFSET,
    PATH,
    STEPOVER,
    Direction,
    Parameter,
    Parameters,
    Table,
)
from CNCStepper.quantities import (
    Angle,
    Bounds,
    Coordinate,
    Depth,
    DepthOr0,
    FeedOr0,
    Length,
    LengthOr0,
    ToolReference,
    Width,
    WidthOr0,
)

PLACES = "Places"
MOST_HOLES = 5_000
Point = tuple[Coordinate, Coordinate]
Count = Annotated[int, Bounds("count", most=MOST_HOLES)]
Order = Literal["short", "given"]
ORDER = Parameter(PATH, "Order", "The order in which the holes are made")
THROUGH = Parameter(CUT, "Beyond", "Extra depth, so that the tool comes out below")

CENTRE = Parameter(PLACES, "Centre", "The middle of the circle, from the work zero", (0.0, 0.0))
RADIUS = Parameter(PLACES, "Radius", "From the middle of the circle to the holes", 20.0)
COUNT = Parameter(PLACES, "Count", "How many holes", 6)
START_ANGLE = Parameter(
    PLACES, "Start angle", "From X to the first hole, counter-clockwise", 0.0, name="PlaceStartAngle"
)


class PointsParameters(Parameters):
    """The keys of holes at given points."""

    kind: Literal["points"]
    points_mm: Annotated[tuple[Point, ...], Parameter(PLACES, "Points", "One hole at each point", ((0.0, 0.0, 0.0),))]


class LineParameters(Parameters):
    """The keys of holes evenly spaced from `start_mm` to `end_mm`, both included."""

    kind: Literal["line"]
    start_mm: Annotated[
        Point, Parameter(PLACES, "First hole", "Where the row begins, from the work zero", (-30.0, 0.0))
    ]  # fmt: skip
    end_mm: Annotated[Point, Parameter(PLACES, "Last hole", "Where the row ends", (30.0, 0.0))]
    count: Annotated[Count, COUNT]


class GridCountParameters(Parameters):
    """The two values of a grid's count, which a window shows apart."""

    columns: Annotated[Count, Parameter(PLACES, "Columns", "How many holes along X", 4)]
    rows: Annotated[Count, Parameter(PLACES, "Rows", "How many holes along Y", 3)]


class GridParameters(Parameters):
    """The keys of rows along X and columns along Y from `origin_mm`, the grid turned about it counter-clockwise."""

    kind: Literal["grid"]
    origin_mm: Annotated[
        Point, Parameter(PLACES, "First hole", "The corner where the grid begins, from the work zero", (-30.0, -20.0))
    ]
    spacing_mm: Annotated[Point, Parameter(PLACES, "Spacing", "From hole to hole along X and along Y", (20.0, 20.0))]
    count: Annotated[tuple[Count, Count], Table(GridCountParameters)]
    rotation_deg: Annotated[Angle, Parameter(PLACES, "Rotation", "Of the grid about its first hole")] = 0.0


class BoltCircleParameters(Parameters):
    """The keys of holes evenly spaced all round a circle, counter-clockwise from `start_deg`."""

    kind: Literal["bolt_circle"]
    centre_mm: Annotated[Point, CENTRE]
    radius_mm: Annotated[Length, RADIUS]
    count: Annotated[Count, COUNT]
    start_deg: Annotated[Angle, START_ANGLE] = 0.0


class ArcParameters(Parameters):
    """The keys of holes on an arc from `start_deg` to `end_deg`, both included; counter-clockwise if it is larger."""

    kind: Literal["arc"]
    centre_mm: Annotated[Point, CENTRE]
    radius_mm: Annotated[Length, RADIUS]
    start_deg: Annotated[Angle, START_ANGLE]
    end_deg: Annotated[
        Angle, Parameter(PLACES, "End angle", "From X to the last hole", 90.0, name="PlaceEndAngle")
    ]  # fmt: skip
    count: Annotated[Count, COUNT]


PATTERNS = (BoltCircleParameters, GridParameters, LineParameters, ArcParameters, PointsParameters)


class HoleParameters(Parameters):
    """The keys of every cycle that makes holes at the places of a pattern."""

    tool: ToolReference
    pattern: Any
    offset_mm: Annotated[tuple[Coordinate, Coordinate], OFFSET] = (0.0, 0.0)


class DrillParameters(HoleParameters):
    """The keys of drilling.

    style: the canned cycle; peck_mm belongs to G83 and G73, dwell_s to G82. retract: "clearance" (G98) or "retract"
    (G99). order: "short" rapids or the pattern's own.
    """

    cycle: Literal["drill"] = "drill"
    depth_mm: Annotated[Depth, DEPTH]
    tip: Annotated[
        Literal["tip", "diameter"],
        Parameter(CUT, "Depth to", "Whether the depth is that of the point or of the full diameter", name="DepthOf"),
    ] = "tip"
    through_mm: Annotated[DepthOr0, THROUGH] = 0.0
    style: Annotated[Literal["G81", "G82", "G83", "G73"], Parameter(CUT, "Cycle", "How the drill goes down")] = "G81"
    peck_mm: Annotated[
        DepthOr0, Parameter(CUT, "Peck", "How deep one peck goes", 2.0, only=("style", ("G83", "G73")))
    ] = 0.0  # fmt: skip
    dwell_s: Annotated[
        float,
        Bounds("time", most=600.0, zero=True),
        Parameter(CUT, "Pause", "Seconds at the bottom", 0.5, only=("style", ("G82",))),
    ] = 0.0
    retract: Annotated[
        Literal["clearance", "retract"],
        Parameter(PATH, "Retract to", "The height of the rapids between holes: G98 or G99", name="RetractTo"),
    ] = "clearance"
    order: Annotated[Order, ORDER] = "short"


class BoreParameters(HoleParameters):
    """The keys of a helical bore.

    pitch_mm: less where the inner helix would be steeper than the tool's ramp_max_deg. finish_stepover_mm: what the
    last helix takes off the wall, 0 is none of its own.
    """

    cycle: Literal["bore"] = "bore"
    diameter_mm: Annotated[
        LengthOr0, Parameter(CUT, "Diameter", "Of the bores; 0: that of each circle of the drawing", 12.0)
    ] = 0.0
    depth_mm: Annotated[Depth, DEPTH]
    through_mm: Annotated[DepthOr0, THROUGH] = 0.0
    pitch_mm: Annotated[Width, Parameter(CUT, "Pitch", "How far one turn of the helix falls", 1.0)]
    stepover_mm: Annotated[
        WidthOr0,
        replace(
            STEPOVER,
            help="Stepover (ae): between neighbouring helices at most; 0: 0.4 of the tool's diameter",
            new=None,
        ),
    ] = 0.0
    finish_stepover_mm: Annotated[WidthOr0, replace(FINISH_STEPOVER, new=None)] = 0.0
    finish_feed_mm_min: Annotated[FeedOr0, FINISH_FEED] = 0.0
    direction: Annotated[Direction, DIRECTION] = "climb"
    order: Annotated[Order, ORDER] = "short"


class ThreadParameters(HoleParameters):
    """The keys of thread milling; the tool counts as its largest disc.

    passes: radially, in equal steps from the drilled hole (or the boss) to the thread's full depth.
    """

    cycle: Literal["thread"] = "thread"
    major_diameter_mm: Annotated[
        WidthOr0, Parameter(CUT, "Major", "The nominal diameter; 0: that of each circle of the drawing", 10.0)
    ] = 0.0
    minor_diameter_mm: Annotated[
        WidthOr0,
        Parameter(CUT, "Minor", "The diameter at the other end of the flanks; 0: that of a metric thread"),
    ] = 0.0
    pitch_mm: Annotated[Width, Parameter(CUT, "Pitch", "From one turn of the thread to the next", 1.5)]
    depth_mm: Annotated[Depth, DEPTH]
    side: Annotated[Literal["inside", "outside"], Parameter(CUT, "Side", "In holes, or round bosses", row=-1)] = (
        "inside"
    )
    hand: Annotated[Literal["right", "left"], Parameter(CUT, "Hand", "How the thread winds", row=-1)] = "right"
    passes: Annotated[
        int,
        Bounds("count", most=100),
        Parameter(CUT, "Passes", "In how many steps outwards", name="RadialPasses"),
    ] = 1
    direction: Annotated[Direction, DIRECTION] = "climb"
    order: Annotated[Order, ORDER] = "short"
