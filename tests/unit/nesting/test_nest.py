# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random orders nested by our own layer, judged by an oracle of the tests; holes, exact fits, a stop, filling."""

from __future__ import annotations

import threading
import time
from collections import Counter
from collections.abc import Sequence

import pytest
import shapely

from CNCStepper.errors import JobError
from CNCStepper.nesting.nest import nest
from CNCStepper.nesting.nesting_model import Budget, Item, Placement, Sheet, Spacing, placed
from CNCStepper.nesting.strips import StripPart, StripPlace, first_windows, fullest_window
from helpers.cycles.seeds import SEEDS
from helpers.nesting.layout_oracle import complaints
from helpers.nesting.random_orders import TRAITS, random_order

ORDER_SEEDS = [seed for seed in SEEDS if seed <= 200]
AMPLE_S, ATTEMPTS = 600.0, 2


def test_the_generator_makes_every_hard_case() -> None:
    counts = Counter(trait for seed in ORDER_SEEDS for trait in random_order(seed).traits)
    assert all(counts[trait] >= 0.15 * len(ORDER_SEEDS) for trait in TRAITS), counts


@pytest.mark.parametrize("seed", ORDER_SEEDS)
def test_a_random_order_is_nested_without_a_fault(seed: int) -> None:
    order = random_order(seed)
    budget = Budget(AMPLE_S, ATTEMPTS)  # a busy computer takes longer, and leaves no part out
    layout = nest(order.items, order.sheets, order.spacing, budget, side_by_side if seed % 2 else None, seed)
    assert complaints(order.items, order.sheets, order.spacing, layout) == []
    assert all(unplaced.why for unplaced in layout.unplaced)
    if "full" not in order.traits:
        assert not layout.unplaced


def side_by_side(parts: Sequence[StripPart], height_mm: float, budget: Budget, seed: int) -> list[StripPlace] | None:
    """A packer of strips that lays all parts in a row."""
    places, at_mm = [], 0.0
    for part in parts:
        angle = (part.rotations_deg or (0.0,))[0]
        left, low, right, _ = shapely.affinity.rotate(part.outline, angle, origin=(0, 0)).bounds
        for _ in range(part.count):
            places.append(StripPlace(part.item, at_mm - left + 1e-6, 1e-6 - low, angle))
            at_mm += right - left + 1e-6
    return places


def item(polygon: shapely.Polygon, count: int = 1, **more: object) -> Item:
    return Item("part", polygon, polygon, count, **more)  # type: ignore[arg-type]


def test_small_parts_lie_in_the_holes_of_large_ones() -> None:
    frame = shapely.box(0, 0, 50, 50).difference(shapely.box(5, 5, 45, 45))
    items = (item(frame, 2), item(shapely.box(0, 0, 18, 18), 8))
    layout = nest(items, (Sheet("plate", shapely.box(0, 0, 110, 55)),), Spacing(1.0, 2.0), Budget(0.3), side_by_side)
    assert not layout.unplaced
    frames = [shapely.Polygon(placed(frame, each).exterior) for each in layout.placements if each.item == 0]
    small = [placed(items[1].exact, each) for each in layout.placements if each.item == 1]
    assert all(any(outer.covers(part) for outer in frames) for part in small)


def test_what_fits_exactly_is_placed() -> None:
    sheet = (Sheet("plate", shapely.box(0, 0, 100, 60)),)
    layout = nest((item(shapely.box(0, 0, 20, 30), 10),), sheet, Spacing(), Budget(0.3))
    assert not layout.unplaced
    layout = nest((item(shapely.box(0, 0, 30, 20), 10, rotations_deg=(90.0,)),), sheet, Spacing(), Budget(0.3))
    assert not layout.unplaced


def test_filling_parts_use_no_sheet_of_their_own() -> None:
    sheets = tuple(Sheet(f"plate {n}", shapely.box(0, 0, 100, 50)) for n in range(3))
    items = (item(shapely.box(0, 0, 80, 45)), item(shapely.box(0, 0, 9, 9), 500, fill=True))
    layout = nest(items, sheets, Spacing(1.0), Budget(0.2))
    assert layout.sheets == (0,) and len(layout.placements) > 8 and not layout.unplaced


