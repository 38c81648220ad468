# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plan of a sheet: all cuts with their leads in their order, what they set free, figures and warnings."""

from __future__ import annotations

import math
from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.contours.contour_model import Lead
from CNCStepper.cycles.contours.disc_swept_area import swept
from CNCStepper.cycles.cycle import Answer, Removal, RestCorner, Setup
from CNCStepper.cycles.sheet_cutting.chain_polygons import parts_of
from CNCStepper.cycles.sheet_cutting.chains import Chain, nested, polygon_of
from CNCStepper.cycles.sheet_cutting.chord_pieces import ChordPieces, points_of
from CNCStepper.cycles.sheet_cutting.corner_loops import knife_way, loops_at, where_clear
from CNCStepper.cycles.sheet_cutting.cut_precedence import precedence
from CNCStepper.cycles.sheet_cutting.kerf_offset import narrow_warnings, require_gaps, with_paths
from CNCStepper.cycles.sheet_cutting.lead_places import LEAST, Item, lead_ins, lead_outs
from CNCStepper.cycles.sheet_cutting.lead_room import LeadRoom, NoScrap
from CNCStepper.cycles.sheet_cutting.open_lines import Begins, begins_of
from CNCStepper.cycles.sheet_cutting.rapids import cut_order, rapid_ways
from CNCStepper.cycles.sheet_cutting.sheet_model import SheetModel
from CNCStepper.cycles.sheet_cutting.sheet_parameter_checks import Measures, measures_of
from CNCStepper.cycles.sheet_cutting.slow_places import slow_places
from CNCStepper.cycles.sheet_cutting.strokes import Stroke, even, strokes
from CNCStepper.cycles.sheet_cutting.torch_moves import Cut
from CNCStepper.cycles.sheet_cutting.torch_tabs import tabbed_paths
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve, joined

ROUGH_MM = 0.05  # of pieces round which rapids go


@dataclass(frozen=True)
class Spot:
    """A place that gets power for a short time, with the rapids that lead there, float64[k, 2]."""

    title: str
    point: tuple[float, float]
    way: np.ndarray


@dataclass(frozen=True)
class Plan:
    """What is run, in order: spots, then cuts (the marks first); mark_power: the share for spots."""

    spots: list[Spot]
    cuts: list[Cut]
    answer: Answer
    depth_mm: float
    mark_power: float


class SheetAnswer(Answer):
    """The answer of a sheet's cut; the removed area is found when it is asked for."""

    def __init__(self, cuts: Sequence[Cut], kerf_mm: float, depth_mm: float, tolerance_mm: float, **known: object):
        none: list[RestCorner] = []
        self.__dict__.update(_cuts=cuts, _kerf_mm=kerf_mm, _depth_mm=depth_mm, _tolerance_mm=tolerance_mm)
        self.__dict__.update(corners=none, **known)

    @cached_property
    def removals(self) -> list[Removal]:
        """The band of the kerf along everything that is run with power, in the whole sheet."""
        kerf_mm: float = self.__dict__["_kerf_mm"]
        bands = [swept(_powered(cut), kerf_mm / 2.0) for cut in self.__dict__["_cuts"]]
        return [Removal(shapely.union_all(bands), 0.0, -self.__dict__["_depth_mm"], self.__dict__["_tolerance_mm"])]


def planned(cycle: SheetModel, setup: Setup) -> Plan:
    """Return the plan of a sheet; raises CycleError for what cannot be cut safely."""
    measures = measures_of(cycle, setup)
    chains, warnings = nested([curve.moved(*cycle.offset_mm) for curve in cycle.curves])
    spotted = [chain for chain in chains if chain.is_hole and chain.diameter_mm < cycle.spot_below_mm]
    planner = _Planner(cycle, setup, measures, _without(chains, spotted))
    marks = [_mark(cycle, number, curve, measures) for number, curve in enumerate(cycle.marks, start=1)]
    cuts = planner.cuts()
    spots = [Spot(f"spot {chain.number}", point, np.array([point])) for chain in spotted for point in [_centre(chain)]]
    known = {"figures": planner.figures(cuts), "warnings": warnings + planner.warnings, "parts": planner.parts}
    answer = SheetAnswer(cuts, measures.kerf_mm, measures.depth_mm, cycle.tolerance_mm, **known)
    return Plan(spots, marks + cuts, answer, measures.depth_mm, measures.mark_share)


