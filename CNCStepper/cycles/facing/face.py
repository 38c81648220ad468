# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facing: the top of the whole stock, or of drawn regions of it, made level in one or several depths.

    zigzag   lines to and fro, a run as long as it gets
    oneway   every line in the same direction, climb or conventional throughout, over clearance height in between
    spiral   from outside inwards, climb or conventional throughout, where the shape allows it

The tool's centre runs past the outline by overhang_mm at the ends of lines, in the spiral all round; so no corner
stays, and the tool cuts up to its radius beyond. Wherever it can, it comes from the side: it goes down beside the
stock. Elsewhere, as in a region within the stock, it goes down as a pocket's entry does.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate

from pydantic import BaseModel, ConfigDict, Field
from shapely import Polygon
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.clearing.helix_and_ramp_entry import Entry, entry_for
from CNCStepper.cycles.clearing.pattern import Area
from CNCStepper.cycles.clearing.straight_links import LinkRegion
from CNCStepper.cycles.cycle import Answer, Removal, Setup
from CNCStepper.cycles.facing.face_parameters import FaceParameters
from CNCStepper.cycles.facing.facing_lines import chains_of, inwards, level, lines_of, one_way, zigzags
from CNCStepper.cycles.facing.side_entry import Surroundings, lead_to
from CNCStepper.cycles.moves import Moves, Point, point_of, require_setup
from CNCStepper.cycles.parameter_types import CurveField
from CNCStepper.cycles.passes import require_few_blocks, whole_passes
from CNCStepper.cycles.tool_requirements import require_flat, require_stepover
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.cut_order.cut_order import Stop, ordered
from CNCStepper.geometry.fitting.point_fit import refitted
from CNCStepper.geometry.region import Region
from CNCStepper.geometry.shapely_polygons import polygons_of
from CNCStepper.quantities import MOST_ITEMS
from CNCStepper.toolpath import TableBuilder

ROUNDING_MM = 0.002  # so much narrower than the tool a strip is at least


