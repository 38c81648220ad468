# SPDX-License-Identifier: LGPL-2.1-or-later
"""How thick the material is that stays inside what was to be removed.

A point p at the floor of the removal is left; the layer over it is as thick as its distance to what
was cut. What was cut at level z is everything within the tool's radius of the path at or below z:

    thickness(p) = min over the levels z of  gap( distance(p, path at or below z), z - bottom )

It grows along the way out from the path, so it is largest on the region's wall or where the ways from
two passes meet: at a corner of the path's Voronoi diagram. Such an island is twice as thick as its
middle is far from the cut. The levels are taken from the bottom upwards until none can matter.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import partial

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.cycle import Removal
from CNCStepper.simulation.cutter_solid import Cutter
from CNCStepper.simulation.exact.gouge import Worst
from CNCStepper.simulation.exact.segment_blocks import MOST_HELD, Blocks, Cuts, Trees, joined
from CNCStepper.simulation.exact.voronoi_corners import Places, corners_within
from CNCStepper.simulation.exact.wall_distance import climbed
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.tip_segments import Segments, chains, clipped_below
from CNCStepper.tolerances import SAME_HEIGHT_MM, TOUCHING_MM

MOST_LEVELS = 200
MOST_BELOW = 50  # levels below a floor, where a point is wider at the floor
WALL_STEP_MM = 0.1
COARSE = 0.05  # share of the radius by which the path may be simplified to find where islands can be
VORONOI_STEP = 0.1  # share of the radius between the points of that path
RUN_POINTS = 400  # of the path are simplified at once
MOST_AREAS = 16  # are joined at once
ISLAND_REACH_MM = 0.5  # middles closer than twice this belong to one island
MOST_CLIMBED = 100
BESIDE_MM = 1.0  # a path may lie this far beside what it was meant to remove, and is still measured


@dataclass(frozen=True)
class Island:
    """An island of material inside a removal: its thickest place and how thick it is."""

    place_mm: tuple[float, float, float]
    thickness_mm: float


@dataclass(frozen=True)
class Leftover:
    """What a removal leaves: the thickest material, and the islands thicker than the removal's tolerance."""

    tolerance_mm: float
    worst: Worst = field(default_factory=Worst)
    islands: list[Island] = field(default_factory=list)


@dataclass(frozen=True)
class _Cover:
    """What is cut at one level, and how far it lies above the floor."""

    drop_mm: float
    parts: list[tuple[Cutter, Trees]]

    def thickness(self, points: np.ndarray, alone: bool) -> np.ndarray:
        """Return the distance of floor points to the cut; `alone` counts the distance across an island twice."""
        thickness = np.full(len(points), np.inf)
        for cutter, trees in self.parts:
            beside = trees.distance(points)
            if alone:
                beside = beside + np.maximum(beside - cutter.radius_mm, 0.0)
            thickness = np.minimum(thickness, cutter.gap(beside, self.drop_mm))
        return thickness

    def clearance(self, points: np.ndarray) -> np.ndarray:
        """Return a measure that grows with the thickness, and keeps falling below zero under a flat floor."""
        clearance = np.full(len(points), np.inf)
        for cutter, trees in self.parts:
            beside = trees.distance(points)
            gap = cutter.gap(beside, self.drop_mm)
            within = beside < cutter.floor_mm
            clearance = np.minimum(clearance, np.where(within, beside - cutter.floor_mm, gap))
        return clearance

    def reach(self, points: np.ndarray) -> np.ndarray:
        """Return how far the nearest of the points that `_coarse` gives is at most."""
        reach = np.full(len(points), np.inf)
        for cutter, trees in self.parts:
            between_mm = COARSE * cutter.radius_mm + _spread_mm(cutter) / 2
            reach = np.minimum(reach, trees.distance(points) + between_mm)
        return reach


