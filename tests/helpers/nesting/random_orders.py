# SPDX-License-Identifier: LGPL-2.1-or-later
"""Orders of random parts and sheets; `traits` says which hard cases an order has."""

from __future__ import annotations

import math
import random
from dataclasses import dataclass, replace

import shapely
from shapely import Polygon

from CNCStepper.nesting.nesting_model import Item, Placement, Sheet, Spacing

TRAITS = ("holes", "free", "grain", "gap", "margin", "odd sheet", "locked", "fill", "two stocks", "priority", "full")


@dataclass(frozen=True)
class RandomOrder:
    """An order and its traits, some of TRAITS."""

    items: tuple[Item, ...]
    sheets: tuple[Sheet, ...]
    spacing: Spacing
    traits: frozenset[str]


def random_order(seed: int) -> RandomOrder:
    """Return an order of 3 to 6 items; each trait is in about a third of all orders."""
    dice = random.Random(seed)
    traits = {trait for trait in TRAITS if dice.random() < 0.35}
    spacing = Spacing(dice.uniform(0.2, 3.0) * ("gap" in traits), dice.uniform(0.5, 6.0) * ("margin" in traits))
    stocks = ("steel 3 mm", "plywood 6 mm") if "two stocks" in traits else ("",)
    items = [_item(dice, number, traits, stocks[number % len(stocks)]) for number in range(dice.randint(3, 6))]
    count = 1 if "full" in traits else 4
    sheets = [
        Sheet(f"sheet {n}", _sheet(dice, traits), dice.choice([0.0, 90.0]) if "grain" in traits else None, stock)
        for n in range(count)
        for stock in stocks
    ]
    if "locked" in traits:
        place = _locked(items[0], sheets, spacing)
        if _lies_within(items[0], place, sheets[place.sheet], spacing):
            items[0] = replace(items[0], locked=(place,))
        else:
            traits.remove("locked")
    return RandomOrder(tuple(items), tuple(sheets), spacing, frozenset(traits))


def _item(dice: random.Random, number: int, traits: set[str], stock: str) -> Item:
    outline = _outline(dice, "holes" in traits and number == 0)
    has_grain = "grain" in traits and number != 1
    choices: list[tuple[float, ...]] = [(0.0, 90.0), (0.0, 90.0, 180.0, 270.0), (0.0,), (45.0,)]
    rotations_deg = dice.choice(choices[: 2 if has_grain else 4])
    return Item(
        f"part {number}",
        outline,
        outline,
        dice.randint(8, 16) if "full" in traits else dice.randint(1, 4),
        None if "free" in traits and number == 1 else rotations_deg,
        grain_deg=0.0 if has_grain else None,
        priority=number % 2 if "priority" in traits else 0,
        fill="fill" in traits and number == 2,
        stock=stock,
    )


def _outline(dice: random.Random, has_hole: bool) -> Polygon:
    if has_hole:
        return shapely.box(0, 0, 60, 50).difference(shapely.box(12, 12, 48, 40))
    corners = dice.randint(3, 9)
    radii = [dice.uniform(6.0, 22.0) for _ in range(corners)]
    angles = [2.0 * math.pi * (n + dice.uniform(0.1, 0.9)) / corners for n in range(corners)]
    polygon = Polygon([(r * math.cos(a), r * math.sin(a)) for r, a in zip(radii, angles, strict=True)])
    return polygon if polygon.is_valid and polygon.area > 60.0 else shapely.box(-7, -4, 7, 4)


def _sheet(dice: random.Random, traits: set[str]) -> Polygon:
    whole = shapely.box(0, 0, 150, 110)
    if "odd sheet" not in traits:
        return whole
    return whole.difference(shapely.box(105, 70, 150, 110)).difference(shapely.box(70, 30, 80, 40))


def _locked(item: Item, sheets: list[Sheet], spacing: Spacing) -> Placement:
    """Return a place of an item by hand, in the lower left corner of the first sheet of its stock, turned by 10."""
    number = next(n for n, sheet in enumerate(sheets) if sheet.stock == item.stock)
    left, low, _, _ = shapely.affinity.rotate(item.outline, 10.0, origin=(0, 0)).bounds
    rim = spacing.margin_mm + 0.5
    return Placement(number, 0, rim - left, rim - low, 10.0)


def _lies_within(item: Item, place: Placement, sheet: Sheet, spacing: Spacing) -> bool:
    """Return whether a part lies on a sheet, off its holes and no closer to its rim than the margin."""
    turned = shapely.affinity.rotate(item.outline, place.rotation_deg, origin=(0, 0))
    part = shapely.affinity.translate(turned, place.x_mm, place.y_mm)
    return bool(sheet.outline.covers(part) and part.distance(sheet.outline.boundary) >= spacing.margin_mm)
