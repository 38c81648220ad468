# SPDX-License-Identifier: LGPL-2.1-or-later
"""The judge of a layout: exact geometry, apart from the search; a layout with a fault is never written.

It knows nothing of no-fit polygons: it turns and moves each part's exact polygon and measures distances with shapely.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

import shapely
from shapely import Polygon
from shapely.geometry.base import BaseGeometry

from CNCStepper.errors import GeometryError, Text
from CNCStepper.nesting.nesting_model import (
    Item,
    Layout,
    Placement,
    Sheet,
    Spacing,
    allowed_rotations_deg,
    is_among,
    placed,
)
from CNCStepper.tolerances import TOUCHING_PARTS_MM


def require_sound(items: Sequence[Item], sheets: Sequence[Sheet], spacing: Spacing, layout: Layout) -> None:
    """Raise GeometryError with the first fault of a layout."""
    if fault := next(faults(items, sheets, spacing, layout), None):
        raise GeometryError("nest-fault", fault, advice="move or turn that part, or nest again")


def faults(items: Sequence[Item], sheets: Sequence[Sheet], spacing: Spacing, layout: Layout) -> Iterator[str]:
    """Yield each fault: overlap, too little distance, beyond the sheet, wrong rotation, stock or count."""
    for number in layout.sheets:
        on_sheet = [placement for placement in layout.placements if placement.sheet == number]
        yield from sheet_faults(items, sheets[number], spacing, on_sheet)
    yield from _count_faults(items, layout)


def sheet_faults(
    items: Sequence[Item], sheet: Sheet, spacing: Spacing, placements: Sequence[Placement]
) -> Iterator[str]:
    """Yield each fault of the placements on one sheet."""
    polygons = [placed(items[placement.item].exact, placement) for placement in placements]
    names = [items[placement.item].name for placement in placements]
    for placement, polygon, name in zip(placements, polygons, names, strict=True):
        item = items[placement.item]
        if item.stock != sheet.stock:
            yield Text("part '{name}' lies on a sheet of other stock", name=name)
        if not _may_turn(item, sheet, placement):
            yield Text("part '{name}' is turned by {angle:g} deg", name=name, angle=placement.rotation_deg)
        if not lies_within(polygon, sheet.outline, spacing.margin_mm):
            yield Text("part '{name}' lies beyond the sheet '{sheet}'", name=name, sheet=sheet.name)
    for first, second in _close_pairs(polygons, spacing.gap_mm):
        if conflict(polygons[first], polygons[second], spacing.gap_mm):
            yield Text("parts '{one}' and '{other}' are too close", one=names[first], other=names[second])


def conflict(one: BaseGeometry, other: BaseGeometry, gap_mm: float) -> bool:
    """Return whether two parts overlap or lie closer than the gap; what is within TOUCHING_PARTS_MM touches."""
    if gap_mm > 0.0 and one.distance(other) < gap_mm - TOUCHING_PARTS_MM:
        return True
    return one.intersects(other) and is_thick(one.intersection(other))


def lies_within(part: BaseGeometry, outline: Polygon, margin_mm: float) -> bool:
    """Return whether a part lies on a sheet and no closer than the margin to its rim."""
    if margin_mm > 0.0 and part.distance(outline.boundary) < margin_mm - TOUCHING_PARTS_MM:
        return False
    return outline.covers(part) or not is_thick(part.difference(outline))


def is_thick(overlap: BaseGeometry) -> bool:
    """Return whether an overlap is deeper than TOUCHING_PARTS_MM anywhere: its mean width, of each piece."""
    pieces = shapely.get_parts(overlap)
    return any(piece.area > TOUCHING_PARTS_MM * max(piece.length / 2.0, TOUCHING_PARTS_MM) for piece in pieces)


def _may_turn(item: Item, sheet: Sheet, placement: Placement) -> bool:
    if placement in item.locked:
        return True
    allowed = allowed_rotations_deg(item, sheet)
    return allowed is None or is_among(placement.rotation_deg, allowed)


def _close_pairs(polygons: Sequence[Polygon], gap_mm: float) -> Iterator[tuple[int, int]]:
    if len(polygons) < 2:
        return
    tree = shapely.STRtree(polygons)
    left, right = tree.query(polygons, predicate="dwithin", distance=gap_mm)
    yield from ((int(a), int(b)) for a, b in zip(left, right, strict=True) if a < b)


def _count_faults(items: Sequence[Item], layout: Layout) -> Iterator[str]:
    counts = Counter(placement.item for placement in layout.placements)
    for unplaced in layout.unplaced:
        counts[unplaced.item] += unplaced.count
    for number, item in enumerate(items):
        wanted = item.count + len(item.locked)
        is_right = counts[number] <= wanted if item.fill else counts[number] == wanted
        if not is_right:
            yield Text("part '{name}' lies there {count} times", name=item.name, count=counts[number])