def left_over(removal: Removal, cuts: Cuts, stock: Stock | None = None) -> Leftover:
    """Return the thickest material left of one removal, and its islands thicker than its tolerance.

    stock: where its top lies lower than the removal's, no more can be left than there was.
    """
    wall = _Candidates(_wall_points(removal.region), alone=False)
    middles = _Candidates(np.zeros((0, 2)), alone=True)
    covers: list[_Cover] = []
    for cover in _covers(removal, _near(cuts, removal.region)):
        if covers and max(wall.thickest, middles.thickest) <= cover.drop_mm:
            break  # whatever is left here is nearer to a cut already seen
        covers.append(cover)
        wall.meet([cover])
        middles.meet([cover])
        if removal.region.area > 0 and cover.drop_mm >= 0:
            middles.join(_Candidates(_middles(removal.region, cover), alone=True), covers)
    if removal.region.length and wall.thickest > SAME_HEIGHT_MM and covers:
        wall.join(_Candidates(_finer(removal.region, wall), alone=False), covers)
    for found in (wall, middles):
        found.limit(removal, stock)
    return _answer(removal, wall, middles, covers)


class _Candidates:
    """Points where the thickest material may be, with the thickness found so far."""

    def __init__(self, points: np.ndarray, alone: bool):
        self.points = points
        self.alone = alone
        self.thickness = np.full(len(points), np.inf)

    @property
    def thickest(self) -> float:
        return float(self.thickness.max(initial=0.0))

    def meet(self, covers: list[_Cover]) -> None:
        """Let the cut of these levels count; only points that still matter are measured."""
        for cover in covers:
            open_ = self.thickness > cover.drop_mm
            self.thickness[open_] = np.minimum(self.thickness[open_], cover.thickness(self.points[open_], self.alone))

    def limit(self, removal: Removal, stock: Stock | None) -> None:
        """Let nothing be thicker than what there was over the removal's floor."""
        top_mm = removal.top_mm if stock is None else np.minimum(stock.tops_at(self.points), removal.top_mm)
        self.thickness = np.minimum(self.thickness, np.maximum(top_mm - removal.bottom_mm, 0.0))

    def join(self, others: _Candidates, covers: list[_Cover]) -> None:
        """Take in new points, measured against all levels so far."""
        others.meet(covers)
        self.points = np.vstack([self.points, others.points])
        self.thickness = np.r_[self.thickness, others.thickness]


def _near(cuts: Cuts, region: BaseGeometry) -> Cuts:
    """Return the cuts whose discs reach the bounds of the region, or nearly: a point that engraves has no disc."""
    return [(cutter, Blocks(blocks, partial(_meeting, region, cutter)).held()) for cutter, blocks in cuts]


def _meeting(region: BaseGeometry, cutter: Cutter, pieces: Segments) -> Segments:
    low_x, low_y, high_x, high_y = np.array(region.bounds) + BESIDE_MM * np.array([-1, -1, 1, 1])
    low = np.minimum(pieces.begin, pieces.end) - cutter.radius_mm
    high = np.maximum(pieces.begin, pieces.end) + cutter.radius_mm
    return pieces[(low[:, 0] <= high_x) & (high[:, 0] >= low_x) & (low[:, 1] <= high_y) & (high[:, 1] >= low_y)]


def _covers(removal: Removal, cuts: Cuts) -> Iterator[_Cover]:
    """Yield the cut at the floor, then at each level above it where a piece of path ends.

    Where a point went deeper than the floor, it is wider there: those levels come first.
    """
    above = _ends(cuts, removal.bottom_mm, removal.top_mm, MOST_LEVELS)
    pointed = [cut for cut in cuts if cut[0].form.slope]
    full_mm = max((cutter.rise_mm for cutter, _ in pointed), default=0.0)  # deeper makes it no wider
    below = _ends(pointed, removal.bottom_mm - full_mm, removal.bottom_mm, MOST_BELOW)
    lowest = [removal.bottom_mm - full_mm] if pointed else []
    room = [MOST_HELD]
    for level in np.r_[lowest, below, removal.bottom_mm, above].tolist():
        lower = partial(clipped_below, level_mm=level + SAME_HEIGHT_MM)
        parts = [(cutter, Trees(Blocks(blocks, lower), room)) for cutter, blocks in cuts]
        yield _Cover(level - removal.bottom_mm, parts)


