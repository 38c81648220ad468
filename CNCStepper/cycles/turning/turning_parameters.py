# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameters of the turning cycles, named as in a job file; lengths in the part's own coordinates.

z = 0 is the finished end face, z < 0 lies towards the chuck. Radial depths are on the radius; a key with `diameter`
is a diameter whatever the job's x_is says.
"""

from typing import Annotated, Literal

from CNCStepper.cycles.parameter import CUT, FINISH, PATH, Parameter, Parameters
from CNCStepper.quantities import Bounds, ChipLoadOr0, Coordinate, SpeedOr0, TimeOr0, ToolReference, Width, WidthOr0

FEEDS = "Feed and speed"
SurfaceSpeedOr0 = Annotated[float, Bounds("surface_speed", zero=True)]
DEPTH_OF_CUT = Parameter(CUT, "Depth per pass", "Depth of cut (ap): of one pass at most, on the radius", 1.0)
TO_LEAVE = Parameter(FINISH, "Stock to leave", "Left on the profile, normal to it, for another operation")
TO_DIAMETER = Parameter(CUT, "To diameter", "The diameter at which the cut ends; 0: over the axis")
PECK = Parameter(CUT, "Peck", "How deep one peck goes; 0: in one go")
DWELL = Parameter(CUT, "Pause", "Seconds at the bottom", name="Pause")


class TurningParameters(Parameters):
    """The keys of every cycle: feeds and speeds, 0 takes those of the tool; clearance_mm: where a rapid ends.

    constant_surface_speed: the spindle follows X (G96) so that the surface speed stays, up to max_rpm.
    """

    cycle: str
    tool: ToolReference
    feed_mm_rev: Annotated[
        ChipLoadOr0,
        Parameter(FEEDS, "Feed per turn", "Millimetres a turn of the spindle; 0: the tool's", name="FeedPerTurn"),
    ] = 0.0  # fmt: skip
    spindle_rpm: Annotated[
        SpeedOr0, Parameter(FEEDS, "Spindle", "Spindle turns a minute; 0: that of the tool", name="SpindleSpeed")
    ] = 0.0
    surface_speed_m_min: Annotated[
        SurfaceSpeedOr0,
        Parameter(FEEDS, "Surface speed", "Metres a minute at the bar's diameter; 0: not given", name="SurfaceSpeed"),
    ] = 0.0
    max_rpm: Annotated[
        SpeedOr0, Parameter(FEEDS, "Fastest spindle", "The limit of the surface speed; 0: none", name="MostTurns")
    ] = 0.0  # fmt: skip
    constant_surface_speed: Annotated[
        bool, Parameter(FEEDS, "Spindle follows X", "Whether the surface speed stays as X changes (G96)")
    ] = False
    clearance_mm: Annotated[Width, Parameter(PATH, "Clearance", "How far before the material a rapid ends", 1.0)] = 1.0


class TurnFaceParameters(TurningParameters):
    """Turn the end face down to to_z_mm, from outside to to_diameter_mm; 0 is over the axis."""

    cycle: Literal["turn_face"]
    to_z_mm: Annotated[Coordinate, Parameter(CUT, "To Z", "Where the face lies when it is cut")] = 0.0
    to_diameter_mm: Annotated[WidthOr0, TO_DIAMETER] = 0.0
    ap_mm: Annotated[Width, DEPTH_OF_CUT] = 1.0
    stock_to_leave_mm: Annotated[
        WidthOr0, Parameter(FINISH, "Stock to leave", "Left on the face for another operation")
    ] = 0.0  # fmt: skip


class TurnRoughParameters(TurningParameters):
    """Rough a profile out of the stock; along: passes along Z (as G71), along X (as G72) or along the profile (G73).

    The stock to leave is measured normal to the profile. Outside or in a bore, as the tool does.
    """

    cycle: Literal["turn_rough", "turn_bore"]
    profile: str
    along: Annotated[
        Literal["z", "x", "profile"], Parameter(CUT, "Passes along", "Along Z, along X or along the profile")
    ] = "z"
    ap_mm: Annotated[Width, DEPTH_OF_CUT]
    stock_to_leave_mm: Annotated[WidthOr0, TO_LEAVE] = 0.0


class TurnFinishParameters(TurningParameters):
    """Follow a profile in one pass, the radius of the nose compensated in the program."""

    cycle: Literal["turn_finish"]
    profile: str
    stock_to_leave_mm: Annotated[WidthOr0, TO_LEAVE] = 0.0


class TurnTaperParameters(TurningParameters):
    """Turn a cone without a profile: from diameter_mm at z_mm over length_mm towards the chuck.

    by: "diameters", where end_diameter_mm is that of its end, or "angle", where angle_deg is that by which the radius
    grows towards the chuck. Each corner has a chamfer, a fillet or neither. Outside or in a bore, as the tool does.
    """

    cycle: Literal["turn_taper"]
    by: Annotated[
        Literal["diameters", "angle"], Parameter(CUT, "Cone by", "Its two diameters, or an angle", name="ConeBy")
    ] = "diameters"
    z_mm: Annotated[Coordinate, Parameter(CUT, "From Z", "Where the cone begins", name="FromZ")] = 0.0
    diameter_mm: Annotated[WidthOr0, Parameter(CUT, "Diameter", "Where the cone begins; 0: at a tip", 20.0)]
    end_diameter_mm: Annotated[
        WidthOr0, Parameter(CUT, "End diameter", "At its end towards the chuck", 30.0, only=("by", ("diameters",)))
    ] = 0.0
    angle_deg: Annotated[
        float, Bounds("angle", -80.0, 80.0),
        Parameter(CUT, "Angle", "By which the radius grows towards the chuck", 10.0, only=("by", ("angle",))),
    ] = 0.0  # fmt: skip
    length_mm: Annotated[Width, Parameter(CUT, "Cone length", "Along Z, from there towards the chuck", 20.0)]
    ap_mm: Annotated[Width, DEPTH_OF_CUT] = 1.0
    last_pass_mm: Annotated[
        WidthOr0, Parameter(FINISH, "Last pass: depth", "Left on the cone for a last pass along it; 0: none", 0.2)
    ] = 0.0
    begin_chamfer_mm: Annotated[WidthOr0, Parameter(FINISH, "Begin: chamfer", "At the end face; 0: none")] = 0.0
    begin_fillet_mm: Annotated[WidthOr0, Parameter(FINISH, "Begin: radius", "At the end face; 0: none")] = 0.0
    end_chamfer_mm: Annotated[WidthOr0, Parameter(FINISH, "End: chamfer", "At the shoulder; 0: none")] = 0.0
    end_fillet_mm: Annotated[WidthOr0, Parameter(FINISH, "End: radius", "At the shoulder; 0: none")] = 0.0


class TurnGrooveParameters(TurningParameters):
    """Cut a groove with parallel walls: from z_mm, its wall towards the chuck, width_mm towards the end face.

    diameter_mm: of its floor. top_diameter_mm: of the surface into which it is cut. peck_mm: 0 plunges in one go.
    """

    cycle: Literal["turn_groove"]
    z_mm: Annotated[Coordinate, Parameter(CUT, "Z of the wall", "The wall towards the chuck", -20.0, name="WallZ")]
    width_mm: Annotated[Width, Parameter(CUT, "Width", "From that wall towards the end face", 3.0)]
    diameter_mm: Annotated[Width, Parameter(CUT, "Floor diameter", "The diameter of the floor", 20.0)]
    top_diameter_mm: Annotated[
        Width, Parameter(CUT, "Top diameter", "The diameter of the surface into which it is cut", 30.0)
    ]
    peck_mm: Annotated[WidthOr0, PECK] = 0.0
    dwell_s: Annotated[TimeOr0, DWELL] = 0.0


class TurnPartParameters(TurningParameters):
    """Part off at z_mm, the length that the part keeps; to_diameter_mm: 0 is over the axis, a tube's bore is enough."""

    cycle: Literal["turn_part"]
    z_mm: Annotated[
        Coordinate, Parameter(CUT, "Z of the cut", "The length that the part keeps, below zero", -50.0, name="CutZ")
    ]
    to_diameter_mm: Annotated[WidthOr0, TO_DIAMETER] = 0.0
    peck_mm: Annotated[WidthOr0, PECK] = 0.0


