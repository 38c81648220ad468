# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two turned parts differ where shapely and a grid of points say, by the diameters that a person would measure."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from CNCStepper.job.comparison.turned_difference import DifferentRing, different_rings
from CNCStepper.simulation.turning.half_section import HalfSection, bar
from helpers.cycles.seeds import SEEDS

BAR = bar(55, 170, 1)
SHOULDER = (-40, 25, 5, 40)


def cut(*boxes: tuple[float, float, float, float]) -> HalfSection:
    return HalfSection(BAR.region.difference(shapely.union_all([shapely.box(*each) for each in boxes])))


def only_ring(first: HalfSection, second: HalfSection) -> DifferentRing:
    (ring,) = different_rings(first, second, 0.02)
    return ring


@pytest.mark.parametrize(
    ("boxes", "side", "z_mm", "depth_mm", "of_both_mm"),
    [
        pytest.param([(-40, 24.95, 5, 40)], "outer", (-40, 1), 0.05, (50, 49.9), id="a step 0.1 mm smaller"),
        pytest.param([(-40.05, 25, 5, 40)], "outer", (-40.05, -40), 0.05, (55, 50), id="a shoulder moved"),
        pytest.param([(-40.05, 24.95, 5, 40)], "outer", (-40.05, 1), 0.05, (50, 49.9), id="both of these"),
        pytest.param([SHOULDER, (-20, 20, -17, 40)], "outer", (-20, -17), 1.5, (50, 40), id="a groove"),
        pytest.param([SHOULDER, (-30, 0, 5, 8)], "bore", (-30, 1), 8, (0, 16), id="a bore"),
        pytest.param([SHOULDER, (-3, 10, 5, 13)], "within", (-3, 1), 1.5, None, id="a groove in the face"),
        pytest.param([SHOULDER, (-0.1, 0, 5, 40)], "outer", (-0.1, 1), 1.1, (50, 0), id="faced"),
    ],
)
def test_a_difference_has_its_side_its_place_and_both_diameters(boxes, side, z_mm, depth_mm, of_both_mm) -> None:
    first, second = cut(SHOULDER), cut(*boxes)
    ring = only_ring(first, second)
    assert (ring.first, ring.side) == (False, side)
    assert ring.z_mm == pytest.approx(z_mm, abs=1e-6) and ring.depth_mm == pytest.approx(depth_mm, abs=1e-6)
    assert z_mm[0] <= ring.at_z_mm <= z_mm[1]
    assert ring.of_both_mm == (pytest.approx(of_both_mm, abs=1e-6) if of_both_mm else None)
    turned_round = only_ring(second, first)
    assert turned_round.first and turned_round.of_both_mm == (ring.of_both_mm and ring.of_both_mm[::-1])


def test_what_is_within_the_tolerance_is_no_difference() -> None:
    first, second = cut(SHOULDER), cut((-40.015, 24.99, 5, 40))
    assert different_rings(first, second, 0.02) == [] == different_rings(first, first, 1e-6)
    assert only_ring(first, HalfSection(shapely.Polygon())).first is False  # nothing is left of the other one
    assert len(different_rings(first, second, 0.005)) == 1


def test_a_cone_differs_from_where_it_leaves_the_tolerance_and_most_at_its_end() -> None:
    cone = HalfSection(BAR.region.difference(shapely.Polygon([(-40, 25), (1, 24.59), (5, 40), (-40, 40)])))
    ring = only_ring(cut(SHOULDER), cone)
    assert ring.z_mm == pytest.approx((-40 + 0.02 * 100, 1), abs=1e-5)
    assert ring.at_z_mm == 1 and ring.of_both_mm == pytest.approx((50, 49.18))
    assert ring.depth_mm == pytest.approx(0.41 * np.cos(np.arctan(0.01)), abs=1e-6)  # across the cone


def test_a_profile_of_many_chords_is_compared_in_seconds() -> None:
    """Without fewer chords the work grows with their square: that of these takes half a minute."""
    z = np.linspace(-160, 0.5, 5000)

    def waves(radius_mm: float) -> HalfSection:
        course = np.column_stack([z, radius_mm + 3 * np.sin(z / 7)])
        return HalfSection(shapely.Polygon([(-160, 0), *course, (0.5, 0)]))

    ring = only_ring(waves(20.0), waves(20.05))
    assert ring.depth_mm == pytest.approx(0.05, abs=2e-4) and ring.z_mm == pytest.approx((-160, 0.5), abs=0.1)


@pytest.mark.parametrize("seed", SEEDS[:5])
def test_random_parts_differ_where_points_on_a_grid_say(seed: int) -> None:
    random = np.random.default_rng(seed)

    def part() -> HalfSection:
        ends = [*np.sort(random.uniform(-60, 0, 5)).tolist(), 1.0]
        radii = np.round(random.uniform(8, 24, 5), 2).tolist()
        steps = [(low, radius, high, 40.0) for low, high, radius in zip(ends[:-1], ends[1:], radii, strict=True)]
        return cut(*steps, (random.uniform(-50, -5), 0, 5, random.uniform(1, 7)))

    first, second = part(), part()
    rings = different_rings(first, second, 0.05)
    places = np.stack(np.meshgrid(np.arange(-65, 1.5, 0.13), np.arange(0.05, 28, 0.13)), axis=-1).reshape(-1, 2)
    points = shapely.points(places)
    inside = [shapely.contains_xy(each.region, *places.T) for each in (first, second)]
    deepest = 0.0
    for own, other, part_of_own in ((inside[0], inside[1], first.region), (inside[1], inside[0], second.region)):
        gone = other & ~own
        deepest = max(deepest, float(shapely.distance(points[gone], part_of_own).max(initial=0.0)))
        z = places[gone & (shapely.distance(points, part_of_own) > 0.3), 0]
        mine = [ring.z_mm for ring in rings if ring.first == (part_of_own is first.region)]
        covered = [any(low - 0.1 <= each <= high + 0.1 for low, high in mine) for each in np.unique(z)]
        assert all(covered), f"seed {seed}"
    assert rings[0].depth_mm == pytest.approx(deepest, rel=0.05, abs=0.2), f"seed {seed}"
