# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Straight ways through the scrap, clear of every part, and the shortest way from what is cut to what is to be cut.

walls      the parts, and open lines, grown by half the kerf and the margin: no way crosses them
corners    places just outside of the convex corners of the walls, where a shortest way can turn

     X - - - - corner         A connection begins on a way that is there already, at any place of it; it ends
    /            |            square to a ring, or at an end of an open line. The last margin of it, from
way-+-way      stand-off      the stand-off on, is the only one nearer than the walls.
                 |  lead
            - - ring - -
"""

from __future__ import annotations

import heapq
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from shapely import LineString, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.geometry.polygon import orient

from CNCStepper.cycles.moves import Point
from CNCStepper.cycles.wire_cutting.wire_items import OFFSET_TOLERANCE_MM, Item, Items, Line, Part
from CNCStepper.geometry.box_tree import tree_of
from CNCStepper.geometry.curve import joined
from CNCStepper.geometry.curve_bundle import bundle_of
from CNCStepper.geometry.line_of_sight import sees
from CNCStepper.geometry.offset import left_loops
from CNCStepper.geometry.region import Region
from CNCStepper.kernels import njit
from CNCStepper.tolerances import SAME_MM

COARSE = 0.1  # of the margin: how far corners may be off the walls
QUADRANT = 4  # chords of a quarter turn round a corner

Segment = tuple[Point, Point]


@dataclass(frozen=True)
class Connection:
    """A way from one that is there to an item: its vertices, the last one on the ring; item: which one."""

    item: int
    way: tuple[Point, ...]
    length_mm: float


class Roadmap:
    """The walls and corners of all items, and what is visible from where; outside: further places to turn at."""

    def __init__(self, items: Items, kerf_mm: float, margin_mm: float, outside: np.ndarray):
        self.half_mm, self.margin_mm = kerf_mm / 2.0, margin_mm
        self.clear_mm = self.half_mm + margin_mm
        self.stand_off_mm = margin_mm * (1.0 + COARSE / 2.0)
        self._material = items.material
        shapely.prepare(self._material)
        self._walls = _walls(items, self.clear_mm)
        rows = np.concatenate([wall.rows for wall in self._walls])
        self._barrier = (rows, *tree_of(rows, SAME_MM))
        corners = np.concatenate([_corners(items, self.clear_mm, COARSE * margin_mm), outside])
        self.corners = corners[self.free(corners)]
        self._seen: dict[int, np.ndarray] = {}

    def free(self, places: np.ndarray) -> np.ndarray:
        """Return which places, float64[m, 2], lie outside of all walls."""
        inside = np.zeros(len(places), bool)
        for wall in self._walls:
            inside |= wall.contains(places)
        return ~inside

    def sees(self, begins: np.ndarray, ends: np.ndarray) -> np.ndarray:
        """Return between which pairs of places, float64[m, 2] each, no wall stands."""
        pairs = np.ascontiguousarray(begins), np.ascontiguousarray(ends)
        return _sees_each(*self._barrier, *pairs)  # type: ignore[no-any-return]

    def sight_of(self, corner: int) -> np.ndarray:
        """Return how far all corners are from one, infinite where a wall stands between."""
        if corner not in self._seen:
            here = np.broadcast_to(self.corners[corner], self.corners.shape)
            seen = self.sees(here, self.corners)
            self._seen[corner] = np.where(seen, np.hypot(*(self.corners - here).T), np.inf)
        return self._seen[corner]

    def lead(self, begin: Point, item: Item) -> tuple[Point, ...] | None:
        """Return the end of a straight way from `begin` to an item: stand-off, place on it; None where blocked."""
        end = _nearest_place(item, begin)
        away_mm = float(np.hypot(end[0] - begin[0], end[1] - begin[1]))
        near_mm = self.stand_off_mm + (self.half_mm if isinstance(item, Line) else 0.0)
        if away_mm <= self.margin_mm * (1.0 - COARSE):
            return None
        share = min(near_mm / away_mm, 1.0)
        stand = (end[0] + share * (begin[0] - end[0]), end[1] + share * (begin[1] - end[1]))
        if not self.free(np.array([stand]))[0] or not self.sees(np.array([begin]), np.array([stand]))[0]:
            return None
        if shapely.distance(self._material, LineString([stand, end])) < self.half_mm - OFFSET_TOLERANCE_MM:
            return None
        return (end,) if share == 1.0 else (stand, end)


class Reach:
    """The shortest connections from ways that grow to items that are not connected yet.

    corner: how far each corner is straight from the nearest place of the ways, and that place.
    """

    def __init__(self, roadmap: Roadmap, allowed: np.ndarray, segments: Sequence[Segment]):
        self._map, self._allowed = roadmap, np.flatnonzero(allowed)
        self._segments: list[Segment] = []
        self._away_mm = np.full(len(roadmap.corners), np.inf)
        self._from = np.zeros((len(roadmap.corners), 2))
        self.grow(segments)

    def grow(self, segments: Sequence[Segment]) -> None:
        """Let connections begin on these segments too."""
        self._segments += segments
        corners = self._map.corners[self._allowed]
        for begin, end in segments if len(corners) else ():
            places = _feet(corners, np.array(begin), np.array(end))
            away_mm = np.hypot(*(corners - places).T)
            closer = np.flatnonzero(away_mm < self._away_mm[self._allowed] - SAME_MM)
            closer = closer[self._map.sees(places[closer], corners[closer])]
            self._away_mm[self._allowed[closer]] = away_mm[closer]
            self._from[self._allowed[closer]] = places[closer]

    def nearest(self, items: Sequence[Item], waiting: Sequence[int]) -> Connection | None:
        """Return the shortest connection to one of the waiting items; None where none can be reached."""
        best = self._straight(items, waiting)
        away_mm, before = self._away_mm.copy(), np.full(len(self._away_mm), -1)
        queue = [(float(away_mm[corner]), int(corner)) for corner in self._allowed if np.isfinite(away_mm[corner])]
        heapq.heapify(queue)
        while queue and (best is None or queue[0][0] < best.length_mm):
            so_far_mm, corner = heapq.heappop(queue)
            if so_far_mm > away_mm[corner]:
                continue
            best = self._from_corner(corner, so_far_mm, before, items, waiting, best)
            further_mm = so_far_mm + self._map.sight_of(corner)[self._allowed]
            closer = np.flatnonzero(further_mm < away_mm[self._allowed] - SAME_MM)
            for index in closer.tolist():
                other = int(self._allowed[index])
                away_mm[other], before[other] = further_mm[index], corner
                heapq.heappush(queue, (float(further_mm[index]), other))
        return best

    def _straight(self, items: Sequence[Item], waiting: Sequence[int]) -> Connection | None:
        """Return the shortest connection without a corner."""
        found: Connection | None = None
        lines = shapely.linestrings(self._segments)
        for item in waiting:
            gaps = shapely.shortest_line(lines, items[item].chords)
            for index in np.argsort(shapely.length(gaps).round(9), kind="stable").tolist():
                if found and shapely.length(gaps[index]) >= found.length_mm:
                    break
                x, y = gaps[index].coords[0]
                end = self._map.lead((float(x), float(y)), items[item])
                if end is not None:
                    found = _shorter(found, _connection(item, ((float(x), float(y)), *end)))
                    break
        return found

    def _from_corner(
        self,
        corner: int,
        so_far_mm: float,
        before: np.ndarray,
        items: Sequence[Item],
        waiting: Sequence[int],
        best: Connection | None,
    ) -> Connection | None:
        """Return the best connection with those that leave the corners here."""
        x, y = self._map.corners[corner].tolist()
        for item in waiting:
            left_mm = np.inf if best is None else best.length_mm - so_far_mm
            place = shapely.points(x, y)
            if not shapely.dwithin(place, items[item].chords, min(left_mm, 1e9)):
                continue
            end = self._map.lead((x, y), items[item])
            if end is not None:
                best = _shorter(best, _connection(item, (*self._way_to(corner, before), *end)))
        return best

    def _way_to(self, corner: int, before: np.ndarray) -> tuple[Point, ...]:
        ways = [corner]
        while before[ways[-1]] >= 0:
            ways.append(int(before[ways[-1]]))
        x, y = self._from[ways[-1]].tolist()
        return ((x, y), *(tuple(self._map.corners[each].tolist()) for each in reversed(ways)))


def _shorter(one: Connection | None, other: Connection) -> Connection:
    """Return the shorter connection; the first of two that differ by rounding alone."""
    return other if one is None or other.length_mm < one.length_mm - SAME_MM else one


def _connection(item: int, way: tuple[Point, ...]) -> Connection:
    steps = np.diff(np.array(way), axis=0)
    keep = [way[0], *(place for place, step in zip(way[1:], steps, strict=True) if np.hypot(*step) > SAME_MM)]
    return Connection(item, tuple(keep), float(np.hypot(*steps.T).sum()))


def _nearest_place(item: Item, place: Point) -> Point:
    """Return where a way from `place` meets an item: the nearest place of a ring, the nearer end of a line."""
    if isinstance(item, Part):
        _, along_mm = item.ring.nearest(np.array([place]))
        x, y = item.ring.at_length(float(along_mm[0]))[0].tolist()
        return x, y
    ends = item.curve.xy[[0, -1]]
    x, y = ends[np.hypot(*(ends - np.array(place)).T).argmin()].tolist()
    return x, y


def _feet(places: np.ndarray, begin: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Return the place of a segment that is nearest to each place."""
    along = end - begin
    square = float(along @ along)
    share = np.clip((places - begin) @ along / square, 0.0, 1.0) if square > 0.0 else np.zeros(len(places))
    return np.where(share[:, None] == 1.0, end, begin + share[:, None] * along)


