# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Spiral: from the middle outwards in one curve, then once round the wall, without a step from ring to ring.

        .----------.        On the ray from the middle c with the angle v, turned by so far since the start, stands
      /  .------.   \       the point whose distance to the wall is
     |  |  c-.   |   |
     |   \    |  |   |          depth of c - step * v / (2 pi)
      \   '--'  /   /
        '------'---'        so the distance falls by one step a turn, evenly, whatever the shape.

The shape allows it where it has one part without holes, where from c every parallel of the wall is seen whole (all
convex rooms, and rooms near to that) and none splits. Between two turns the distance to the wall falls by a step and
by what the outer turn falls while the shortest way to the wall leads round c, by an angle of less than that between
the way and the ray. So with all of that below the tool's radius nothing stays between the turns.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import shapely
from shapely import LineString, Polygon

from CNCStepper.cycles.clearing.pattern import Area, Pass, Run
from CNCStepper.cycles.passes import MOST_PASSES
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve, from_points
from CNCStepper.geometry.fitting.point_fit import refitted

FLAT = 0.1  # of the tolerance: how far chords leave the wall, and once more fewer chords these
CHORD = 0.2  # of the tolerance: how far the spiral's points are apart
FIT = 0.5  # of the tolerance: how far the fitted spiral leaves its chords
MIDDLE = 1e-3  # the middle is where the room is at least this share less deep than at its deepest
BISECTIONS = 18
FIRST_POINTS = 48  # of a turn
ROUNDS = 12  # of halving chords that are too coarse
TURN = 2.0 * math.pi


def spiral(area: Area) -> list[Run]:
    """Return one run from the middle to the wall and round it; turns are at most the stepover and the radius apart.

    Raises CycleError where the room's shape does not allow it.
    """
    if area.room.empty:
        return []
    if len(area.room.loops) > 1:
        raise _no_spiral("the room of the tool's centre has islands or several parts", f"{len(area.room.loops)} walls")
    rays = _rays(area.room.loops[0], FLAT * area.tolerance_mm)
    lag = _lag(rays)
    turns = _turns(rays, area, lag)
    _require_seen(area, rays, turns)
    points = _points(rays, turns, area)
    wall = area.room.loops[0]
    ring = wall.started_at_length(float(wall.nearest(points[-1:])[1][0]))
    way = refitted(from_points(np.vstack([points[:-1], ring.xy[:1]])), FIT * area.tolerance_mm)
    passes = Pass("roughing 1", way), Pass("roughing 2", ring if area.climb else ring.reversed())
    return [Run(passes, rays.depth_mm / turns * (1.0 + lag))]


@dataclass(frozen=True)
class _Rays:
    """The wall as seen from the middle.

    wall: its chords. angles_rad, ascending, and their reaches_mm: the wall's points. middle: complex. depth_mm: its
    distance to the wall; start_rad: the direction of the nearest place of the wall.
    """

    wall: LineString
    middle: complex
    depth_mm: float
    start_rad: float
    angles_rad: np.ndarray
    wall_points: np.ndarray

    def reaches_mm(self, angles_rad: np.ndarray) -> np.ndarray:
        """Return how far it is from the middle to the wall in each direction: where a chord meets the ray."""
        turned = (angles_rad - self.angles_rad[0]) % TURN + self.angles_rad[0]
        index = np.clip(np.searchsorted(self.angles_rad, turned, "right") - 1, 0, len(self.angles_rad) - 2)
        begin, end = self.wall_points[index], self.wall_points[index + 1]
        way = np.exp(1j * angles_rad)
        across = (np.conj(way) * (end - begin)).imag
        return np.where(
            np.abs(across) > 1e-12, (np.conj(begin) * end).imag / np.where(across, across, 1.0), np.abs(begin)
        )

    def at_depth(self, angles_rad: np.ndarray, depths_mm: np.ndarray) -> np.ndarray:
        """Return the points, complex128, on rays where the wall is that far away: the farthest from the middle."""
        ways = np.exp(1j * angles_rad)
        low, high = np.zeros(len(ways)), self.reaches_mm(angles_rad)
        for _ in range(BISECTIONS):
            half = (low + high) / 2.0
            inside = self.depths_mm(self.middle + half * ways) >= depths_mm
            low, high = np.where(inside, half, low), np.where(inside, high, half)
        return self.middle + low * ways

    def depths_mm(self, places: np.ndarray) -> np.ndarray:
        """Return how far places are from the wall."""
        return shapely.distance(self.wall, shapely.points(places.real, places.imag))


