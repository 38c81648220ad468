# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Cuts that neighbouring parts share: straight edges a kerf apart are cut once, in the middle between them.

     A   | |   B        edges a kerf apart, facing each other        line: their middle, cut on it
    -----' '-----       their ends are bridged                       loop: the outline round all parts of a block,
    =============       what stays of the outlines and the bridges          cut outside, as that of one part

Where bridges enclose no more than the kerf, as between four corners, lines go on through the gap until it is cut
away. In a larger gap a line goes on round the gap, half a kerf from its parts, so that no gap is pierced. At the rim of
the block it goes on half a kerf, so that no crumb stays beside it, and farther where it leads into scrap: there it is
pierced. A gap with a part in it is a hole of the block. A block that cannot be cut so is left as it was: each of its
parts has its own outline.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Hashable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from shapely import LineString, Polygon
from shapely.geometry.base import BaseGeometry

from CNCStepper.cancellation import checkpoint
from CNCStepper.geometry.chain_joining import chained
from CNCStepper.geometry.curve import Curve, from_points, straight
from CNCStepper.geometry.region import Region
from CNCStepper.tolerances import COMMON_LINE_MM, SAME_MM

LEAST_COMMON_MM = 0.01  # facing edges that overlap by less are not common
FLAT_MM = 0.001  # of the chords of loops
CRUMB = 0.1  # of the kerf: how thick what stays in a gap may be
LEADS = (8.0, 4.0, 2.0, 1.0)  # kerfs that a line begins before the block, the longest that lies in scrap
AWAY = 0.7  # a line into scrap of that share of its length or more leads away from its parts


@dataclass(frozen=True)
class Block:
    """Parts that share cuts, by number. loops: the outline round all, then holes in it; lines: cut on their line."""

    parts: tuple[int, ...]
    loops: tuple[Curve, ...]
    lines: tuple[Curve, ...]


@dataclass(frozen=True)
class CommonCuts:
    """The blocks of a sheet; saved_mm, saved_pierces: against each part's own outline; left: blocks cut apart."""

    blocks: tuple[Block, ...] = ()
    saved_mm: float = 0.0
    saved_pierces: int = 0
    left: int = 0

    @property
    def parts(self) -> frozenset[int]:
        """The numbers of the parts that share cuts."""
        return frozenset(number for block in self.blocks for number in block.parts)


@dataclass(frozen=True)
class Facing:
    """A stretch of two edges that face each other; begin, end: on both outlines, mm along them; places on the edges."""

    parts: tuple[int, int]
    stretches: tuple[tuple[float, float], tuple[float, float]]
    begin: np.ndarray  # float64[2, 2]: on the first part, on the second
    end: np.ndarray

    @property
    def middle(self) -> LineString:
        """The line in the middle of both edges."""
        return LineString([self.begin.mean(axis=0), self.end.mean(axis=0)])


@dataclass(frozen=True)
class _Tip:
    """An end of a line at a bridge: the bridge, its middle, the direction out of the line, its two parts."""

    bridge: LineString
    place: np.ndarray
    way: np.ndarray
    parts: tuple[int, int]


def common_cuts(
    outlines: Sequence[Curve], parts: Sequence[Polygon], keys: Sequence[Hashable], sheet: Polygon, kerf_mm: float
) -> CommonCuts:
    """Return what neighbouring parts of a sheet share.

    outlines: closed, where the parts lie; parts: the same with their holes; keys: parts of the same key may share.
    """
    outlines = [_forward(outline) for outline in outlines]
    found: dict[int, list[Facing]] = defaultdict(list)
    facings = list(facing_edges(outlines, keys, kerf_mm))
    for root, facing in zip(_roots(len(outlines), facings), facings, strict=True):
        found[root].append(facing)
    ground = _Ground(outlines, parts, sheet, kerf_mm)
    made = [ground.block(own) for own in found.values()]
    blocks = tuple(block for block in made if block is not None)
    alone_mm = sum(outlines[number].length_mm for block in blocks for number in block.parts)
    cuts = [curve for block in blocks for curve in (*block.loops, *block.lines)]
    saved_mm = alone_mm - sum(curve.length_mm for curve in cuts)
    pierces = sum(len(block.parts) for block in blocks) - len(cuts)
    return CommonCuts(blocks, saved_mm, pierces, len(made) - len(blocks))


def facing_edges(outlines: Sequence[Curve], keys: Sequence[Hashable], kerf_mm: float) -> Iterator[Facing]:
    """Yield the stretches of straight edges of two parts, counter-clockwise, that face each other a kerf apart."""
    edges, owner = _straight_edges(outlines)
    if not edges:
        return
    lines = shapely.linestrings([(begin, end) for begin, end, _ in edges])
    one, other = shapely.STRtree(lines).query(lines, predicate="dwithin", distance=kerf_mm + 2.0 * COMMON_LINE_MM)
    for a, b in zip(one.tolist(), other.tolist(), strict=True):
        first, second = owner[a], owner[b]
        if first < second and keys[first] == keys[second]:
            facing = _facing((first, second), edges[a], edges[b], kerf_mm)
            if facing is not None:
                yield facing


