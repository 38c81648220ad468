# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contour: along drawn curves, on them or beside them, at several depths, with tabs, leads and dog-bones.

    sides     drawn curves ---> paths of the tool's centre, exact parallels     cycles/contours/sides.py
    dogbones  inside corners sharper than the tool                              cycles/contours/dogbones.py
    leads     where a path begins and how the tool comes and goes, in scrap     cycles/contours/leads.py
    tabs      where it must stay above what holds the part                      cycles/contours/tabs.py
    plan      all of these put together, in order; what is removed, warnings    cycles/contours/plan.py
    run       down, along, up, level by level                                   cycles/contours/contour_levels.py

With `finish_stepover_mm` a roughing contour that much farther out is cut to the full depth first. What lies inside
an outline is cut before it.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field

from CNCStepper.cycles.contours.contour_levels import run
from CNCStepper.cycles.contours.plan import planned
from CNCStepper.cycles.contours.sides import as_cycle_error
from CNCStepper.cycles.contours.tab_and_lead_options import Dogbones, Lead, Side, Tabs
from CNCStepper.cycles.cycle import Answer, Setup
from CNCStepper.cycles.moves import Moves
from CNCStepper.cycles.parameter_types import CurveField
from CNCStepper.cycles.passes import require_few_blocks
from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve
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
from CNCStepper.toolpath import TableBuilder


class Contour(BaseModel):
    """Parameters of a contour, named as in a job file.

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

    def kept(self) -> tuple[Curve, ...]:
        """Return the outlines of what is left standing, for the leads of the job's other contours."""
        if self.side not in ("inside", "outside"):
            return ()
        return tuple(curve.moved(*self.offset_mm) for curve in self.curves)

    def cut(self, setup: Setup, table: TableBuilder) -> Answer:
        """Append the contours to `table`; raises CycleError before any row when they cannot be cut safely."""
        try:
            plan = planned(self, setup)
        except GeometryError as error:
            raise as_cycle_error(error) from error
        require_few_blocks(sum(path.blocks for path in plan.paths))
        moves, feed = Moves(table, setup), setup.tool.feed_mm_min
        for number, path in enumerate(plan.paths, start=1):
            table.open_span("contour", f"{'finishing' if path.finishing else 'roughing'} contour {number}")
            feed_here = (self.finish_feed_mm_min or feed) if path.finishing else feed
            run(path, moves, plan.tab_top_mm, feed_here, self.ramp_deg > 0)
            table.close_span()
        return plan.answer