@njit
def _sees_each(barrier, boxes, tree, begins, ends):
    """Return between which pairs of places no row of the barrier stands."""
    seen = np.empty(len(ends), np.bool_)
    for way in range(len(ends)):
        seen[way] = sees(barrier, boxes, tree, begins[way, 0], begins[way, 1], ends[way, 0], ends[way, 1])
    return seen


def _walls(items: Items, clear_mm: float) -> list[Region]:
    """Return the parts and the lines, each grown by what ways stay off them."""
    walls = [items.region.offset(clear_mm, OFFSET_TOLERANCE_MM)] if items.parts else []
    for line in items.lines:
        there_and_back = bundle_of([joined([line.curve, line.curve.reversed()])])
        walls.append(Region.trusted(left_loops(there_and_back, clear_mm, OFFSET_TOLERANCE_MM).reversed()))
    return walls


def _corners(items: Items, clear_mm: float, coarse_mm: float) -> np.ndarray:
    """Return the convex corners of polygons that lie a little outside of the walls, float64[m, 2]."""
    shapes = [part.polygon for part in items.parts] + [line.chords for line in items.lines]
    far_mm = (clear_mm + 3.0 * coarse_mm) / np.cos(np.pi / 4.0 / QUADRANT)
    found = [np.zeros((0, 2))]
    for shape in shapes:
        grown = shape.simplify(coarse_mm).buffer(far_mm, quad_segs=QUADRANT).simplify(coarse_mm)
        for polygon in shapely.get_parts(grown):
            found += [_convex(ring) for ring in _rings(polygon)]
    return np.concatenate(found)


def _rings(polygon: BaseGeometry) -> list[np.ndarray]:
    """Return the vertices of a polygon's rings, each once, the polygon to their left."""
    assert isinstance(polygon, Polygon)
    turned = orient(polygon)
    return [shapely.get_coordinates(ring)[:-1] for ring in (turned.exterior, *turned.interiors)]


def _convex(ring: np.ndarray) -> np.ndarray:
    """Return the vertices at which a ring turns to its left."""
    into, out = ring - np.roll(ring, 1, axis=0), np.roll(ring, -1, axis=0) - ring
    return ring[into[:, 0] * out[:, 1] - into[:, 1] * out[:, 0] > 0.0]
