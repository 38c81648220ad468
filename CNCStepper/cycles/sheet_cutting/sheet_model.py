# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutting parts out of sheet as a job file has it, checked, with the process's defaults."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict, Field, StrictBool, model_validator

from CNCStepper.cycles.contours.contour_model import Lead
from CNCStepper.cycles.parameter_types import CurveField
from CNCStepper.cycles.sheet_cutting.sheet_parameters import (
    ArcRuleParameters,
    CornerRuleParameters,
    LoopParameters,
    MicroJointParameters,
    PowerRampParameters,
    SheetParameters,
    SmallHoleParameters,
)
from CNCStepper.machine.processes import Process
from CNCStepper.quantities import MOST_ITEMS

LEAD_KERFS = 2.0  # a lead is so many kerfs long, where neither job nor chart requires more


class _Table(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)


class SmallHoles(SmallHoleParameters, _Table):
    """The rule for small holes."""


class ArcRule(ArcRuleParameters, _Table):
    """The rule for narrow arcs."""


class CornerRule(CornerRuleParameters, _Table):
    """The rule for corners."""


class Loops(LoopParameters, _Table):
    """Loops at sharp outside corners."""


class PowerRamp(PowerRampParameters, _Table):
    """A power that rises behind the pierce."""


class MicroJoints(MicroJointParameters, _Table):
    """Joints that hold a part: how many on each outline, or how far apart at most."""

    @model_validator(mode="after")
    def _are_counted_once(self) -> MicroJoints:
        if (self.count > 0) == (self.spacing_mm > 0):
            raise ValueError("tabs need either count or spacing_mm")
        return self


class SheetModel(SheetParameters, BaseModel):
    """What a sheet's cut is given, checked."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, arbitrary_types_allowed=True)

    curves: tuple[CurveField, ...] = Field(min_length=1, max_length=MOST_ITEMS["curves"])
    marks: tuple[CurveField, ...] = Field(default=(), max_length=MOST_ITEMS["curves"])
    lead_in: Lead | None = None
    lead_out: Lead = Lead()
    small_holes: SmallHoles | None = None
    arcs: ArcRule | None = None
    corners: CornerRule | None = None
    loops: Loops | None = None
    tabs: MicroJoints | None = None
    power_ramp: PowerRamp | None = None
    dynamic_power: StrictBool = False

    def lead_of(self, process: Process, kerf_mm: float, pierce_mm: float) -> Lead:
        """Return the lead-in: the job's own, else an arc for a process that pierces, none for one that is lowered."""
        if self.lead_in is not None:
            return self.lead_in
        if process.entry != "pierce":
            return Lead()
        return Lead(kind="arc", radius_mm=max(LEAD_KERFS * kerf_mm, pierce_mm - kerf_mm / 2.0, 0.01))

    def small_holes_of(self, process: Process) -> SmallHoles | None:
        """Return the rule for small holes: the job's own, else that of plasma, whose arc lags and blows corners out."""
        return self.small_holes or (SmallHoles() if process.name == "plasma" else None)

    def corners_of(self, process: Process) -> CornerRule | None:
        """Return the rule for corners: the job's own, else that of a water jet, which lags behind its nozzle."""
        return self.corners or (CornerRule(angle_deg=60.0) if process.name == "waterjet" else None)