def test_parts_of_high_priority_get_their_place() -> None:
    sheets = (Sheet("plate", shapely.box(0, 0, 50, 50)),)
    items = (item(shapely.box(0, 0, 45, 45)), item(shapely.box(0, 0, 20, 20), 4, priority=1))
    layout = nest(items, sheets, Spacing(), Budget(0.2))
    assert Counter(each.item for each in layout.placements) == {1: 4}
    assert [(each.item, each.count) for each in layout.unplaced] == [(0, 1)]


def test_a_stop_gives_the_best_so_far_at_once() -> None:
    order = random_order(1)
    budget = Budget(60.0)
    threading.Timer(0.5, budget.stop).start()
    begun_s = time.monotonic()
    layout = nest(order.items, order.sheets, order.spacing, budget)
    assert time.monotonic() - begun_s < 20.0
    assert layout.placements and complaints(order.items, order.sheets, order.spacing, layout) == []


def test_a_packer_that_finds_nothing_leaves_our_own_layer() -> None:
    sheets = (Sheet("plate", shapely.box(0, 0, 60, 50)),)
    layout = nest((item(shapely.box(0, 0, 20, 20), 4),), sheets, Spacing(), Budget(0.2), lambda *_: None)
    assert len(layout.placements) == 4


def test_a_strip_is_cut_where_most_area_lies_between() -> None:
    import numpy as np

    extents = np.array([(0, 10, 1.0), (8, 20, 90.0), (12, 25, 90.0), (24, 40, 5.0)])
    begin_mm, inside = fullest_window(extents, 20.0)
    assert begin_mm == 8.0 and inside.tolist() == [False, True, True, False]
    assert first_windows(extents, 20.0) == 3


@pytest.mark.parametrize(
    ("items", "spacing", "code"),
    [
        ((), Spacing(), "nest-empty"),
        ((item(shapely.box(0, 0, 200, 5)),), Spacing(), "nest-part-large"),
        ((item(shapely.box(0, 0, 95, 5)),), Spacing(0.0, 3.0), "nest-part-large"),
        ((item(shapely.box(0, 0, 5, 5), 20_000),), Spacing(), "nest-count"),
        ((item(shapely.box(0, 0, 5, 5), stock="gold"),), Spacing(), "nest-stock"),
        ((item(shapely.box(0, 0, 5, 5), rotations_deg=(45.0,), grain_deg=0.0),), Spacing(), "nest-grain"),
        ((item(shapely.box(0, 0, 5, 5)),), Spacing(float("nan")), "nest-spacing"),
    ],
)
def test_an_order_that_cannot_be_met_is_refused_by_name(items: tuple[Item, ...], spacing: Spacing, code: str) -> None:
    with pytest.raises(JobError) as refused:
        nest(items, (Sheet("plate", shapely.box(0, 0, 100, 50), grain_deg=0.0),), spacing, Budget(0.2))
    assert refused.value.code == code


@pytest.mark.parametrize(
    "places",
    [
        (Placement(0, 0, 90.0, 5.0, 0.0),),  # beyond the rim
        (Placement(0, 0, 32.0, 20.0, 0.0),),  # over the sheet's hole
        (Placement(0, 0, 5.0, 5.0, 0.0), Placement(0, 0, 10.0, 5.0, 0.0)),  # on each other
    ],
)
def test_a_locked_part_that_cannot_stay_is_refused_before_the_search(places: tuple[Placement, ...]) -> None:
    plate = shapely.box(0, 0, 100, 50).difference(shapely.box(30, 20, 40, 30))
    with pytest.raises(JobError, match="a locked part cannot stay where it is: part"):
        nest((item(shapely.box(0, 0, 20, 5), locked=places),), (Sheet("plate", plate),), Spacing(), Budget(60.0))
