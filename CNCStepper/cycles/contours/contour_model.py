# SPDX-License-Identifier: LGPL-2.1-or-later
"""A contour with its tabs and leads as a job file has them."""

from __future__ import annotations

from typing import ClassVar

from pydantic import BaseModel, ConfigDict, Field, model_validator

from CNCStepper.cycles.contours.contour_parameters import ContourParameters, LeadParameters, TabParameters
from CNCStepper.cycles.parameter_types import CurveField
from CNCStepper.geometry.curve import Curve
from CNCStepper.quantities import MOST_ITEMS


class Tabs(TabParameters, BaseModel):
    """Bridges that hold a part: how many on each contour, or how far apart at most."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)

    @model_validator(mode="after")
    def _are_counted_once(self) -> Tabs:
        if (self.count > 0) == (self.spacing_mm > 0):
            raise ValueError("tabs need either count or spacing_mm")
        return self


class Lead(LeadParameters, BaseModel):
    """The way to or from a contour, in the scrap beside it."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)

    @model_validator(mode="after")
    def _has_its_size(self) -> Lead:
        if self.kind == "arc" and not (self.radius_mm > 0 and self.length_mm == 0):
            raise ValueError("a lead of kind 'arc' needs radius_mm, and no length_mm")
        if self.kind == "line" and not (self.length_mm > 0 and self.radius_mm == 0):
            raise ValueError("a lead of kind 'line' needs length_mm, and no radius_mm")
        return self


class ContourModel(ContourParameters, BaseModel):
    """What a contour is given, checked."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, arbitrary_types_allowed=True)
    DEPENDS_ON_CONTOURS: ClassVar[bool] = True  # of the job: `job.model` gives them in the setup

    curves: tuple[CurveField, ...] = Field(min_length=1, max_length=MOST_ITEMS["curves"])
    tabs: Tabs | None = None
    lead_in: Lead = Lead()
    lead_out: Lead = Lead()

    def kept(self) -> tuple[Curve, ...]:
        """Return the outlines of the parts left, for the leads of the job's other contours."""
        if self.side not in ("inside", "outside"):
            return ()
        return tuple(curve.moved(*self.offset_mm) for curve in self.curves)
