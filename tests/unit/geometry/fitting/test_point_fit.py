# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points as lines and arcs: never outside the tolerance, measured by shapely; corners kept; never more segments."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable

import numpy as np
import pytest
import shapely

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.geometry.curve_columns import complex_of
from CNCStepper.geometry.fitting.fit_kernels import NO, UNSURE, YES, advances, serves_by_angle
from CNCStepper.geometry.fitting.point_fit import CORNER_DEG, corners, fit_points, refitted

CASES = 30
HARD = ("tiny arc", "full circle", "collinear", "cusp", "nearly closed", "noise", "doubled points", "corner")


def turtle(rng: np.random.Generator, scale_mm: float) -> tuple[np.ndarray, list[np.ndarray], set[str]]:
    """Return points along random lines and arcs, the corners among them, and which hard cases occur."""
    place, direction = 0j, np.exp(1j * rng.uniform(0, math.tau))
    points, sharp, kinds = [place], [], set()
    for number in range(int(rng.integers(1, 7))):
        turn = float(rng.choice([0.0, 0.0, rng.uniform(-2.4, 2.4), math.pi]))
        if number and abs(turn) > 1.5 * math.radians(CORNER_DEG):
            sharp.append(place)
            kinds.add("cusp" if turn == math.pi else "corner")
        direction *= np.exp(1j * turn) if number else 1.0
        kind = str(rng.choice(["line", "arc", "tiny arc", "full circle"], p=[0.4, 0.35, 0.15, 0.1]))
        sweep = {"line": 0.0, "full circle": math.tau}.get(kind, float(rng.uniform(-3.0, 3.0)))
        length = scale_mm * (0.02 if kind == "tiny arc" else float(rng.uniform(0.3, 1.0)))
        kinds.add("collinear" if kind == "line" else kind)
        share = np.linspace(0, 1, int(rng.integers(2, 120)))[1:]
        share[:-1] += rng.uniform(-0.3, 0.3, len(share) - 1) * np.diff(share, append=1.0)[:-1]
        along = share if sweep == 0.0 else (np.exp(1j * sweep * share) - 1.0) / (1j * sweep)
        points.extend(place + length * direction * along)
        place, direction = points[-1], direction * np.exp(1j * sweep)
    return np.array(points), sharp, kinds


def random_case(seed: int) -> tuple[np.ndarray, float, list[np.ndarray], set[str]]:
    """Return points, a tolerance, the corners that a person would see, and which hard cases occur."""
    rng = np.random.default_rng(seed)
    z, sharp, kinds = turtle(rng, scale_mm=float(10 ** rng.uniform(0, 2)))
    tolerance_mm = float(10 ** rng.uniform(-3, -1))
    if rng.random() < 0.3:
        kinds.add("noise")
        z, sharp = z + tolerance_mm * 0.4 * (rng.uniform(-1, 1, len(z)) + 1j * rng.uniform(-1, 1, len(z))), []
    if rng.random() < 0.25:
        kinds.add("nearly closed")
        z = np.append(z, z[0] + 0.5 * tolerance_mm)
    if rng.random() < 0.3:
        kinds.add("doubled points")
        z = np.repeat(z, rng.integers(1, 3, len(z)))
    return np.column_stack([z.real, z.imag]), tolerance_mm, sharp, kinds


def apart_mm(curve: Curve, points: np.ndarray, tolerance_mm: float) -> float:
    """Return how far the polyline and the curve leave each other, both ways, the curve drawn a thousand times finer."""
    drawn, here = shapely.LineString(points), curve.points(tolerance_mm / 1000)
    dense = shapely.get_coordinates(shapely.segmentize(drawn, max(drawn.length / 4000, 1e-6)))
    fitted = shapely.LineString(here)
    shapely.prepare([drawn, fitted])
    away = shapely.distance(fitted, shapely.points(dense)).max()
    return float(max(away, shapely.distance(drawn, shapely.points(here)).max()))


