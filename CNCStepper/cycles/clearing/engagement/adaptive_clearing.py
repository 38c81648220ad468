# SPDX-License-Identifier: LGPL-2.1-or-later
r"""The plan of a run through one room at bounded engagement.

    opening      a helix has cut a disc at the room's roomiest place
    roughing     walks along the front of the material, each at the bound, or at what walls and corners leave of it
    links        from the end of a walk to the begin of the next, through what is cut
    wall         along the room's own loops, for the thin layer that is left there

The walks are those of the incremental method (as the adaptive clearing of kreso-t in FreeCAD's libarea has it), with
distances on a grid in place of polygons, and the angle of contact bounded in place of the area cut.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np
import shapely
from shapely import Polygon

from CNCStepper.cycles.clearing.engagement.clearing_map import ClearingMap, clearing_map_of, inset_mm
from CNCStepper.cycles.clearing.engagement.links import Links, straight
from CNCStepper.cycles.clearing.engagement.walk_kernels import IDLE, cut_to_node, follow, start, walk
from CNCStepper.cycles.clearing.pattern import Area, Opening, Pass, Run
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.fitting.point_fit import fit_points
from CNCStepper.geometry.region import Region

MARGIN_DEG = 1.0  # above the bound along the walls, at most: measured as coarsely as here it may be 4 degrees more
LEAST_DEG = 20.0  # planned at least: thinner chips would count as none
WIDEST_DEG = 135.0  # planned at most: beyond it a walk would be a slot
HELIX = 0.8  # of the radius; below 1 no core stays
LEAST_HELIX = 0.05
STEPS = (0.08, 0.08, 0.02, 0.02, 0.005, 0.005)  # of the radius, by attempt; every second one goes straight in
CHANNEL_STEPS = (0.055, 0.055, *STEPS[2:])  # the same in channels, whose arcs are small
LAGS = (0.32, 0.32, 0.08, 0.08, 0.02, 0.02)  # of the radius
THIN = (0.0128, 0.0128, 0.006, 0.006, 0.002, 0.002)  # of the radius: a chip below that is no engagement
BENT_RAD = math.radians(3.75)  # by which the first attempts may go above the bound in a channel's bends
SURE_DEG = 0.5  # by which the first attempts keep below the bound: refitted ways are a little off
UNSURE_DEG = 4.0  # by which attempts but the first keep below the bound: their lag hides more of the rim's side
SHORTEST_MM = 1e-3  # shorter walks are left out
LEAD = 0.2  # of the radius: before the material begins, in the other attempts
AHEAD = 0.1  # radians that it may turn to the right at once
SIDEWAYS = 1.6  # the same, straight in
REST = 0.3  # of the radius: the way between two walks, at least; what is just cut beside the tool counts as in its way
WALL_LAG = 0.4  # of the radius
CHIP = 0.03  # of the radius, or four tolerances: along walls a thinner one counts as nothing
LOOK = 0.02  # of the radius: between the places at which a link to a wall is looked at
SEEN = 0.8  # of that: thinner chips are no cutting where the length in the material is measured


class Plan:
    """The run through one room, while it grows, and how far its walks cut so far, the thinnest chips too.

    max_deg: the bound. channels: whether walks may exceed it in bends, no deeper than they may be straight on.
    """

    def __init__(self, area: Area, room: Region, max_deg: float, *, channels: bool = False):
        self.area, self.room, self.max_deg = area, room, max_deg
        self.steps, self.bent_rad = (CHANNEL_STEPS, BENT_RAD) if channels else (STEPS, 0.0)
        self.cut_mm = 0.0
        self.most = min(math.radians(min(max_deg, WIDEST_DEG)), _angle_rad(area))
        self.inset_mm = inset_mm(area)
        self.opening = self._opening()
        self.chart = clearing_map_of(room, area, area.tool_mm * (1.0 - math.cos(self.most)))
        self.chart.open(self.opening, area.tool_mm)

    def run(self) -> Run:
        self._clear()
        while len(places := self._overloaded()) and self.chart.require_cleared(places):
            self._clear()
        walls = list(self._walls())
        self._require_cleared()
        apart_mm = self.area.tool_mm * (1.0 - math.cos(self.most))
        return Run(tuple(self._passes(walls)), apart_mm, self.opening)

    def in_material_mm(self, run: Run) -> float:
        """Return the share of a run, which is cut again for that, on which the tool meets material."""
        chart, length_mm = self.chart, 0.0
        chart.fill()
        chart.cut(0, chart.begins[1])
        for curve in (one.curve for one in run.passes if not one.lifted):
            points, angles = self._followed(curve, chart, SEEN)
            length_mm += float(np.hypot(*np.diff(points, axis=0).T)[angles > 0.0].sum())
        return length_mm

    def _clear(self) -> None:
        self._rough()
        self._cut_specks()

    def _opening(self) -> Opening:
        outer, *holes = sorted((loop.points(self.inset_mm) for loop in self.room.loops), key=_extent, reverse=True)
        line = shapely.maximum_inscribed_circle(Polygon(outer, holes), tolerance=0.1 * self.area.tool_mm)
        centre = np.array(line.coords[0])
        wide_mm = min(HELIX * self.area.tool_mm, float(self.room.distances_mm(centre[None])[0]))
        if wide_mm < LEAST_HELIX * self.area.tool_mm:
            raise narrow(centre)
        return Opening((float(centre[0]), float(centre[1])), self.area.tool_mm + wide_mm)

    def _rough(self) -> None:
        chart = self.chart
        tried = np.zeros(len(chart.way), np.int8)
        beside = np.empty(len(chart.way), np.int64)
        attempt = 0
        while attempt < len(STEPS):
            node = start(
                chart.map, chart.way, chart.count, chart.front, chart.met, tried, attempt + 1, beside, *chart.place
            )
            if node < 0:
                attempt += 1
                continue
            index = int(chart.map.vertex.flat[node])
            if self._walk(node, index, attempt):
                attempt = 0
                tried[: chart.count] = 0
            else:
                tried[index] = attempt + 1

    def _walk(self, node: int, index: int, attempt: int) -> bool:
        """Add a walk that begins near the way's vertex `index`; return whether it has cleared anything."""
        chart = self.chart
        if attempt % 2 == 0:
            index = chart.before(index, LEAD * self.area.tool_mm)
            ahead = chart.way[index + 1] - chart.way[index]
            angle = math.atan2(ahead[1], ahead[0])
        else:
            aside = np.array(chart.at(node)) - chart.way[index]
            angle = math.atan2(aside[1], aside[0]) + math.pi / 2.0
        chart.branch(index)
        first = chart.count
        longest, lag = self.steps[attempt] * self.area.tool_mm, LAGS[attempt] * self.area.tool_mm
        turn = AHEAD if attempt % 2 == 0 else SIDEWAYS
        chart.map = chart.map._replace(thin=THIN[attempt] * self.area.tool_mm)
        kept = chart.kept(index, IDLE * self.area.tool_mm + lag)
        most, more = self.most - math.radians(UNSURE_DEG if attempt else SURE_DEG), 0.0 if attempt else self.bent_rad
        count, cleared, cut_mm = walk(
            chart.map, chart.way, first, angle, turn, longest, lag, most, more, chart.front, chart.met
        )
        if cleared:
            chart.count = count
            self.cut_mm += cut_mm
        else:
            chart.restore(kept)
            chart.drop()
        return bool(cleared)

    def _cut_specks(self) -> None:
        """Step to the nodes that no walk has cleared: specks between walks."""
        chart = self.chart
        for node in self.chart.uncleared_nodes().tolist():
            index = int(chart.map.vertex.flat[node])
            if index < 0 or chart.map.field.flat[node] <= chart.map.need.flat[node]:
                continue
            chart.branch(index)
            first, longest = chart.count, STEPS[2] * self.area.tool_mm
            kept, most = chart.kept(index, self.area.tool_mm), self.most - math.radians(UNSURE_DEG)
            count = cut_to_node(chart.map, chart.way, first, node, longest, most, chart.front, chart.met)
            if math.dist(chart.way[count - 1], chart.way[first - 1]) > SHORTEST_MM:
                chart.count = count
            else:
                chart.restore(kept)
                chart.drop()

    def _overloaded(self) -> np.ndarray:
        """Return where the rim would meet too much along the walls as things stand, float64[n, 2]."""
        chart = self.chart.copied()
        return np.vstack([self._too_much(self._begun(loop)[0], chart) for loop in self.area.room.loops])

    def _walls(self) -> Iterator[Curve]:
        """Yield the room's own loops as they are cut; raises CycleError where the engagement exceeds the bound."""
        for loop in self.area.room.loops:
            wall, index = self._begun(loop)
            self.chart.branch(index)
            self.chart.add(wall.xy[:1])
            places = self._too_much(wall, self.chart)
            if len(places):
                raise narrow(places[0])
            yield wall

    def _begun(self, loop: Curve) -> tuple[Curve, int]:
        """Return a loop as it is begun, and from which of the way's vertices a straight link leads there.

        That is at the middle of its longest segment, or where the way comes nearest to the loop: the link must not
        cut across an island's corner.
        """
        way = self.chart.way[: self.chart.count]
        wall = loop.started_at_length(_middle_mm(loop))
        index = int(np.argmin(np.hypot(*(way - wall.xy[0]).T)))
        if self._in_room(way[index], wall.xy[0]):
            return wall, index
        index, _, on_mm = loop.nearest_of(way, math.inf)
        return loop.started_at_length(on_mm), index

    def _in_room(self, begin: np.ndarray, end: np.ndarray) -> bool:
        """Return whether the straight way between two places stays in the true room, but for what rounding may add."""
        parts = math.ceil(math.dist(begin, end) / (LOOK * self.area.tool_mm))
        places = begin + np.linspace(0.0, 1.0, parts + 1)[:, None] * (end - begin)
        out = places[~self.area.room.contains(places)]
        return bool((self.area.room.distances_mm(out) <= self.area.tolerance_mm / 4.0).all())

    def _passes(self, walls: Sequence[Curve]) -> Iterator[Pass]:
        """Yield all passes: the planned walks are cut again, with links over cut material."""
        chart, links = self.chart, Links(self.chart, self.area.tool_mm, 0.75 * self.inset_mm)
        chart.fill()
        chart.cut(0, chart.begins[1])
        walks = list(chart.walks())
        roughed, here = len(walks) - len(walls), chart.begins[1] - 1
        for number, (parent, begin, end) in enumerate(walks, start=1):
            yield from self._between(here, parent, links)
            if number <= roughed:
                yield Pass(f"roughing {number}", fit_points(chart.way[begin:end], self.inset_mm / 2.0))
            else:
                yield from straight(chart.way[begin:end])
                yield Pass(f"wall {number - roughed}", walls[number - roughed - 1])
            chart.cut(begin, end)
            here = end - 1

    def _between(self, here: int, there: int, links: Links) -> list[Pass]:
        """Return the link between two walks, by a place further back where it would be too short."""
        way, least_mm = links.link(here, there), REST * self.area.tool_mm
        if sum(one.curve.length_mm for one in way) >= least_mm:
            return way
        back = self.chart.before(here, least_mm)
        return [*links.link(here, back), *links.link(back, there)]

    def _too_much(self, wall: Curve, chart: ClearingMap) -> np.ndarray:
        """Cut along a wall and return where the rim met more than the bound, float64[n, 2], the worst place first."""
        points, angles = self._followed(wall, chart, 1.0)
        worst_first = np.argsort(-angles, kind="stable")
        return points[1:][worst_first[np.degrees(angles[worst_first]) > self.max_deg + MARGIN_DEG]]

    def _followed(self, curve: Curve, chart: ClearingMap, share: float) -> tuple[np.ndarray, np.ndarray]:
        """Cut along a curve; return places along it, float64[n, 2], and at which angle each but the first is met.

        share: of CHIP; a thinner chip counts as nothing.
        """
        tool_mm = self.area.tool_mm
        parts = max(math.ceil(curve.length_mm / (0.05 * tool_mm)), 2)
        corners_mm = np.cumsum(curve.lengths_mm)[:-1]
        points = curve.at_length(np.union1d(np.linspace(0.0, curve.length_mm, parts + 1), corners_mm))[0]
        angles = np.zeros(len(points) - 1)
        thin = share * max(CHIP * tool_mm, 4.0 * self.area.tolerance_mm)
        follow(chart.map, points, chart.count - 1, tool_mm, thin, WALL_LAG * tool_mm, chart.front, chart.met, angles)
        return points, angles

    def _require_cleared(self) -> None:
        chart = self.chart
        nodes = chart.uncleared_nodes()
        nodes = nodes[chart.map.field.flat[nodes] > self.area.tool_mm + self.area.tolerance_mm]
        if len(nodes):
            raise narrow(np.array(chart.at(int(nodes[0]))))


