# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions and their offsets: random ones against shapely, and plain ones against plain geometry."""

from __future__ import annotations

import itertools
import math
from collections import Counter

import numpy as np
import pytest
import shapely

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.geometry.region import Region
from helpers.geometry.random_regions import Case, random_case, shapely_of, wanted_offset, wanted_region

TOLERANCE_MM = 0.004
JUDGE_MM = 0.001  # by so much the judge's chords may be off on each side
QUICK, SLOW = 20, 300
SHARES = {  # of all cases, at least
    "island": 0.5,
    "collapses": 0.1,
    "splits": 0.08,
    "island merges with the wall": 0.1,
    "grows": 0.2,
    "crosses itself": 0.1,
    "circle": 0.1,
    "slot": 0.1,
    "tiny": 0.1,
    "touches": 0.08,
}


def box(x: float, y: float, wide: float, high: float) -> Curve:
    return from_points([(x, y), (x + wide, y), (x + wide, y + high), (x, y + high)], closed=True)


def judged(case: Case) -> set[str]:
    """Compare a case with the judge and return what happens in it."""
    wanted = wanted_region(case)
    region = Region.of(case.outlines, case.islands)
    assert off_mm2(region, wanted) <= JUDGE_MM * (wanted.length + 1), f"seed {case.seed}: another region"
    expected = wanted_offset(wanted, case.distance_mm)
    found = region.offset(case.distance_mm, TOLERANCE_MM)
    limit_mm2 = (TOLERANCE_MM + JUDGE_MM) * (wanted.length + expected.length + 1)
    assert off_mm2(found, expected) <= limit_mm2, f"seed {case.seed}: another offset"
    for loop in found.loops:
        away = region.distances_mm(loop.points(TOLERANCE_MM))
        assert np.abs(away - abs(case.distance_mm)).max() <= TOLERANCE_MM, f"seed {case.seed}: not at its distance"
        assert loop.closed
    return happens(case, wanted, expected)


def off_mm2(region: Region, wanted: shapely.Geometry) -> float:
    return float(shapely_of(region).symmetric_difference(wanted).area)


def happens(case: Case, wanted: shapely.Geometry, expected: shapely.Geometry) -> set[str]:
    """Return the names of SHARES that fit the case, as the judge sees it."""
    before, after = shapely.get_parts(wanted), shapely.get_parts(expected)
    shrinks = case.distance_mm < 0
    inner = [hole for part in before for hole in part.interiors]
    names = {
        "island": bool(case.islands),
        "collapses": shrinks and (expected.is_empty or sum(not part.intersects(expected) for part in before) > 0),
        "splits": shrinks and len(after) > len(before),
        "island merges with the wall": bool(inner) and shrinks and sum(len(p.interiors) for p in after) < len(inner),
        "grows": not shrinks,
        "crosses itself": "tangle" in case.kinds,
        "touches": any(
            one.boundary.intersection(other.boundary).length > 0.1
            for one, other in itertools.combinations(map(outline, [*case.outlines, *case.islands]), 2)
        ),
    }
    return {name for name, is_so in names.items() if is_so} | (case.kinds & SHARES.keys())


def outline(curve: Curve) -> shapely.Geometry:
    return shapely.make_valid(shapely.Polygon(curve.points(0.01)))


@pytest.mark.parametrize("seed", range(QUICK))
def test_some_regions_and_their_offsets_are_the_judges(seed: int) -> None:
    judged(random_case(seed))


@pytest.mark.slow
def test_many_regions_and_their_offsets_are_the_judges() -> None:
    seen: Counter[str] = Counter()
    for seed in range(SLOW):
        seen.update(judged(random_case(seed)))
    print({name: f"{seen[name] / SLOW:.0%}" for name in SHARES})
    rare = {name: seen[name] for name, share in SHARES.items() if seen[name] < share * SLOW}
    assert not rare, f"too few cases of {rare}"


def test_a_judge_who_sees_another_distance_complains() -> None:
    case = random_case(0)
    wrong = wanted_offset(wanted_region(case), case.distance_mm + 0.1)
    found = Region.of(case.outlines, case.islands).offset(case.distance_mm, TOLERANCE_MM)
    assert off_mm2(found, wrong) > (TOLERANCE_MM + JUDGE_MM) * (wrong.length + 1)


def test_a_box_grows_round_and_shrinks_sharp() -> None:
    square = Region.of([box(0, 0, 10, 10)])
    (grown,) = square.offset(1.0, 0.01).loops
    assert len(grown) == 8 and grown.area_mm2 == pytest.approx(100 + 40 + math.pi, abs=1e-9)
    assert sorted(np.unique(grown.bulge).tolist()) == pytest.approx([0, math.tan(math.pi / 8)])
    (shrunk,) = square.offset(-1.0, 0.01).loops
    assert len(shrunk) == 4 and not shrunk.bulge.any() and shrunk.area_mm2 == pytest.approx(64, abs=1e-9)
    assert square.offset(-5.1, 0.01).empty and square.offset(0.0, 0.01) is square


def test_a_circle_stays_a_circle() -> None:
    (ring,) = Region.of([circle((3, 4), 10)]).offset(-4, 0.01).loops
    assert (
        len(ring) == 2
        and ring.radii_mm == pytest.approx([6, 6])
        and ring.centres == pytest.approx(np.array([(3, 4)] * 2))
    )
    assert Region.of([circle((3, 4), 10)]).offset(-10.1, 0.01).empty


