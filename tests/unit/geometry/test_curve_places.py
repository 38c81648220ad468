# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places on curves: nearest, winding, boxes, pieces and transforms of random hard curves, against shapely and sums."""

from __future__ import annotations

import itertools
import math
from collections import Counter

import numpy as np
import pytest
import shapely

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve, circle, from_points

CASES = 60
FINE_MM = 1e-4
HARD = ("tiny arc", "nearly full arc", "full circle", "collinear", "cusp", "no length", "closed", "nearly closed")


def random_curve(seed: int) -> tuple[Curve, set[str]]:
    """Return a curve of hard cases, and which of them it has."""
    rng = np.random.default_rng(seed)
    xy, bulge, kinds = [rng.uniform(-40, 40, 2)], [], set()
    for _ in range(int(rng.integers(1, 9))):
        kind = str(rng.choice(["line", "arc", *HARD[:6]]))
        kinds.add(kind)
        step = rng.uniform(-30, 30, 2)
        if kind in ("collinear", "cusp") and len(xy) > 1:
            step = (xy[-1] - xy[-2]) * (1.5 if kind == "collinear" else -0.5)
        size = {"tiny arc": 1e-5, "nearly full arc": 0.01, "no length": 0.0}.get(kind, 1.0)
        turns = {"arc": rng.uniform(-1.5, 1.5), "tiny arc": rng.uniform(-1.5, 1.5)}
        bend = turns.get(kind, 0.0) if kind != "nearly full arc" else float(rng.choice([-1, 1])) * rng.uniform(40, 100)
        xy.append(xy[-1] + size * step)
        bulge.append(bend)
        if kind == "full circle":
            xy.append(xy[-2])
            bulge[-1] = float(rng.choice([-1, 1]))
            bulge.append(bulge[-1])
    if rng.random() < 0.5 and np.hypot(*(xy[-1] - xy[0])) > 0:
        nearly = rng.random() < 0.4
        kinds.add("nearly closed" if nearly else "closed")
        xy.append(xy[0] + (1e-6 if nearly else 0.0))
        bulge.append(0.0)
    return Curve(np.array(xy), np.array(bulge)), kinds


def line_of(curve: Curve) -> shapely.Geometry:
    """Return the curve as fine lines, made of centres and angles, not by the curve's own points."""
    pieces = [curve.xy[:1]]
    for i, sweep in enumerate(curve.sweeps_rad):
        begin, end, count = curve.xy[i], curve.xy[i + 1], 2
        if sweep != 0.0:
            radius = float(curve.radii_mm[i])
            count = 2 + math.ceil(abs(sweep) / math.sqrt(8 * FINE_MM / max(radius, FINE_MM)))
            spokes = (begin - curve.centres[i]) @ (1, 1j) * np.exp(1j * sweep * np.linspace(0, 1, count)[1:-1])
            pieces.append(curve.centres[i] + np.column_stack([spokes.real, spokes.imag]))
        pieces.append(end[None])
    return shapely.LineString(np.vstack(pieces))


