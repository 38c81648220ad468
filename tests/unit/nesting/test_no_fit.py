# SPDX-License-Identifier: LGPL-2.1-or-later
"""No-fit polygons against what shapely says of the parts themselves at random places."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
import shapely
from shapely import Point, Polygon

from CNCStepper.nesting.nesting_model import moved, turned
from CNCStepper.nesting.no_fit import convex_pieces, inner_fit, no_fit
from helpers.nesting.random_orders import random_order

L_SHAPE = Polygon([(0, 0), (40, 0), (40, 10), (10, 10), (10, 30), (0, 30)])
U_SHAPE = Polygon([(0, 0), (30, 0), (30, 30), (20, 30), (20, 8), (10, 8), (10, 30), (0, 30)])


def outlines(seed: int) -> list[Polygon]:
    return [item.outline for item in random_order(seed).items if not item.outline.interiors] + [L_SHAPE, U_SHAPE]


@pytest.mark.parametrize("seed", range(5))
def test_pieces_are_convex_and_make_up_the_outline(seed: int) -> None:
    for outline in outlines(seed):
        pieces = [Polygon(piece) for piece in convex_pieces(outline)]
        assert sum(piece.area for piece in pieces) == pytest.approx(outline.area)
        assert all(piece.convex_hull.area == pytest.approx(piece.area) for piece in pieces)
        assert shapely.union_all(pieces).symmetric_difference(outline).area < 1e-6


@pytest.mark.parametrize("seed", range(5))
def test_parts_overlap_exactly_where_the_no_fit_polygon_says(seed: int) -> None:
    dice, overlaps = random.Random(seed), 0
    shapes = outlines(seed)
    for _ in range(60):
        still, part = dice.choice(shapes), dice.choice(shapes)
        region = no_fit(still, part)
        left, low, right, high = region.bounds
        place = Point(dice.uniform(left, right), dice.uniform(low, high))
        overlap = still.intersection(moved(part, place.x, place.y)).area > 1e-9
        assert region.contains(place) == overlap
        overlaps += overlap
    assert 15 < overlaps < 59, "both cases occur"


def test_a_part_fits_into_a_room_of_any_outline_exactly_where_the_inner_fit_says() -> None:
    dice, within = random.Random(3), 0
    part = Polygon([(0, 0), (7, 1), (5, 6), (1, 4)])
    for room in (L_SHAPE, U_SHAPE, Polygon([(0, 0), (40, 0), (40, 30), (0, 30)])):
        region = inner_fit(room, part)
        for _ in range(80):
            place = Point(dice.uniform(-8, 40), dice.uniform(-8, 30))
            lies = room.covers(moved(part, place.x, place.y))
            assert region.covers(place) == lies
            within += lies
    assert within > 25


def test_a_room_that_is_too_small_takes_nothing() -> None:
    assert inner_fit(shapely.box(0, 0, 5, 5), shapely.box(0, 0, 6, 1)).is_empty
    assert inner_fit(L_SHAPE, shapely.box(0, 0, 20, 20)).is_empty


def test_pieces_of_an_outline_with_corners_on_straight_lines() -> None:
    outline = Polygon([(0, 0), (5, 0), (10, 0), (10, 10), (5, 10), (5, 5), (0, 5)])
    assert sum(Polygon(piece).area for piece in convex_pieces(outline)) == pytest.approx(outline.area)
    assert np.isfinite(np.concatenate(convex_pieces(outline))).all()


@pytest.mark.parametrize("rotation_deg", [0.0, 30.0, 88.5, 90.0])
def test_a_disc_of_chords_fits_into_a_round_hole_nowhere_but_round_its_middle(rotation_deg: float) -> None:
    hole, disc = Point(32.5, 22.5).buffer(13.5, 24), turned(Point(6.0, 6.0).buffer(7.5, 15), rotation_deg)
    region = inner_fit(hole, disc)
    assert region.area == pytest.approx(math.pi * 36.0, rel=0.02)
    assert all(moved(disc, *corner).difference(hole).area < 1e-3 for corner in shapely.get_coordinates(region))
