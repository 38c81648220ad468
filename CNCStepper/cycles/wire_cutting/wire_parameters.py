# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameters of wire cutting, named as in a job file."""

from typing import Annotated, Any, Literal

from CNCStepper.cycles.parameter import CUT, OFFSET, PATH, TOLERANCE, Parameter, Parameters
from CNCStepper.quantities import Bounds, Coordinate, CutTolerance, TimeOr0, ToolReference, Width, WidthOr0

SheetSide = Literal["left", "right", "front", "back"]


class WireParameters(Parameters):
    """The keys of wire cutting; closed outlines that lie in each other are part and hole in turn.

    front is the side of the lowest Y. The dwell at a corner is corner_dwell_s for a half turn, and less for less.
    The feed is lower from corner_distance_mm before a corner until as far behind it.
    """

    cycle: Literal["wire_cut"] = "wire_cut"
    tool: ToolReference
    curves: Any
    offset_mm: Annotated[tuple[Coordinate, Coordinate], OFFSET] = (0.0, 0.0)
    enter_from: Annotated[
        Literal["nearest", "left", "right", "front", "back"],
        Parameter(CUT, "Enter from", "The edge of the sheet at which the wire enters"),
    ] = "nearest"
    leave: Annotated[
        Literal["back", "edge"],
        Parameter(CUT, "Leave", "Exit of the wire: back along its entry, or the shortest way to an edge"),
    ] = "back"
    entry_slit: Annotated[
        bool,
        Parameter(CUT, "Entry slit", "Whether a slit through the part leads the wire into a closed hole", False),
    ]
    margin_mm: Annotated[
        Width, Parameter(PATH, "Margin", "How far the kerf of a way through the scrap stays from every part")
    ] = 1.0
    kerf_mm: Annotated[
        WidthOr0,
        Parameter(PATH, "Kerf", "The width of the cut where it is not the chart's; 0: the chart's, else the tool's"),
    ] = 0.0
    corner_dwell_s: Annotated[
        TimeOr0,
        Parameter(PATH, "Corner dwell", "Pause of the wire where the path turns back; shorter at blunter corners"),
    ] = 0.0
    corner_angle_deg: Annotated[
        float,
        Bounds("angle", 1.0, 180.0),
        Parameter(PATH, "Corner angle", "At smaller corners the wire neither pauses nor slows down"),
    ] = 30.0  # fmt: skip
    corner_distance_mm: Annotated[
        WidthOr0,
        Parameter(PATH, "Corner distance", "How far before and behind a corner the feed is lower; 0: it is not"),
    ] = 0.0
    corner_feed_share: Annotated[
        float,
        Bounds("share", 0.05, 1.0),
        Parameter(PATH, "Feed at corners", "The share of the feed there; a slower wire melts a wider kerf"),
    ] = 0.6
    tolerance_mm: Annotated[CutTolerance, TOLERANCE] = 0.01
