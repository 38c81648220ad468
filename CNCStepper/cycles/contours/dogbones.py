# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Inside corners sharper than the tool: how much stays in them, and strokes that take it away.

         | wall         corner: along the bisector       side: along the longer of the two sides
. path   |
|        |   place      from the path's corner `place` the tool goes on until its rim reaches the wall's corner,
'--------|---            and back again
---------+   corner
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
import shapely

from CNCStepper.cycles.contours.contour_parameters import Dogbones
from CNCStepper.errors import Text
from CNCStepper.geometry.curve import Curve, joined
from CNCStepper.geometry.curve_columns import complex_of, xy_of
from CNCStepper.tolerances import COINCIDENT_MM

TURN_RAD = math.radians(1.0)  # a path that turns less has no corner
LONGEST = 3.0  # of the tool's radius: a sharper corner gets no relief
CHORD_MM = 0.0005
LOOKS = np.array([0.25, 0.5, 0.75, 0.95])  # of the way from where the tool touches a wall to the corner
BENT = 0.05  # of the tool's radius, that a wall may be off that way
ASTRAY_RAD = math.radians(45.0)  # by which that way may turn off the tool's
APART_MM = 4.0 * COINCIDENT_MM  # nearer to each other, or to an end, two reliefs are one, or none


@dataclass(frozen=True)
class Corner:
    """A corner of the path that the wall's own corner lies behind.

    place: of the path's corner. rest_mm: how much the tool leaves there, or LONGEST tool radii where it is more.
    relief: where the tool's centre must go to take it, None where it may not: that is too far, or the place is a gap
    between walls that do not meet.
    """

    place: tuple[float, float]
    rest_mm: float
    relief: tuple[float, float] | None
    why_not: Literal["", "far", "gap"] = ""


class Corners:
    """Finds the corners of paths along some walls."""

    def __init__(self, wall: Sequence[Curve], tool_mm: float, tolerance_mm: float):
        chords = [curve.points(CHORD_MM) for curve in wall]
        edges = np.concatenate([np.stack([points[:-1], points[1:]], axis=1) for points in chords])
        self._tree = shapely.STRtree(shapely.linestrings(edges))
        self._tool_mm, self._tolerance_mm = tool_mm, tolerance_mm

    def of(self, path: Curve, scrap: int, kind: Dogbones) -> list[Corner]:
        """Return the corners in which more than the tolerance stays; scrap is 1 when it lies left of the path."""
        before, after = complex_of(path.end_directions), complex_of(path.begin_directions)
        before = np.roll(before, 1) if path.closed else np.r_[after[0], before[:-1]]
        sharp = np.flatnonzero(np.angle(after / before) * scrap > TURN_RAD)
        found = (self._corner(path, int(vertex), before[vertex], after[vertex], kind) for vertex in sharp)
        return [corner for corner in found if corner.rest_mm > self._tolerance_mm]

    def _corner(self, path: Curve, vertex: int, before: complex, after: complex, kind: Dogbones) -> Corner:
        place = complex(*path.xy[vertex])
        here = place.real, place.imag
        out = (before - after) / abs(before - after)
        far_mm = self._seen_mm(place, out)
        if far_mm is None:
            far = abs(before + after) < 2.0 / (1.0 + LONGEST)  # straight walls would meet beyond the searched part
            return Corner(here, LONGEST * self._tool_mm, None, "far" if far else "gap")
        corner = place + out * far_mm
        if not self._walls_meet(place, before, after, corner):
            return Corner(here, far_mm - self._tool_mm, None, "gap")
        relief = corner - out * self._tool_mm
        if kind == "side":
            lengths = path.lengths_mm
            along = before if lengths[vertex - 1] >= lengths[vertex] else -after
            relief = place + along * ((corner - place) * np.conj(along)).real
        return Corner(here, far_mm - self._tool_mm, (float(relief.real), float(relief.imag)))

    def _walls_meet(self, place: complex, before: complex, after: complex, corner: complex) -> bool:
        """Return whether walls lead to the corner from both places where the tool touches them, on as the tool came.

        Elsewhere the corner is only seen through a gap that is too narrow for the tool, at the end of a slit, or
        across a wall's bend, and a stroke to it would cut into what ends before it.
        """
        side = 1.0 if (1j * before * np.conj(corner - place)).real > 0.0 else -1.0
        feet = place + side * 1j * self._tool_mm * np.array([before, after])
        if np.abs(np.angle((corner - feet) / [before, -after])).max() > ASTRAY_RAD:
            return False
        looks = (feet[:, None] + (corner - feet)[:, None] * LOOKS).ravel()
        near = self._tree.query(shapely.points(xy_of(looks)), predicate="dwithin", distance=BENT * self._tool_mm)
        return len(np.unique(near[0])) == len(looks)

    def _seen_mm(self, place: complex, out: complex) -> float | None:
        """Return how far the wall is from a place in a direction."""
        reach = self._tool_mm * (1.0 + LONGEST)
        ray = shapely.LineString(xy_of(np.array([place, place + reach * out])))
        hit = self._tree.query(ray, predicate="intersects")
        if not len(hit):
            return None
        return float(shapely.distance(shapely.intersection(ray, self._tree.geometries[hit]), _point(place)).min())


