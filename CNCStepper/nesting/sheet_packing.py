# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fills sheets by packed strips: of all parts that are left, a strip as high as the sheet; its fullest window stays.

    parts left ──► strip ──► shorter than the sheet: all lie on it
                     └─────► fullest window ──► a second strip, of as much area as fills the sheet ──► the better
    then holes and gaps are filled part by part (sheet_filling.py), and the next sheet takes what is left

Parts that the first attempt has put into holes of others are left out of the strips: they go into holes again. Sheets
of other outlines than a rectangle, and those with locked parts, are filled part by part alone.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence

import numpy as np
import shapely
from shapely import Polygon

from CNCStepper.nesting.nesting_model import Budget, Item, Placement, allowed_rotations_deg, moved, tried_rotations_deg
from CNCStepper.nesting.sheet_filling import Filling, Shapes, fill
from CNCStepper.nesting.strips import StripPacker, StripPart, StripPlace, extents_mm, fullest_window
from CNCStepper.tolerances import SAME_SHARE

LEAST_S = 0.5  # of time for a strip
DENSER = 0.97  # of the strip's density is tried on a sheet
SECOND_SHARE = 0.5  # of a sheet's time, for the second strip


def in_holes(shapes: Shapes, fillings: Iterable[Filling]) -> Counter[int]:
    """Return how many parts of each item lie in holes of other parts."""
    hidden: Counter[int] = Counter()
    if not any(item.outline.interiors for item in shapes.items):
        return hidden
    for filling in filter(lambda filling: filling.placements, fillings):
        polygons = [moved(shapes.turned(_key(each)), each.x_mm, each.y_mm) for each in filling.placements]
        filled = [Polygon(polygon.exterior) for polygon in polygons]
        tree = shapely.STRtree(filled)
        inner, outer = tree.query([polygon.representative_point() for polygon in polygons], predicate="within")
        within = {int(a) for a, b in zip(inner, outer, strict=True) if a != b and polygons[b].area > polygons[a].area}
        hidden.update(filling.placements[number].item for number in within)
    return hidden


def packed_sheets(
    fillings: Sequence[Filling],
    order: Sequence[int],
    hidden: Counter[int],
    strips: StripPacker,
    budget: Budget,
    seed: int,
) -> list[int]:
    """Fill the sheets in turn from the parts in `order`; return those that found no place."""
    left = Counter(order)
    for place, filling in enumerate(fillings):
        if not +left:
            break
        share = _shares_of(left, fillings[place:])
        own = budget.part(budget.left_s / share)
        for placement in _from_strips(filling, left, hidden, strips, own, seed + place):
            if filling.is_free(placement):
                filling.add(placement)
                left[placement.item] -= 1
        rest = fill(filling, iter(_in_order(order, left)), budget)
        left = Counter(rest)
    return _in_order(order, left)


def _in_order(order: Sequence[int], left: Counter[int]) -> list[int]:
    return [number for number in dict.fromkeys(order) for _ in range(left[number])]


def _shares_of(left: Counter[int], fillings: Sequence[Filling]) -> float:
    """Return by how many the time that is left is divided: about the number of sheets that are still needed."""
    shapes = fillings[0].shapes
    needed = sum(count * shapes.items[number].outline.area for number, count in left.items())
    area = sum(piece.area for piece in fillings[0].room.pieces)
    return float(max(1, min(len(fillings), np.ceil(1.2 * needed / max(area, 1e-9)))))


def _from_strips(
    filling: Filling, left: Counter[int], hidden: Counter[int], strips: StripPacker, budget: Budget, seed: int
) -> list[Placement]:
    """Return what strips place on a sheet."""
    box = _rectangle(filling)
    parts = _strip_parts(filling, left - hidden)
    if box is None or not parts or budget.left_s < LEAST_S:
        return []
    length_mm, height_mm = box[2] - box[0], box[3] - box[1]
    is_long = _area(parts) < 0.5 * length_mm * height_mm  # a strip: all of it fits for certain
    first = strips(parts, height_mm, budget.part(budget.left_s * (1.0 if is_long else 1.0 - SECOND_SHARE)), seed)
    if not first:
        return []
    extents = extents_mm(parts, first)
    best = _window(first, extents, length_mm, box)
    if np.ptp(extents[:, :2]) > length_mm and budget.left_s > LEAST_S:
        density = extents[:, 2].sum() / (height_mm * np.ptp(extents[:, :2]))
        few = _selected(parts, DENSER * density * length_mm * height_mm)
        second = strips(few, height_mm, budget, seed + 1) if few else None
        if second:
            other = _window(second, extents_mm(few, second), length_mm, box)
            best = max(best, other, key=lambda found: _placed_area(filling, found))
    return best


def _rectangle(filling: Filling) -> tuple[float, float, float, float] | None:
    """Return the box for grown outlines on a sheet that is an empty rectangle along the axes."""
    pieces = filling.room.pieces
    if filling.placements or len(pieces) != 1 or pieces[0].interiors:
        return None
    left, low, right, high = pieces[0].bounds
    if shapely.box(left, low, right, high).area - pieces[0].area > SAME_SHARE * pieces[0].area:
        return None
    rim_mm = filling.shapes.spacing.gap_mm / 2.0
    return left - rim_mm, low - rim_mm, right + rim_mm, high + rim_mm


def _strip_parts(filling: Filling, left: Counter[int]) -> list[StripPart]:
    shapes, sheet = filling.shapes, filling.room.sheet
    counts = {number: count for number, count in sorted(left.items()) if count > 0}
    return [
        StripPart(number, shapes.turned((number, 0.0)), count, allowed_rotations_deg(shapes.items[number], sheet))
        for number, count in counts.items()
        if _fits(filling, number)
    ]


def _fits(filling: Filling, number: int) -> bool:
    """Return whether an item lies on the empty sheet in some rotation that a strip packer may choose."""
    item: Item = filling.shapes.items[number]
    angles = tried_rotations_deg(item, filling.room.sheet)
    return any(not filling.room.fit(filling.shapes, (number, angle % 360.0)).is_empty for angle in angles)


def _window(
    places: Sequence[StripPlace], extents: np.ndarray, length_mm: float, box: tuple[float, float, float, float]
) -> list[Placement]:
    begin_mm, inside = fullest_window(extents, length_mm)
    return [
        Placement(0, place.item, place.x_mm - begin_mm + box[0], place.y_mm + box[1], place.rotation_deg)
        for place, is_in in zip(places, inside.tolist(), strict=True)
        if is_in
    ]


def _selected(parts: Sequence[StripPart], area: float) -> list[StripPart]:
    """Return about the share of each part that gives the area, the large ones rounded up."""
    share, taken, chosen = min(area / _area(parts), 1.0), 0.0, []
    for part in sorted(parts, key=lambda part: -part.outline.area):
        count = min(int(np.ceil(part.count * share)), int((area - taken) / part.outline.area))
        if count > 0:
            chosen.append(StripPart(part.item, part.outline, count, part.rotations_deg))
            taken += count * part.outline.area
    return chosen


def _area(parts: Sequence[StripPart]) -> float:
    return float(sum(part.count * part.outline.area for part in parts))


def _placed_area(filling: Filling, placements: Sequence[Placement]) -> float:
    return float(sum(filling.shapes.items[placement.item].outline.area for placement in placements))


def _key(placement: Placement) -> tuple[int, float]:
    return placement.item, placement.rotation_deg % 360.0
