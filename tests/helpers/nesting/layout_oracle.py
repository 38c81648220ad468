# SPDX-License-Identifier: LGPL-2.1-or-later
"""Judges a layout by shapely's own transforms and booleans: it imports no geometry of the package under test."""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Sequence

from shapely import Polygon, affinity

from CNCStepper.nesting.nesting_model import Item, Layout, Sheet, Spacing

NEAR_MM = 2e-6
NOTHING_MM2 = 1e-4


def complaints(items: Sequence[Item], sheets: Sequence[Sheet], spacing: Spacing, layout: Layout) -> list[str]:
    """Return what is wrong with a layout, [] for a sound one."""
    found = []
    for number, sheet in enumerate(sheets):
        lie = [placement for placement in layout.placements if placement.sheet == number]
        parts = [_placed(items[each.item].exact, each.rotation_deg, each.x_mm, each.y_mm) for each in lie]
        room = sheet.outline.buffer(NEAR_MM - spacing.margin_mm)
        for each, part in zip(lie, parts, strict=True):
            item = items[each.item]
            found += ["outside"] * (part.difference(room).area > NOTHING_MM2)
            found += ["stock"] * (item.stock != sheet.stock)
            found += ["rotation"] * (each not in item.locked and not _allowed(item, sheet, each.rotation_deg))
        for one, other in itertools.combinations(parts, 2):
            found += ["overlap"] * (one.intersection(other).area > NOTHING_MM2)
            found += ["gap"] * (spacing.gap_mm > 0 and one.distance(other) < spacing.gap_mm - NEAR_MM)
    counts = Counter(each.item for each in layout.placements)
    for number, item in enumerate(items):
        told = sum(each.count for each in layout.unplaced if each.item == number)
        wanted = item.count + len(item.locked)
        found += ["count"] * (counts[number] + told > wanted or (not item.fill and counts[number] + told < wanted))
        found += ["locked"] * (not set(item.locked) <= set(layout.placements))
    return found


def _placed(polygon: Polygon, rotation_deg: float, x_mm: float, y_mm: float) -> Polygon:
    return affinity.translate(affinity.rotate(polygon, rotation_deg, origin=(0, 0)), x_mm, y_mm)


def _allowed(item: Item, sheet: Sheet, rotation_deg: float) -> bool:
    if item.grain_deg is not None and sheet.grain_deg is not None:
        turned = (item.grain_deg + rotation_deg - sheet.grain_deg) % 180.0
        if min(turned, 180.0 - turned) > 1e-6:
            return False
    return item.rotations_deg is None or any(
        min((rotation_deg - angle) % 360.0, (angle - rotation_deg) % 360.0) < 1e-6 for angle in item.rotations_deg
    )