class _Planner:
    """The steps from chains to cuts in their order."""

    def __init__(self, cycle: SheetModel, setup: Setup, measures: Measures, chains: Sequence[Chain]):
        self.cycle, self.setup, self.measures = cycle, setup, measures
        self.side = 1 if cycle.good_side == "right" else -1
        self.warnings: list[str] = []
        self.parts: list[BaseGeometry] = []
        self.crossing, self.rapids_mm, self.loops, self.held = 0, 0.0, 0, 0
        kerf_mm = measures.kerf_mm
        closed = [index for index, chain in enumerate(chains) if not chain.is_open]
        self.outlines = ChordPieces([chains[index].curve for index in closed], closed)
        require_gaps(chains, self.outlines, kerf_mm)
        self.chains = with_paths(chains, kerf_mm, cycle.good_side == "right")
        self.warnings += narrow_warnings(self.chains, kerf_mm)
        self.part_of = np.array([index for index, chain in enumerate(self.chains) for _ in chain.paths], np.int64)
        self.items = [Item(chain, path) for chain in self.chains for path in chain.paths]
        for number in self._begins().turned:
            self.items[number] = replace(self.items[number], path=self.items[number].path.reversed())

    def cuts(self) -> list[Cut]:
        """Return the cuts in their order."""
        self._loop_corners()
        try:
            made = self._begun()
        except NoScrap as error:
            raise error.with_most(self._most_pierce_mm()) from error
        before = self._before()
        begins = np.array([cut.begin for cut in made])
        ends = np.array([cut.end for cut in made])
        fixed = self._begins().fixed
        turns = [
            item.chain.is_open and not self.cycle.blade_offset_mm and number not in fixed
            for number, item in enumerate(self.items)
        ]
        order = cut_order(begins, ends, turns, before)
        return self._on_ways([_turned(made[number]) if turned else made[number] for number, turned in order],
                             [number for number, _ in order])  # fmt: skip

    def figures(self, cuts: Sequence[Cut]) -> dict[str, float]:
        """Return how much is cut, pierced and travelled."""
        cut_mm = sum(curve.length_mm for cut in cuts for curve in _powered(cut))
        figures = {"contours": float(len(cuts)), "pierces": float(len(cuts)), "cut_length_mm": cut_mm}
        figures |= {
            "rapids_mm": self.rapids_mm,
            "parts": float(len(self.parts) - self.held),
            "kerf_mm": self.measures.kerf_mm,
        }
        small = [item for item in self.items if self.measures.rules.is_small(item.chain)]
        figures |= {"small_holes": float(len(small)), "rapids_over_free_parts": float(self.crossing)}
        figures |= {"held_parts": float(self.held)} if self.cycle.tabs else {}
        return figures | ({"loops": float(self.loops)} if self.cycle.loops else {})

    def _loop_corners(self) -> None:
        """Put loops at sharp outside corners where they lie in scrap."""
        loops = self.cycle.loops
        if loops is None:
            return
        paths = [item.path for item in self.items]
        found = [
            loops_at(item.path, loops, self.measures.kerf_mm, self.side) if item.path.closed else []
            for item in self.items
        ]
        room = self._room()

        def clear(items: list[int], curves: list[Curve]) -> np.ndarray:
            ways = np.array([shapely.LineString(curve.points(0.001)) for curve in curves], object)
            fits = room.ways_fit(np.array(items), ways, np.full(len(ways), 0.001))
            for number in np.flatnonzero(fits).tolist():
                others = np.flatnonzero(fits[:number])
                near = shapely.dwithin(ways[others], ways[number], self.measures.kerf_mm)
                fits[number] = not near.any()
            return fits

        paths, left_out = where_clear(paths, found, clear)
        self.loops = sum(map(len, found)) - left_out
        self.items = [replace(item, path=path) for item, path in zip(self.items, paths, strict=True)]
        if left_out:
            self.warnings.append(Text("{left_out} corner(s) get no loop: there is no scrap for it", left_out=left_out))

    def _room(self) -> LeadRoom:
        paths = ChordPieces([item.path for item in self.items])
        sheet = self.setup.stock
        inner = polygon_of(sheet, 0.01).buffer(-self.measures.kerf_mm / 2.0) if sheet is not None else None
        return LeadRoom(self.measures.kerf_mm, self.measures.pierce_mm, self.outlines, paths, self.part_of, inner)

    def _most_pierce_mm(self) -> float | None:
        """Return the largest pierce_mm, in hundredths, with which all contours have a lead; None where none does."""
        measures = self.measures
        fits, too_large = math.ceil(50.0 * measures.kerf_mm), math.ceil(100.0 * measures.pierce_mm)
        if fits >= too_large or not self._has_leads(fits / 100.0):
            return None
        while too_large - fits > 1:
            middle = (fits + too_large) // 2
            fits, too_large = (middle, too_large) if self._has_leads(middle / 100.0) else (fits, middle)
        return fits / 100.0

    def _has_leads(self, pierce_mm: float) -> bool:
        """Return whether all contours have a lead with another distance of pierces."""
        trial = copy(self)
        trial.warnings, trial.measures = [], replace(self.measures, pierce_mm=pierce_mm)
        try:
            trial._begun()
        except NoScrap:
            return False
        except CycleError:  # of another kind, which is reported once this is corrected
            return True
        return True

    def _begun(self) -> list[Cut]:
        """Return each cut from its lead-in on, in the order of the items; raises NoScrap."""
        room = self._room()
        lead_in = self.cycle.lead_of(self.setup.process, self.measures.kerf_mm, self.measures.pierce_mm)
        closed = [number for number, item in enumerate(self.items) if item.path.closed]
        tabbed = self._tabbed()
        closed = [number for number in closed if number not in tabbed]
        begins: list[tuple[float, Curve | None]] = [(0.0, None)] * len(self.items)
        if lead_in.kind != "none" and closed:
            for number, begun in zip(closed, lead_ins(self.items, closed, lead_in, room, self.side), strict=True):
                begins[number] = begun
        outs: dict[int, Curve | None] = dict.fromkeys(range(len(self.items)))
        if self.cycle.lead_out.kind != "none" and closed:
            outs |= self._lead_outs(room, closed, [begins[number][0] for number in closed])
        paths = [self._way(item.path, place_mm) for item, (place_mm, _) in zip(self.items, begins, strict=True)]
        if tabbed:
            paths, begins, outs = self._with_tabs(tabbed, paths, begins, outs, room, lead_in)
        rules = self.measures.rules
        slow = slow_places(paths, rules.arcs, rules.corners, rules.kerf_mm, rules.side)
        return [self._cut(item.chain, strokes(paths[number], item.chain, slow[number], rules), begins[number][1],
                          outs[number]) for number, item in enumerate(self.items)]  # fmt: skip

    def _tabbed(self) -> list[int]:
        """Return the items that a torch cuts in several stretches; a laser goes over its joints without power."""
        if self.cycle.tabs is None or self.setup.process.passes:
            return []
        return [number for number, item in enumerate(self.items) if item.chain.is_part]

    def _with_tabs(
        self,
        tabbed: list[int],
        paths: list[Curve],
        begins: list[tuple[float, Curve | None]],
        outs: dict[int, Curve | None],
        room: LeadRoom,
        lead_in: Lead,
    ) -> tuple[list[Curve], list[tuple[float, Curve | None]], dict[int, Curve | None]]:
        """Return paths and leads with the stretches of each tabbed item in its place, and make these the items."""
        assert self.cycle.tabs is not None
        least_mm = max(room.pierce_mm - room.kerf_mm / 2.0, LEAST * room.kerf_mm)
        lengths_mm = (lead_in.radius_mm or lead_in.length_mm, least_mm)
        runs: list[tuple[int, Curve, Curve | None, Curve | None]] = []
        for number, path in enumerate(paths):
            if number not in tabbed:
                runs.append((number, path, begins[number][1], outs[number]))
                continue
            taken = [lead for _, lead in begins if lead is not None] + [lead for _, _, lead, _ in runs if lead]
            stretches = tabbed_paths(self.items, number, self.cycle.tabs, lengths_mm, room, self.side, taken)
            runs += [(number, stretch, lead, None) for stretch, lead in stretches]
        self.items = [replace(self.items[number], path=path) for number, path, _, _ in runs]
        self.part_of = self.part_of[[number for number, *_ in runs]]
        leads: list[tuple[float, Curve | None]] = [(0.0, lead) for _, _, lead, _ in runs]
        return [path for _, path, _, _ in runs], leads, dict(enumerate(out for *_, out in runs))

    def _lead_outs(self, room: LeadRoom, closed: list[int], places_mm: list[float]) -> dict[int, Curve | None]:
        overcut_mm = self.cycle.overcut_mm
        ends = [place + overcut_mm for place in places_mm]
        small = {number for number in closed if self.measures.rules.is_small(self.items[number].chain)}
        found = dict(
            zip(closed, lead_outs(self.items, closed, ends, self.cycle.lead_out, room, self.side), strict=True)
        )
        missing = sum(lead is None for number, lead in found.items() if number not in small)
        if missing:
            self.warnings.append(
                Text("{missing} cut(s) end without a lead-out: there is no scrap for it", missing=missing)
            )
        return {number: None if number in small else lead for number, lead in found.items()}

    def _way(self, path: Curve, place_mm: float) -> Curve:
        """Return a path from its start, of a drag knife the path of its axis."""
        path = path.started_at_length(place_mm) if place_mm else path
        return knife_way(path, self.cycle.blade_offset_mm) if self.cycle.blade_offset_mm else path

    def _cut(self, chain: Chain, run: list[Stroke], lead_in: Curve | None, lead_out: Curve | None) -> Cut:
        words = {"chain": float(chain.number), "hole": float(chain.is_hole)}
        return Cut(chain.title, np.zeros((0, 2)), lead_in, run, lead_out, words)

    def _before(self) -> list[tuple[int, int]]:
        """Return which items are cut before which others."""
        paths = ChordPieces([item.path for item in self.items], None)
        by_chain = _owned(paths, self.part_of)
        items: dict[int, list[int]] = {}
        for number, chain in enumerate(self.part_of.tolist()):
            items.setdefault(chain, []).append(number)
        pairs = precedence(self.chains, by_chain, self.measures.kerf_mm)
        return [*self._begins().before, *((one, other) for a, b in pairs for one in items[a] for other in items[b])]

    def _begins(self) -> Begins:
        """Return how the open lines begin; a drag knife pierces nothing."""
        lines = {number: item.path for number, item in enumerate(self.items) if item.chain.is_open}
        return begins_of({} if self.cycle.blade_offset_mm else lines, self.measures.kerf_mm)

    def _on_ways(self, cuts: list[Cut], numbers: list[int]) -> list[Cut]:
        """Return the cuts with the rapids that lead to them, and note what they set free."""
        begins, ends = np.array([cut.begin for cut in cuts]), np.array([cut.end for cut in cuts])
        tips, held = self.setup.process.tips_parts, self.cycle.tabs is not None
        whole = parts_of(self.chains, self.measures.kerf_mm)
        last = {int(self.part_of[number]): place for place, number in enumerate(numbers)}
        pieces: list[shapely.Polygon | None] = [None] * len(cuts)
        inner = points_of([item.path for item in self.items], ROUGH_MM)
        for chain in sorted(last, key=last.__getitem__):
            if self.chains[chain].is_part:
                self.parts += whole[chain]
        self.held = len(self.parts) if held else 0
        for place, number in enumerate(numbers):
            if self.items[number].path.closed and not (held and self.items[number].chain.is_part):
                pieces[place] = shapely.Polygon(inner[number])
        ways = rapid_ways(begins, ends, pieces, self.measures.kerf_mm, tips)
        self.crossing, self.rapids_mm = len(ways.crossing), ways.length_mm
        if ways.crossing:
            self.warnings.append(
                Text("{crossing} rapid(s) lead over parts that are already free", crossing=len(ways.crossing))
            )
        return [replace(cut, way=way[1:]) for cut, way in zip(cuts, ways.ways, strict=True)]


