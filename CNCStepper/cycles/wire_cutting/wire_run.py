# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Rows of the table for the way of a wire: rapids round the sheet, the power, feeds, and corners.

  rapids, cold               A wire cuts at any height: all rows are at z = 0, and where there is a Z axis it
. - - - - - - - .            comes down beside the sheet. The wire is heated outside of the sheet, is hot all
|   +-------+                the way, and is put out when it is outside again.
'- >|- way  |
    +-------+                A wire lags behind: it goes slowly near a corner, and stands a while before it turns.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from shapely import LineString, Polygon
from shapely import Point as Place

from CNCStepper.cycles.cycle import Setup
from CNCStepper.cycles.moves import Moves, Point, point_of
from CNCStepper.cycles.wire_cutting.wire_route import Route, Stroke, corners_of
from CNCStepper.errors import Text
from CNCStepper.geometry.curve import Curve, straight
from CNCStepper.tolerances import COINCIDENT_MM
from CNCStepper.toolpath import TableBuilder

WITHIN_MM = 0.001  # of rounding: a wire that stands so far inside the sheet's edge stands on it
SHORTEST_DWELL_S = 0.001
SQUARE_DEG = 90.0  # by so much the way of a contour turns at its begin and end


@dataclass(frozen=True)
class Corners:
    """What a wire does where its way turns by angle_deg or more.

    dwell_s: how long it stands for a half turn. distance_mm: how far before and behind the corner it is slow, with
    feed_share of its feed.
    """

    dwell_s: float = 0.0
    angle_deg: float = 30.0
    distance_mm: float = 0.0
    feed_share: float = 1.0

    @property
    def is_slow(self) -> bool:
        """Whether the feed changes at corners."""
        return self.distance_mm > 0.0 and self.feed_share < 1.0


class WireRun:
    """Writes a route into a table.

    before: what the wire may burn on its way to the route's begin. warnings: what a person should know.
    """

    def __init__(self, table: TableBuilder, setup: Setup, sheet: Polygon | None):
        self._table, self._setup, self._sheet = table, setup, sheet
        self._moves = Moves(table, setup)
        self._dwells: list[float] = []
        self._slow_mm = 0.0
        self.before: list[Curve] = []
        self.warnings: list[str] = []

    def run(self, route: Route, kerf_mm: float, corners: Corners) -> dict[str, float]:
        """Append the rows; return lengths and dwells by their names."""
        begin = point_of(route.strokes[0].curve.xy[0])
        self._approach(begin, kerf_mm / 2.0)
        self._switch_on()
        for stroke in route.strokes:
            self._table.open_span(stroke.kind, stroke.name)
            self._follow(stroke, kerf_mm, corners)
            self._table.close_span()
        self._switch_off()
        lengths = {kind: sum(each.curve.length_mm for each in route.strokes if each.kind == kind) for kind in _KINDS}
        return {
            "length_mm": sum(lengths.values()),
            "link_mm": sum(lengths[kind] for kind in _KINDS if kind != "contour"),
            "corner_dwells": len(self._dwells),
            "corner_dwell_s": sum(self._dwells),
            "corner_slow_mm": self._slow_mm,
        }

    def _approach(self, begin: Point, half_mm: float) -> None:
        """Go round the sheet by rapids, and down beside it where there is a Z axis."""
        stands = point_of(np.array(self._table.position_mm))
        height_mm = self._setup.clearance_mm if self._setup.has_z else 0.0
        if self._sheet is not None and np.isfinite(stands).all():
            if self._sheet.buffer(-WITHIN_MM).contains(Place(stands)):
                self._warn_inside(stands, begin)
            elif self._sheet.distance(Place(stands)) < half_mm:
                stands = self._away(stands, begin, height_mm)
        for place in self._round(stands, begin, half_mm):
            self._rapid((*place, height_mm))
        self._rapid((*begin, 0.0))

    def _away(self, stands: Point, begin: Point, height_mm: float) -> Point:
        """Feed straight away from an edge that the wire touches, for it may be hot; return where it then is."""
        (low_x, low_y), _, (high_x, high_y), _ = self._corners(begin)
        (x, y), ways = stands, ((low_x, stands[1]), (high_x, stands[1]), (stands[0], low_y), (stands[0], high_y))
        place = min(ways, key=lambda way: abs(way[0] - x) + abs(way[1] - y))
        self._table.feed((*place, height_mm), self._setup.tool.feed_mm_min)
        self.before.append(straight(stands, place))
        return place

    def _warn_inside(self, stands: Point, begin: Point) -> None:
        what = (
            "the program begins at X{x:g} Y{y:g}, which is over the sheet: move the wire out of the sheet, "
            "to X{begin_x:.3f} Y{begin_y:.3f}, before it is started"
        )
        self.warnings.append(Text(what, x=stands[0], y=stands[1], begin_x=begin[0], begin_y=begin[1]))

    def _round(self, stands: Point, begin: Point, half_mm: float) -> list[Point]:
        """Return the places to go to, so that no straight way between them comes near the sheet."""
        if self._sheet is None or not np.isfinite(stands).all() or self._sheet.contains(Place(stands)):
            return [begin]
        near = self._sheet.buffer(half_mm - WITHIN_MM)
        corners = self._corners(begin)
        ways = ((*way, begin) for count in range(len(corners)) for way in itertools.permutations(corners, count))
        open_ones = [way for way in ways if not LineString([stands, *way]).intersects(near)]
        return list(min(open_ones, key=lambda way: LineString([stands, *way]).length))

    def _corners(self, begin: Point) -> list[Point]:
        """Return the corners of the box round the sheet on which the way begins, counter-clockwise from the lowest."""
        assert self._sheet is not None
        low_x, low_y, high_x, high_y = self._sheet.bounds
        off_mm = max(low_x - begin[0], begin[0] - high_x, low_y - begin[1], begin[1] - high_y)
        return [point_of(corner) for corner in corners_of(self._sheet.buffer(off_mm).bounds)]

    def _switch_on(self) -> None:
        """Put the power on and wait until the wire is hot."""
        self._table.set_state(replace(self._table.state, spindle="cw", spindle_rpm=self._setup.power_s))
        hot_s = self._setup.cut_data.pierce_delay_s if self._setup.cut_data else 0.0
        if hot_s:
            self._table.event("dwell", hot_s)

    def _switch_off(self) -> None:
        self._table.set_state(replace(self._table.state, spindle="off", spindle_rpm=0.0))
        if self._setup.has_z:
            self._moves.retract()

    def _follow(self, stroke: Stroke, kerf_mm: float, corners: Corners) -> None:
        """Run along a stroke; near the corners of a contour, its begin and its end, the wire is slow and stands."""
        feed_mm_min, curve = self._setup.tool.feed_mm_min, stroke.curve
        turns = _turns(curve, kerf_mm, corners.angle_deg) if stroke.kind == "contour" else []
        dwells = [(turn.first_mm, corners.dwell_s * turn.angle_deg / 180.0) for turn in turns if corners.dwell_s]
        near = _stretches(curve, turns, corners.distance_mm) if turns and corners.is_slow else np.zeros((0, 2))
        done_mm = 0.0
        for piece in curve.split([*(at_mm for at_mm, _ in dwells), *near.reshape(-1).tolist()]):
            dwells = self._stand(dwells, done_mm)
            middle_mm = done_mm + piece.length_mm / 2.0
            is_slow = bool(((near[:, 0] <= middle_mm) & (middle_mm <= near[:, 1])).any())
            self._moves.follow(piece, feed_mm_min * (corners.feed_share if is_slow else 1.0))
            self._slow_mm += piece.length_mm if is_slow else 0.0
            done_mm += piece.length_mm
        self._stand(dwells, curve.length_mm)

    def _stand(self, dwells: list[tuple[float, float]], at_mm: float) -> list[tuple[float, float]]:
        """Stand for the dwells up to a length of the way; return those that are left."""
        for place_mm, seconds in dwells:
            if place_mm <= at_mm + COINCIDENT_MM:
                self._dwell(seconds)
        return [each for each in dwells if each[0] > at_mm + COINCIDENT_MM]

    def _dwell(self, seconds: float) -> None:
        if seconds >= SHORTEST_DWELL_S:
            self._table.event("dwell", seconds)
            self._dwells.append(seconds)

    def _rapid(self, end: tuple[float, float, float]) -> None:
        if end != self._table.position_mm[:3]:
            self._table.rapid(end)
        self._moves.position = end