def _ends(cuts: Cuts, low_mm: float, high_mm: float, most: int) -> np.ndarray:
    """Return the heights between two others at which pieces of path end, rising, at most that many of them."""
    levels = np.zeros(0)
    for pieces in (pieces for _, blocks in cuts for pieces in blocks):
        ends = np.r_[pieces.begin[:, 2], pieces.end[:, 2]]
        between = ends[(ends > low_mm + SAME_HEIGHT_MM) & (ends < high_mm - SAME_HEIGHT_MM)]
        levels = np.union1d(levels, np.round(between / SAME_HEIGHT_MM) * SAME_HEIGHT_MM)
    return levels if len(levels) <= most else levels[np.linspace(0, len(levels) - 1, most).astype(int)]


def _wall_points(region: BaseGeometry) -> np.ndarray:
    lines = region.boundary if region.area > 0 else region
    return shapely.get_coordinates(shapely.segmentize(lines, WALL_STEP_MM))


def _finer(region: BaseGeometry, wall: _Candidates) -> np.ndarray:
    """Return points on the wall close about the thickest found, so that a peak between two points is not missed."""
    lines = shapely.get_parts(region.boundary if region.area > 0 else region)
    offsets = np.linspace(-WALL_STEP_MM, WALL_STEP_MM, 201)
    found = []
    for point in shapely.points(wall.points[np.argsort(-wall.thickness, kind="stable")[:12]]):
        line = lines[np.argmin(shapely.distance(lines, point))]
        found.append(_places_on(line, shapely.line_locate_point(line, point) + offsets))
    return np.vstack(found)


def _places_on(line: shapely.LineString, lengths_mm: np.ndarray) -> np.ndarray:
    """Return the places at lengths along a line, float64[n, 2]; before its begin that, beyond its end that."""
    corners = shapely.get_coordinates(line)
    reached = np.r_[0.0, np.cumsum(np.hypot(*np.diff(corners, axis=0).T))]
    return np.column_stack([np.interp(lengths_mm, reached, corners[:, axis]) for axis in range(2)])


def _middles(region: BaseGeometry, cover: _Cover) -> np.ndarray:
    """Return the points inside the region, uncut at this level, that are locally farthest from the path.

    What hangs together with the wall is no island, and the wall's own points tell it.
    """
    places = Places()
    sure: list[BaseGeometry] = []
    for area, points in (one for cutter, trees in cover.parts for one in _coarse(cutter, trees.blocks)):
        places.add(points)
        sure = [*([shapely.union_all(sure)] if len(sure) == MOST_AREAS else sure), area]
    if not sure:
        return np.zeros((0, 2))
    uncut = region.difference(shapely.union_all(sure))
    corners = corners_within(uncut, places, cover.reach)
    shapely.prepare(region)

    def height(points: np.ndarray) -> np.ndarray:
        return np.where(shapely.contains_xy(region, points), cover.clearance(points), -np.inf)

    found = np.vstack([corners, climbed(_most_promising(corners, cover), height, step_mm=0.1, stop_mm=2e-4)])
    return found[shapely.distance(region.boundary, shapely.points(found)) > cover.clearance(found)]


def _most_promising(corners: np.ndarray, cover: _Cover) -> np.ndarray:
    """Return at most MOST_CLIMBED of the points, those farthest from the cut, one in each small square."""
    corners = corners[np.argsort(-cover.clearance(corners), kind="stable")]
    first = np.unique(np.round(corners / ISLAND_REACH_MM), axis=0, return_index=True)[1]
    return corners[np.sort(first)[:MOST_CLIMBED]]