class Face(FaceParameters, BaseModel):
    """A facing that can be cut."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, arbitrary_types_allowed=True)

    outlines: tuple[CurveField, ...] = Field(default=(), max_length=MOST_ITEMS["areas"])

    def cut(self, setup: Setup, table: TableBuilder) -> Answer:
        """Append the facing to `table`; raises CycleError before any row when it cannot be cut."""
        plan = self._plan(setup)
        moves, top_mm = Moves(table, setup), setup.retract_mm
        for number, floor_mm in enumerate(plan.floors_mm, start=1):
            finishing = number == len(plan.floors_mm) and self.finish_stepdown_mm > 0
            table.open_span("level", f"level {number}", floor_mm=floor_mm)
            for run in plan.runs:
                _enter(run, moves, table, top_mm, floor_mm, setup.tool.feed_mm_min)
                table.open_span("pass", "finishing" if finishing else "roughing")
                moves.follow(run.curve, (finishing and self.finish_feed_mm_min) or setup.tool.feed_mm_min)
                table.close_span()
                moves.retract()
            table.close_span()
            top_mm = floor_mm
        return self._answer(plan)

    def _plan(self, setup: Setup) -> _Plan:
        self._require(setup)
        steps = whole_passes(self.depth_mm, self.stepdown_mm, self.finish_stepdown_mm, "stepdown_mm")
        floors_mm = [-depth_mm for depth_mm in accumulate(steps)]
        region, slack_mm = self._region(setup), self.tolerance_mm / 4.0
        wanted = polygons_of(region)
        wide_mm = self._strip_mm(wanted, setup)
        out_mm = self.overhang_mm if self.pattern == "spiral" else math.hypot(self.overhang_mm, wide_mm / 2.0)
        room = region.offset(out_mm, slack_mm)
        allowed = polygons_of(region.offset(out_mm + setup.tool.radius_mm, slack_mm))
        stock = Polygon() if setup.stock is None else polygons_of(Region.of([setup.stock]))
        around = Surroundings(stock, allowed, setup.tool.radius_mm)
        allowed = allowed if stock.is_empty else allowed.intersection(stock)
        if not allowed.area > 0:
            raise CycleError("face-beside", "the outlines are beside the stock", advice="move them or the work zero")
        groups, apart_mm = self._groups(wanted, room, wide_mm, setup)
        runs = [run for ways in groups for run in self._entered(ways, around, LinkRegion(room), setup)]
        blocks = sum(len(run.curve) + run.blocks(setup.retract_mm + self.depth_mm) for run in runs)
        require_few_blocks(len(floors_mm) * blocks)
        return _Plan(
            wanted.intersection(allowed), allowed, self._in_order(runs), [*floors_mm[:-1], -self.depth_mm], apart_mm
        )

    def _region(self, setup: Setup) -> Region:
        """Return the regions to face."""
        drawn = [refitted(curve.moved(*self.offset_mm), self.tolerance_mm / 4.0) for curve in self.outlines]
        if not drawn and setup.stock is None:
            raise CycleError("stock-missing", "there is no outline and no stock to face", advice="name one of them")
        region = Region.of(drawn or [curve for curve in [setup.stock] if curve is not None])
        if region.empty:
            raise CycleError("face-empty", "the outlines enclose nothing", advice="draw outlines with an area")
        return region

    def _strip_mm(self, wanted: BaseGeometry, setup: Setup) -> float:
        """Return the recalculated stepover."""
        _, low, _, high = level(wanted, self.angle_deg).bounds
        most_mm = min(self.stepover_mm, setup.tool.diameter_mm - ROUNDING_MM)
        return whole_passes(high - low, most_mm, 0.0, "stepover_mm")[0]

    def _groups(
        self, wanted: BaseGeometry, room: Region, wide_mm: float, setup: Setup
    ) -> tuple[list[list[list[Curve]]], float]:
        """Return what is to be cut, in groups that can be cut in several ways each (facing_lines.py), and the
        stepover."""
        climb = self.direction == "climb"
        if self.pattern == "spiral":
            return inwards(room, Area(room, setup.tool.radius_mm, self.stepover_mm, self.tolerance_mm, climb))
        lines = lines_of(level(wanted, self.angle_deg), wide_mm, self.overhang_mm)
        chains = chains_of(lines, level(polygons_of(room), self.angle_deg))
        if self.pattern == "oneway":
            return one_way(chains, self.angle_deg, climb), wide_mm
        return zigzags(chains, self.angle_deg), wide_mm

    def _entered(self, ways: list[list[Curve]], around: Surroundings, ground: LinkRegion, setup: Setup) -> list[_Run]:
        """Return the runs of the order with the most leads from outside the stock, and then the shortest.

        A run without one comes from where the run before began, if it can: there this floor is cut already.
        """
        leads = [[lead_to(curve, around) for curve in way] for way in ways]

        def cost(index: int) -> tuple[int, float]:
            far_mm = [
                math.dist(lead, curve.xy[0])
                for lead, curve in zip(leads[index], ways[index], strict=True)
                if lead is not None
            ]
            return len(ways[index]) - len(far_mm), sum(far_mm)

        best = min(range(len(ways)), key=cost)
        runs: list[_Run] = []
        for curve, lead in zip(ways[best], leads[best], strict=True):
            before = point_of(runs[-1].curve.xy[0]) if runs else None
            if lead is not None:
                runs.append(_Run(curve, point_of(lead)))
            elif before is not None and ground.sees(before, point_of(curve.xy[0])):
                runs.append(_Run(curve, before))
            else:
                runs.append(_Run(curve, self._entry(curve, ground, setup)))
        return runs

    def _entry(self, curve: Curve, ground: LinkRegion, setup: Setup) -> Entry:
        return entry_for(self.entry, ground, curve, setup.tool, self.entry_angle_deg)

    def _in_order(self, runs: Sequence[_Run]) -> list[_Run]:
        """Return the runs with short rapids between them; lines cut one way stay in their order."""
        if self.pattern == "oneway":
            return list(runs)
        stops = [Stop(run.curve.xy[:1], run.curve.xy[-1:], False) for run in runs]
        return [runs[visit.item] for visit in ordered(stops)]

    def _answer(self, plan: _Plan) -> Answer:
        inside = [run.way_in.kind for run in plan.runs if not isinstance(run.way_in, tuple)]
        figures = {"ap_mm": -plan.floors_mm[0], "levels": len(plan.floors_mm), "ae_mm": plan.apart_mm}
        figures |= {"passes": len(plan.runs), "entries_from_the_side": len(plan.runs) - len(inside)}
        removal = Removal(plan.allowed, 0.0, -self.depth_mm, self.tolerance_mm, plan.wanted)
        told: list[str] = [
            Text(
                "{inside} of {runs} runs cannot be entered from the side; a {kind} is used",
                inside=len(inside),
                runs=len(plan.runs),
                kind=kind,
            )
            for kind in inside
        ]
        return Answer([removal], figures, told[:1])

    def _require(self, setup: Setup) -> None:
        require_flat(setup.tool)
        require_stepover(self.stepover_mm, setup.tool)
        require_setup(setup)


@dataclass(frozen=True)
class _Run:
    """What is cut without lifting the tool, and the way in: a place from which to come sideways, or an entry."""

    curve: Curve
    way_in: Point | Entry

    def blocks(self, fall_mm: float) -> int:
        return 1 if isinstance(self.way_in, tuple) else self.way_in.blocks(fall_mm)


@dataclass(frozen=True)
class _Plan:
    wanted: BaseGeometry
    allowed: BaseGeometry
    runs: list[_Run]
    floors_mm: list[float]
    apart_mm: float


def _enter(run: _Run, moves: Moves, table: TableBuilder, top_mm: float, floor_mm: float, feed_mm_min: float) -> None:
    """Come to a run's begin on the floor: from beside the stock, or down from the floor above."""
    if isinstance(run.way_in, tuple):
        table.open_span("entry", "side")
        moves.approach(run.way_in)
        moves.plunge(floor_mm)
        moves.feed(point_of(run.curve.xy[0]), feed_mm_min)
    else:
        table.open_span("entry", run.way_in.kind)
        moves.approach(run.way_in.begin)
        moves.plunge(top_mm)
        run.way_in.descend(moves, top_mm, floor_mm, feed_mm_min)
    table.close_span()