Edge = tuple[np.ndarray, np.ndarray, float]  # begin, end, mm along the outline to its begin


def _straight_edges(outlines: Sequence[Curve]) -> tuple[list[Edge], list[int]]:
    edges: list[Edge] = []
    owner: list[int] = []
    for number, outline in enumerate(outlines):
        long = (outline.bulge == 0.0) & (outline.lengths_mm > LEAST_COMMON_MM)
        for row in np.flatnonzero(long).tolist():
            edges.append((outline.xy[row], outline.xy[row + 1], float(outline.before_mm[row])))
            owner.append(number)
    return edges, owner


def _facing(parts: tuple[int, int], one: Edge, other: Edge, kerf_mm: float) -> Facing | None:
    """Return the stretch in which two edges of counter-clockwise outlines face each other, None for none."""
    along = one[1] - one[0]
    long_mm = float(np.hypot(*along))
    along = along / long_mm
    right = np.array([along[1], -along[0]])  # out of the first part
    places = [float((end - one[0]) @ along) for end in (other[0], other[1])]  # the second edge runs the other way
    begin_mm, end_mm = max(0.0, places[1]), min(long_mm, places[0])
    if end_mm - begin_mm < LEAST_COMMON_MM:
        return None
    at = np.array([begin_mm, end_mm])
    way = other[1] - other[0]
    share = (at - places[0]) / (places[1] - places[0])
    apart = (other[0] + share[:, None] * way - one[0]) @ right
    if np.abs(apart - kerf_mm).max() > COMMON_LINE_MM:
        return None
    first, second = one[0] + at[:, None] * along, other[0] + share[:, None] * way
    on_other = other[2] + share * float(np.hypot(*way))
    stretches = (one[2] + begin_mm, one[2] + end_mm), (float(on_other[1]), float(on_other[0]))
    return Facing(parts, stretches, np.array([first[0], second[0]]), np.array([first[1], second[1]]))


def _roots(count: int, facings: Sequence[Facing]) -> list[int]:
    """Return for each facing pair the least number of the parts that hang together with it."""
    root = list(range(count))

    def root_of(number: int) -> int:
        while root[number] != number:
            root[number] = root[root[number]]
            number = root[number]
        return number

    for facing in facings:
        low, high = sorted(root_of(number) for number in facing.parts)
        root[high] = low
    return [root_of(facing.parts[0]) for facing in facings]


