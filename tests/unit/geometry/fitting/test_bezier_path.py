# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines and arcs along Bezier paths, against the same paths sampled finely."""

from __future__ import annotations

import numpy as np
import pytest

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import from_points
from CNCStepper.geometry.fitting.bezier_path import BezierPath, PathPen

SEEDS = range(40)


def random_path(rng: np.random.Generator) -> BezierPath:
    """Return a path of lines, arcs and wild Bezier curves: smooth joints, corners, cusps, controls on their ends."""
    place = complex(*rng.normal(0.0, 20.0, 2))
    pen, leaving = PathPen(place), 1.0 + 0j
    for _ in range(int(rng.integers(1, 8))):
        one, other, end = (complex(*rng.normal(0.0, 20.0, 2)) for _ in range(3))
        kind = int(rng.integers(0, 6))
        if kind == 0:
            pen.line(end)
        elif kind == 1:
            pen.arc(float(rng.uniform(-1.0, 1.0)), end)
        elif kind == 2:
            pen.quadratic(one, end)
        elif kind == 3:
            pen.cubic(pen.place + leaving, other, end)  # smooth
        elif kind == 4:
            pen.cubic(pen.place, end, end)
        else:
            pen.cubic(2.0 * end - pen.place, pen.place, end)  # a loop or a cusp
        leaving = end - other
    if rng.random() < 0.5:
        pen.close()
    return pen.path()


def sampled(path: BezierPath) -> np.ndarray:
    """Return points of the Bezier curves of a path, float64[m, 2]."""
    t = np.linspace(0.0, 1.0, 400)[:, None]
    p0, p3, (c1, c2) = path.points[:-1], path.points[1:], path.controls.T
    z = (1 - t) ** 3 * p0 + 3 * (1 - t) ** 2 * t * c1 + 3 * (1 - t) * t**2 * c2 + t**3 * p3
    z = z[:, np.isnan(path.bulge)]
    return np.column_stack([z.T.ravel().real, z.T.ravel().imag])


@pytest.mark.parametrize("seed", SEEDS)
def test_the_curve_stays_within_its_tolerance(seed: int) -> None:
    rng = np.random.default_rng(seed)
    path, tolerance_mm = random_path(rng), float(rng.choice([0.002, 0.02, 0.2]))
    curve = path.curve(tolerance_mm)
    points = sampled(path)
    if len(points):
        assert curve.distances_mm(points).max() <= tolerance_mm, f"seed {seed}"
    assert curve.xy[0] @ (1.0, 1j) == path.points[0] and curve.xy[-1] @ (1.0, 1j) == path.points[-1]
    exact = [bulge for bulge in path.bulge.tolist() if bulge == bulge and bulge]
    assert set(np.round(exact, 12)) <= set(np.round(curve.bulge, 12).tolist()), "arcs come over exactly"


def test_the_generator_makes_the_hard_cases() -> None:
    paths = [random_path(np.random.default_rng(seed)) for seed in SEEDS]
    kinds = [
        (np.isnan(path.bulge).any(), (path.bulge == 0.0).any(), (np.abs(path.bulge) > 0.0).any()) for path in paths
    ]
    assert sum(all(kind) for kind in kinds) >= 5
    assert sum(path.closed for path in paths) >= 8


def test_the_curve_does_not_leave_the_path_either() -> None:
    pen = PathPen(0j)
    pen.cubic(0 + 40j, 60 - 30j, 50 + 10j)
    path = pen.path()
    chords = from_points(sampled(path))
    assert chords.distances_mm(path.curve(0.01).points(0.001)).max() <= 0.01 + 0.002


def test_a_circle_of_four_curves_takes_few_arcs_and_its_area() -> None:
    pen, k = PathPen(10 + 0j), 0.5522847498 * 10.0
    pen.cubic(10 + k * 1j, k + 10j, 10j)
    pen.cubic(-k + 10j, -10 + k * 1j, -10 + 0j)
    pen.cubic(-10 - k * 1j, -k - 10j, -10j)
    pen.cubic(k - 10j, 10 - k * 1j, 10 + 0j)
    curve = pen.path().curve(0.005)
    assert curve.closed and len(curve) <= 4
    assert curve.area_mm2 == pytest.approx(np.pi * 100.0, abs=0.3)


def test_corners_stay_where_they_are() -> None:
    pen = PathPen(0j)
    pen.quadratic(5 + 5j, 10 + 0j)
    pen.quadratic(15 + 5j, 20 + 0j)
    assert [10.0, 0.0] in pen.path().curve(0.5).xy.tolist()


@pytest.mark.parametrize("end", [complex("nan"), 1e300 + 0j, complex("inf")])
def test_numbers_out_of_bounds_are_refused(end: complex) -> None:
    pen = PathPen(0j)
    pen.cubic(1j, 2j, end)
    with pytest.raises(GeometryError):
        pen.path().curve(0.01)


def test_a_path_too_long_for_its_tolerance_is_refused() -> None:
    pen = PathPen(0j)
    for number in range(2000):
        pen.cubic(1e6 + 0j, 1e6 * 1j, complex(number, 1))
    with pytest.raises(GeometryError) as refusal:
        pen.path().curve(1e-4)
    assert refusal.value.code == "fit-large"
