# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts placed by a person: moved, turned, locked, filled; never an overlap, never outside."""

from __future__ import annotations

import random
from contextlib import suppress
from dataclasses import replace

import pytest
import shapely
from shapely import Polygon

from CNCStepper.errors import JobError
from CNCStepper.nesting.judge import faults
from CNCStepper.nesting.manual_nesting import ManualNest, PlacedPart, filled, in_rows, sheet_at
from CNCStepper.nesting.nesting_model import Budget, Item, Layout, Placement, Sheet, Spacing
from helpers.cycles.seeds import SEEDS

PLATE = shapely.box(0, 0, 100, 60)
ELL = Polygon([(0, 0), (30, 0), (30, 10), (10, 10), (10, 25), (0, 25)])
RING = shapely.box(0, 0, 40, 40).difference(shapely.box(10, 10, 30, 30))


def item(name: str, polygon: Polygon, **more: object) -> Item:
    return Item(name, polygon, polygon, **more)  # type: ignore[arg-type]


def nest_of(*parts: PlacedPart, gap_mm: float = 2.0) -> ManualNest:
    items = [item("ell", ELL, count=3, rotations_deg=(0.0, 90.0)), item("ring", RING, rotations_deg=None)]
    return ManualNest(items, [Sheet("a", PLATE), Sheet("b", PLATE)], Spacing(gap_mm, 3.0), parts)


def test_a_part_is_moved_where_it_may_lie_and_stays_where_it_may_not() -> None:
    nest = nest_of(PlacedPart(Placement(0, 0, 3.0, 3.0, 0.0)), PlacedPart(Placement(0, 1, 50.0, 10.0, 0.0)))
    before = list(nest.parts)
    for place, why in (
        (nest.moved_by(0, 20.0, 0.0), "'ell' and 'ring' are too close"),
        (nest.moved_by(0, -0.5, 0.0), "beyond the sheet 'a'"),
    ):
        assert why in nest.problem(place, 0)
        with pytest.raises(JobError, match=r"too close|beyond"):
            nest.move(0, place)
        assert nest.parts == before
    nest.move(0, nest.moved_by(0, 15.0, 0.0))
    assert nest.parts[0].placement.x_mm == 18.0 and nest.polygon(0).bounds == (18, 3, 48, 28)
    assert nest.problem(nest.moved_by(0, 0.001, 0.0), 0)  # just the gap
    nest.move(0, nest.moved_by(0, 0.0, 0.0, sheet=1))
    assert nest.parts[0].placement.sheet == 1 and nest.part_at(0, 20.0, 5.0) is None and nest.part_at(1, 20, 5) == 0


def test_a_part_is_dragged_up_to_its_neighbour_and_into_a_hole() -> None:
    nest = nest_of(PlacedPart(Placement(0, 0, 3.0, 3.0, 0.0)), PlacedPart(Placement(0, 1, 50.0, 10.0, 0.0)))
    reached = nest.reached(0, nest.moved_by(0, 40.0, 0.0))
    assert reached.x_mm == pytest.approx(18.0, abs=0.001) and not nest.problem(reached, 0)
    small = ManualNest([*nest.items, item("dot", shapely.box(0, 0, 5, 5))], nest.sheets, nest.spacing, nest.parts)
    number = small.add(Placement(0, 2, 65.0, 25.0, 0.0))
    assert small.part_at(0, 67.0, 27.0) == number and small.part_at(0, 52.0, 12.0) == 1


def test_parts_turn_about_their_middle_to_allowed_rotations_only() -> None:
    nest = nest_of(PlacedPart(Placement(0, 0, 10.0, 10.0, 0.0)), PlacedPart(Placement(1, 1, 20.0, 10.0, 0.0)))
    middle = nest.polygon(0).envelope.centroid
    nest.move(0, nest.turned_by(0, 70.0))
    assert nest.parts[0].placement.rotation_deg == 90.0
    assert nest.polygon(0).envelope.centroid.distance(middle) < 0.001
    assert nest.next_rotation_deg(0) == 270.0 and nest.next_rotation_deg(0, -1) == -90.0
    assert nest.turned_by(1, 33.4).rotation_deg == 33.0 and nest.next_rotation_deg(1) == 90.0
    fixed = ManualNest([item("ell", ELL)], nest.sheets, nest.spacing, [PlacedPart(Placement(0, 0, 10, 10, 0.0))])
    assert fixed.next_rotation_deg(0) == 0.0


