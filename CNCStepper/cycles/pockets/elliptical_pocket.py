# SPDX-License-Identifier: LGPL-2.1-or-later
"""The elliptical pocket: part C's fixed cycle, cleared from the centre outwards at every level.

    level   entry (helix, ramp or plunge) at the centre down to the level's floor
            pass 1 .. I   closed curves, each `ae` outside the one before
            finishing pass, `finish_stepover_mm` farther, on the wall
    ...     the last level is `finish_stepdown_mm` thick

Stepover and stepdown are RECALCULATED to whole passes, I = ceil((R - d_finish) / d), so that every
pass cuts the same. Method "tolerance" runs true parallel curves of the wall (R = short radius - tool
radius; the step is the same all around). Method "dda" runs similar ellipses as published; their step
grows along the longer axis, and `ae` bounds the larger one.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import accumulate
from typing import ClassVar

from pydantic import BaseModel, ConfigDict
from shapely import Polygon

from CNCStepper.cycles.contours.neighbour_parts import open_edge_warnings
from CNCStepper.cycles.cycle import Answer, Removal, Setup
from CNCStepper.cycles.moves import Moves, point_of, require_setup
from CNCStepper.cycles.passes import require_few_blocks, whole_passes
from CNCStepper.cycles.pockets.elliptical_entry import Entry, entry_of
from CNCStepper.cycles.pockets.elliptical_rings import (
    OUTLINE_ERROR_MM,
    Way,
    offset_deviation_mm,
    parallel_way,
    rings_along,
    similar_way,
)
from CNCStepper.cycles.pockets.pocket_parameters import EllipticalPocketParameters
from CNCStepper.cycles.tool_requirements import require_flat, require_stepover
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.shapes.ellipse import Ellipse
from CNCStepper.toolpath import TableBuilder

FINE = 256  # segments a quarter: the edge of the reachable region is exact to 0.0001 mm


class EllipticalPocket(EllipticalPocketParameters, BaseModel):
    """An elliptical pocket that can be cut."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)
    DEPENDS_ON_CONTOURS: ClassVar[bool] = True  # of the job: `job.model` gives them in the setup

    def cut(self, setup: Setup, table: TableBuilder) -> Answer:
        """Append the pocket to `table`; raises CycleError before any row when it cannot be cut safely."""
        plan = self._plan(setup)
        moves = Moves(table, setup)
        top_mm = setup.retract_mm
        for number, floor_mm in enumerate(plan.floors_mm, start=1):
            table.open_span("level", f"level {number}", floor_mm=floor_mm)
            self._level(plan, moves, table, top_mm, floor_mm, setup)
            table.close_span()
            top_mm = floor_mm
        moves.retract()
        return self._answer(plan, setup)

    def _answer(self, plan: _Plan, setup: Setup) -> Answer:
        """Return the removals, with warnings where they are not exact or open another part's edge."""
        left = plan.figures.get("unreachable_mm", 0.0) > self.tolerance_mm
        tool_mm = setup.tool.radius_mm
        reachable = _inner(plan.region, tool_mm).buffer(tool_mm, quad_segs=FINE) if left else None
        removal = Removal(plan.region, 0.0, -self.depth_mm, plan.promise_mm, reachable)
        edges = open_edge_warnings(reachable or plan.region, setup.parts, self.tolerance_mm)
        return Answer([removal], plan.figures, [*self._inexact_warnings(plan, left), *edges])

    def _inexact_warnings(self, plan: _Plan, left: bool) -> list[str]:
        if self.method == "dda" and plan.promise_mm > self.tolerance_mm:
            return [
                Text(
                    "the wall may be up to {promise_mm:.3f} mm off: an ellipse is no offset of an "
                    'ellipse, and the resolution adds to it; method "tolerance" keeps to tolerance_mm',
                    promise_mm=plan.promise_mm,
                )
            ]
        if not left:
            return []
        long_mm, short_mm = sorted((self.radius_x_mm, self.radius_y_mm), reverse=True)
        return [
            Text(
                "{unreachable_mm:.3f} mm of material stays at each end of the long axis, where the "
                "ellipse is tighter than the tool; a tool of at most {short_mm:.3g} mm diameter "
                "reaches it",
                unreachable_mm=plan.figures["unreachable_mm"],
                short_mm=2.0 * short_mm**2 / long_mm,
            )
        ]

    def _level(
        self, plan: _Plan, moves: Moves, table: TableBuilder, top_mm: float, floor_mm: float, setup: Setup
    ) -> None:
        feed = setup.tool.feed_mm_min
        table.open_span("entry", self.entry)
        plan.entry.descend(moves, top_mm, floor_mm, feed)
        table.close_span()
        for number, ring in enumerate(plan.rings, start=1):
            finishing = number == len(plan.rings)
            table.open_span("pass", "finishing" if finishing else f"roughing {number}")
            moves.feed(point_of(ring.xy[0]), feed)
            moves.follow(ring, (self.finish_feed_mm_min or feed) if finishing else feed)
            table.close_span()

    def _plan(self, setup: Setup) -> _Plan:
        self._check(setup)
        ellipse = Ellipse.of_radii(self.centre_mm, self.radius_x_mm, self.radius_y_mm, self.rotation_deg)
        region = _inner(Polygon(ellipse.points(OUTLINE_ERROR_MM)), self.stock_to_leave_mm)
        levels = whole_passes(self.depth_mm, self.stepdown_mm, self.finish_stepdown_mm, "stepdown_mm")
        way, promise_mm, figures = self._way(ellipse, setup.tool.radius_mm + self.stock_to_leave_mm)
        finish_mm = self.finish_stepover_mm
        rings = rings_along(way, self.centre_mm, setup.tool.radius_mm, self.stepover_mm, finish_mm, len(levels))
        curves = rings.curves if self.direction == "climb" else [ring.reversed() for ring in rings.curves]
        roughed = curves[-2] if finish_mm else curves[-1]
        entry = entry_of(self.entry, ellipse, setup.tool.radius_mm, roughed, self.entry_angle_deg)
        require_few_blocks(entry.blocks(setup.retract_mm + self.depth_mm) + len(levels) * sum(map(len, curves)))
        floors = [-depth_mm for depth_mm in accumulate(levels)]
        floors[-1] = -self.depth_mm
        figures |= {"ap_mm": levels[0], "levels": len(levels), "passes": len(curves), "ae_mm": rings.stepover_mm}
        return _Plan(region, curves, floors, entry, figures, promise_mm)

    def _check(self, setup: Setup) -> None:
        tool = setup.tool
        narrowest_mm = 2.0 * (min(self.radius_x_mm, self.radius_y_mm) - self.stock_to_leave_mm)
        require_flat(tool)
        if tool.diameter_mm >= narrowest_mm:
            raise CycleError(
                "tool-wide",
                "the tool is wider than the pocket",
                value=f"{tool.diameter_mm:g} mm",
                limit=Text("below {narrowest_mm:g} mm", narrowest_mm=narrowest_mm),
                advice="choose a smaller tool",
            )
        require_stepover(self.stepover_mm, tool)
        require_setup(setup)

    def _way(self, ellipse: Ellipse, wall_mm: float) -> tuple[Way, float, dict[str, float]]:
        """Return the curves to run along, how far off the wanted wall they promise to be, and the method's figure.

        wall_mm: how far the tool's centre keeps from the ellipse.
        """
        if self.method == "tolerance":
            figures = {"unreachable_mm": ellipse.unreachable_mm(wall_mm)}
            return (
                parallel_way(ellipse, wall_mm, self.stepover_mm, self.finish_stepover_mm, self.tolerance_mm),
                self.tolerance_mm,
                figures,
            )
        error_mm = self.resolution_mm * max(1.0, self.radius_x_mm / self.radius_y_mm)
        self._check_dda(ellipse, wall_mm, error_mm)
        radii_mm = (self.radius_x_mm, self.radius_y_mm)
        off_mm = offset_deviation_mm(ellipse, wall_mm)
        way = similar_way(self.centre_mm, radii_mm, self.rotation_deg, wall_mm, self.resolution_mm, error_mm)
        return way, off_mm + error_mm, {"offset_deviation_mm": off_mm}

    def _check_dda(self, ellipse: Ellipse, wall_mm: float, error_mm: float) -> None:
        tightest_mm, tool_mm = ellipse.minor_mm**2 / ellipse.major_mm, wall_mm - self.stock_to_leave_mm
        if wall_mm > tightest_mm:
            raise CycleError(
                "dda-tight",
                "the ellipse's ends are tighter than the tool, where similar ellipses would cut into the wall",
                value=Text("{wall_mm:g} mm radius", wall_mm=wall_mm),
                limit=f"{tightest_mm:.3f} mm",
                advice='use method "tolerance" or a smaller tool',
            )
        if error_mm > tool_mm / 2.0:
            raise CycleError(
                "dda-coarse",
                "resolution_mm is too coarse for the tool",
                value=f"{self.resolution_mm:g} mm",
                limit=f"{self.resolution_mm * tool_mm / 2.0 / error_mm:.3g} mm",
                advice="make it smaller, or islands remain",
            )


@dataclass(frozen=True)
class _Plan:
    region: Polygon
    rings: list[Curve]  # from the centre outwards, the last on the wall
    floors_mm: list[float]
    entry: Entry
    figures: dict[str, float]
    promise_mm: float


def _inner(region: Polygon, by_mm: float) -> Polygon:
    """Return a convex region shrunk."""
    return region.buffer(-by_mm, quad_segs=FINE) if by_mm else region