class _Ground:
    """The parts of a sheet, and the search for the cuts of one block among them."""

    def __init__(self, outlines: Sequence[Curve], parts: Sequence[Polygon], sheet: Polygon, kerf_mm: float):
        self._outlines, self._parts, self._sheet, self._kerf_mm = outlines, list(parts), sheet, kerf_mm
        self._tree = shapely.STRtree(self._parts)

    def block(self, facings: Sequence[Facing]) -> Block | None:
        """Return the cuts of parts that hang together; None where they cannot be cut so."""
        checkpoint()
        numbers = tuple(sorted({number for facing in facings for number in facing.parts}))
        tips = _tips(facings)
        bridges = [straight(*tip.bridge.coords) for tip in tips if tip.bridge.length > COMMON_LINE_MM]
        stay = [piece for number in numbers for piece in self._left_of(number, facings)]
        loops, _ = chained([*stay, *bridges], COMMON_LINE_MM + SAME_MM)
        if not loops or not all(loop.closed for loop in loops):
            return None
        polygons = [Polygon(loop.points(FLAT_MM)) for loop in loops]
        outer = max(range(len(loops)), key=lambda number: polygons[number].area)
        others = [number for number in range(len(loops)) if number != outer]
        if not all(polygon.is_valid for polygon in polygons) or not all(
            polygons[outer].contains(polygons[number].representative_point()) for number in others
        ):
            return None
        holes = [number for number in others if self._tree.query(polygons[number], predicate="contains_properly").size]
        gaps = [(loops[number], polygons[number]) for number in others if number not in holes]
        lines = self._lines(facings, tips, gaps)
        rim = [tip for tip in tips if not any(_on(tip, gap) for _, gap in gaps)]
        if lines is None or not self._has_room(rim):
            return None
        return Block(numbers, tuple(_forward(loops[number]) for number in (outer, *holes)), lines)

    def _left_of(self, number: int, facings: Sequence[Facing]) -> list[Curve]:
        """Return what stays of an outline without its common stretches."""
        outline = self._outlines[number]
        taken = [facing.stretches[facing.parts.index(number)] for facing in facings if number in facing.parts]
        start_mm = min(taken)[0]
        turned = outline.started_at_length(start_mm) if start_mm > 0.0 else outline
        free_mm, pieces = 0.0, []
        for begin_mm, end_mm in [*sorted((a - start_mm, b - start_mm) for a, b in taken), (turned.length_mm,) * 2]:
            if begin_mm - free_mm > COMMON_LINE_MM:
                pieces.append(turned.part(free_mm, min(begin_mm, turned.length_mm)))
            free_mm = max(free_mm, end_mm)
        return pieces

    def _lines(
        self, facings: Sequence[Facing], tips: Sequence[_Tip], gaps: Sequence[tuple[Curve, Polygon]]
    ) -> tuple[Curve, ...] | None:
        """Return the lines, led through gaps or round them; None where they cut into a part, or too little."""
        middles = [facing.middle for facing in facings]
        pieces, rounds = list(middles), list[Curve]()
        for loop, gap in gaps:
            own = [tip for tip in tips if _on(tip, gap)]
            through = self._through(gap, own, middles)
            if not self._is_cut(gap, [*through, *middles]):
                inner = self._inside(loop)
                rounds += inner
                through = [self._up_to_loop(tip, inner) for tip in own]
            pieces += through
        if self._kerf_mm > COMMON_LINE_MM:
            pieces += [self._led(tip) for tip in tips if not any(_on(tip, gap) for _, gap in gaps)]
        chains, _ = chained([straight(*piece.coords) for piece in pieces], COMMON_LINE_MM + SAME_MM)
        lines = [from_points(shapely.simplify(LineString(chain.xy), SAME_MM).coords) for chain in chains]
        if not all(_add_round(lines, loop) for loop in rounds):
            return None
        ways = [LineString(line.points(FLAT_MM)) for line in lines]
        if any(self._least_mm(way) < self._kerf_mm / 2.0 - COMMON_LINE_MM for way in ways):
            return None
        return tuple(lines) if all(self._is_cut(gap, ways) for _, gap in gaps) else None

    def _is_cut(self, gap: Polygon, ways: Sequence[LineString]) -> bool:
        """Return whether the beam on its ways cuts along the whole rim of a gap."""
        reach_mm = (0.5 + CRUMB) * self._kerf_mm + COMMON_LINE_MM
        band = shapely.union_all([way.buffer(reach_mm) for way in ways if way.dwithin(gap, self._kerf_mm)])
        return bool(gap.exterior.difference(band).is_empty)

    def _inside(self, loop: Curve) -> list[Curve]:
        """Return where the beam's centre runs round a gap, half a kerf from its parts."""
        if self._kerf_mm <= COMMON_LINE_MM:
            return [loop]
        return list(Region.of([_forward(loop)]).offset(-self._kerf_mm / 2.0, COMMON_LINE_MM).loops)

    def _up_to_loop(self, tip: _Tip, loops: Sequence[Curve]) -> LineString:
        """Return how a line goes on from a tip to the loop ahead; half a kerf where there is none."""
        rings = shapely.union_all([LineString(loop.points(FLAT_MM)) for loop in loops])
        ray = LineString([tip.place, tip.place + 2.0 * self._kerf_mm * tip.way])
        met = rings.intersection(ray) if self._kerf_mm > COMMON_LINE_MM else shapely.Point(tip.place)
        far_mm = self._kerf_mm / 2.0 if met.is_empty else shapely.Point(tip.place).distance(met)
        return LineString([tip.place, tip.place + far_mm * tip.way])

    def _through(self, gap: Polygon, tips: list[_Tip], lines: Sequence[LineString]) -> list[LineString]:
        """Return what leads the lines that end at a small gap through it: straight on to another, or up to one."""
        found, rest = [], list(tips)
        for tip in tips:
            partner = next((other for other in rest if other is not tip and _is_ahead(tip, other)), None)
            if tip in rest and partner is not None:
                bridge = LineString([tip.place, partner.place])
                if self._least_mm(bridge) >= self._kerf_mm / 2.0 - COMMON_LINE_MM:
                    found.append(bridge)
                    rest = [other for other in rest if other is not tip and other is not partner]
        across = shapely.union_all([*found, *(line for line in lines if line.dwithin(gap, COMMON_LINE_MM))])
        return found + [self._up_to(tip, across, gap) for tip in rest]

    def _up_to(self, tip: _Tip, across: BaseGeometry, gap: Polygon) -> LineString:
        """Return the way from a tip to the first line that it meets, or as far as it cuts into no part."""
        reach_mm = 2.0 * self._kerf_mm + gap.length / 2.0
        ray = LineString([tip.place + COMMON_LINE_MM * tip.way, tip.place + reach_mm * tip.way])
        met = ray.intersection(across.difference(shapely.Point(tip.place).buffer(2.0 * COMMON_LINE_MM)))
        near = self._near(gap, self._kerf_mm)
        walls = shapely.union_all([part.buffer(self._kerf_mm / 2.0 - COMMON_LINE_MM) for part in near])
        start = shapely.Point(tip.place)
        stops = [start.distance(each) for each in (met, ray.intersection(walls)) if not each.is_empty]
        return LineString([tip.place, tip.place + min([*stops, reach_mm]) * tip.way])

    def _led(self, tip: _Tip) -> LineString:
        """Return how a line goes on beyond the block: half a kerf, farther where it leads into scrap."""
        half_mm = self._kerf_mm / 2.0
        for kerfs in LEADS:
            reach_mm = kerfs * self._kerf_mm
            way = LineString([tip.place + half_mm * tip.way, tip.place + reach_mm * tip.way])
            end = shapely.Point(way.coords[-1])
            own = [self._parts[number] for number in tip.parts]
            others = [part for part in self._near(way, self._kerf_mm) if not any(part is each for each in own)]
            if self._sheet.covers(way) and not others and all(end.distance(part) >= AWAY * reach_mm for part in own):
                return LineString([tip.place, way.coords[-1]])
        return LineString([tip.place, tip.place + half_mm * tip.way])

    def _has_room(self, tips: Sequence[_Tip]) -> bool:
        """Return whether the beam passes between each bridge of a loop and all parts but its own two."""
        least_mm = self._kerf_mm - COMMON_LINE_MM
        for tip in tips:
            near = self._tree.query(tip.bridge, predicate="dwithin", distance=max(least_mm, 0.0))
            if least_mm > 0.0 and not set(near.tolist()) <= set(tip.parts):
                return False
        return True

    def _near(self, place: BaseGeometry, reach_mm: float) -> list[Polygon]:
        return [self._parts[number] for number in self._tree.query(place, predicate="dwithin", distance=reach_mm)]

    def _least_mm(self, line: LineString) -> float:
        """Return how near a line comes to the parts."""
        return min((part.distance(line) for part in self._near(line, self._kerf_mm)), default=self._kerf_mm)


