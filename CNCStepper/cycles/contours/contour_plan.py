# SPDX-License-Identifier: LGPL-2.1-or-later
"""A contour's parameters turned into paths, removals, figures and warnings; see contour.py for the steps."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import accumulate, pairwise

import numpy as np
import shapely

from CNCStepper.cycles.contours.contour_levels import Path
from CNCStepper.cycles.contours.contour_model import ContourModel
from CNCStepper.cycles.contours.cutting_width import radius_at, require_contour_tool, require_kerf
from CNCStepper.cycles.contours.dogbones import Corner, Corners, relieved_mm, rest_warnings, strokes, with_reliefs
from CNCStepper.cycles.contours.leads import Fitted, Walls, fit_closed, fit_open
from CNCStepper.cycles.contours.neighbour_parts import neighbour_warnings, require_apart
from CNCStepper.cycles.contours.removed_area import removed
from CNCStepper.cycles.contours.scrap_side import require_followed, sides_of
from CNCStepper.cycles.contours.tabs import TabContext, stretches, tab_area, tab_places, tabs_wanted
from CNCStepper.cycles.cycle import Answer, Setup
from CNCStepper.cycles.moves import require_setup
from CNCStepper.cycles.passes import deep_pass_warnings, whole_passes
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.cut_order.cut_order import Stop, inside_before_outside, ordered
from CNCStepper.geometry.fitting.point_fit import fit_points
from CNCStepper.machine.tools.tool_shapes import BEAMS

FIT_SHARE = 0.3  # of the tolerance: how far a path may leave its exact parallel to be of fewer lines and arcs
LEAD_SHARE = 0.35  # of the tolerance: by so much a lead may come nearer to a wall than the tool's radius
START_MM = 1e-3  # of a path is where the tool goes down
SHORT_MM = 0.5  # a path whose segments are shorter than this on average is fitted again


@dataclass(frozen=True)
class Plan:
    """What a contour does: its paths in order, the height of its tabs, and what it reports."""

    paths: list[Path]
    tab_top_mm: float
    answer: Answer


@dataclass(frozen=True)
class _Way:
    """A path before tabs are set: its exact parallel, as it is run, its leads and corners."""

    exact: Curve
    curve: Curve  # from its start on
    fitted: Fitted
    corners: list[Corner]
    finishing: bool
    aside_mm: float


def planned(cycle: ContourModel, setup: Setup) -> Plan:
    """Return the plan of a contour; raises CycleError or GeometryError for what cannot be cut safely."""
    return _Planner(cycle, setup).plan()


class _Planner:
    """Turns the parameters into paths, removals and figures."""

    def __init__(self, cycle: ContourModel, setup: Setup):
        self.cycle, self.setup, self.tool = cycle, setup, setup.tool
        _require_cuttable(cycle, setup)
        self.radius_mm = cycle.kerf_mm / 2.0 or radius_at(self.tool, cycle.depth_mm, cycle.depth_mm)
        curves = [curve.moved(*cycle.offset_mm) for curve in cycle.curves]
        leave_mm, climb = cycle.stock_to_leave_mm, cycle.direction == "climb"
        self.sides = sides_of(curves, cycle.side, self.radius_mm, leave_mm, climb)
        self.scrap = 1 if climb else -1
        self.ramping = cycle.ramp_deg > 0
        self.warnings: list[str] = []

    def plan(self) -> Plan:
        """Return the paths to cut, in order."""
        cycle = self.cycle
        tracks = self.sides.tracks()
        require_followed(self.sides, tracks)
        rough = self.sides.tracks(cycle.finish_stepover_mm) if cycle.finish_stepover_mm else []
        require_apart(self.sides, [*tracks, *rough], self.setup.parts, cycle.tolerance_mm)
        corners = self._corners(tracks)
        walls = self._walls()
        ways = [self._way(track, found, walls, True) for track, found in zip(tracks, corners, strict=True)]
        ways += [self._way(track, [], walls, False) for track in rough]
        areas = self._tabs(ways)
        paths = [self._path(way, areas) for way in ways]
        answer = self._answer(ways, paths, len(areas))
        tab_top_mm = cycle.tabs.height_mm - cycle.depth_mm if cycle.tabs else -math.inf
        return Plan([paths[index] for index in _order(ways)], tab_top_mm, answer)

    def _corners(self, tracks: list[Curve]) -> list[list[Corner]]:
        if self.cycle.side == "on":
            return [[] for _ in tracks]
        finder = Corners(self.sides.wall(), self.radius_mm, self.cycle.tolerance_mm)
        return [finder.of(track, self.scrap, self.cycle.dogbones) for track in tracks]

    def _walls(self) -> Walls:
        """Return the obstacles of the leads: the drawn curves, and the parts of other operations."""
        slack_mm = LEAD_SHARE * self.cycle.tolerance_mm
        own, keep = self.sides.curves, self.setup.keep
        need = [self.sides.clear_mm - slack_mm] * len(own) + [self.radius_mm - slack_mm] * len(keep)
        names = [f"curve {number}" for number in range(1, len(own) + 1)]
        return Walls([*own, *keep], need, names + ["a part of another operation"] * len(keep))

    def _way(self, track: Curve, corners: list[Corner], walls: Walls, finishing: bool) -> _Way:
        cycle = self.cycle
        curve = _shortened(track, FIT_SHARE * cycle.tolerance_mm)
        leads = (cycle.lead_in, cycle.lead_out)
        if not curve.closed:
            fitted = fit_open(curve, leads, self.scrap, walls)
        elif cycle.overcut_mm < curve.length_mm:
            fitted = fit_closed(curve, leads, cycle.overcut_mm, self.scrap, walls)
            curve = curve.started_at_length(fitted.start_mm)
        else:
            raise CycleError(
                "overcut-long",
                "the overcut is longer than the contour",
                value=f"{cycle.overcut_mm:g} mm",
                limit=Text("below {length_mm:.3f} mm", length_mm=curve.length_mm),
                advice="make it shorter",
            )
        return _Way(track, curve, fitted, corners, finishing, 0.0 if finishing else cycle.finish_stepover_mm)

    def _tabs(self, ways: list[_Way]) -> list[shapely.Polygon]:
        cycle, areas = self.cycle, []
        if cycle.tabs is None:
            return []
        busy = [lead for way in ways for lead in way.fitted.leads]
        busy += [way.curve.part(0.0, max(self._overcut_mm(way), START_MM)) for way in ways]
        if cycle.dogbones != "none":
            busy += [stroke for way in ways for stroke in strokes(way.corners)]
        for way in (way for way in ways if way.finishing):
            wall_mm = self.sides.clear_mm if cycle.side != "on" else self.radius_mm
            scrap_mm = self.radius_mm + cycle.finish_stepover_mm
            ground = TabContext(self.radius_mm, self.scrap, wall_mm, scrap_mm, busy, self._overcut_mm(way))
            wanted = tabs_wanted(way.curve, cycle.tabs)
            places = tab_places(way.curve, cycle.tabs, ground)
            if len(places) < wanted:
                x, y = way.curve.xy[0]
                self.warnings.append(
                    Text(
                        "{places} of {wanted} tabs fit on the contour that begins at X{x:.3f} Y{y:.3f}; make them "
                        "narrower to fit more",
                        places=len(places),
                        wanted=wanted,
                        x=x,
                        y=y,
                    )
                )
            areas += [tab_area(way.curve, place, cycle.tabs, ground) for place in places]
        if not areas:
            raise CycleError(
                "tab-room",
                "no tab fits on any contour",
                value=Text("{width_mm:g} mm wide", width_mm=cycle.tabs.width_mm),
                advice="make the tabs narrower or the tool smaller, or cut without tabs",
            )
        return areas

    def _path(self, way: _Way, areas: list[shapely.Polygon]) -> Path:
        cycle = self.cycle
        pieces = stretches(way.curve, areas, self.radius_mm)
        overcut_mm, near_mm = self._overcut_mm(way), cycle.tolerance_mm
        corners = way.corners if cycle.dogbones != "none" else []
        relieved = [(with_reliefs(piece, corners, near_mm), up) for piece, up in pieces]
        return Path(
            pieces=tuple(pieces),
            relieved=tuple(relieved),
            whole=with_reliefs(way.curve, corners, near_mm),
            fitted=way.fitted,
            overcut=way.curve.part(0.0, overcut_mm) if overcut_mm else None,
            head_mm=relieved_mm(way.curve, corners, near_mm, overcut_mm),
            closed=way.curve.closed,
            floors_mm=self._floors(way),
            finishing=way.finishing,
            turns=cycle.side == "on",
        )

    def _overcut_mm(self, way: _Way) -> float:
        return self.cycle.overcut_mm if way.curve.closed else 0.0

    def _floors(self, way: _Way) -> tuple[float, ...]:
        """Return the levels of a path; a ramp that comes not down by the stepdown in one lap has more of them."""
        cycle = self.cycle
        step_mm, finish_mm = cycle.stepdown_mm or cycle.depth_mm, cycle.finish_stepdown_mm
        if self.tool.shape in BEAMS:
            step_mm, finish_mm = cycle.depth_mm, 0.0
        if self.ramping:
            leads_mm = 0.0 if way.curve.closed else sum(lead.length_mm for lead in way.fitted.leads)
            lap_mm = (way.curve.length_mm + leads_mm) * math.tan(math.radians(cycle.ramp_deg))
            step_mm, finish_mm = min(step_mm, lap_mm), finish_mm if finish_mm <= lap_mm else 0.0
        steps = whole_passes(cycle.depth_mm, step_mm, finish_mm, "stepdown_mm")
        return (*(-depth_mm for depth_mm in accumulate(steps[:-1])), -cycle.depth_mm)

    def _answer(self, ways: list[_Way], paths: list[Path], tabs: int) -> Answer:
        cycle = self.cycle
        finishing = [way for way in ways if way.finishing]
        relieved = [way for way in finishing if cycle.dogbones != "none"]
        reliefs = [stroke for way in relieved for stroke in strokes(way.corners)]
        low = [curve for path in paths for curve in path.low_curves(self.ramping)]
        every = [way.exact for way in ways] + [lead for path in paths for lead in path.cutting_leads(self.ramping)]
        removals = removed(self.cycle, self.tool, self.radius_mm, self.sides, low if tabs else every, every, reliefs)
        corners = [corner for way in finishing for corner in way.corners]
        left = [corner for corner in corners if cycle.dogbones == "none" or corner.relief is None]
        self._warn(finishing, tabs, left, reliefs)
        floors = max((path.floors_mm for path in paths), key=len)
        deepest_mm = max(before - floor for path in paths for before, floor in pairwise((0.0, *path.floors_mm)))
        self.warnings += deep_pass_warnings(deepest_mm, self.tool)
        figures = {
            "ap_mm": -floors[0],
            "levels": len(floors),
            "passes": 2 if cycle.finish_stepover_mm else 1,
            "contours": len(finishing),
            "length_mm": sum(way.curve.length_mm for way in finishing),
            "tabs": tabs,
            "rest_mm": max((corner.rest_mm for corner in left), default=0.0),
        }
        return Answer(removals, figures, self.warnings)

    def _warn(self, ways: list[_Way], tabs: int, left: list[Corner], reliefs: list[Curve]) -> None:
        cycle, thick_mm = self.cycle, self.setup.thickness_mm
        self.warnings += rest_warnings(left, boned=cycle.dogbones != "none")
        if hanging := self.sides.hanging([way.exact for way in ways]):
            x, y = self.sides.tightest()
            self.warnings.append(
                Text(
                    "{hanging} piece(s) stay joined to others, for the tool does not fit between them; "
                    "the tightest place is at X{x:.3f} Y{y:.3f}",
                    hanging=hanging,
                    x=x,
                    y=y,
                )
            )
        keep = self.setup.keep
        self.warnings += neighbour_warnings([way.exact for way in ways], self.radius_mm, keep, cycle.tolerance_mm)
        others = [curve for curve in keep if curve not in self.sides.curves]
        self.warnings += neighbour_warnings(reliefs, self.radius_mm, others, cycle.tolerance_mm)
        smallest = min(way.fitted.size for way in ways)
        if smallest < 1.0:
            self.warnings.append(
                Text(
                    "leads had to be made smaller to stay in the scrap, down to {smallest:.0%} of their size",
                    smallest=smallest,
                )
            )
        through = thick_mm is not None and cycle.depth_mm >= thick_mm
        if through and not tabs and self.tool.shape not in BEAMS and any(way.curve.closed for way in ways):
            self.warnings.append("the contour goes through the stock and sets a piece free that no tab holds")
        if cycle.kerf_mm and abs(cycle.kerf_mm - self.tool.diameter_mm) > cycle.tolerance_mm:
            self.warnings.append(
                Text(
                    "the cycle uses a kerf of {kerf_mm:g} mm, the simulation the tool's diameter of {diameter_mm:g} mm",
                    kerf_mm=cycle.kerf_mm,
                    diameter_mm=self.tool.diameter_mm,
                )
            )


def _require_cuttable(cycle: ContourModel, setup: Setup) -> None:
    """Raise CycleError for parameters that do not go together, or not with the tool."""
    tool = setup.tool
    require_contour_tool(tool)
    require_setup(setup)
    require_kerf(tool, cycle.kerf_mm, cycle.depth_mm)
    if tool.shape in BEAMS and (cycle.tabs or cycle.ramp_deg):
        raise CycleError(
            "beam-height",
            Text("a {tool_shape} cuts through at any height: no tabs, no ramp", tool_shape=tool.shape),
            advice="leave them out",
        )
    if cycle.tabs and cycle.tabs.height_mm >= cycle.depth_mm:
        raise CycleError(
            "tab-high",
            "the tabs are as high as the contour is deep",
            value=f"{cycle.tabs.height_mm:g} mm",
            limit=Text("below {depth_mm:g} mm", depth_mm=cycle.depth_mm),
            advice="make them lower",
        )
    if cycle.side == "on" and (cycle.lead_in.kind != "none" or cycle.lead_out.kind != "none"):
        raise CycleError("lead-side", "on its line a contour has no scrap side for leads", advice="choose another side")
    if cycle.side == "on" and (cycle.dogbones != "none" or cycle.finish_stepover_mm or cycle.stock_to_leave_mm):
        what = "on its line a contour has no wall for dog-bones, a finishing pass or stock to leave"
        raise CycleError("wall-side", what, advice="choose another side")
    if tool.core_diameter_mm > 0 and (not cycle.ramp_deg or cycle.ramp_deg > tool.ramp_max_deg or cycle.tabs):
        raise CycleError(
            "tool-core",
            "the mill does not cut over its centre: it can neither plunge nor come down beside a tab",
            value=Text("ramp {ramp_deg:g} deg", ramp_deg=cycle.ramp_deg),
            limit=Text("above 0, at most {ramp_max_deg:g} deg, no tabs", ramp_max_deg=tool.ramp_max_deg),
            advice="set ramp_deg and no tabs, or use a mill that cuts over its centre",
        )


def _shortened(curve: Curve, tolerance_mm: float) -> Curve:
    """Return the path as fewer lines and arcs where it is made of many short ones."""
    if curve.length_mm > SHORT_MM * len(curve):
        return curve
    found = fit_points(curve.points(tolerance_mm / 10.0), 0.9 * tolerance_mm, closed=curve.closed)
    return found if len(found) < len(curve) and found.closed == curve.closed else curve


def _order(ways: list[_Way]) -> list[int]:
    """Return the ways in order: inner ones first, roughing before the finishing pass along the same wall."""
    last = [index for index, way in enumerate(ways) if way.finishing]
    curves = [ways[index].curve for index in last]
    stops = [Stop.of_curve(curve, starts=[0] if curve.closed else None) for curve in curves]
    visits = ordered(stops, before=inside_before_outside(curves))
    order: list[int] = []
    rough = [index for index, way in enumerate(ways) if not way.finishing]
    beside = {index: _beside(ways[index], curves) for index in rough}
    for visit in visits:
        order += [index for index in rough if visit.item in beside[index] and index not in order]
        order.append(last[visit.item])
    return order


def _beside(way: _Way, curves: list[Curve]) -> list[int]:
    """Return which finishing passes a roughing pass runs along: the nearest, and all as near as it should be."""
    points = way.curve.xy
    near = np.array([curve.distances_mm(points).min() for curve in curves])
    return np.flatnonzero(near <= max(near.min(), way.aside_mm) * (1.0 + 1e-3)).tolist()
