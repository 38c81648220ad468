# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameters of facing, named as in a job file."""

from dataclasses import replace
from typing import Annotated, Any, Literal

from CNCStepper.cycles.parameter import (
    DEPTH,
    DIRECTION,
    ENTRY,
    ENTRY_ANGLE,
    FINISH_FEED,
    FINISH_STEPDOWN,
    OFFSET,
    PATH,
    PATTERN,
    PATTERN_ANGLE,
    STEPDOWN,
    STEPOVER,
    TOLERANCE,
    Direction,
    EntryName,
    Parameter,
    Parameters,
)
from CNCStepper.quantities import (
    Coordinate,
    CutTolerance,
    Depth,
    DepthOr0,
    EntryAngle,
    FeedOr0,
    ToolReference,
    Turn,
    Width,
    WidthOr0,
)


class FaceParameters(Parameters):
    """The keys of facing; without outlines the whole stock is faced.

    finish_stepdown_mm is the last depth, cut at finish_feed_mm_min; 0 is none, and the tool's own feed.
    """

    cycle: Literal["face"] = "face"
    tool: ToolReference
    outlines: Any
    offset_mm: Annotated[tuple[Coordinate, Coordinate], OFFSET] = (0.0, 0.0)
    depth_mm: Annotated[Depth, DEPTH]
    stepdown_mm: Annotated[Depth, STEPDOWN]
    stepover_mm: Annotated[Width, STEPOVER]
    finish_stepdown_mm: Annotated[DepthOr0, replace(FINISH_STEPDOWN, new=None)] = 0.0
    finish_feed_mm_min: Annotated[
        FeedOr0, replace(FINISH_FEED, help="The feed of the last pass; 0: the tool's own feed")
    ] = 0.0  # fmt: skip
    overhang_mm: Annotated[WidthOr0, Parameter(PATH, "Overhang", "How far the tool's rim runs over the edge", 1.0)] = (
        0.0
    )
    pattern: Annotated[Literal["zigzag", "oneway", "spiral"], PATTERN] = "zigzag"
    angle_deg: Annotated[Turn, PATTERN_ANGLE] = 0.0
    entry: Annotated[EntryName, ENTRY] = "helix"
    entry_angle_deg: Annotated[EntryAngle, ENTRY_ANGLE] = 3.0
    direction: Annotated[Direction, DIRECTION] = "climb"
    tolerance_mm: Annotated[CutTolerance, TOLERANCE] = 0.01
