# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fills one sheet part by part: each goes into the hole of a part, else to the leftmost place that is free for it.

    free places of an item = inner fit of the sheet  less  no-fit polygons of its holes and of the parts there
    candidates             = corners of that region, by what the part's right end and then its top come to

What fits exactly has a region without area. Where an item has no place, its region is taken a little larger; a corner
of that, rounded, is a place only where the judge finds no conflict.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import shapely
from shapely import Polygon
from shapely.geometry.base import BaseGeometry

from CNCStepper.cancellation import checkpoint
from CNCStepper.nesting.judge import conflict, lies_within
from CNCStepper.nesting.nesting_model import (
    Budget,
    Item,
    Placement,
    Sheet,
    Spacing,
    moved,
    tried_rotations_deg,
    turned,
)
from CNCStepper.nesting.no_fit import inner_fit, no_fit
from CNCStepper.nesting.outlines import grown, shrunk
from CNCStepper.tolerances import SAME_OUTLINE_SHARE, TOUCHING_PARTS_MM

LOOSE_MM = 2e-6  # how much larger a region is taken where nothing fits
GRID_DECIMALS = 5  # of a place that is rounded: coarser than LOOSE_MM
MOST_TRIED = 40  # corners of a loose region
ROUND = 24  # corners of an outline whose rotations may be the same though its corners differ
Key = tuple[int, float]  # of an item and its rotation
Make = Callable[[Key, Key], BaseGeometry]


class Shapes:
    """The grown outlines of the items and their no-fit polygons, each calculated once.

    Outlines are grown by half the gap: grown outlines that touch lie the gap apart.
    """

    def __init__(self, items: Sequence[Item], spacing: Spacing):
        self.items, self.spacing = tuple(items), spacing
        self._grown = [grown(item.outline, spacing.gap_mm / 2.0) for item in items]
        self._turned: dict[Key, Polygon] = {}
        self._bare: dict[Key, Polygon] = {}
        self._no_fits: dict[tuple[int, int, float], BaseGeometry] = {}
        self._in_holes: dict[tuple[int, int, float], BaseGeometry] = {}
        self._loose: dict[tuple[int, int, float], BaseGeometry] = {}
        self._rotations: dict[tuple[int, float | None], tuple[float, ...]] = {}

    def rotations_deg(self, number: int, sheet: Sheet) -> tuple[float, ...]:
        """Return the rotations to try on a sheet, of those that give the same outline one."""
        key = number, sheet.grain_deg
        if key not in self._rotations:
            tried = [angle % 360.0 for angle in tried_rotations_deg(self.items[number], sheet)]
            outlines = {angle: _centred(self.turned((number, angle))) for angle in tried}
            distinct: list[float] = []
            for angle in tried:
                if not any(_same(outlines[angle], outlines[other]) for other in distinct):
                    distinct.append(angle)
            self._rotations[key] = tuple(distinct)
        return self._rotations[key]

    def turned(self, key: Key) -> Polygon:
        """Return the grown outline of an item in a rotation."""
        if key not in self._turned:
            self._turned[key] = turned(self._grown[key[0]], key[1])
        return self._turned[key]

    def bare(self, key: Key) -> Polygon:
        """Return the outline of an item in a rotation as it is, for the rim of a sheet."""
        if key not in self._bare:
            self._bare[key] = turned(self.items[key[0]].outline, key[1])
        return self._bare[key]

    def no_fit(self, still: Key, part: Key) -> BaseGeometry:
        """Return where the origin of `part` may not lie beside and in `still`, whose origin is at 0, 0."""
        return self._relative(self._no_fits, still, part, self._no_fit)

    def loose_no_fit(self, still: Key, part: Key) -> BaseGeometry:
        """Return the no-fit polygon, smaller by LOOSE_MM."""
        return self._relative(self._loose, still, part, self._loose_no_fit)

    def in_holes(self, still: Key, part: Key) -> BaseGeometry:
        """Return where the origin of `part` lies in a hole of `still`, whose origin is at 0, 0."""
        if not self._grown[still[0]].interiors:
            return Polygon()
        return self._relative(self._in_holes, still, part, self._hole_fit)

    def _relative(
        self, kept: dict[tuple[int, int, float], BaseGeometry], still: Key, part: Key, make: Make
    ) -> BaseGeometry:
        between = (part[1] - still[1]) % 360.0
        key = still[0], part[0], between
        if key not in kept:
            checkpoint()
            kept[key] = make((still[0], 0.0), (part[0], between))
        return turned(kept[key], still[1]) if still[1] else kept[key]

    def _no_fit(self, still: Key, part: Key) -> BaseGeometry:
        beside, in_holes = no_fit(self.turned(still), self.turned(part)), self.in_holes(still, part)
        return beside if in_holes.is_empty else beside.difference(in_holes)

    def _loose_no_fit(self, still: Key, part: Key) -> BaseGeometry:
        return self.no_fit(still, part).buffer(-LOOSE_MM, join_style="mitre")

    def _hole_fit(self, still: Key, part: Key) -> BaseGeometry:
        holes = self.turned(still).interiors
        return shapely.union_all([inner_fit(Polygon(hole), self.turned(part)) for hole in holes])