def _angle_rad(area: Area) -> float:
    """Return the engagement that makes the stepover along a straight front.

    Raises CycleError for less than LEAST_DEG.
    """
    least_mm = area.tool_mm * (1.0 - math.cos(math.radians(LEAST_DEG)))
    if area.stepover_mm < least_mm:
        raise CycleError(
            "stepover-small",
            "stepover_mm is too small for the engagement to be bounded by it",
            value=f"{area.stepover_mm:g} mm",
            limit=Text("at least {least_mm:.3g} mm", least_mm=least_mm),
            advice="make stepover_mm larger",
        )
    return math.acos(max(1.0 - area.stepover_mm / area.tool_mm, -1.0))


def _extent(points: np.ndarray) -> float:
    return float(np.ptp(points, axis=0).sum())


def _middle_mm(loop: Curve) -> float:
    """Return at which length the middle of a loop's longest segment is."""
    ends = np.concatenate([[0.0], np.cumsum(loop.lengths_mm)])
    longest = int(np.argmax(np.diff(ends)))
    return float(ends[longest : longest + 2].mean())


def narrow(place: np.ndarray) -> CycleError:
    """Return the refusal of a pocket for what it is at a place, float64[2]."""
    x, y = place.tolist()
    return CycleError(
        "engagement-narrow",
        "the pocket is too narrow for its engagement to be bounded",
        value=f"at X{x:.3f} Y{y:.3f}",
        advice="use a smaller tool, a larger engagement_max_deg, or another pattern",
    )