def _tips(facings: Sequence[Facing]) -> list[_Tip]:
    """Return the ends of all lines; where two stretches of one edge follow each other there is none."""
    tips = []
    for facing in facings:
        along = facing.end.mean(axis=0) - facing.begin.mean(axis=0)
        along = along / np.hypot(*along)
        tips.append(_Tip(LineString(facing.begin), facing.begin.mean(axis=0), -along, facing.parts))
        tips.append(_Tip(LineString(facing.end), facing.end.mean(axis=0), along, facing.parts))
    points = shapely.points([tip.place for tip in tips])
    one, other = shapely.STRtree(points).query(points, predicate="dwithin", distance=COMMON_LINE_MM)
    inner = {
        a
        for a, b in zip(one.tolist(), other.tolist(), strict=True)
        if a != b and tips[a].parts == tips[b].parts and tips[a].way @ tips[b].way < 0.0
    }
    return [tip for number, tip in enumerate(tips) if number not in inner]


def _on(tip: _Tip, gap: Polygon) -> bool:
    """Return whether a tip's bridge is a side of a gap."""
    return bool(gap.exterior.distance(shapely.Point(tip.place)) <= COMMON_LINE_MM)


def _add_round(lines: list[Curve], loop: Curve) -> bool:
    """Let the first line that ends at a loop go on round it; return False where none does."""
    for number, line in enumerate(lines):
        ends = line.xy[[0, -1]]
        apart_mm, at_mm = loop.nearest(ends)
        if apart_mm.min() <= COMMON_LINE_MM + FLAT_MM:
            end = int(apart_mm.argmin())
            way = line if end else line.reversed()
            turned = loop.started_at_length(float(at_mm[end]) % loop.length_mm)
            joined_xy = np.vstack([way.xy[:-1], turned.xy])
            lines[number] = Curve(joined_xy, np.concatenate([way.bulge, turned.bulge]))
            return True
    return False


def _is_ahead(tip: _Tip, other: _Tip) -> bool:
    """Return whether the line of a tip goes on in the line of another one."""
    way = other.place - tip.place
    apart_mm = abs(float(way[0] * tip.way[1] - way[1] * tip.way[0]))
    return float(tip.way @ other.way) < 0.0 < float(way @ tip.way) and apart_mm <= COMMON_LINE_MM


def _forward(loop: Curve) -> Curve:
    """Return a loop counter-clockwise."""
    return loop if loop.area_mm2 > 0.0 else loop.reversed()
