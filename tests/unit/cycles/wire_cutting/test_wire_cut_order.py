# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which stretch of a ring is cut last, so that the part hangs until then."""

from __future__ import annotations

import pytest
from shapely import box

from CNCStepper.cycles.wire_cutting.wire_cut_order import Uncut
from CNCStepper.cycles.wire_cutting.wire_items import Part, items_of
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import Curve, from_points
from CNCStepper.geometry.shapes.rectangle import rectangle

KERF_MM = 1.2
SHEET = box(0, 0, 100, 60)


def part_and_sides() -> tuple[Part, list[Curve]]:
    """Return a part and its ring in stretches: its left side with the top, and its right side with the bottom."""
    (part,) = items_of([rectangle((40, 20), (60, 40))], KERF_MM, False, SHEET).parts
    off = KERF_MM / 2.0
    low, high = (40 - off, 20 - off), (60 + off, 40 + off)
    corners = [low, (low[0], high[1]), high, (high[0], low[1]), low]
    return part, [from_points(corners[:3]), from_points(corners[2:])]


def beside(far_mm: float) -> Curve:
    """Return a way round the right side and the bottom of the part, its middle so far from the part."""
    return from_points([(60 + far_mm, 45), (60 + far_mm, 20 - far_mm), (35, 20 - far_mm)])


def uncut(*ways: Curve) -> Uncut:
    found = Uncut(SHEET, KERF_MM / 2.0)
    for way in ways:
        found.take(way)
    return found


def test_the_last_stretch_stays_the_last_where_it_holds() -> None:
    assert uncut().last_stretch(*part_and_sides()) == 1


@pytest.mark.parametrize("far_mm", [1.0, 1.6, 1.9], ids=["overlap", "margin 1", "a strip of 0.1 mm"])
def test_a_way_along_a_stretch_makes_the_other_one_the_last(far_mm: float) -> None:
    assert uncut(beside(far_mm)).last_stretch(*part_and_sides()) == 0


def test_a_way_that_is_far_enough_changes_nothing() -> None:
    assert uncut(beside(4.0)).last_stretch(*part_and_sides()) == 1


def test_a_thin_strip_is_better_than_a_refusal() -> None:
    corner_left = from_points([(39, 18.1), (39, 41), (60, 41)])
    assert uncut(beside(1.9), corner_left).last_stretch(*part_and_sides()) == 1


def test_a_part_that_is_loose_already_is_refused() -> None:
    around = rectangle((35, 15), (65, 45))
    with pytest.raises(CycleError) as caught:
        uncut(around).last_stretch(*part_and_sides())
    assert caught.value.code == "wire-loose"