def test_an_island_takes_its_place_and_merges_with_the_wall() -> None:
    region = Region.of([box(0, 0, 10, 10)], [circle((5, 5), 2)])
    assert region.area_mm2 == pytest.approx(100 - 4 * math.pi)
    near = region.offset(-1.4, 0.01)
    assert near.area_mm2 == pytest.approx(7.2**2 - 3.4**2 * math.pi) and len(near.parts()) == 1
    far = region.offset(-1.6, 0.01)
    assert len(far.parts()) == 4 and all(len(part.loops) == 1 for part in far.parts())


def test_a_dumbbell_splits_where_its_neck_is_too_narrow() -> None:
    neck = [(10, 0), (10, 4), (20, 4), (20, 0), (30, 0), (30, 10), (20, 10), (20, 6), (10, 6), (10, 10), (0, 10)]
    region = Region.of([from_points([(0, 0), *neck], closed=True)])
    assert [len(region.offset(-d, 0.01).parts()) for d in (0.99, 1.01, 5.1)] == [1, 2, 0]


def test_a_slot_just_as_wide_as_the_tool_is_kept_or_dropped_but_never_torn() -> None:
    for wide in (1, 2, 3, 6.3):
        region = Region.of([box(0, 0, 40, wide)])
        assert region.offset(-wide / 2, 0.01).area_mm2 <= 40 * 0.01
        (strip,) = region.offset(-(wide / 2 - 0.001), 0.01).loops
        assert strip.length_mm == pytest.approx(2 * (40 - wide), abs=0.02)


def test_islands_that_touch_nest_and_double_make_one_hole() -> None:
    islands = [box(2, 2, 2, 2), box(4, 2, 2, 2), box(2, 2, 2, 2), box(2.5, 2.5, 1, 1), box(3, 3, 2, 2).reversed()]
    region = Region.of([box(0, 0, 10, 10)], islands)
    assert len(region.loops) == 2 and region.area_mm2 == pytest.approx(100 - 10)
    along_the_wall = Region.of([box(0, 0, 10, 10)], [box(0, 2, 3, 3)])
    assert len(along_the_wall.loops) == 1 and along_the_wall.area_mm2 == pytest.approx(91)
    assert Region.of([box(0, 0, 10, 10)], [box(-1, -1, 20, 20)]).empty
    assert Region.of([box(0, 0, 10, 10)], [box(0, 0, 10, 10)]).empty


def test_islands_that_share_a_whole_edge_are_one_hole() -> None:
    wall = from_points([(0, 0), (14, 0), (14, 10), (0, 10)], True)
    left = from_points([(3, 3), (7, 3), (7, 7), (3, 7)], True)
    assert Region.of([wall], [left, left.moved(4, 0)]).area_mm2 == pytest.approx(140 - 32)
    assert Region.of([left, left.moved(4, 0)]).area_mm2 == pytest.approx(32)


def test_a_bow_tie_drawn_through_its_crossing_is_two_triangles() -> None:
    tie = from_points([(0, 0), (2, 2), (4, 4), (4, 0), (2, 2), (0, 4)], True)
    found = Region.of([tie])
    assert found.area_mm2 == pytest.approx(8) and len(found.loops) == 2


def test_parts_keep_their_own_holes() -> None:
    region = Region.of(
        [box(0, 0, 10, 10), box(20, 0, 10, 10)], [circle((5, 5), 1), circle((25, 5), 2), circle((28, 8), 0.5)]
    )
    assert sorted((len(part.loops), round(part.area_mm2, 2)) for part in region.parts()) == [(2, 96.86), (3, 86.65)]


def test_a_region_knows_its_points() -> None:
    region = Region.of([box(0, 0, 10, 10).reversed()], [circle((5, 5), 2)])
    points = np.array([(1, 1), (5, 5), (11, 5), (5, 2.5)])
    assert region.contains(points).tolist() == [True, False, False, True]
    assert region.distances_mm(points) == pytest.approx([1, 2, 1, 0.5])
    assert region.length_mm == pytest.approx(40 + 4 * math.pi)


def test_outlines_of_no_area_are_no_region() -> None:
    stroke = Curve(np.array([(0.0, 0), (10, 0), (0, 0)]), np.zeros(2))
    point = Curve(np.array([(1.0, 1), (1, 1)]), np.zeros(1))
    assert Region.of([stroke]).empty and Region.of([point]).empty and Region.of([]).empty
    assert Region.of([stroke]).offset(3, 0.01).empty and Region.of([]).parts() == []
    assert np.isinf(Region.of([]).distances_mm(np.zeros((2, 2)))).all()


def test_open_outlines_and_mad_distances_are_refused() -> None:
    with pytest.raises(GeometryError, match=r"open.*gap 1 mm"):
        Region.of([from_points([(0, 0), (1, 0)])])
    square = Region.of([box(0, 0, 1, 1)])
    for distance_mm, tolerance_mm in ((1, 0), (1, -1), (1, math.nan), (math.nan, 0.01), (math.inf, 0.01)):
        with pytest.raises(GeometryError):
            square.offset(distance_mm, tolerance_mm)