def test_the_grain_limits_turning() -> None:
    grained = replace(item("ell", ELL, rotations_deg=None), grain_deg=0.0)
    sheet = Sheet("a", PLATE, grain_deg=90.0)
    nest = ManualNest([grained], [sheet], Spacing(), [PlacedPart(Placement(0, 0, 60.0, 10.0, 90.0))])
    assert nest.turned_by(0, 80.0).rotation_deg == 90.0 and nest.turned_by(0, 100.0).rotation_deg == 270.0


def test_a_locked_part_stays_and_counts_follow() -> None:
    nest = nest_of(PlacedPart(Placement(0, 0, 3.0, 3.0, 0.0)))
    nest.lock(0, True)
    with pytest.raises(JobError, match="locked"):
        nest.move(0, nest.moved_by(0, 1.0, 0.0))
    nest.add(Placement(1, 0, 10.0, 10.0, 0.0))
    assert nest.counts() == [(2, 3), (0, 1)] and nest.parts[0].locked
    nest.remove(0)
    assert nest.counts() == [(1, 3), (0, 1)] and nest.polygon(0).bounds[:2] == (10, 10)


def test_free_places_are_filled_and_all_is_sound() -> None:
    nest = nest_of(PlacedPart(Placement(0, 1, 30.0, 10.0, 0.0)))
    more = filled(nest, 0, 0, Budget(60.0))
    for place in more:
        nest.add(place)
    assert len(more) >= 2
    counted = [replace(nest.items[0], count=len(more)), nest.items[1]]
    assert not list(faults(counted, nest.sheets, nest.spacing, Layout(tuple(nest.placements))))
    assert filled(nest, 0, 0, Budget(60.0)) == []


def test_what_does_not_fit_any_more_is_named() -> None:
    nest = nest_of(PlacedPart(Placement(0, 0, 3.0, 3.0, 0.0)), PlacedPart(Placement(0, 1, 35.0, 3.0, 0.0)))
    assert nest.overlapping() == []
    nest.spacing = Spacing(4.0, 3.0)
    assert nest.overlapping() == [0, 1]


def test_sheets_lie_side_by_side() -> None:
    sheets = [Sheet("a", PLATE), Sheet("b", shapely.box(-10, 5, 10, 25))]
    corners = in_rows(sheets, 20.0)
    assert corners == [(0.0, 0.0), (130.0, -5.0)]
    assert sheet_at(sheets, corners, 125.0, 10.0) == (1, -5.0, 15.0)
    assert sheet_at(sheets, corners, 110.0, 10.0) is None


@pytest.mark.parametrize("seed", SEEDS)
def test_random_drags_never_leave_a_fault(seed: int) -> None:
    chance = random.Random(seed)
    nest = nest_of(*(PlacedPart(Placement(0, 0, 3.0 + 32.0 * number, 3.0, 0.0)) for number in range(3)))
    for _ in range(20):
        number = chance.randrange(3)
        wanted = nest.moved_by(number, chance.uniform(-60, 60), chance.uniform(-40, 40), chance.choice([0, 0, 1]))
        if chance.random() < 0.3:
            wanted = nest.turned_to(wanted, chance.choice([0.0, 90.0]))
        with suppress(JobError):
            nest.move(number, nest.reached(number, wanted))
        placements = tuple(nest.placements)
        items = [nest.items[0], replace(nest.items[1], count=0)]
        assert not list(faults(items, nest.sheets, nest.spacing, Layout(placements)))
