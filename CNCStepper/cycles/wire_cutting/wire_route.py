# SPDX-License-Identifier: LGPL-2.1-or-later
r"""The one way of the wire: in from the sheet's edge, from item to item, round each, and out.

edge -> link -> lead-in -> ring of a part -> lead-out -> link -> ... -> edge
                              |  ^
                         slit v  |           what lies in a hole is cut first, then the hole, then the wire goes
                           hole's ring       back through the slit and on along the part's ring

The ring is run the other way round, or first to some slits and back, where the part would fall before its last hole.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import pairwise

import numpy as np
import shapely
from shapely import LineString, Polygon
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.moves import Point
from CNCStepper.cycles.wire_cutting.hole_slits import Slit, slit_into
from CNCStepper.cycles.wire_cutting.route_tree import ROOT, WayTree, connected
from CNCStepper.cycles.wire_cutting.scrap_roadmap import COARSE, Roadmap, Segment
from CNCStepper.cycles.wire_cutting.wire_cut_order import Uncut, best_last, safe_order
from CNCStepper.cycles.wire_cutting.wire_items import Item, Items, Line, Part
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve, from_points, joined, straight
from CNCStepper.tolerances import SAME_MM

SIDES = ("left", "right", "front", "back")


@dataclass(frozen=True)
class Stroke:
    """A piece of the way; kind: "link", "lead-in", "lead-out", "slit" or "contour"."""

    kind: str
    name: str
    curve: Curve


@dataclass(frozen=True)
class Route:
    """The strokes, one beginning where the last one ended, and the parts in the order in which they come free."""

    strokes: tuple[Stroke, ...]
    parts: tuple[BaseGeometry, ...]


class RouteMaker:
    """Puts the way together for one sheet.

    box: low and high corner of the sheet, grown so far that the wire on it is clear of the sheet.
    """

    def __init__(self, items: Items, sheet: Polygon, kerf_mm: float, margin_mm: float):
        self._sheet, self._items, self._half_mm = sheet, items, kerf_mm / 2.0
        out_mm = kerf_mm / 2.0 + (1.0 + COARSE) * margin_mm
        low_x, low_y, high_x, high_y = sheet.bounds
        self._box = (low_x - out_mm, low_y - out_mm, high_x + out_mm, high_y + out_mm)
        self._map = Roadmap(items, kerf_mm, margin_mm, corners_of(self._box))
        self._parts: list[BaseGeometry] = []
        self._uncut = Uncut(sheet, self._half_mm)

    def route(self, enter_from: str, leave: str) -> Route:
        """Return the way; raises CycleError where an item cannot be reached, or would come loose before it is cut."""
        begins = [sides_of(self._box)[side] for side in SIDES if enter_from in (side, "nearest")]
        tree = self._tree(self._items.top, begins)
        last = best_last(tree, partial(self._leaving_mm, tree)) if leave == "edge" else None
        order = safe_order(tree.order(last), tree, self._items.top, self._sheet, self._half_mm)
        strokes = []
        for stroke in self._visits(tree, order, self._items.top):  # the strokes to come ask what is cut by then
            self._uncut.take(stroke.curve)
            strokes.append(stroke)
        strokes += self._way_out(tree, tree.leaves[order[-1]], leave)
        return Route(tuple(strokes), tuple(self._parts))

    def _tree(self, items: Sequence[Item], begins: Sequence[Segment]) -> WayTree:
        """Return the ways to all items, within the sheet where that is possible."""
        inside = self._sheet.buffer(-self._map.clear_mm)
        shapely.prepare(inside)
        corners = self._map.corners
        for allowed in (shapely.contains_xy(inside, corners[:, 0], corners[:, 1]), np.ones(len(corners), bool)):
            tree, unreached = connected(self._map, items, begins, allowed)
            if not unreached:
                return tree
        raise unreachable(items[unreached[0]], self._map.margin_mm)

    def _visits(self, tree: WayTree, order: Sequence[int], items: Sequence[Item]) -> Iterator[Stroke]:
        position = ROOT
        for index in order:
            yield from _walked(tree, tree.way(position, tree.leaves[index]))
            position = tree.leaves[index]
            yield from self._cut(items[index], tree.places[position])

    def _cut(self, item: Item, begin: Point) -> Iterator[Stroke]:
        if isinstance(item, Line):
            there = item.curve if _is_at(item.curve.xy[0], begin) else item.curve.reversed()
            yield Stroke("contour", f"line {item.number}", there)
            yield Stroke("contour", f"line {item.number} back", there.reversed())
            return
        slits = [slit_into(item, hole, self._map) for hole in item.holes]
        yield from self._round(item, begin, slits)
        gone = [slit.line.buffer(self._half_mm, cap_style="flat") for slit in slits]
        self._parts.append(item.polygon.difference(shapely.union_all(gone)) if gone else item.polygon)

    def _round(self, part: Part, begin: Point, slits: Sequence[Slit]) -> Iterator[Stroke]:
        """Yield the ring of a part from `begin` on, with the detours into its holes while the part hangs."""
        name = f"part {part.number}"
        stretches, stops = _stretches(started_near(part.ring, begin), slits)
        last = self._uncut.last_stretch(part, stretches) if slits else 0
        yield from self._holes(part, stops[0])
        for stretch, stop in zip(stretches[:last], stops[1:], strict=False):
            yield Stroke("contour", name, stretch)
            yield from self._holes(part, stop)
        if last == len(stretches) - 1:
            yield Stroke("contour", name, stretches[last])
            return
        back = [Stroke("link", f"{name} back", joined(stretches[:last]).reversed())] if last else []
        yield from back
        for number in range(len(stretches) - 1, last, -1):
            yield Stroke("contour", name, stretches[number].reversed())
            yield from self._holes(part, stops[number])
        yield Stroke("contour", name, stretches[last].reversed())
        yield from back

    def _holes(self, part: Part, slits: Sequence[Slit]) -> Iterator[Stroke]:
        for slit in slits:
            yield from self._hole(part, slit)

    def _hole(self, part: Part, slit: Slit) -> Iterator[Stroke]:
        name = f"hole {slit.hole.number} of part {part.number}"
        yield Stroke("slit", name, straight(slit.outer, slit.inner))
        if slit.hole.inside:
            tree = self._tree(slit.hole.inside, [(slit.begin, slit.begin)])
            order = safe_order(tree.order(), tree, slit.hole.inside, self._sheet, self._half_mm)
            yield Stroke("lead-in", name, straight(slit.inner, slit.begin))
            yield from self._visits(tree, order, slit.hole.inside)
            yield from _walked(tree, tree.way(tree.leaves[order[-1]], ROOT))
            yield Stroke("lead-out", name, straight(slit.begin, slit.inner))
        yield Stroke("contour", name, started_near(slit.hole.ring, slit.inner))
        yield Stroke("slit", name, straight(slit.inner, slit.outer))

    def _way_out(self, tree: WayTree, node: int, leave: str) -> Iterator[Stroke]:
        if leave == "back":
            yield from _walked(tree, tree.way(node, ROOT))
            return
        _, turn, end = self._exit(tree, node)
        yield from _walked(tree, tree.way(node, turn))
        if not _is_at(np.array(tree.places[turn]), end):
            yield Stroke("link", "way out", straight(tree.places[turn], end))

    def _leaving_mm(self, tree: WayTree, node: int) -> float:
        return self._exit(tree, node)[0]

    def _exit(self, tree: WayTree, node: int) -> tuple[float, int, Point]:
        """Return the shortest way out from a node: back along the ways to another one, and from there straight on."""
        ends = {ROOT: (0.0, tree.places[ROOT])} | self._exits(tree)
        found = [
            (tree.length_mm(tree.way(node, turn)) + length_mm, turn, end) for turn, (length_mm, end) in ends.items()
        ]
        return min(found)

    def _exits(self, tree: WayTree) -> dict[int, tuple[float, Point]]:
        """Return from which nodes a straight way out of the sheet crosses nothing, how long it is and where it ends."""
        low_x, low_y, high_x, high_y = self._box
        ways = shapely.multilinestrings(
            [[tree.places[before], tree.places[node]] for node, before in enumerate(tree.before) if before >= 0]
        )
        found: dict[int, tuple[float, Point]] = {}
        for node in set(range(1, len(tree.places))) - set(tree.leaves.values()):
            x, y = tree.places[node]
            for end in ((low_x, y), (high_x, y), (x, low_y), (x, high_y)):
                length_mm = abs(end[0] - x) + abs(end[1] - y)
                if length_mm < found.get(node, (np.inf,))[0] and self._is_open((x, y), end, ways):
                    found[node] = (length_mm, end)
        return found

    def _is_open(self, begin: Point, end: Point, ways: BaseGeometry) -> bool:
        if not self._map.sees(np.array([begin]), np.array([end]))[0]:
            return False
        met = shapely.get_coordinates(LineString([begin, end]).intersection(ways))
        return bool((np.hypot(*(met - np.array(begin)).T) <= SAME_MM).all())


def corners_of(box: tuple[float, float, float, float]) -> np.ndarray:
    """Return the corners of a box: low x, low y, high x, high y; float64[4, 2], counter-clockwise."""
    low_x, low_y, high_x, high_y = box
    return np.array([(low_x, low_y), (high_x, low_y), (high_x, high_y), (low_x, high_y)])


def sides_of(box: tuple[float, float, float, float]) -> dict[str, Segment]:
    """Return the sides of a box by their names; front is that of the lowest Y."""
    a, b, c, d = ((x, y) for x, y in corners_of(box).tolist())
    return {"left": (a, d), "right": (b, c), "front": (a, b), "back": (d, c)}


def started_near(ring: Curve, place: Point) -> Curve:
    """Return a closed curve begun at its nearest place to another one."""
    return ring.started_at_length(float(ring.nearest(np.array([place]))[1][0]))


def _stretches(ring: Curve, slits: Sequence[Slit]) -> tuple[list[Curve], list[list[Slit]]]:
    """Return the stretches of a ring between slits, and which slits leave where each of them begins."""
    along_mm = ring.nearest(np.array([slit.outer for slit in slits]).reshape(-1, 2))[1].tolist()
    stretches = ring.split(along_mm)
    bounds_mm = np.cumsum([0.0, *(stretch.length_mm for stretch in stretches)])
    stops: list[list[Slit]] = [[] for _ in stretches]
    for at_mm, slit in sorted(zip(along_mm, slits, strict=True), key=lambda each: each[0]):
        stops[int(np.abs(bounds_mm - at_mm).argmin()) % len(stretches)].append(slit)
    return stretches, stops


def unreachable(item: Item, margin_mm: float) -> CycleError:
    """Return the refusal of an item to which no way leads."""
    x, y = item.chords.coords[0]
    what = "no way through the scrap leads to what lies at X{x:.3f} Y{y:.3f}"
    return CycleError(
        "wire-way",
        Text(what, x=x, y=y),
        value=Text("margin {margin_mm:g} mm", margin_mm=margin_mm),
        advice="move the parts farther apart, enter from another edge, or use a thinner wire",
    )


def _walked(tree: WayTree, nodes: Sequence[int]) -> Iterator[Stroke]:
    """Yield the way along nodes: a lead at each end that is an item, links between."""
    leaves = set(tree.leaves.values())
    run: list[Point] = []
    for begin, end in pairwise(nodes):
        kind = "lead-out" if begin in leaves else "lead-in" if end in leaves else "link"
        if kind == "link":
            run = run or [tree.places[begin]]
            run.append(tree.places[end])
            continue
        if run:
            yield Stroke("link", "way", from_points(run))
            run = []
        yield Stroke(kind, kind, straight(tree.places[begin], tree.places[end]))
    if run:
        yield Stroke("link", "way", from_points(run))


def _is_at(place: np.ndarray, other: Point) -> bool:
    return float(np.hypot(place[0] - other[0], place[1] - other[1])) <= SAME_MM
