# SPDX-License-Identifier: LGPL-2.1-or-later
"""Freehand lines with fewer points: near the drawn line both ways, quick, never collapsing."""

from __future__ import annotations

import math
import random
import time

import numpy as np
import pytest
from shapely import LineString, hausdorff_distance, points

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.geometry.fitting.simplify import STRETCH, simplified


def freehand(count: int, seed: int) -> np.ndarray:
    rng = np.random.default_rng(seed)
    return np.cumsum(rng.normal(size=(count, 2)), axis=0)


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("tolerance_mm", [0.0, 0.1, 1.0, 1000.0])
def test_both_lines_stay_within_the_tolerance_of_each_other(closed: bool, tolerance_mm: float) -> None:
    seed = random.randrange(10**6)
    print("seed", seed)
    curve = from_points(freehand(STRETCH + 500, seed), closed)
    simple = simplified(curve, tolerance_mm)
    away = LineString(simple.xy).distance(points(curve.xy)).max()
    back = LineString(curve.xy).distance(points(simple.points(0.1))).max()
    inside = LineString(curve.xy).distance(points((simple.xy[:-1] + simple.xy[1:]) / 2)).max()
    assert max(away, back, inside) <= tolerance_mm + 1e-9
    assert simple.closed == closed and len(simple) <= len(curve)
    assert simple.xy[0].tolist() == curve.xy[0].tolist() and simple.xy[-1].tolist() == curve.xy[-1].tolist()
    assert {tuple(row) for row in simple.xy} <= {tuple(row) for row in curve.xy}


def test_points_on_a_line_go() -> None:
    assert simplified(from_points([(0, 0), (1, 0), (2, 0), (3, 0)]), 0.0).xy.tolist() == [[0, 0], [3, 0]]


def test_a_closed_line_does_not_collapse() -> None:
    square = from_points([(0, 0), (1, 0), (1, 1), (0, 1)], closed=True)
    assert simplified(square, 50.0).xy.tolist() == [[0, 0], [1, 1], [0, 0]]


def zigzag(count: int) -> np.ndarray:
    """The worst case: each split takes off one point only."""
    i = np.arange(count)
    return np.column_stack([i, (-1.0) ** i * (count - i)])


@pytest.mark.slow
@pytest.mark.parametrize(
    "xy",
    [freehand(50_000, 1), zigzag(50_000), pytest.param(zigzag(300_000), marks=pytest.mark.slow)],
    ids=["freehand", "worst", "long"],
)
def test_long_lines_are_quick_and_safe(xy: np.ndarray) -> None:
    began_s = time.process_time()
    simple = simplified(from_points(xy), 0.5)
    assert time.process_time() - began_s < 4.0
    assert 2 <= len(simple) <= len(xy)


def test_degenerate_input() -> None:
    two = from_points([(0, 0), (1, 1)])
    assert simplified(two, 5.0) == two
    same = Curve(np.zeros((5, 2)), np.zeros(4))
    assert simplified(same, 0.1).length_mm == 0
    there_and_back = from_points([(0, 0), (5, 0), (0, 0)])
    assert simplified(there_and_back, 0.1) == there_and_back
    assert simplified(circle((0, 0), 5), 1.0) == circle((0, 0), 5)


@pytest.mark.parametrize("tolerance_mm", [-0.1, math.nan])
def test_a_negative_tolerance_is_refused(tolerance_mm: float) -> None:
    with pytest.raises(GeometryError, match="negative"):
        simplified(from_points([(0, 0), (1, 1), (2, 0)]), tolerance_mm)


def test_the_measure_sees_a_moved_line() -> None:
    line = freehand(500, 3)
    assert hausdorff_distance(LineString(line), LineString(line + np.array([0, 5]))) > 1
