# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all cycles that clear an area have in common: their keys, and the road from curves to moves.

    curves ──► rooms ──────► parts ─────────────────────► levels ──────► Answer
               reachable_regions.py      region_stages.py                    depth_levels.py
               walls,        runs of the pattern,         down and      the removal, what is
               roughed       ways down (entry_moves.py)       around        reachable, corners

A cycle derives from `AreaCycle`, adds its own keys and calls `_clear` with its curves and a pattern.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import accumulate
from typing import Literal

from pydantic import BaseModel, ConfigDict

from CNCStepper.cycles.clearing.area_result import AreaAnswer
from CNCStepper.cycles.clearing.depth_levels import cut_parts, require_short
from CNCStepper.cycles.clearing.pattern import Area, Pattern
from CNCStepper.cycles.clearing.reachable_regions import reachable_regions
from CNCStepper.cycles.clearing.region_stages import ClearingOptions, parts_of
from CNCStepper.cycles.cycle import Answer, Setup
from CNCStepper.cycles.moves import require_setup
from CNCStepper.cycles.passes import whole_passes
from CNCStepper.cycles.tool_requirements import require_flat, require_stepover
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.region import Region
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.quantities import (
    Coordinate,
    CutTolerance,
    Depth,
    DepthOr0,
    EntryAngle,
    FeedOr0,
    ToolReference,
    Width,
    WidthOr0,
)
from CNCStepper.toolpath import TableBuilder


class AreaCycle(BaseModel):
    """The keys of every cycle that clears an area, named as in a job file.

    depth_mm is ap_total, stepdown_mm ap, stepover_mm ae, finish_stepdown_mm ap_acab and finish_stepover_mm ae_acab:
    what the pass along the wall takes, 0 for none. offset_mm moves the drawn curves.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, arbitrary_types_allowed=True)

    tool: ToolReference
    depth_mm: Depth
    stepdown_mm: Depth
    stepover_mm: Width
    finish_stepdown_mm: DepthOr0 = 0.0
    finish_stepover_mm: WidthOr0 = 0.0
    finish_feed_mm_min: FeedOr0 = 0.0
    stock_to_leave_mm: WidthOr0 = 0.0
    entry: Literal["helix", "ramp", "plunge"] = "helix"
    entry_angle_deg: EntryAngle = 3.0
    direction: Literal["climb", "conventional"] = "climb"
    tolerance_mm: CutTolerance = 0.01
    offset_mm: tuple[Coordinate, Coordinate] = (0.0, 0.0)

    def _clear(
        self,
        outlines: Sequence[Curve],
        islands: Sequence[Curve],
        pattern: Pattern,
        setup: Setup,
        table: TableBuilder,
    ) -> Answer:
        """Append the clearing of what lies in the outlines and in no island; raises CycleError before any row."""
        self._require(setup)
        drawn, kept = ([curve.moved(*self.offset_mm) for curve in curves] for curves in (outlines, islands))
        finish_mm = self.finish_stepover_mm
        rooms = reachable_regions(
            drawn, kept, setup.tool.radius_mm, self.stock_to_leave_mm, finish_mm, self.tolerance_mm
        )
        parts = parts_of(rooms.walls, rooms.roughed, self._ways(pattern, setup.tool))
        floors_mm = self._floors_mm()
        require_short(parts, floors_mm, setup.retract_mm)
        cut_parts(parts, floors_mm, setup, table)
        return AreaAnswer(self, rooms, parts, floors_mm, setup)

    def _ways(self, pattern: Pattern, tool: Tool) -> ClearingOptions:
        area = Area(Region(()), tool.radius_mm, self.stepover_mm, self.tolerance_mm, self.direction == "climb")
        return ClearingOptions(
            pattern,
            area,
            tool,
            self.entry,
            self.entry_angle_deg,
            self.finish_stepover_mm,
            self.finish_feed_mm_min,
        )

    def _floors_mm(self) -> list[float]:
        steps = whole_passes(self.depth_mm, self.stepdown_mm, self.finish_stepdown_mm, "stepdown_mm")
        floors = [-depth_mm for depth_mm in accumulate(steps)]
        return [*floors[:-1], -self.depth_mm]

    def _require(self, setup: Setup) -> None:
        tool = setup.tool
        require_flat(tool)
        require_stepover(self.stepover_mm, tool)
        if self.finish_stepover_mm > tool.radius_mm - self.tolerance_mm:
            raise CycleError(
                "finish-wide",
                "finish_stepover_mm (ae_acab) is larger than the tool's radius allows",
                value=f"{self.finish_stepover_mm:g} mm",
                limit=f"{tool.radius_mm - self.tolerance_mm:.4g} mm",
                advice="leave less for the finishing pass, or islands remain",
            )
        require_setup(setup)
