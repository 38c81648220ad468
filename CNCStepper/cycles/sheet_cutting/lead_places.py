# SPDX-License-Identifier: LGPL-2.1-or-later
"""The search for leads: each contour gets a start where its lead and its pierce lie wholly in scrap.

First the lead as it is wanted at a few places of each path. Paths without room get more places, smaller leads down to
the least that holds the pierce's distance, and other angles; holes also a lead from the middle of their scrap. Leads
that come too near to each other move on in turn.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import shapely

from CNCStepper.cycles.contours.contour_model import Lead
from CNCStepper.cycles.sheet_cutting.chain_polygons import scrap_in
from CNCStepper.cycles.sheet_cutting.chains import Chain
from CNCStepper.cycles.sheet_cutting.chord_pieces import ChordPieces
from CNCStepper.cycles.sheet_cutting.lead_room import LeadRoom, NoScrap
from CNCStepper.cycles.sheet_cutting.lead_shapes import ARC, LINE, Leads, curve_of, flatness_mm, lead_points, together
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve

LONGEST = 4  # segments in whose middle a start is tried first
LEAST = 0.05  # of a kerf: no lead is shorter
BATCH = 40_000  # leads that are tested together


@dataclass(frozen=True)
class Item:
    """A path to cut: of which chain, and the curve."""

    chain: Chain
    path: Curve


@dataclass(frozen=True)
class _Round:
    """One round of the search: places on each path, sizes between the wanted and the least, angles of lines."""

    places: int
    sizes: tuple[float, ...]
    lines_deg: tuple[float, ...]
    arcs_deg: tuple[float, ...]
    middles: bool = False


ROUNDS = (
    _Round(1, (1.0, 0.5), (), ()),
    _Round(2, (0.5, 0.0), (90.0,), ()),
    _Round(24, (1.0, 0.5, 0.0), (90.0,), ()),
    _Round(96, (0.6, 0.3, 0.0), (90.0, 60.0, 120.0, 35.0), (90.0, 50.0), middles=True),
)


def lead_ins(
    items: Sequence[Item], numbers: Sequence[int], wanted: Lead, room: LeadRoom, side: int
) -> list[tuple[float, Curve]]:
    """Return for some items, by number, the length along the path where each begins and its lead-in.

    side: +1 where the scrap lies left of the paths. Raises CycleError where there is no room.
    """
    search = _Search([item.path for item in items], wanted, room, side)
    pending = _searched(search, items, np.array(numbers, np.int64), room)
    if len(pending) and room.sheet is not None:
        search.room = replace(room, sheet=None)  # shapes outside the sheet are reported elsewhere
        pending = _searched(search, items, pending, search.room)
    if len(pending):
        raise _no_room(items[int(pending[0])], room)
    return search.found(numbers)


def _searched(search: _Search, items: Sequence[Item], pending: np.ndarray, room: LeadRoom) -> np.ndarray:
    """Look for leads round by round; return the items that have none then."""
    for one in ROUNDS:
        if not len(pending):
            break
        extra = [_from_middle(items, int(item), room) for item in pending] if one.middles else []
        pending = search.settle(together([search.candidates(pending, one), *extra]))
    return pending


def lead_outs(
    items: Sequence[Item], numbers: Sequence[int], places_mm: Sequence[float], wanted: Lead, room: LeadRoom, side: int
) -> list[Curve | None]:
    """Return a lead-out for some items, from a place of each path, shorter where it must; None for no room."""
    paths = [item.path for item in items]
    angle, kind = math.radians(wanted.angle_deg), ARC if wanted.kind == "arc" else LINE
    found: list[Curve | None] = [None] * len(numbers)
    pending, size_mm = np.arange(len(numbers)), wanted.radius_mm or wanted.length_mm
    for factor in (1.0, 0.6, 0.3, 0.1):
        if not len(pending):
            break
        place, item = np.array(places_mm, float)[pending], np.array(numbers, np.int64)[pending]
        place = np.array([at % paths[each].length_mm for at, each in zip(place, item.tolist(), strict=True)])
        full = np.full(len(pending), 1.0)
        leads = Leads(item, place, np.full(len(pending), kind), full * size_mm * factor, full * angle)
        points = lead_points(leads, paths, side, into=False)
        fits = room.ways_fit(leads.item, shapely.linestrings(points), flatness_mm(leads))
        for row in np.flatnonzero(fits).tolist():
            found[int(pending[row])] = curve_of(leads.rows(np.array([row])), points[row], side, into=False)
        pending = pending[~fits]
    return found


class _Search:
    """The leads found so far; those of later rounds keep clear of them."""

    def __init__(self, paths: list[Curve], wanted: Lead, room: LeadRoom, side: int):
        self._paths, self._wanted, self.room, self._side = paths, wanted, room, side
        self._found: dict[int, tuple[float, Curve]] = {}

    def found(self, numbers: Sequence[int]) -> list[tuple[float, Curve]]:
        """Return the place and the lead-in of some items."""
        return [self._found[number] for number in numbers]

    def candidates(self, pending: np.ndarray, one: _Round) -> Leads:
        """Return the leads of a round for some items, the wanted ones first."""
        wanted, least_mm = self._wanted, self._least_mm
        full_mm = max(wanted.radius_mm or wanted.length_mm, least_mm)
        ways: list[tuple[int, float, float]] = []
        for share in one.sizes:
            size_mm = least_mm + share * (full_mm - least_mm)
            ways.append((ARC if wanted.kind == "arc" else LINE, size_mm, wanted.angle_deg))
            ways += [(ARC, size_mm / (1.0 - math.cos(math.radians(deg))), deg) for deg in one.arcs_deg]
            ways += [(LINE, size_mm / math.sin(math.radians(deg)), deg) for deg in one.lines_deg]
        table = np.array(ways, float)
        places = [_starts(self._paths[item], one.places) for item in pending.tolist()]
        counts = np.array([len(each) for each in places])
        item = np.repeat(pending, counts * len(ways))
        place = np.concatenate([np.tile(each, len(ways)) for each in places])
        kind, sizes_mm, angle = np.concatenate([np.repeat(table, count, axis=0) for count in counts]).T
        return Leads(item, place, kind.astype(int), sizes_mm, np.radians(angle))

    def settle(self, leads: Leads) -> np.ndarray:
        """Give each item the first of its leads that fits beside those found; return the items without one."""
        pending = np.unique(leads.item)
        leads, points = self._fitting(leads)
        order = np.argsort(leads.item, kind="stable")
        leads, points = leads.rows(order), points[order]
        alive = self._clear_of_found(leads, points)
        while alive.any():
            items, first = np.unique(leads.item[alive], return_index=True)
            chosen = np.flatnonzero(alive)[first]
            bad = _too_near(points[chosen], self._apart_mm)
            if not bad.any():
                break
            alive[chosen[bad]] = False
        if not alive.any():
            return pending
        for row in chosen.tolist():
            curve = curve_of(leads.rows(np.array([row])), points[row], self._side, into=True)
            self._found[int(leads.item[row])] = (float(leads.place_mm[row]), curve)
        return np.setdiff1d(pending, items)

    @property
    def _least_mm(self) -> float:
        """How far a pierce is from the path at least."""
        return max(self.room.pierce_mm - self.room.kerf_mm / 2.0, LEAST * self.room.kerf_mm)

    @property
    def _apart_mm(self) -> float:
        """How far leads stay from each other: a pierce's spot and half a kerf."""
        return self.room.pierce_mm + self.room.kerf_mm / 2.0

    def _fitting(self, leads: Leads) -> tuple[Leads, np.ndarray]:
        """Return the leads that fit, with their points."""
        kept, kept_points = [], []
        for first in range(0, len(leads), BATCH):
            some = leads.rows(np.arange(first, min(first + BATCH, len(leads))))
            points = lead_points(some, self._paths, self._side, into=True)
            fits = np.flatnonzero(self.room.pierces_fit(some.item, points[:, 0]))
            some, points = some.rows(fits), points[fits]
            fits = self.room.ways_fit(some.item, shapely.linestrings(points), flatness_mm(some))
            kept.append(some.rows(fits))
            kept_points.append(points[fits])
        return together(kept), np.concatenate(kept_points)

    def _clear_of_found(self, leads: Leads, points: np.ndarray) -> np.ndarray:
        alive = np.ones(len(leads), bool)
        if self._found and len(leads):
            others = ChordPieces([curve for _, curve in self._found.values()])
            hit, _ = others.near(shapely.linestrings(points), self._apart_mm)
            alive[hit] = False
        return alive


