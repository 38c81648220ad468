# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parallels of single curves, and the kernels of the offset compiled and as plain Python."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
import shapely

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.geometry.offset import parallels
from helpers.geometry.random_regions import CHORD_MM


def random_chain(rng: np.random.Generator) -> Curve:
    """Return an open chain of lines and arcs that crosses itself as often as not."""
    count = rng.integers(2, 12)
    xy = np.cumsum(rng.normal(0, 10, (count, 2)), axis=0)
    return Curve(xy, rng.uniform(-1, 1, count - 1) * rng.integers(0, 2, count - 1))


def wanted_places(curve: Curve, distance_mm: float) -> np.ndarray:
    """Return places at the distance from all of the curve, on its left (right below 0), by shapely; ends left out."""
    chords = curve.points(CHORD_MM)
    lines = shapely.linestrings(np.stack([chords[:-1], chords[1:]], axis=1))
    quarter = math.ceil(math.pi / 4 / math.sqrt(2 * CHORD_MM / abs(distance_mm))) + 2
    edge = shapely.union_all(shapely.buffer(lines, abs(distance_mm), quad_segs=quarter)).boundary
    places = shapely.get_coordinates(shapely.segmentize(edge, 0.1))
    nearest, ahead = curve.at_length(curve.nearest(places)[1])
    left = np.sign(ahead[:, 0] * (places - nearest)[:, 1] - ahead[:, 1] * (places - nearest)[:, 0])
    corner = (np.abs(curve.nearest(places)[1][:, None] - curve.before_mm) < 0.02).any(axis=1)
    return places[(left == np.sign(distance_mm)) & ~corner]


@pytest.mark.parametrize("seed", range(25))
def test_parallels_are_all_there_and_at_their_distance(seed: int) -> None:
    rng = np.random.default_rng(seed)
    curve, distance_mm = random_chain(rng), float(rng.uniform(0.3, 6) * rng.choice([-1, 1]))
    found = parallels(curve, distance_mm, 0.01)
    for piece in found:
        away = curve.distances_mm(piece.points(0.001))
        assert np.abs(away - abs(distance_mm)).max() < 0.0011, f"seed {seed}"
    wanted = wanted_places(curve, distance_mm)
    if len(wanted):
        missed = np.min([piece.distances_mm(wanted) for piece in found], axis=0)
        assert missed.max() < 0.02, f"seed {seed}: nothing there for {wanted[missed.argmax()]}"


def test_a_line_has_a_parallel_on_each_side_that_runs_its_way() -> None:
    line = from_points([(0, 0), (10, 0)])
    assert parallels(line, 2, 0.01)[0].xy.tolist() == [[0, 2], [10, 2]]
    assert parallels(line, -2, 0.01)[0].xy.tolist() == [[0, -2], [10, -2]]
    assert parallels(line, 0, 0.01) == [line]


def test_corners_are_round_outside_and_sharp_inside() -> None:
    angle = from_points([(0, 0), (10, 0), (10, 10)])
    (inside,) = parallels(angle, 2, 0.01)
    assert inside.xy.tolist() == [[0, 2], [8, 2], [8, 10]]
    (outside,) = parallels(angle, -2, 0.01)
    assert outside.xy == pytest.approx(np.array([(0, -2), (10, -2), (12, 0), (12, 10)]))
    assert outside.bulge == pytest.approx([0, math.tan(math.pi / 8), 0])


def test_a_closed_curve_keeps_its_direction() -> None:
    ring = circle((0, 0), 5)
    assert parallels(ring, 2, 0.01)[0].area_mm2 == pytest.approx(9 * math.pi)
    assert parallels(ring.reversed(), 2, 0.01)[0].area_mm2 == pytest.approx(-49 * math.pi)
    assert parallels(ring, 6, 0.01) == []


def test_the_inside_of_a_bend_that_is_too_sharp_is_cut_off() -> None:
    hairpin = Curve(np.array([(0.0, 0), (20, 0), (20, 2), (0, 2)]), np.array([0, 1.0, 0]))
    assert parallels(hairpin, 1.5, 0.01) == []
    (around,) = parallels(hairpin, -1.5, 0.01)
    assert around.length_mm == pytest.approx(40 + 2.5 * math.pi)


def test_mad_distances_are_refused() -> None:
    for distance_mm, tolerance_mm in ((1, 0), (math.nan, 0.01), (math.inf, 0.01)):
        with pytest.raises(GeometryError):
            parallels(circle((0, 0), 5), distance_mm, tolerance_mm)


PRINT_LOOPS = """
from CNCStepper.geometry.curve import circle, from_points
from CNCStepper.geometry.cut_order.cut_order import Stop, ordered
from CNCStepper.geometry.region import Region
walls = [(0, 0), (30, 0), (30, 9), (18, 9), (18, 6), (12, 6), (12, 9), (0, 9)]
islands = [circle((6, 5), 1.5), circle((29, 5), 2)]
region = Region.of([from_points(walls, closed=True)], islands)
for distance_mm in (-1.2, 4):
    found = region.offset(distance_mm, 0.01).loops
    print([(loop.xy.round(9).tolist(), loop.bulge.round(9).tolist()) for loop in found])
print(ordered([*map(Stop.of_curve, islands), *(Stop.at_point(x, 7 * x % 5) for x in range(9))], locks=[(5, 3)]))
"""


@pytest.mark.slow
def test_the_kernels_give_the_same_three_ways(printed_three_ways: Callable[[str], list[str]]) -> None:
    texts = printed_three_ways(PRINT_LOOPS)
    assert texts[0] == texts[1] == texts[2] and len(texts[0]) > 500
