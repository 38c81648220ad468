# SPDX-License-Identifier: LGPL-2.1-or-later
"""The operations of a lathe's job file: the parameters of `turning_parameters.py`, checked."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict, model_validator

from CNCStepper.cycles.turning.turning_parameters import (
    TurnDrillParameters,
    TurnFaceParameters,
    TurnFinishParameters,
    TurnGrooveParameters,
    TurningParameters,
    TurnPartParameters,
    TurnRoughParameters,
    TurnTaperParameters,
    TurnThreadParameters,
)
from CNCStepper.errors import JobError, Text

ALONG_PROFILES = ("turn_bore", "turn_finish", "turn_rough")  # cycles that follow one
BY_EDGE = (*ALONG_PROFILES, "turn_taper")  # cycles whose path is that of an insert's nose
FIXED_SPEED = ("turn_drill", "turn_thread")  # cycles on the axis, or in step with the spindle


class TurningOperation(TurningParameters, BaseModel):
    """An operation of any cycle."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    @model_validator(mode="after")
    def _speed_follows_x(self) -> TurningOperation:
        if self.constant_surface_speed and self.spindle_rpm:
            raise ValueError("constant_surface_speed takes surface_speed_m_min and max_rpm: take spindle_rpm out")
        if self.constant_surface_speed and self.cycle in FIXED_SPEED:
            what = "{cycle} needs a fixed speed of the spindle: take constant_surface_speed out"
            raise ValueError(Text(what, cycle=self.cycle))
        return self


class TurnFace(TurnFaceParameters, TurningOperation):
    """A facing."""


class TurnRough(TurnRoughParameters, TurningOperation):
    """A roughing, outside or in a bore."""


class TurnFinish(TurnFinishParameters, TurningOperation):
    """A finishing."""


class TurnGroove(TurnGrooveParameters, TurningOperation):
    """A groove."""


class TurnPart(TurnPartParameters, TurningOperation):
    """A parting off."""


class TurnDrill(TurnDrillParameters, TurningOperation):
    """A drilling on the axis."""

    @model_validator(mode="after")
    def _pecks_are_not_deeper(self) -> TurnDrill:
        if self.peck_mm > self.depth_mm:
            what = "peck_mm must not exceed depth_mm, {limit:g} mm; write 0 to drill in one go"
            raise ValueError(Text(what, limit=self.depth_mm))
        return self


class TurnTaper(TurnTaperParameters, TurningOperation):
    """A cone without a profile."""

    @model_validator(mode="after")
    def _corners_are_one_thing(self) -> TurnTaper:
        for name in ("begin", "end"):
            if getattr(self, f"{name}_chamfer_mm") and getattr(self, f"{name}_fillet_mm"):
                what = "a corner of the cone has {name}_chamfer_mm or {name}_fillet_mm, not both"
                raise ValueError(Text(what, name=name))
        return self


class TurnThread(TurnThreadParameters, TurningOperation):
    """A thread."""


TURNING_OPERATIONS: dict[str, type[TurningOperation]] = {
    "turn_bore": TurnRough,
    "turn_drill": TurnDrill,
    "turn_face": TurnFace,
    "turn_finish": TurnFinish,
    "turn_groove": TurnGroove,
    "turn_part": TurnPart,
    "turn_rough": TurnRough,
    "turn_taper": TurnTaper,
    "turn_thread": TurnThread,
}


def turning_operation_class(name: object) -> type[TurningOperation]:
    """Return the parameters of a cycle of the lathe; raises JobError for a name that is none."""
    if not isinstance(name, str) or name not in TURNING_OPERATIONS:
        what = Text("a lathe has no cycle '{name}'", name=str(name)[:60])
        advice = Text("use one of: {cycles}", cycles=", ".join(sorted(TURNING_OPERATIONS)))
        raise JobError("cycle-unknown", what, advice=advice)
    return TURNING_OPERATIONS[name]
