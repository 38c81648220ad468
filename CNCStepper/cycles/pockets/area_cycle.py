# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all cycles that clear an area have in common: their keys, and the road from curves to moves.

    curves ──► rooms ──────► parts ─────────────────────► levels ──────► Answer
               reachable_regions.py      region_stages.py                    depth_levels.py
               walls,        runs of the pattern,         down and      the removal, what is
               roughed       ways down (helix_and_ramp_entry)  around        reachable, corners

A cycle derives from `AreaCycle`, adds its own keys and calls `_clear` with its curves and a pattern.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import accumulate
from typing import ClassVar

from pydantic import BaseModel, ConfigDict

from CNCStepper.cycles.clearing.area_result import AreaAnswer
from CNCStepper.cycles.clearing.depth_levels import cut_parts, require_short
from CNCStepper.cycles.clearing.pattern import Area, Pattern
from CNCStepper.cycles.clearing.reachable_regions import reachable_regions
from CNCStepper.cycles.clearing.region_stages import ClearingOptions, parts_of
from CNCStepper.cycles.cycle import Answer, Setup
from CNCStepper.cycles.moves import require_setup
from CNCStepper.cycles.passes import whole_passes
from CNCStepper.cycles.pockets.pocket_parameters import AreaParameters
from CNCStepper.cycles.tool_requirements import require_flat, require_stepover
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.region import Region
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.toolpath import TableBuilder


class AreaCycle(AreaParameters, BaseModel):
    """A cycle that clears an area."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, arbitrary_types_allowed=True)
    DEPENDS_ON_CONTOURS: ClassVar[bool] = True  # of the job: `job.model` gives them in the setup

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