def with_reliefs(path: Curve, corners: Sequence[Corner], near_mm: float) -> Curve:
    """Return a path, or a piece of one, with a stroke to each relief that belongs to it, and back."""
    mine = _reliefs(path, corners, near_mm)
    if not mine:
        return path
    parts = path.split(mine)
    found = [parts[0]]
    for part, relief in zip(parts[1:], mine.values(), strict=True):
        here = part.xy[0]
        found += [Curve(np.array([here, relief, here]), np.zeros(2)), part]
    return joined(found)


def relieved_mm(path: Curve, corners: Sequence[Corner], near_mm: float, length_mm: float) -> float:
    """Return the length, along a path with its strokes, of a place of the plain path."""
    before = {place: relief for place, relief in _reliefs(path, corners, near_mm).items() if place < length_mm}
    strokes_mm = np.hypot(*(path.at_length(list(before))[0] - list(before.values())).T) if before else np.zeros(1)
    return length_mm + 2.0 * float(strokes_mm.sum())


def _reliefs(path: Curve, corners: Sequence[Corner], near_mm: float) -> dict[float, tuple[float, float] | None]:
    """Return at which lengths along a path there are reliefs, ascending and apart, and where these are."""
    far = [corner for corner in corners if corner.relief is not None]
    if not far:
        return {}
    off_mm, lengths = path.nearest(np.array([corner.place for corner in far]))
    found, last_mm = {}, 0.0
    for index in np.argsort(lengths, kind="stable").tolist():
        if off_mm[index] <= near_mm and last_mm + APART_MM < lengths[index] < path.length_mm - APART_MM:
            last_mm = float(lengths[index])
            found[last_mm] = far[index].relief
    return found


def strokes(corners: Sequence[Corner]) -> list[Curve]:
    """Return the ways from the path to the reliefs."""
    ends = [(corner.place, corner.relief) for corner in corners if corner.relief is not None]
    return [Curve(np.array(xy), np.zeros(1)) for xy in ends]


def rest_warnings(corners: Sequence[Corner], *, boned: bool) -> list[str]:
    """Return warnings for corners that keep their material; boned: dog-bones take all others."""
    return [*_sharp_warnings([each for each in corners if each.why_not != "gap"], boned), *_gap_warnings(corners)]


def _sharp_warnings(corners: Sequence[Corner], boned: bool) -> list[str]:
    if not corners:
        return []
    most = max(corners, key=lambda corner: corner.rest_mm)
    more = "more than" if most.why_not else "up to"
    told = "a dog-bone would be too long" if boned else "dog-bones or a smaller tool remove it"
    return [
        Text(
            "{more} {rest_mm:.3f} mm of material stays in {corners} inside corner(s) that are "
            "sharper than the tool; {told}",
            more=more,
            rest_mm=most.rest_mm,
            corners=len(corners),
            told=told,
        )
    ]


def _gap_warnings(corners: Sequence[Corner]) -> list[str]:
    gaps = [corner for corner in corners if corner.why_not == "gap"]
    if not gaps:
        return []
    x, y = max(gaps, key=lambda corner: corner.rest_mm).place
    return [
        Text(
            "material stays in {gaps} gap(s) between walls that are narrower than the tool, the deepest one before"
            " X{x:.3f} Y{y:.3f}; a smaller tool removes it",
            gaps=len(gaps),
            x=x,
            y=y,
        )
    ]


def _point(place: complex) -> shapely.Point:
    return shapely.Point(place.real, place.imag)
