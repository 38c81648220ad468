# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tabs and leads as a job file names them."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, model_validator

from CNCStepper.quantities import Bounds, Depth, LengthOr0, Width, WidthOr0

Side = Literal["on", "inside", "outside", "left", "right"]
Dogbones = Literal["none", "corner", "side"]
MOST_TABS = 1000  # on one contour


class Tabs(BaseModel):
    """Bridges that hold a part: how many on each contour, or how far apart at most; width along the contour.

    width_mm is what stays between the two cuts beside a tab; height_mm is measured from the contour's depth upwards.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)

    count: Annotated[int, Bounds("count", 0, MOST_TABS)] = 0
    spacing_mm: LengthOr0 = 0.0
    width_mm: Width
    height_mm: Depth

    @model_validator(mode="after")
    def _are_counted_once(self) -> Tabs:
        if (self.count > 0) == (self.spacing_mm > 0):
            raise ValueError("tabs need either count or spacing_mm")
        return self


class Lead(BaseModel):
    """The way to or from a contour, through the scrap.

    A line of length_mm meets the contour at angle_deg (90: square to it); an arc of radius_mm meets it along its
    tangent and turns by angle_deg.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)

    kind: Literal["none", "line", "arc"] = "none"
    radius_mm: WidthOr0 = 0.0
    length_mm: WidthOr0 = 0.0
    angle_deg: Annotated[float, Bounds("angle", 0.01, 180.0)] = 90.0

    @model_validator(mode="after")
    def _has_its_size(self) -> Lead:
        if self.kind == "arc" and not (self.radius_mm > 0 and self.length_mm == 0):
            raise ValueError("a lead of kind 'arc' needs radius_mm, and no length_mm")
        if self.kind == "line" and not (self.length_mm > 0 and self.radius_mm == 0):
            raise ValueError("a lead of kind 'line' needs length_mm, and no radius_mm")
        return self