def _rays(wall: Curve, flat_mm: float) -> _Rays:
    """Return the rays from the middle; raises CycleError when they do not see all of the wall."""
    line = LineString(wall.points(flat_mm)).simplify(flat_mm)
    points = np.asarray(line.coords)
    shapely.prepare(line)
    middle = _middle(points, line)
    seen = (points @ (1, 1j)) - (middle.x + 1j * middle.y)
    turns = np.angle(seen[1:] / seen[:-1])
    if (turns < 0.0).any():
        raise _no_spiral("not all of the wall is seen from the middle of the room", f"{middle.x:.3f}, {middle.y:.3f}")
    angles = np.angle(seen[0]) + np.concatenate([[0.0], np.cumsum(turns)])
    foot = line.interpolate(line.project(middle))
    start = math.atan2(foot.y - middle.y, foot.x - middle.x)
    return _Rays(line, middle.x + 1j * middle.y, float(line.distance(middle)), start, angles, seen)


def _middle(points: np.ndarray, line: LineString) -> shapely.Point:
    """Return the middle of where the room is about deepest, or its deepest place where that is bent."""
    room = Polygon(points)
    deepest = shapely.maximum_inscribed_circle(room)
    depth_mm = deepest.length
    core = room.buffer(-(1.0 - 2.0 * MIDDLE) * depth_mm)
    middle = core.centroid
    if core.is_empty or line.distance(middle) < (1.0 - 3.0 * MIDDLE) * depth_mm:
        return shapely.Point(deepest.coords[0])
    return middle


def _lag(rays: _Rays) -> float:
    """Return by which share of a step two turns are farther apart than it, at most; see the module's text."""
    chords = np.diff(rays.wall_points)
    outward = -1j * chords / np.where(chords, np.abs(chords), 1.0)
    aside = np.abs(np.angle(outward / rays.wall_points[:-1], deg=False))[np.abs(chords) > 0.0]
    return float(aside.max()) / TURN


def _turns(rays: _Rays, area: Area, lag: float) -> int:
    """Return into how many turns the depth is divided, so that neither the stepover nor the radius is exceeded."""
    apart_mm = min(area.stepover_mm, area.tool_mm - area.tolerance_mm) / (1.0 + lag)
    if rays.depth_mm > MOST_PASSES * apart_mm:
        raise CycleError(
            "passes-many",
            Text("stepover_mm asks for more than {most_passes} turns", most_passes=MOST_PASSES),
            value=f"{area.stepover_mm:g} mm",
            limit=Text("at least {depth_mm:.3g} mm", depth_mm=rays.depth_mm / MOST_PASSES),
            advice="make stepover_mm larger",
        )
    return max(math.ceil(rays.depth_mm / apart_mm), 1)


def _require_seen(area: Area, rays: _Rays, turns: int) -> None:
    """Raise CycleError when a parallel of the wall splits or is not seen whole from the middle."""
    for turn in range(1, turns):
        inner = area.room.offset(-rays.depth_mm * turn / turns, area.tolerance_mm)
        if len(inner.loops) != 1:
            raise _no_spiral("the room falls into parts away from its wall", f"{len(inner.loops)} parts")
        seen = inner.loops[0].points(area.tolerance_mm) @ (1, 1j) - rays.middle
        if (np.angle(seen[1:] / seen[:-1]) < 0.0).any():
            raise _no_spiral("not all of a parallel of the wall is seen from the middle of the room", f"turn {turn}")


def _points(rays: _Rays, turns: int, area: Area) -> np.ndarray:
    """Return the spiral's points, float64[n, 2], as close as its bends ask for."""
    turned = np.linspace(0.0, TURN * turns, FIRST_POINTS * turns + 1)
    sense = 1.0 if area.climb else -1.0
    clear_mm = FIT * area.tolerance_mm

    def at(turned: np.ndarray) -> np.ndarray:
        depths_mm = np.maximum(rays.depth_mm * (1.0 - turned / (TURN * turns)), clear_mm)
        return rays.at_depth(rays.start_rad + sense * turned, np.minimum(depths_mm, rays.depth_mm))

    points = at(turned)
    coarse = np.arange(len(turned) - 1)
    for _ in range(ROUNDS):
        middle = (turned[coarse] + turned[coarse + 1]) / 2.0
        found = at(middle)
        chord = points[coarse + 1] - points[coarse]
        aside = np.abs((np.conj(chord) * (found - points[coarse])).imag) / np.maximum(np.abs(chord), 1e-12)
        off = aside > CHORD * area.tolerance_mm
        if not off.any():
            break
        turned, points = np.insert(turned, coarse[off] + 1, middle[off]), np.insert(points, coarse[off] + 1, found[off])
        new = coarse[off] + np.arange(int(off.sum()))
        coarse = np.concatenate([new, new + 1])
        coarse.sort()
    return np.column_stack([points.real, points.imag])


def _no_spiral(reason: str, value: str) -> CycleError:
    return CycleError("spiral-shape", reason, value=value, advice='use pattern "offset" or "zigzag"')