_KINDS = ("link", "lead-in", "lead-out", "slit", "contour")


@dataclass(frozen=True)
class _Turn:
    """A corner: from which length of the way to which it turns, and by how much."""

    first_mm: float
    last_mm: float
    angle_deg: float


def _turns(curve: Curve, kerf_mm: float, least_deg: float) -> list[_Turn]:
    """Return where a way turns by at least an angle.

    An arc no wider than the kerf, round a sharp corner of the part, turns as sharply as a corner; where the way of a
    contour ends it turns square to its lead.
    """
    begins, ends = curve.begin_directions, curve.end_directions
    turns_deg = np.degrees(np.arctan2(_cross(ends[:-1], begins[1:]), (ends[:-1] * begins[1:]).sum(axis=1)))
    round_corner = np.abs(curve.radii_mm) <= kerf_mm / 2.0 * 1.01
    arcs_deg = np.where(round_corner & (curve.bulge != 0.0), np.degrees(curve.sweeps_rad), 0.0)
    at_deg = np.abs(np.concatenate([[0.0], turns_deg]) + arcs_deg)
    before_mm = curve.before_mm
    found = [
        _Turn(float(before_mm[vertex]), float(before_mm[vertex + int(arcs_deg[vertex] != 0.0)]), float(at_deg[vertex]))
        for vertex in np.flatnonzero((at_deg >= least_deg) & (at_deg > 0.0)).tolist()
    ]
    end = _Turn(curve.length_mm, curve.length_mm, SQUARE_DEG)
    return [*found, end] if least_deg <= SQUARE_DEG else found


def _stretches(curve: Curve, turns: Sequence[_Turn], distance_mm: float) -> np.ndarray:
    """Return the stretches within a distance of turns, and of the begin, where it turns off its lead: float64[k, 2]."""
    ends = [(0.0, 0.0), *((turn.first_mm, turn.last_mm) for turn in turns)]
    around = np.array([-distance_mm, distance_mm])
    return np.clip(np.array(ends) + around, 0.0, curve.length_mm)


def _cross(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    return np.asarray(one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0])
