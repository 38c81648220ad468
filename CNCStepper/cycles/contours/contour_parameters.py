# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameters of a contour, as a job file names them."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field

from CNCStepper.cycles.contours.tab_and_lead_options import Dogbones, Lead, Side, Tabs
from CNCStepper.cycles.parameter_types import CurveField
from CNCStepper.quantities import (
    MOST_ITEMS,
    Bounds,
    Coordinate,
    CutTolerance,
    Depth,
    DepthOr0,
    FeedOr0,
    ToolReference,
    WidthOr0,
)


class ContourParameters(BaseModel):
    """The parameters of a contour.

    side: of the drawn curves on which the tool runs; left and right are seen along an open curve. Closed outlines
    that lie in each other are part and hole in turn. ramp_deg: 0 plunges. kerf_mm: the width of the cut, 0 for the
    tool's own. tabs.height_mm counts from depth_mm upwards.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, arbitrary_types_allowed=True)

    cycle: Literal["contour"] = "contour"
    tool: ToolReference
    curves: tuple[CurveField, ...] = Field(min_length=1, max_length=MOST_ITEMS["curves"])
    offset_mm: tuple[Coordinate, Coordinate] = (0.0, 0.0)
    side: Side = "outside"
    depth_mm: Depth
    stepdown_mm: DepthOr0 = 0.0
    finish_stepdown_mm: DepthOr0 = 0.0
    finish_stepover_mm: WidthOr0 = 0.0
    finish_feed_mm_min: FeedOr0 = 0.0
    stock_to_leave_mm: WidthOr0 = 0.0
    direction: Literal["climb", "conventional"] = "climb"
    ramp_deg: Annotated[float, Bounds("slope", 0.1, 45.0, zero=True)] = 0.0
    tabs: Tabs | None = None
    lead_in: Lead = Lead()
    lead_out: Lead = Lead()
    overcut_mm: WidthOr0 = 0.0
    dogbones: Dogbones = "none"
    kerf_mm: WidthOr0 = 0.0
    tolerance_mm: CutTolerance = 0.01