@dataclass(frozen=True)
class Room:
    """A sheet and where parts may lie on it, no closer to its rim than the margin."""

    number: int
    sheet: Sheet
    spacing: Spacing

    @cached_property
    def pieces(self) -> tuple[Polygon, ...]:
        """The usable pieces of the sheet."""
        usable = shrunk(self.sheet.outline, self.spacing.margin_mm)
        return tuple(part for part in shapely.get_parts(usable) if isinstance(part, Polygon) and part.area > 0)

    @cached_property
    def _fits(self) -> dict[Key, BaseGeometry]:
        return {}

    def fit(self, shapes: Shapes, key: Key) -> BaseGeometry:
        """Return where the origin of an item may lie on the empty sheet."""
        if key not in self._fits:
            part = shapes.bare(key)
            self._fits[key] = shapely.union_all([_fit(piece, part) for piece in self.pieces])
        return self._fits[key]


def _fit(piece: Polygon, part: Polygon) -> BaseGeometry:
    within = inner_fit(piece, part)
    holes = [no_fit(Polygon(hole), part) for hole in piece.interiors] if not within.is_empty else []
    return within.difference(shapely.union_all(holes)) if holes else within


class Filling:
    """A sheet while it is filled."""

    def __init__(self, room: Room, shapes: Shapes):
        self.room, self.shapes = room, shapes
        self.placements: list[Placement] = []
        self._exact: list[Polygon] = []
        self._free: dict[Key, tuple[int, BaseGeometry]] = {}

    @property
    def end_mm(self) -> float:
        """How far the parts reach along X."""
        return max((polygon.bounds[2] for polygon in self._exact), default=-np.inf)

    def add(self, placement: Placement) -> None:
        """Let a part lie where it is placed."""
        self.placements.append(replace(placement, sheet=self.room.number))
        item = self.shapes.items[placement.item]
        self._exact.append(moved(turned(item.exact, placement.rotation_deg), placement.x_mm, placement.y_mm))

    def place(self, number: int) -> bool:
        """Place one part of an item where it fits best; return False where it does not fit."""
        keys = [(number, angle) for angle in self.shapes.rotations_deg(number, self.room.sheet)]
        found = [place for key in keys if (place := self._best(key)) is not None]
        if not found:
            found = [place for key in keys if (place := self._exact_fit(key)) is not None]
        if not found:
            return False
        self.add(min(found)[1])
        return True

    def _best(self, key: Key) -> tuple[tuple[float, float, float], Placement] | None:
        """Return the best free corner with its rank: in a hole first, then by right end and top."""
        free = self._free_places(key)
        if free.is_empty:
            return None
        in_hole = free.intersection(self._holes(key))
        corners = shapely.get_coordinates(free if in_hole.is_empty else in_hole)
        right, top = self.shapes.bare(key).bounds[2:]
        x, y = min(corners.tolist())
        return (float(in_hole.is_empty), x + right, y + top), Placement(self.room.number, key[0], x, y, key[1])

    def _holes(self, key: Key) -> BaseGeometry:
        """Return where the item lies in the hole of a part."""
        found = []
        for placement in self.placements:
            holes = self.shapes.in_holes((placement.item, placement.rotation_deg), key)
            if not holes.is_empty:
                found.append(moved(holes, placement.x_mm, placement.y_mm))
        return shapely.union_all(found)

    def _free_places(self, key: Key) -> BaseGeometry:
        """Return the free places of an item, kept from one part to the next."""
        done, free = self._free.get(key) or (0, self.room.fit(self.shapes, key))
        if done < len(self.placements) and not free.is_empty:
            taken = [self._taken(placement, key) for placement in self.placements[done:]]
            free = _areas(free.difference(shapely.union_all(taken)))
        self._free[key] = len(self.placements), free
        return free

    def _taken(self, placement: Placement, key: Key) -> BaseGeometry:
        no_fit = self.shapes.no_fit((placement.item, placement.rotation_deg), key)
        return moved(no_fit, placement.x_mm, placement.y_mm)

    def _exact_fit(self, key: Key) -> tuple[tuple[float, float, float], Placement] | None:
        """Return a place where the item just fits between others, touching them on two sides."""
        bounds = self.shapes.bare(key).bounds
        if not self._may_just_fit(bounds):
            return None
        loose = _loose_fit(self.room, self.shapes, key)
        taken = [
            moved(self.shapes.loose_no_fit((each.item, each.rotation_deg), key), each.x_mm, each.y_mm)
            for each in self.placements
        ]
        loose = loose.difference(shapely.union_all(taken))
        corners = np.unique(shapely.get_coordinates(loose).round(GRID_DECIMALS), axis=0).tolist()
        for x, y in sorted(corners)[:MOST_TRIED]:
            placement = Placement(self.room.number, key[0], x, y, key[1])
            if self.is_free(placement):
                return (1.0, x + bounds[2], y + bounds[3]), placement
        return None

    def _may_just_fit(self, bounds: tuple[float, float, float, float]) -> bool:
        long_mm, high_mm = bounds[2] - bounds[0] - LOOSE_MM, bounds[3] - bounds[1] - LOOSE_MM
        rooms = [piece.bounds for piece in self.room.pieces]
        return any(room[2] - room[0] >= long_mm and room[3] - room[1] >= high_mm for room in rooms)

    def is_free(self, placement: Placement) -> bool:
        """Return whether the judge allows a part there."""
        item, spacing = self.shapes.items[placement.item], self.shapes.spacing
        polygon = moved(turned(item.exact, placement.rotation_deg), placement.x_mm, placement.y_mm)
        if not lies_within(polygon, self.room.sheet.outline, spacing.margin_mm):
            return False
        return not any(conflict(polygon, other, spacing.gap_mm) for other in self._exact)