def angle_sum(line: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Return how often a closed line runs round points, by the sum of the angles under which it is seen."""
    seen = (line[None] - points[:, None]) @ (1, 1j)
    return np.rint(np.angle(seen[:, 1:] / seen[:, :-1]).sum(axis=1) / math.tau).astype(int)


@pytest.mark.slow
def test_random_curves_agree_with_shapely() -> None:
    seen: Counter[str] = Counter()
    for seed in range(CASES):
        curve, kinds = random_curve(seed)
        seen.update(kinds)
        line, rng = line_of(curve), np.random.default_rng(seed)
        points = np.vstack([rng.uniform(-80, 80, (60, 2)), curve.xy, np.nan_to_num(curve.centres)])
        distance_mm, length_mm = curve.nearest(points)
        assert distance_mm == pytest.approx(shapely.distance(line, shapely.points(points)), abs=2 * FINE_MM), (
            f"seed {seed}"
        )
        there, _ = curve.at_length(length_mm)
        assert np.hypot(*(there - points).T) == pytest.approx(distance_mm, abs=1e-6), f"seed {seed}"
        assert curve.length_mm == pytest.approx(line.length, rel=1e-4, abs=1e-6), f"seed {seed}"
        assert curve.box_mm == pytest.approx(line.bounds, abs=2 * FINE_MM), f"seed {seed}"
    assert all(seen[kind] >= CASES // 10 for kind in HARD), f"seeds 0 to {CASES - 1}: {dict(seen)}"


@pytest.mark.slow
def test_winding_agrees_with_the_sum_of_angles() -> None:
    found: Counter[int] = Counter()
    for seed in range(CASES):
        curve, _ = random_curve(seed)
        if not curve.closed:
            with pytest.raises(GeometryError, match="open"):
                curve.winding(np.zeros((1, 2)))
            continue
        line = line_of(curve)
        rng = np.random.default_rng(seed)
        points = np.vstack(
            [rng.uniform(-60, 60, (80, 2)), np.nan_to_num(curve.centres), curve.xy + np.array([0.5, 0.0])]
        )
        points = points[shapely.distance(line, shapely.points(points)) > 5 * FINE_MM]
        expected = angle_sum(np.asarray(line.coords), points)
        assert curve.winding(points).tolist() == expected.tolist(), f"seed {seed}"
        found.update(expected.tolist())
    assert found[0] and found[1] and found[-1] and len(found) > 3, found


def test_rays_through_vertices_and_level_lines_count_once() -> None:
    comb = from_points([(0, 0), (2, 2), (4, 0), (6, 0), (8, 2), (8, -2), (0, -2)], closed=True)
    places = np.array([(-1, 0), (1, 0), (5, -0.0), (3.9, 0), (7, 0), (9, 0), (-1, 2), (2, 1), (5, -2.5)], float)
    inside = shapely.contains_xy(shapely.Polygon(comb.xy), places)
    off_edge = np.array([True, True, False, True, True, True, True, True, True])
    assert (comb.winding(places) != 0)[off_edge].tolist() == inside[off_edge].tolist()
    ring = circle((0, 0), 5)
    assert ring.winding(np.array([(0, 0), (-4.999, 0), (-5.001, 0), (4.999, 0), (5.001, 0), (0, 6)])).tolist() == [
        1,
        1,
        0,
        1,
        0,
        0,
    ]


def test_pieces_put_together_are_the_curve() -> None:
    for seed in range(CASES):
        curve, _ = random_curve(seed)
        if curve.length_mm == 0.0:
            continue
        rng = np.random.default_rng(seed)
        places = rng.uniform(-1, curve.length_mm + 1, 6)
        pieces = curve.split([*places, *curve.before_mm[:2], places[0]])
        assert pieces[0].xy[0].tolist() == curve.xy[0].tolist() and pieces[-1].xy[-1].tolist() == curve.xy[-1].tolist()
        assert all((a.xy[-1] == b.xy[0]).all() for a, b in itertools.pairwise(pieces)), f"seed {seed}"
        assert sum(piece.length_mm for piece in pieces) == pytest.approx(curve.length_mm, abs=1e-6), f"seed {seed}"
        for piece in pieces:
            assert piece.length_mm > 0 and curve.distances_mm(piece.points(0.01)).max() < 1e-6, f"seed {seed}"


@pytest.mark.slow
def test_a_part_lies_between_its_places_and_goes_round() -> None:
    line = from_points([(0, 0), (10, 0), (10, 10)])
    assert line.part(2, 15).xy.tolist() == [[2, 0], [10, 0], [10, 5]]
    assert line.part(-5, 99) == line
    with pytest.raises(GeometryError, match="must have a length"):
        line.part(7, 7)
    ring = circle((0, 0), 5)
    quarter = 2.5 * math.pi
    assert ring.part(3 * quarter, quarter).xy[[0, -1]] == pytest.approx(np.array([(0, -5), (0, 5)]))
    assert ring.part(quarter, quarter).length_mm == pytest.approx(4 * quarter)
    turned = ring.started_at_length(quarter)
    assert turned.closed and turned.xy[0] == pytest.approx((0, 5)) and turned.area_mm2 == pytest.approx(25 * math.pi)
    assert ring.started_at_length(2 * quarter).xy.tolist() == ring.started_at(1).xy.tolist()
    with pytest.raises(GeometryError, match="open"):
        line.started_at_length(1)


def test_many_places_at_once_are_those_one_by_one() -> None:
    curve, _ = random_curve(3)
    places = np.linspace(-1, curve.length_mm + 1, 50)
    points, directions = curve.at_length(places)
    one_by_one = [curve.at_length(place) for place in places]
    assert points.tolist() == [point.tolist() for point, _ in one_by_one]
    assert directions.tolist() == [direction.tolist() for _, direction in one_by_one]


def test_a_transform_carries_points_along_and_refuses_what_is_no_arc() -> None:
    for seed in range(20):
        curve, _ = random_curve(seed)
        rng = np.random.default_rng(seed)
        c, s = 3 * math.cos(seed), 3 * math.sin(seed)
        matrix = np.array([(c, -s, 7.0), (s, c, -2.0)]) * (1.0 if seed % 2 else np.array([-1.0, 1.0, 1.0]))
        moved = curve.transformed(matrix)
        places, _ = curve.at_length(rng.uniform(0, curve.length_mm, 30))
        assert moved.distances_mm(places @ matrix[:, :2].T + matrix[:, 2]).max() < 1e-6, f"seed {seed}"
        assert moved.length_mm == pytest.approx(3 * curve.length_mm)
    uneven = np.array([(2.0, 0.0, 0.0), (0.0, 1.0, 0.0)])
    with pytest.raises(GeometryError, match="no arc"):
        circle((0, 0), 1).transformed(uneven)
    assert from_points([(1, 1), (2, 2)]).transformed(uneven).xy.tolist() == [[2, 1], [4, 2]]
    with pytest.raises(GeometryError, match="collapse"):
        from_points([(1, 1), (2, 2)]).transformed(np.zeros((2, 3)))


def test_short_segments_are_taken_out() -> None:
    curve = Curve(np.array([(0.0, 0), (0, 0), (5, 0), (5, 1e-12), (5, 5)]), np.array([0, 0.5, 0, 0]))
    assert curve.without_short().xy.tolist() == [[0, 0], [5, 1e-12], [5, 5]]
    assert curve.without_short().bulge.tolist() == [0.5, 0]
    with pytest.raises(GeometryError, match="no length"):
        Curve(np.zeros((3, 2)), np.zeros(2)).without_short()


def test_directions_at_both_ends_of_segments() -> None:
    ring = circle((0, 0), 5)
    assert ring.begin_directions == pytest.approx(np.array([(0, 1), (0, -1)]), abs=1e-12)
    assert ring.end_directions == pytest.approx(np.array([(0, -1), (0, 1)]), abs=1e-12)


@pytest.mark.slow
def test_a_hundred_thousand_segments_are_no_loop() -> None:
    t = np.linspace(0, math.tau, 100_001)
    radius = 50 + np.sin(40 * t)
    curve = Curve(np.column_stack([radius * np.cos(t), radius * np.sin(t)]), np.full(100_000, 1e-3))
    points = np.random.default_rng(0).uniform(-60, 60, (20_000, 2))
    inside = np.hypot(*points.T) < 50 + np.sin(40 * np.arctan2(points[:, 1], points[:, 0]))
    ring = Curve(np.vstack([curve.xy[:-1], curve.xy[:1]]), curve.bulge)
    assert np.count_nonzero((ring.winding(points) == 1) != inside) <= 3
    assert ring.split(np.linspace(0, ring.length_mm, 1001))[500].length_mm == pytest.approx(ring.length_mm / 1000)
    assert ring.nearest(points[:50])[0] == pytest.approx(
        shapely.distance(shapely.LineString(ring.points(1e-7)), shapely.points(points[:50])), abs=1e-5
    )