def _starts(path: Curve, count: int) -> np.ndarray:
    """Return lengths along a path where it may begin: in its longest segments first, then evenly over it."""
    longest = np.argsort(-path.lengths_mm, kind="stable")[:LONGEST]
    middles = path.before_mm[longest] + path.lengths_mm[longest] / 2.0
    return np.concatenate([middles, (np.arange(max(count - len(middles), 0)) + 0.25) * path.length_mm / count])[:count]


def _too_near(points: np.ndarray, apart_mm: float) -> np.ndarray:
    """Return which of some leads come too near to an earlier one that stays, bool[n]."""
    lines = shapely.linestrings(points)
    one, other = shapely.STRtree(lines).query(lines, predicate="dwithin", distance=apart_mm)
    bad = np.zeros(len(lines), bool)
    for first, second in sorted(zip(one.tolist(), other.tolist(), strict=True)):
        if first < second and not bad[first]:
            bad[second] = True
    return bad


def _from_middle(items: Sequence[Item], number: int, room: LeadRoom) -> Leads:
    """Return the lead from the middle of a hole's scrap straight to the path, none for the outline of a part."""
    item = items[number]
    middle = scrap_in([each.chain for each in items], item.chain, room.kerf_mm) if item.chain.is_hole else None
    if middle is None:
        return Leads(*(np.zeros(0, kind) for kind in (int, float, int, float, float)))
    (size_mm,), (place_mm,) = item.path.nearest(middle[None, :])
    meet, along = item.path.at_length(float(place_mm))
    away, ahead = complex(*(middle - meet)), complex(*along)
    angle = math.pi - abs(math.atan2((away / ahead).imag, (away / ahead).real)) if size_mm else math.pi / 2.0
    return Leads(*(np.array([value]) for value in (number, float(place_mm), LINE, float(size_mm), angle)))


def _no_room(item: Item, room: LeadRoom) -> CycleError:
    x, y = item.path.xy[0].tolist()
    what = Text(
        "there is no scrap for the pierce and lead-in of {chain} near X{x:.3f} Y{y:.3f}",
        chain=item.chain.title, x=x, y=y,
    )  # fmt: skip
    return NoScrap("lead-room", what, value=room.pierce_value, scrap_mm=room.scrap_mm(item.chain.is_hole))