def _centred(polygon: Polygon) -> Polygon:
    """Return a polygon with its box's middle at 0, 0."""
    left, low, right, high = polygon.bounds
    return moved(polygon, -(left + right) / 2.0, -(low + high) / 2.0)


def _same(one: Polygon, other: Polygon) -> bool:
    """Return whether two outlines are one but for rounding; two discs of chords are one too."""
    if one.symmetric_difference(other).area > SAME_OUTLINE_SHARE * one.area:
        return False
    return (
        bool(np.allclose(one.bounds, other.bounds, rtol=0.0, atol=TOUCHING_PARTS_MM))
        or len(one.exterior.coords) > ROUND
    )


def _areas(found: BaseGeometry) -> BaseGeometry:
    """Return the polygons of a result; lines and points in it are places of no tolerance."""
    if found.geom_type in ("Polygon", "MultiPolygon"):
        return found
    return shapely.union_all([part for part in shapely.get_parts(found) if isinstance(part, Polygon)])


def _loose_fit(room: Room, shapes: Shapes, key: Key) -> BaseGeometry:
    part = shapes.bare(key)
    pieces = [piece.buffer(LOOSE_MM, join_style="mitre") for piece in room.pieces]
    return shapely.union_all([_fit(piece, part) for piece in pieces if isinstance(piece, Polygon)])


def fill(filling: Filling, order: Iterator[int], budget: Budget) -> list[int]:
    """Place the items in their order on one sheet; return those that found no place, after a stop all others."""
    full = set[tuple[int, int]]()
    return [number for number in order if budget.stopped.is_set() or not placed_on_first([filling], number, full)]


def placed_on_first(fillings: Sequence[Filling], number: int, full: set[tuple[int, int]]) -> bool:
    """Place a part on the first sheet that takes it; `full` remembers which item found no place on which sheet."""
    for place, filling in enumerate(fillings):
        if (number, place) not in full:
            if filling.place(number):
                return True
            full.add((number, place))
    return False
