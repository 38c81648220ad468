# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameters of the turning cycles as a job file names them; lengths in the part's own coordinates.

z = 0 is the finished end face, z < 0 lies towards the chuck. Radial depths are on the radius; a key with `diameter`
is a diameter whatever the job's x_is says.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, StrictBool, model_validator

from CNCStepper.errors import JobError, Text
from CNCStepper.quantities import Bounds, ChipLoadOr0, Coordinate, SpeedOr0, TimeOr0, ToolReference, Width, WidthOr0

FIXED_SPEED = ("turn_drill", "turn_thread")  # cycles on the axis, or in step with the spindle
SurfaceSpeedOr0 = Annotated[float, Bounds("surface_speed", zero=True)]


class TurningOperation(BaseModel):
    """Of every cycle: feeds and speeds, 0 takes those of the tool; clearance_mm: before material a rapid ends.

    constant_surface_speed: the spindle follows X (G96) so that the surface speed stays, up to max_rpm.
    """

    model_config = ConfigDict(extra="forbid", frozen=True)

    cycle: str
    tool: ToolReference
    feed_mm_rev: ChipLoadOr0 = 0.0
    spindle_rpm: SpeedOr0 = 0.0
    surface_speed_m_min: SurfaceSpeedOr0 = 0.0
    max_rpm: SpeedOr0 = 0.0
    constant_surface_speed: StrictBool = False
    clearance_mm: Width = 1.0

    @model_validator(mode="after")
    def _speed_follows_x(self) -> TurningOperation:
        if self.constant_surface_speed and self.spindle_rpm:
            raise ValueError("constant_surface_speed takes surface_speed_m_min and max_rpm: take spindle_rpm out")
        if self.constant_surface_speed and self.cycle in FIXED_SPEED:
            what = "{cycle} needs a fixed speed of the spindle: take constant_surface_speed out"
            raise ValueError(Text(what, cycle=self.cycle))
        return self


class TurnFace(TurningOperation):
    """Turn the end face down to to_z_mm, from outside to to_diameter_mm; 0 is over the axis."""

    cycle: Literal["turn_face"]
    to_z_mm: Coordinate = 0.0
    to_diameter_mm: WidthOr0 = 0.0
    ap_mm: Width = 1.0
    stock_to_leave_mm: WidthOr0 = 0.0


class TurnRough(TurningOperation):
    """Rough a profile out of the stock; along: passes along Z (as G71), along X (as G72) or along the profile (G73).

    The stock to leave is measured normal to the profile. Outside or in a bore, as the tool does.
    """

    cycle: Literal["turn_rough", "turn_bore"]
    profile: str
    along: Literal["z", "x", "profile"] = "z"
    ap_mm: Width
    stock_to_leave_mm: WidthOr0 = 0.0


class TurnFinish(TurningOperation):
    """Follow a profile in one pass, the radius of the nose compensated in the program."""

    cycle: Literal["turn_finish"]
    profile: str
    stock_to_leave_mm: WidthOr0 = 0.0


class TurnGroove(TurningOperation):
    """Cut a groove with parallel walls: from z_mm, its wall towards the chuck, width_mm towards the end face.

    diameter_mm: of its floor. top_diameter_mm: of the surface into which it is cut. peck_mm: 0 plunges in one go.
    """

    cycle: Literal["turn_groove"]
    z_mm: Coordinate
    width_mm: Width
    diameter_mm: Width
    top_diameter_mm: Width
    peck_mm: WidthOr0 = 0.0
    dwell_s: TimeOr0 = 0.0


class TurnPart(TurningOperation):
    """Part off at z_mm, the length that the part keeps; to_diameter_mm: 0 is over the axis, a tube's bore is enough."""

    cycle: Literal["turn_part"]
    z_mm: Coordinate
    to_diameter_mm: WidthOr0 = 0.0
    peck_mm: WidthOr0 = 0.0


class TurnDrill(TurningOperation):
    """Drill on the axis; depth_mm: of the tip below z = 0. A centre drill is one of a small depth.

    peck_mm: 0 drills in one go; retract: out of the hole for each peck, or by clearance_mm to break the chip.
    """

    cycle: Literal["turn_drill"]
    depth_mm: Width
    peck_mm: WidthOr0 = 0.0
    retract: Literal["full", "chip"] = "full"
    dwell_s: TimeOr0 = 0.0

    @model_validator(mode="after")
    def _pecks_are_not_deeper(self) -> TurnDrill:
        if self.peck_mm > self.depth_mm:
            what = "peck_mm must not exceed depth_mm, {limit:g} mm; write 0 to drill in one go"
            raise ValueError(Text(what, limit=self.depth_mm))
        return self


class TurnThread(TurningOperation):
    """Cut a thread from z_mm over length_mm towards the chuck, outside or in a bore as the tool does.

    thread: its designation, such as "M20x2.5", "1/2-13 UNC", "G1/2", "Tr20x4" or "Tr40x14P7". diameter_mm: of the crest
    at z_mm, 0 for that of the profile or of the thread's usual fit. taper_deg: by which the radius grows towards the
    chuck. starts: 0 for those of the designation. approach_mm: in front of z_mm, where the spindle is caught up with.
    infeed_deg: 0 for one degree less than the flank. degression: 2 takes the same area in every pass. spring_passes: at
    the full depth besides the last. pull_out_mm: the length over which the tool comes out at the end.
    """

    cycle: Literal["turn_thread"]
    thread: str
    profile: str = ""
    z_mm: Coordinate = 0.0
    length_mm: Width
    diameter_mm: WidthOr0 = 0.0
    taper_deg: Annotated[float, Bounds("angle", -45.0, 45.0)] = 0.0
    starts: Annotated[int, Bounds("number", 0, 100)] = 0
    approach_mm: Width = 5.0
    first_depth_mm: Width = 0.2
    infeed: Literal["radial", "flank", "alternating"] = "flank"
    infeed_deg: Annotated[float, Bounds("angle", 0.0, 45.0)] = 0.0
    degression: Annotated[float, Bounds("ratio", 1.0, 10.0)] = 2.0
    spring_passes: Annotated[int, Bounds("number", 0, 100)] = 1
    pull_out_mm: WidthOr0 = 0.0


TURNING_OPERATIONS: dict[str, type[TurningOperation]] = {
    "turn_bore": TurnRough,
    "turn_drill": TurnDrill,
    "turn_face": TurnFace,
    "turn_finish": TurnFinish,
    "turn_groove": TurnGroove,
    "turn_part": TurnPart,
    "turn_rough": TurnRough,
    "turn_thread": TurnThread,
}


def turning_operation_class(name: object) -> type[TurningOperation]:
    """Return the parameters of a cycle of the lathe; raises JobError for a name that is none."""
    if not isinstance(name, str) or name not in TURNING_OPERATIONS:
        what = Text("a lathe has no cycle '{name}'", name=str(name)[:60])
        advice = Text("use one of: {cycles}", cycles=", ".join(sorted(TURNING_OPERATIONS)))
        raise JobError("cycle-unknown", what, advice=advice)
    return TURNING_OPERATIONS[name]
