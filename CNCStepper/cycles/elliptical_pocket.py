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

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np
from pydantic import BaseModel, ConfigDict, Field
from shapely import LineString, Point, Polygon, union_all

from CNCStepper.cycles.entry import Entry, entry_of
from CNCStepper.cycles.form import Answer, Removal, Setup
from CNCStepper.cycles.moves import Moves, require_feeds
from CNCStepper.cycles.passes import whole_passes
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.dda import ellipse_by_dda
from CNCStepper.geometry.ellipse import Ellipse
from CNCStepper.toolpath import TableBuilder

OUTLINE_ERROR_MM = 0.0002  # of the wanted region's polygon
ROUNDING_MM = 0.002  # what writing three decimals may add to a fitted arc, end and centre together
ISLAND_ERROR_MM = 0.01  # flattening where passes are tested for islands


class EllipticalPocket(BaseModel):
    """Parameters of the elliptical pocket, named as in a job file.

    depth_mm is ap_total, stepdown_mm ap, stepover_mm ae, finish_stepdown_mm ap_acab and
    finish_stepover_mm ae_acab; rotation_deg turns the ellipse counter-clockwise about its centre.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)

    cycle: Literal["elliptical_pocket"] = "elliptical_pocket"
    tool: int
    centre_mm: tuple[float, float] = (0.0, 0.0)
    radius_x_mm: float = Field(gt=0, le=100_000)
    radius_y_mm: float = Field(gt=0, le=100_000)
    rotation_deg: float = 0.0
    depth_mm: float = Field(gt=0, le=10_000)
    stepdown_mm: float = Field(gt=0)
    stepover_mm: float = Field(gt=0)
    finish_stepdown_mm: float = Field(default=0.0, ge=0)
    finish_stepover_mm: float = Field(default=0.0, ge=0)
    finish_feed_mm_min: float = Field(default=0.0, ge=0)
    method: Literal["tolerance", "dda"] = "tolerance"
    tolerance_mm: float = Field(default=0.01, ge=0.003, le=1.0)
    resolution_mm: float = Field(default=0.05, gt=0)
    entry: Literal["helix", "ramp", "plunge"] = "helix"
    entry_angle_deg: float = Field(default=3.0, gt=0, le=45.0)
    direction: Literal["climb", "conventional"] = "climb"

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
        region = Polygon(plan.ellipse.points(OUTLINE_ERROR_MM))
        return Answer([Removal(region, 0.0, -self.depth_mm, plan.promise_mm)], plan.figures)

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
            moves.feed(_point(ring.xy[0]), feed)
            moves.follow(ring, (self.finish_feed_mm_min or feed) if finishing else feed)
            table.close_span()

    def _plan(self, setup: Setup) -> _Plan:
        self._check(setup)
        ellipse = Ellipse.of_radii(self.centre_mm, self.radius_x_mm, self.radius_y_mm, self.rotation_deg)
        tool_mm = setup.tool.radius_mm
        levels = whole_passes(self.depth_mm, self.stepdown_mm, self.finish_stepdown_mm, "finish_stepdown_mm")
        floors = [-sum(levels[: n + 1]) for n in range(len(levels))]
        floors[-1] = -self.depth_mm
        maker = self._parallel_rings if self.method == "tolerance" else self._dda_rings
        rings, steps, figures, promise_mm = maker(ellipse, tool_mm)
        if self.direction == "conventional":
            rings = [ring.reversed() for ring in rings]
        entry = entry_of(self.entry, ellipse, tool_mm, self.finish_stepover_mm, self.entry_angle_deg)
        figures |= {"ap_mm": levels[0], "levels": len(levels), "passes": len(rings), "ae_mm": steps}
        return _Plan(ellipse, rings, floors, entry, figures, promise_mm)

    def _check(self, setup: Setup) -> None:
        tool = setup.tool
        narrowest_mm = 2.0 * min(self.radius_x_mm, self.radius_y_mm)
        if tool.shape != "flat":
            raise CycleError("tool-shape", f"a {tool.shape} tool leaves no flat floor", advice="use a flat tool")
        if tool.diameter_mm >= narrowest_mm:
            raise CycleError(
                "tool-wide",
                "the tool is wider than the pocket",
                value=f"{tool.diameter_mm:g} mm",
                limit=f"below {narrowest_mm:g} mm",
                advice="choose a smaller tool",
            )
        if self.stepover_mm > tool.diameter_mm:
            raise CycleError(
                "stepover-wide",
                "stepover_mm (ae) is larger than the tool",
                value=f"{self.stepover_mm:g} mm",
                limit=f"{tool.diameter_mm:g} mm",
                advice="make it smaller, or islands remain",
            )
        if self.finish_stepover_mm > tool.radius_mm:
            raise CycleError(
                "finish-wide",
                "finish_stepover_mm (ae_acab) is larger than the tool's radius",
                value=f"{self.finish_stepover_mm:g} mm",
                limit=f"{tool.radius_mm:g} mm",
                advice="leave less for the finishing pass",
            )
        require_feeds(setup)

    def _parallel_rings(self, ellipse: Ellipse, tool_mm: float) -> _Rings:
        """True parallel curves; where a step beyond the tool's radius would leave islands there is one pass more."""
        reach_mm = ellipse.minor_mm - tool_mm
        stepover_mm = self.stepover_mm
        while True:
            steps = whole_passes(reach_mm, stepover_mm, self.finish_stepover_mm, "finish_stepover_mm")
            rings = self._rings_at(ellipse, np.cumsum(steps), reach_mm)
            if steps[0] <= tool_mm or not leaves_islands(rings, ellipse.centre, tool_mm):
                break
            stepover_mm = (reach_mm - self.finish_stepover_mm) / (len(steps) - bool(self.finish_stepover_mm) + 1)
        figures = {"unreachable_mm": ellipse.unreachable_mm(tool_mm)}
        return rings, steps[0], figures, self.tolerance_mm

    def _rings_at(self, ellipse: Ellipse, from_centre_mm: np.ndarray, reach_mm: float) -> list[Curve]:
        fit_mm = 0.8 * (self.tolerance_mm - ROUNDING_MM)
        rough_mm = max(fit_mm, 0.2 * self.finish_stepover_mm)  # stays clear of the wall by four fifths of the stock
        inner = [ellipse.parallel(ellipse.minor_mm - out_mm, rough_mm) for out_mm in from_centre_mm[:-1]]
        return [*inner, ellipse.parallel(ellipse.minor_mm - reach_mm, fit_mm)]

    def _dda_rings(self, ellipse: Ellipse, tool_mm: float) -> _Rings:
        """Similar ellipses, point by point; they promise the resolution and what an ellipse differs from an offset."""
        if tool_mm > ellipse.minor_mm**2 / ellipse.major_mm:
            raise CycleError(
                "dda-tight",
                "the ellipse's ends are tighter than the tool, where similar ellipses would cut into the wall",
                value=f"{tool_mm:g} mm radius",
                limit=f"{ellipse.minor_mm**2 / ellipse.major_mm:.3f} mm",
                advice='use method "tolerance" or a smaller tool',
            )
        wide_mm, high_mm = self.radius_x_mm - tool_mm, self.radius_y_mm - tool_mm
        larger = max(wide_mm / high_mm, 1.0)
        steps = whole_passes(high_mm, self.stepover_mm / larger, self.finish_stepover_mm, "finish_stepover_mm")
        rings = []
        for share in np.cumsum(steps) / high_mm:
            ring = ellipse_by_dda(wide_mm * share, high_mm * share, self.resolution_mm)
            rings.append(ring.rotated(self.rotation_deg).moved(*self.centre_mm))
        off_mm = offset_deviation_mm(ellipse, tool_mm)
        promise_mm = off_mm + self.resolution_mm * max(1.0, self.radius_x_mm / self.radius_y_mm)
        return rings, steps[0] * larger, {"offset_deviation_mm": off_mm}, promise_mm


