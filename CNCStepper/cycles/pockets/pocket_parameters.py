# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameters of pockets of any shape, named as in a job file."""

from typing import Annotated, Literal

from CNCStepper.cycles.parameter import (
    CUT,
    DEPTH,
    DIRECTION,
    ENTRY,
    ENTRY_ANGLE,
    FINISH_FEED,
    FINISH_STEPDOWN,
    FINISH_STEPOVER,
    OFFSET,
    PATH,
    PATTERN,
    PATTERN_ANGLE,
    STEPDOWN,
    STEPOVER,
    STOCK_TO_LEAVE,
    TOLERANCE,
    Direction,
    EntryName,
    Parameter,
    Parameters,
)
from CNCStepper.quantities import (
    Angle,
    Bounds,
    Coordinate,
    CutTolerance,
    Depth,
    DepthOr0,
    EntryAngle,
    FeedOr0,
    Length,
    LengthOr0,
    ToolReference,
    Turn,
    Width,
    WidthOr0,
)

RECTANGLE, CIRCLE, ELLIPSE = "Rectangle", "Circle", "Ellipse"
CENTRE = "The centre, from the work zero"
PatternName = Literal["offset", "zigzag", "spiral", "engagement"]


class AreaParameters(Parameters):
    """The keys of every cycle that clears an area.

    depth_mm is ap_total, stepdown_mm ap, stepover_mm ae, finish_stepdown_mm ap_acab and finish_stepover_mm ae_acab:
    what the pass along the wall takes, 0 for none. offset_mm moves the drawn curves.
    """

    tool: ToolReference
    depth_mm: Annotated[Depth, DEPTH]
    stepdown_mm: Annotated[Depth, STEPDOWN]
    stepover_mm: Annotated[Width, STEPOVER]
    finish_stepdown_mm: Annotated[DepthOr0, FINISH_STEPDOWN] = 0.0
    finish_stepover_mm: Annotated[WidthOr0, FINISH_STEPOVER] = 0.0
    finish_feed_mm_min: Annotated[FeedOr0, FINISH_FEED] = 0.0
    stock_to_leave_mm: Annotated[WidthOr0, STOCK_TO_LEAVE] = 0.0
    entry: Annotated[EntryName, ENTRY] = "helix"
    entry_angle_deg: Annotated[EntryAngle, ENTRY_ANGLE] = 3.0
    direction: Annotated[Direction, DIRECTION] = "climb"
    tolerance_mm: Annotated[CutTolerance, TOLERANCE] = 0.01
    offset_mm: Annotated[tuple[Coordinate, Coordinate], OFFSET] = (0.0, 0.0)


class PatternParameters(AreaParameters):
    """The keys of every pocket that a pattern clears."""

    pattern: Annotated[PatternName, PATTERN] = "offset"
    angle_deg: Annotated[Turn, PATTERN_ANGLE] = 0.0
    engagement_max_deg: Annotated[
        float,
        Bounds("angle", 20.0, 180.0),
        Parameter(CUT, "Engagement", "How much of the rim may be in the material at most, as an angle",
                  only=("pattern", ("engagement",))),
    ] = 60.0  # fmt: skip


class PocketParameters(PatternParameters):
    """The keys of a pocket: what lies in any outline and in no island is cut."""

    cycle: Literal["pocket"] = "pocket"


class RectangularPocketParameters(PatternParameters):
    """The keys of a rectangular pocket; the corners are those before it is rotated."""

    cycle: Literal["rectangular_pocket"] = "rectangular_pocket"
    corner_a_mm: Annotated[
        tuple[Coordinate, Coordinate],
        Parameter(RECTANGLE, "First corner", "One end of the diagonal, from the work zero", (-30.0, -20.0)),
    ]
    corner_b_mm: Annotated[
        tuple[Coordinate, Coordinate],
        Parameter(RECTANGLE, "Other corner", "The other end of the diagonal, before the rectangle is rotated",
                  (30.0, 20.0)),
    ]  # fmt: skip
    corner_radius_mm: Annotated[
        LengthOr0,
        Parameter(RECTANGLE, "Corner radius", "Of the corners seen from above; 0: as round as the tool"),
    ] = 0.0
    rotation_deg: Annotated[
        Turn, Parameter(RECTANGLE, "Rotation", "About the first corner, counter-clockwise")
    ] = 0.0  # fmt: skip


class CircularPocketParameters(PatternParameters):
    """The keys of a circular pocket."""

    cycle: Literal["circular_pocket"] = "circular_pocket"
    centre_mm: Annotated[tuple[Coordinate, Coordinate], Parameter(CIRCLE, "Centre", CENTRE)] = (0.0, 0.0)
    radius_mm: Annotated[Length, Parameter(CIRCLE, "Radius", "Half the width of the pocket", 20.0)]
    pattern: Annotated[PatternName, PATTERN] = "spiral"


class EllipticalPocketParameters(Parameters):
    """The keys of an elliptical pocket.

    depth_mm is ap_total, stepdown_mm ap, stepover_mm ae, finish_stepdown_mm ap_acab and finish_stepover_mm ae_acab;
    rotation_deg turns the ellipse counter-clockwise about its centre. stock_to_leave_mm stays on the wall all round.
    """

    cycle: Literal["elliptical_pocket"] = "elliptical_pocket"
    tool: ToolReference
    centre_mm: Annotated[tuple[Coordinate, Coordinate], Parameter(ELLIPSE, "Centre", CENTRE)] = (0.0, 0.0)
    radius_x_mm: Annotated[
        Length, Parameter(ELLIPSE, "Radius x", "Half the width along the ellipse's first axis", 40.0)
    ]
    radius_y_mm: Annotated[Length, Parameter(ELLIPSE, "Radius y", "Half the width along its second axis", 25.0)]
    rotation_deg: Annotated[Angle, Parameter(ELLIPSE, "Rotation", "From X to the ellipse's first axis")] = 0.0
    depth_mm: Annotated[Depth, DEPTH]
    stepdown_mm: Annotated[Depth, STEPDOWN]
    stepover_mm: Annotated[Width, STEPOVER]
    finish_stepdown_mm: Annotated[DepthOr0, FINISH_STEPDOWN] = 0.0
    finish_stepover_mm: Annotated[WidthOr0, FINISH_STEPOVER] = 0.0
    finish_feed_mm_min: Annotated[FeedOr0, FINISH_FEED] = 0.0
    stock_to_leave_mm: Annotated[WidthOr0, STOCK_TO_LEAVE] = 0.0
    method: Annotated[
        Literal["tolerance", "dda"], Parameter(PATH, "Method", "Arcs within a tolerance, or the published points")
    ] = "tolerance"
    tolerance_mm: Annotated[CutTolerance, TOLERANCE] = 0.01
    resolution_mm: Annotated[
        float,
        Bounds("tolerance", 0.001),
        Parameter(PATH, "Resolution", "The step of the published method", only=("method", ("dda",))),
    ] = 0.05
    entry: Annotated[EntryName, ENTRY] = "helix"
    entry_angle_deg: Annotated[EntryAngle, ENTRY_ANGLE] = 3.0
    direction: Annotated[Direction, DIRECTION] = "climb"