class TurnDrillParameters(TurningParameters):
    """Drill on the axis; depth_mm: of the tip below z = 0. A centre drill is one of a small depth.

    peck_mm: 0 drills in one go; retract: out of the hole for each peck, or by clearance_mm to break the chip.
    """

    cycle: Literal["turn_drill"]
    depth_mm: Annotated[Width, Parameter(CUT, "Depth", "Of the tip below the finished end face", 20.0)]
    peck_mm: Annotated[WidthOr0, PECK] = 0.0
    retract: Annotated[
        Literal["full", "chip"], Parameter(CUT, "Retract", "Out of the hole for each peck, or to break the chip")
    ] = "full"
    dwell_s: Annotated[TimeOr0, DWELL] = 0.0


class TurnThreadParameters(TurningParameters):
    """Cut a thread from z_mm over length_mm towards the chuck, outside or in a bore as the tool does.

    thread: its designation, such as "M20x2.5", "1/2-13 UNC", "G1/2", "Tr20x4" or "Tr40x14P7". diameter_mm: of the crest
    at z_mm, 0 for that of the profile or of the thread's usual fit. taper_deg: by which the radius grows towards the
    chuck. starts: 0 for those of the designation. approach_mm: in front of z_mm, where the spindle is caught up with.
    infeed_deg: 0 for one degree less than the flank. degression: 2 takes the same area in every pass. spring_passes: at
    the full depth besides the last. pull_out_mm: the length over which the tool comes out at the end.
    """

    cycle: Literal["turn_thread"]
    thread: Annotated[
        str, Parameter(CUT, "Designation", "Its designation: M20x2.5, 1/2-13 UNC, G1/2, Tr20x4", "M20x1.5")
    ]  # fmt: skip
    profile: str = ""
    z_mm: Annotated[Coordinate, Parameter(CUT, "From Z", "Where the thread begins", name="FromZ")] = 0.0
    length_mm: Annotated[Width, Parameter(CUT, "Thread length", "From there towards the chuck", 20.0)]
    diameter_mm: Annotated[
        WidthOr0, Parameter(CUT, "Crest diameter", "Where it begins; 0: that of the profile or the usual fit")
    ] = 0.0
    taper_deg: Annotated[
        float, Bounds("angle", -45.0, 45.0), Parameter(CUT, "Taper", "By which the radius grows towards the chuck")
    ] = 0.0
    starts: Annotated[
        int, Bounds("number", 0, 100), Parameter(CUT, "Starts", "How many; 0: those of the designation")
    ] = 0
    approach_mm: Annotated[
        Width, Parameter(PATH, "Approach", "In front of the thread, where the tool catches up with the spindle", 5.0)
    ] = 5.0
    first_depth_mm: Annotated[Width, Parameter(CUT, "First depth", "The depth of the first pass", 0.2)] = 0.2
    infeed: Annotated[
        Literal["radial", "flank", "alternating"], Parameter(CUT, "Infeed", "How the tool is fed in from pass to pass")
    ] = "flank"
    infeed_deg: Annotated[
        float,
        Bounds("angle", 0.0, 45.0),
        Parameter(
            CUT, "Infeed angle", "0: one degree less than the flank", name="InfeedAngle",
            only=("infeed", ("flank", "alternating"))
        ),
    ] = 0.0  # fmt: skip
    degression: Annotated[
        float, Bounds("ratio", 1.0, 10.0), Parameter(CUT, "Degression", "1: equal depths; 2: equal areas of chip")
    ] = 2.0
    spring_passes: Annotated[
        int, Bounds("number", 0, 100), Parameter(FINISH, "Spring passes", "At the full depth, besides the last one")
    ] = 1
    pull_out_mm: Annotated[
        WidthOr0, Parameter(PATH, "Pull-out", "The length over which the tool comes out at the end", name="PullOut")
    ] = 0.0