_Rings = tuple[list[Curve], float, dict[str, float], float]


@dataclass(frozen=True)
class _Plan:
    ellipse: Ellipse
    rings: list[Curve]  # from the centre outwards, the last on the wall
    floors_mm: list[float]
    entry: Entry
    figures: dict[str, float]
    promise_mm: float


def leaves_islands(rings: list[Curve], centre: tuple[float, float], tool_mm: float) -> bool:
    """Return whether a tool that runs along `rings` and has been at `centre` leaves something between them."""
    lines = [LineString(ring.points(ISLAND_ERROR_MM)).buffer(tool_mm, quad_segs=32) for ring in rings]
    swept = union_all([*lines, Point(centre).buffer(tool_mm, quad_segs=32)])
    return any(Polygon(hole).area > ISLAND_ERROR_MM for part in _parts(swept) for hole in part.interiors)


def offset_deviation_mm(ellipse: Ellipse, tool_mm: float) -> float:
    """Return how far the ellipse with both radii smaller by the tool leaves the true path of the tool's centre."""
    t = np.linspace(0.0, math.pi / 2.0, 721)
    own = np.column_stack([(ellipse.major_mm - tool_mm) * np.cos(t), (ellipse.minor_mm - tool_mm) * np.sin(t)])
    wall = Ellipse((0.0, 0.0), ellipse.major_mm, ellipse.minor_mm, 0.0).points(OUTLINE_ERROR_MM)
    ring = Polygon(wall).exterior
    return max(abs(ring.distance(Point(p)) - tool_mm) for p in own)


def _parts(geometry) -> list[Polygon]:
    return list(getattr(geometry, "geoms", [geometry]))


def _point(row: np.ndarray) -> tuple[float, float]:
    return float(row[0]), float(row[1])
