# SPDX-License-Identifier: LGPL-2.1-or-later
r"""What the wire cuts: exact parallels round the parts and in their holes, and open lines; what it cannot cut.

  ring of the part                  A part is what an outline encloses; outlines in it are its holes, and what
 . - - - - - - - - .                lies in these is a part again. The wire's centre runs half a kerf off.
|  +-------------+  |
|  | part        |  |               refused, with the number that would do:
|  |   +------+  |  |               - parts, or two walls of one, with less than a kerf between them
|  |   | ring |  |  |               - holes that no slit leads into, or that are narrower than the kerf
|  |   +------+  |  |               - parts and lines in each other's cut, parts beyond the sheet's edge
|  +-------------+  |
 ' - - - - - - - - '
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import chain

import numpy as np
import shapely
from shapely import LineString, Point, Polygon
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.contours.scrap_side import FOLLOWED_MM, enclosed
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.region import Region
from CNCStepper.geometry.shapely_polygons import polygons_of

OFFSET_TOLERANCE_MM = 0.004
FLAT_MM = 0.002
TOUCHES_MM = 0.001  # a gap may be so much narrower than the kerf: rounding of a drawing
HALVINGS = 20
TOLD = 1e-3  # numbers that would do are told to a micron, rounded to the safe side


@dataclass(frozen=True, eq=False)
class Line:
    """An open line that the wire runs along and back."""

    number: int
    curve: Curve

    @cached_property
    def chords(self) -> LineString:
        """The line as chords."""
        return LineString(self.curve.points(FLAT_MM))


@dataclass(frozen=True, eq=False)
class Hole:
    """A hole: the wire's way in it, counter-clockwise, and what else is cut in there."""

    number: int
    outline: Curve
    ring: Curve
    inside: list[Part | Line] = field(default_factory=list)

    @cached_property
    def chords(self) -> LineString:
        """The way as chords."""
        return LineString(self.ring.points(FLAT_MM))

    @cached_property
    def polygon(self) -> Polygon:
        """What the hole's wall encloses."""
        return Polygon(self.outline.points(FLAT_MM))


@dataclass(frozen=True, eq=False)
class Part:
    """A part: its outer ring, clockwise so that the part lies to the right, its holes, and what of it stays."""

    number: int
    ring: Curve
    holes: list[Hole]
    polygon: BaseGeometry

    @cached_property
    def chords(self) -> LineString:
        """The ring as chords."""
        return LineString(self.ring.points(FLAT_MM))


Item = Part | Line


@dataclass(frozen=True)
class Items:
    """All that is cut: `top` are the parts and lines that lie in no hole; region: all parts."""

    top: list[Item]
    parts: list[Part]
    lines: list[Line]
    region: Region
    material: BaseGeometry

    @property
    def every(self) -> list[Item]:
        """Parts and lines, those in holes too."""
        return [*self.parts, *self.lines]


def items_of(curves: Sequence[Curve], kerf_mm: float, entry_slit: bool, sheet: Polygon | None) -> Items:
    """Return what curves in work coordinates ask for; raises CycleError for what the wire cannot cut."""
    curves = [_with_length(number, curve) for number, curve in enumerate(curves, start=1)]
    closed = [curve for curve in curves if curve.closed]
    region = enclosed(closed) if closed else Region(())
    pieces = region.parts() if not region.empty else []
    if closed and not pieces:
        raise CycleError("outline-empty", "the outlines enclose nothing", advice="draw outlines with an area")
    polygons = [polygons_of(piece) for piece in pieces]
    _require_apart(polygons, kerf_mm)
    if not entry_slit:
        _require_no_holes(pieces)
    parts = [_part(*each, kerf_mm) for each in zip(range(1, len(pieces) + 1), pieces, polygons, strict=True)]
    open_ones = (curve for curve in curves if not curve.closed)
    lines = [Line(number, curve) for number, curve in enumerate(open_ones, start=1)]
    material = shapely.union_all(polygons)
    _require_lines_apart(lines, parts, kerf_mm)
    if sheet is not None:
        _require_on_sheet(parts, sheet)
    return Items(_nested(parts, lines), parts, lines, region, material)


def _with_length(number: int, curve: Curve) -> Curve:
    if curve.length_mm > FOLLOWED_MM:
        return curve.without_short()
    raise CycleError(
        "curve-length",
        Text("curve {number} has no length", number=number),
        value=f"{curve.length_mm:g} mm",
        advice="draw it larger, or leave it out",
    )


def _require_apart(polygons: Sequence[BaseGeometry], kerf_mm: float) -> None:
    """Raise CycleError where two parts are nearer to each other than the kerf is wide."""
    if not polygons:
        return
    near_mm = kerf_mm - TOUCHES_MM
    first, second = shapely.STRtree(polygons).query(polygons, predicate="dwithin", distance=near_mm)
    pairs = [(a, b) for a, b in zip(first.tolist(), second.tolist(), strict=True) if a < b]
    if not pairs:
        return
    gaps = [shapely.shortest_line(polygons[a], polygons[b]) for a, b in pairs]
    gap = min(gaps, key=shapely.length)
    (x, y), gap_mm = gap.coords[0], gap.length
    raise CycleError(
        "wire-gap",
        Text("two parts lie too close to each other for the wire to pass, at X{x:.3f} Y{y:.3f}", x=x, y=y),
        value=f"{gap_mm:.3f} mm",
        limit=Text("the kerf of {kerf_mm:g} mm", kerf_mm=kerf_mm),
        advice=Text(
            "move them {more_mm:.3f} mm farther apart, or cut with a kerf of at most {gap_mm:.3f} mm",
            more_mm=_up(kerf_mm - gap_mm),
            gap_mm=_down(gap_mm),
        ),
    )