@pytest.mark.slow
def test_random_points_are_fitted_within_the_tolerance() -> None:
    seen: Counter[str] = Counter()
    for seed in range(CASES):
        points, tolerance_mm, _, kinds = random_case(seed)
        curve = fit_points(points, tolerance_mm)
        seen.update(kinds)
        assert apart_mm(curve, points, tolerance_mm) <= tolerance_mm * 1.002, f"seed {seed}: {kinds}"
        assert len(curve) <= len(from_points(points)), f"seed {seed}"
        assert np.array_equal(curve.xy[[0, -1]], points[[0, -1]]), f"seed {seed}"
    assert all(seen[kind] >= CASES // 10 for kind in HARD), f"seeds 0 to {CASES - 1}: {dict(seen)}"


def test_corners_stay_where_they_are() -> None:
    kept = 0
    for seed in range(200):
        points, tolerance_mm, sharp, kinds = random_case(seed)
        if "tiny arc" in kinds or tolerance_mm > 0.01:
            continue  # there a corner may lie within one that is sharper
        curve = fit_points(points, tolerance_mm)
        for corner in sharp:
            assert np.abs(complex_of(curve.xy) - corner).min() < 1e-9, f"seed {seed}: {corner}"
            kept += 1
    assert kept > 20


def test_a_finely_drawn_square_is_four_lines() -> None:
    square = from_points([(0, 0), (10, 0), (10, 10), (0, 10)], closed=True)
    fitted = fit_points(square.at_length(np.linspace(0, 40, 4001))[0], 0.2)
    assert fitted.xy.round(9).tolist() == square.xy.tolist() and not fitted.bulge.any()


def test_without_the_corners_the_square_would_be_rounded() -> None:
    z = complex_of(from_points([(0, 0), (5, 0), (10, 0), (10, 5), (10, 10)]).at_length(np.linspace(0, 20, 2001))[0])
    assert corners(z, 0.2).tolist() == [1000]


def test_a_circle_is_two_half_circles() -> None:
    fitted = fit_points(circle((3, -2), 30).points(1e-4), 0.01)
    assert len(fitted) == 2 and fitted.radii_mm == pytest.approx([30, 30], abs=1e-3) and fitted.closed


def test_a_tolerance_ten_times_smaller_takes_about_twice_the_segments() -> None:
    t = np.linspace(0, math.tau, 20_001)
    points = np.column_stack([40 * np.cos(t), 25 * np.sin(t)])
    counts = [len(fit_points(points, tolerance_mm)) for tolerance_mm in (0.1, 0.01, 0.001)]
    assert counts[0] <= 12 and counts[1] <= 20 and counts[2] <= 42, counts


def test_there_and_back_is_not_left_out() -> None:
    fitted = fit_points([(0, 0), (10, 0), (5, 0), (15, 0)], 0.01)
    assert fitted.xy[:, 0].tolist() == [0, 10, 5, 15]


def test_closed_points_and_curves_with_arcs() -> None:
    assert fit_points([(0, 0), (5, 0), (10, 0), (10, 10)], 0.01, closed=True).xy.tolist() == [
        [0, 0],
        [10, 0],
        [10, 10],
        [0, 0],
    ]
    ring = circle((0, 0), 5)
    assert refitted(ring, 0.01) is ring


@pytest.mark.parametrize("tolerance_mm", [0.0, -1.0, math.nan])
def test_a_tolerance_that_is_none_is_refused(tolerance_mm: float) -> None:
    with pytest.raises(GeometryError, match="above 0"):
        fit_points([(0, 0), (1, 1)], tolerance_mm)


@pytest.mark.parametrize("points", [[], [(1, 1)], [(1, 1), (1, 1)], [(0, 0), (math.inf, 1)]])
def test_points_that_make_no_line_are_refused(points: list) -> None:
    with pytest.raises(GeometryError):
        fit_points(points, 0.01)


def test_the_quick_look_at_an_arc_says_what_the_angles_say() -> None:
    chance, said = np.random.default_rng(seed=3), Counter()
    for case in range(400):
        count = int(chance.integers(3, 40))
        turn = chance.uniform(0.0, math.pi if case % 2 else 0.4)
        z = 5.0 * np.exp(1j * turn * np.linspace(0.0, 1.0, count))
        z += chance.choice([0.0, 0.002, 0.3]) * (chance.normal(size=count) + 1j * chance.normal(size=count))
        bulge = float(math.tan(turn / 4.0) + chance.choice([0.0, 0.001, -0.1]))
        for tolerance_mm in (0.005, 0.05, 1.0, 5.0):
            quick = advances(z, 0, count - 1, bulge, tolerance_mm)
            by_angle = serves_by_angle(z, 0, count - 1, bulge, tolerance_mm)
            said[quick] += 1
            assert quick == UNSURE or (quick == YES) == by_angle
    assert min(said[NO], said[YES], said[UNSURE]) > 50, said


RESULT = """
import numpy as np
from CNCStepper.geometry.fitting.point_fit import fit_points
t = np.linspace(0, 20, 1500)
curve = fit_points(np.column_stack([t * np.cos(t), t * np.sin(t) * (1 + 0.01 * (t > 7))]), 0.02)
print(curve.xy.round(6).tolist(), curve.bulge.round(6).tolist())
"""


@pytest.mark.slow
def test_the_kernel_says_the_same_three_ways(printed_three_ways: Callable[[str], list[str]]) -> None:
    said = printed_three_ways(RESULT)
    assert said[0].startswith("[[") and said.count(said[0]) == 3