def _owned(paths: ChordPieces, part_of: np.ndarray) -> ChordPieces:
    """Return the runs of paths with the chain of each as owner."""
    paths.owner = part_of[paths.owner] if len(part_of) else paths.owner
    return paths


def _without(chains: Sequence[Chain], left_out: Sequence[Chain]) -> list[Chain]:
    """Return the chains but some holes that hold nothing."""
    gone = {id(chain) for chain in left_out}
    places: dict[int, int] = {}
    kept: list[Chain] = []
    for index, chain in enumerate(chains):
        if id(chain) not in gone:
            places[index] = len(kept)
            kept.append(chain)
    return [replace(chain, holder=places.get(chain.holder, -1)) for chain in kept]


def _mark(cycle: SheetModel, number: int, curve: Curve, measures: Measures) -> Cut:
    curve = curve.moved(*cycle.offset_mm)
    feed = cycle.mark_feed_mm_min or measures.rules.feed_mm_min
    words = {"mark": float(number)}
    return Cut(f"mark {number}", curve.xy[:1], None, [even(curve, feed, 1.0)], None, words, measures.mark_share, False)


def _centre(chain: Chain) -> tuple[float, float]:
    x, y = polygon_of(chain.curve, ROUGH_MM).centroid.coords[0]
    return float(x), float(y)


def _turned(cut: Cut) -> Cut:
    return replace(cut, strokes=[stroke.reversed() for stroke in reversed(cut.strokes)])


def _powered(cut: Cut) -> list[Curve]:
    """Return the paths with power, joined where they connect."""
    runs: list[list[Curve]] = [[cut.lead_in] if cut.lead_in is not None else []]
    for stroke in cut.strokes:
        if stroke.power:
            runs[-1].append(stroke.curve)
        elif runs[-1]:
            runs.append([])
    if cut.lead_out is not None:
        runs[-1].append(cut.lead_out)
    return [joined(run) for run in runs if run]