def _require_no_holes(pieces: Sequence[Region]) -> None:
    holes = [loop for piece in pieces for loop in piece.loops if loop.area_mm2 < 0.0]
    if not holes:
        return
    x, y = Polygon(holes[0].points(FLAT_MM)).centroid.coords[0]
    raise CycleError(
        "wire-hole",
        Text("the wire has no entry into the closed hole at X{x:.3f} Y{y:.3f}", x=x, y=y),
        value=Text("{holes} closed hole(s)", holes=len(holes)),
        limit="0 without an entry slit",
        advice="set entry_slit = true, which cuts a slit through the part into each hole, or leave the holes out",
    )


def _part(number: int, piece: Region, polygon: BaseGeometry, kerf_mm: float) -> Part:
    outer = next(loop for loop in piece.loops if loop.area_mm2 > 0.0)
    ring = _one_loop(Region((outer,)), kerf_mm, 1, "part", number)
    holes = [loop.reversed() for loop in piece.loops if loop.area_mm2 < 0.0]
    rings = [_one_loop(Region((hole,)), kerf_mm, -1, "hole", number) for hole in holes]
    made = [Hole(index, *each) for index, each in enumerate(zip(holes, rings, strict=True), start=1)]
    return Part(number, ring.reversed(), made, polygon)


def _one_loop(region: Region, kerf_mm: float, side: int, what: str, number: int) -> Curve:
    """Return the one loop of the wire's centre along an outline; raises CycleError where it falls apart."""
    loops = region.offset(side * kerf_mm / 2.0, OFFSET_TOLERANCE_MM).loops
    if len(loops) == 1:
        return loops[0]
    most_mm = _largest(lambda tried: len(region.offset(side * tried / 2.0, OFFSET_TOLERANCE_MM).loops) == 1, kerf_mm)
    x, y = region.loops[0].xy[0]
    says = {
        "part": "the kerf closes a narrow place in the outline of part {number}, which begins at X{x:.3f} Y{y:.3f}",
        "hole": "the kerf is wider than a place in the hole of part {number} that begins at X{x:.3f} Y{y:.3f}",
    }
    raise CycleError(
        "kerf-wide",
        Text(says[what], number=number, x=x, y=y),
        value=f"{kerf_mm:g} mm",
        limit=f"{most_mm:.3f} mm",
        advice=Text("cut with a kerf of at most {most_mm:.3f} mm, or draw that place wider", most_mm=most_mm),
    )


def _largest(works: Callable[[float], bool], most_mm: float) -> float:
    """Return the largest length below `most_mm` with which something works, that does with shorter ones."""
    low_mm, high_mm = 0.0, most_mm
    for _ in range(HALVINGS):
        middle_mm = (low_mm + high_mm) / 2.0
        low_mm, high_mm = (middle_mm, high_mm) if works(middle_mm) else (low_mm, middle_mm)
    return _down(low_mm)


def _require_lines_apart(lines: Sequence[Line], parts: Sequence[Part], kerf_mm: float) -> None:
    """Raise CycleError where an open line runs so near to a part that its kerf would cut into it."""
    for line in lines:
        for part in parts:
            away_mm = shapely.distance(line.chords, part.polygon)
            if away_mm < kerf_mm / 2.0 - TOUCHES_MM:
                x, y = shapely.get_coordinates(shapely.shortest_line(part.polygon, line.chords))[0]
                raise CycleError(
                    "wire-line",
                    Text("open line {line} cuts into a part at X{x:.3f} Y{y:.3f}", line=line.number, x=x, y=y),
                    value=Text("{away_mm:.3f} mm away", away_mm=away_mm),
                    limit=Text("half of the kerf, {half_mm:g} mm", half_mm=kerf_mm / 2.0),
                    advice="move the line away from the part, or leave it out",
                )


def _require_on_sheet(parts: Sequence[Part], sheet: Polygon) -> None:
    for part in parts:
        corners = shapely.points(shapely.get_coordinates(part.polygon))
        away_mm = shapely.distance(sheet, corners)
        beyond_mm, far = float(away_mm.max()), corners[away_mm.argmax()]
        if beyond_mm > TOUCHES_MM:
            raise CycleError(
                "wire-sheet",
                Text("part {number} goes beyond the sheet at X{x:.3f} Y{y:.3f}", number=part.number, x=far.x, y=far.y),
                value=Text("{beyond_mm:.3f} mm beyond", beyond_mm=beyond_mm),
                limit="0 mm",
                advice=Text("move it {in_mm:.3f} mm inwards, or take a larger sheet", in_mm=_up(beyond_mm)),
            )


def _nested(parts: Sequence[Part], lines: Sequence[Line]) -> list[Item]:
    """Put what lies in holes into the innermost of them; return what lies in none."""
    holes = sorted(chain.from_iterable(part.holes for part in parts), key=lambda hole: hole.polygon.area)
    top: list[Item] = []
    every: list[Item] = [*parts, *lines]
    for item in every:
        place = Point(item.chords.coords[0])
        holder = next((hole for hole in holes if hole.polygon.contains(place)), None)
        (holder.inside if holder else top).append(item)
    return top


def _up(value_mm: float) -> float:
    return float(np.ceil(value_mm / TOLD - 1e-6) * TOLD)


def _down(value_mm: float) -> float:
    return float(np.floor(value_mm / TOLD + 1e-6) * TOLD)
