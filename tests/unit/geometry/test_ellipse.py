# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parallel curves of an ellipse, judged by shapely against an ellipse drawn here."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely import LineString, Polygon, points, prepare

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.shapes.ellipse import Ellipse


def outline(major_mm: float, minor_mm: float, count: int = 8_000) -> Polygon:
    """Return the ellipse about the origin as a polygon; its chords are off by major / 8 * (2 pi / count)²."""
    t = np.linspace(0, 2 * math.pi, count, endpoint=False)
    return Polygon(np.column_stack([major_mm * np.cos(t), minor_mm * np.sin(t)]))


@pytest.mark.slow
@given(
    st.floats(1.0, 50.0),
    st.floats(1.0, 8.0),
    st.one_of(st.floats(0.0, 0.9999), st.sampled_from([0.0, 1e-9, 0.5, 0.999999])),
    st.sampled_from([0.005, 0.01, 0.1]),
)
@settings(max_examples=40, deadline=None)
def test_a_parallel_curve_keeps_its_distance(minor: float, aspect: float, share: float, tolerance: float) -> None:
    judge_parallel(minor, aspect, share * minor, tolerance)


@pytest.mark.parametrize("aspect", [1.0, 1.0 + 1e-13, 1.0 + 1e-9, 1.001, 1.6, 8.0])
@pytest.mark.parametrize("factor", [1 - 1e-9, 1.0, 1 + 1e-12, 1 + 1e-9, 1.0001])
def test_at_the_smallest_radius_of_curvature(aspect: float, factor: float) -> None:
    inside = 10.0 / aspect * factor
    if inside < 10.0:
        judge_parallel(10.0, aspect, inside, 0.01)


def judge_parallel(minor: float, aspect: float, inside: float, tolerance: float) -> None:
    ellipse = Ellipse.of_radii((0, 0), minor * aspect, minor)
    curve = ellipse.parallel(inside, tolerance)
    wall, here = outline(minor * aspect, minor), curve.points(1e-5)
    here = here[:: max(1, len(here) // 300)]
    exterior = wall.exterior
    prepare(exterior)
    distances = exterior.distance(points(here))
    assert np.abs(distances - inside).max() <= tolerance + 2e-4
    assert curve.closed and curve.area_mm2 >= 0
    assert curve.xy[0] == pytest.approx((0, minor - inside), abs=1e-9)
    tip = curve.xy[:, 0].max()
    assert tip == pytest.approx(ellipse.tip_mm(inside), abs=1e-9)
    if minor - inside > 0.2 and inside > 0:  # nothing of the true region is missing, its corners neither
        assert wall.buffer(-inside - tolerance - 1e-3).difference(Polygon(curve.points(1e-4))).area < 1e-6


def test_the_hard_cases_are_cut_at_the_corner() -> None:
    ellipse = Ellipse.of_radii((0, 0), 80, 10)  # smallest radius of curvature 1.25
    curve = ellipse.parallel(5.0, 0.01)
    right = int(np.argmax(curve.xy[:, 0]))
    assert curve.xy[right, 1] == pytest.approx(0, abs=1e-12)
    before = curve.points(1e-6)
    assert before[:, 0].max() == pytest.approx(ellipse.tip_mm(5.0), abs=1e-9)
    assert ellipse.tip_mm(5.0) == pytest.approx(math.sqrt(6300 * 0.75))
    opening = outline(80, 10).buffer(-5, quad_segs=64).buffer(5, quad_segs=64)
    assert ellipse.unreachable_mm(5.0) == pytest.approx(80 - opening.bounds[2], abs=2e-3)
    assert ellipse.unreachable_mm(1.25) == 0.0


def test_few_arcs_serve() -> None:
    assert len(Ellipse.of_radii((0, 0), 40, 25).parallel(3.0, 0.01)) <= 20


@pytest.mark.parametrize("rx, ry, turn", [(40, 25, 30), (25, 40, 0), (25, 40, -75)])
def test_it_lies_where_the_ellipse_lies(rx: float, ry: float, turn: float) -> None:
    ellipse = Ellipse.of_radii((7, -3), rx, ry, turn)
    t = np.linspace(0, 2 * math.pi, 20_001)
    angle = math.radians(turn)
    x, y = rx * np.cos(t), ry * np.sin(t)
    wall = np.column_stack(
        [7 + x * math.cos(angle) - y * math.sin(angle), -3 + x * math.sin(angle) + y * math.cos(angle)]
    )
    distances = LineString(wall).distance(points(ellipse.parallel(4, 0.01).points(0.01)))
    assert np.abs(distances - 4).max() < 0.0101
    assert LineString(wall).distance(points(ellipse.points(0.001))).max() < 0.0011
    assert LineString(ellipse.points(0.001)).distance(points(wall[::10])).max() < 0.0011


@pytest.mark.parametrize("inside", [-0.1, 25.0, 26.0, math.nan])
def test_no_parallel_curve_there(inside: float) -> None:
    with pytest.raises(GeometryError, match="that far inside"):
        Ellipse.of_radii((0, 0), 40, 25).parallel(inside, 0.01)


@pytest.mark.parametrize("rx, ry", [(0, 1), (1, -1), (math.nan, 1)])
def test_radii_must_be_positive(rx: float, ry: float) -> None:
    with pytest.raises(GeometryError, match="positive"):
        Ellipse.of_radii((0, 0), rx, ry)
