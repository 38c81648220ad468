# SPDX-License-Identifier: LGPL-2.1-or-later
"""The published ellipse points: registers worked by hand, and the promised deviation of the whole path."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
from shapely import LineString, points, prepare

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.shapes.ellipse_dda import ellipse_by_dda, quadrant_steps


@pytest.mark.slow
def test_the_registers_of_a_small_case_worked_by_hand() -> None:
    # N = 4: (qx, qy) after each iteration 4,0 -> 0,1  4,1 -> 0,3  4,3 -> 0,6>=4 -> 0,2 ...
    # it  qx+=px     X   qy+=py    Y
    #  1  4 -> 0     1   1         4
    #  2  4 -> 0     2   3         4
    #  3  4 -> 0     3   6 -> 2    3
    #  4  3          3   5 -> 1    2
    #  5  5 -> 1     4   5 -> 1    1
    #  6  2          4   5 -> 1    0
    assert quadrant_steps(4).tolist() == [[0, 4], [1, 4], [2, 4], [3, 3], [3, 2], [4, 1], [4, 0]]


def test_the_smallest_circle() -> None:
    assert quadrant_steps(1).tolist() == [[0, 1], [1, 0]]


def deviation_mm(rx: float, ry: float, xy: np.ndarray) -> float:
    t = np.linspace(0, 2 * math.pi, 20_001)
    wall = LineString(np.column_stack([rx * np.cos(t), ry * np.sin(t)]))
    prepare(wall)
    middles = (xy[:-1] + xy[1:]) / 2
    return float(max(wall.distance(points(xy)).max(), wall.distance(points(middles)).max()))


@pytest.mark.parametrize("count", [*range(1, 40), 448, 509, 511, 574, 576, 1000])
def test_the_circle_is_never_left_by_more_than_the_resolution(count: int) -> None:
    """Resolutions whose own register leaves the circle by more are among them (448, 509, 511, 574, 576)."""
    xy = ellipse_by_dda(1.0, 1.0, 1.0 / count).xy
    chord = np.diff(xy, axis=0)
    share = np.clip(-(xy[:-1] * chord).sum(axis=1) / (chord**2).sum(axis=1), 0, 1)
    nearest = np.hypot(*(xy[:-1] + share[:, None] * chord).T)
    assert max(np.hypot(*xy.T).max() - 1, 1 - nearest.min()) <= 1 / count + 1e-12


def test_some_registers_alone_would_leave_it() -> None:
    assert max(abs(math.hypot(*point) - 574) for point in quadrant_steps(574)) > 1


@pytest.mark.slow
def test_random_ellipses_keep_the_promise() -> None:
    seed = random.randrange(10**6)
    print("seed", seed)
    rng = random.Random(seed)
    for _ in range(25):
        ry = rng.uniform(0.5, 50)
        rx, resolution = ry * rng.choice([0.2, 1, 1.6, 3, 8]), rng.uniform(0.01, 0.2) * ry
        xy = ellipse_by_dda(rx, ry, resolution).xy
        assert deviation_mm(rx, ry, xy) <= resolution * max(1, rx / ry) + 1e-5


def test_it_runs_counter_clockwise_from_the_top_through_all_vertices() -> None:
    curve = ellipse_by_dda(40, 25, 0.3)  # 25 / 0.3 is not whole
    assert curve.xy[0].tolist() == [0, 25] and curve.closed and curve.area_mm2 > 0
    for vertex in ((40, 0), (-40, 0), (0, -25)):
        assert np.hypot(*(curve.xy - vertex).T).min() < 1e-12
    assert np.hypot(*np.diff(curve.xy, axis=0).T).min() > 0
    assert not curve.bulge.any()


@pytest.mark.parametrize("values", [(0, 1, 1), (1, -1, 1), (1, 1, 0), (math.nan, 1, 1)])
def test_values_must_be_positive(values: tuple[float, float, float]) -> None:
    with pytest.raises(GeometryError, match="positive"):
        ellipse_by_dda(*values)


@pytest.mark.parametrize("resolution", [1e-12, 1e-320])
def test_too_fine_a_resolution_is_refused(resolution: float) -> None:
    with pytest.raises(GeometryError, match=r"too fine.*limit.*larger"):
        ellipse_by_dda(40, 25, resolution)