def _coarse(cutter: Cutter, blocks: Blocks) -> Iterator[tuple[BaseGeometry, np.ndarray]]:
    """Yield an area that is surely cut, which is that of the cutter's flat floor, and points of the path.

    The path is simplified in short runs: the buffer of a long one that crosses itself takes seconds.
    """
    error_mm = COARSE * cutter.radius_mm
    for runs in _runs(blocks):
        paths = shapely.simplify(np.array([shapely.LineString(run) for run in runs]), error_mm)
        is_point = shapely.length(paths) == 0  # a plunge seen from above
        spread = np.r_[shapely.segmentize(paths[~is_point], _spread_mm(cutter)), paths[is_point]]
        sure_mm = max(cutter.floor_mm - error_mm, 0.0)
        yield shapely.union_all(shapely.buffer(paths, sure_mm)), shapely.get_coordinates(spread)


def _spread_mm(cutter: Cutter) -> float:
    """Return the largest distance between the sample points of a path."""
    return max(VORONOI_STEP * cutter.radius_mm, 0.01)


def _runs(blocks: Blocks) -> Iterator[list[np.ndarray]]:
    """Yield for each block its chains in runs of at most RUN_POINTS points that share their ends.

    The last run of a block continues in the next one, so that blocks of any length have the same runs.
    """
    waiting: Segments | None = None
    for pieces in blocks:
        if waiting is None or not len(pieces):
            waiting = pieces if waiting is None else waiting
            continue
        open_ = _begin_of_open_run(waiting)
        if open_:
            yield _runs_of(waiting[:open_])
        waiting = joined([waiting[open_:], pieces])
    if waiting is not None and len(waiting):
        yield _runs_of(waiting)


def _begin_of_open_run(pieces: Segments) -> int:
    """Return the first segment of the last run, which more segments may make longer."""
    breaks = np.flatnonzero((pieces.begin[1:] != pieces.end[:-1]).any(axis=1)) + 1
    chain = int(breaks[-1]) if len(breaks) else 0
    return len(pieces) - (len(pieces) - chain) % (RUN_POINTS - 1)


def _runs_of(pieces: Segments) -> list[np.ndarray]:
    step = RUN_POINTS - 1
    return [chain[k : k + RUN_POINTS, :2] for chain in chains(pieces) for k in range(0, len(chain) - 1, step)]


def _answer(removal: Removal, wall: _Candidates, middles: _Candidates, covers: list[_Cover]) -> Leftover:
    points = np.vstack([wall.points, middles.points])
    thickness = np.r_[wall.thickness, middles.thickness]
    k = int(thickness.argmax()) if len(points) else 0
    if not len(points) or thickness[k] <= SAME_HEIGHT_MM:
        return Leftover(removal.tolerance_mm)
    place = (*points[k].tolist(), removal.bottom_mm)
    islands = _islands(removal, middles)
    return Leftover(removal.tolerance_mm, Worst(float(thickness[k]), place, _nearest_row(points[k], covers)), islands)


def _islands(removal: Removal, middles: _Candidates) -> list[Island]:
    """Return one island for each group of middles that lie in one another's reach, thickest first."""
    thick = middles.thickness > removal.tolerance_mm
    points, thickness = middles.points[thick], middles.thickness[thick]
    reach = shapely.union_all(shapely.buffer(shapely.points(points), thickness / 2 + ISLAND_REACH_MM, quad_segs=2))
    islands = []
    for part in shapely.get_parts(reach):
        mine = np.flatnonzero(shapely.contains_xy(part, points))
        k = mine[thickness[mine].argmax()]
        islands.append(Island((*points[k].tolist(), removal.bottom_mm), float(thickness[k])))
    return sorted(islands, key=lambda island: -island.thickness_mm)


def _nearest_row(point: np.ndarray, covers: list[_Cover]) -> int:
    """Return the row of the table whose path comes nearest to the point, the last of those as near, or -1."""
    found = [trees.nearest(point) for _, trees in covers[-1].parts] if covers else []
    known = [one for one in found if one]
    nearest = min(known, default=(0.0, -1))[0]
    return max((row for distance, row in known if distance <= nearest + TOUCHING_MM), default=-1)
