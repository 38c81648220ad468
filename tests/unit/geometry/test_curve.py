# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curve: lengths, areas, centres, points, distances and transforms, against shapely and plain geometry."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from CNCStepper.errors import CNCStepperError, GeometryError
from CNCStepper.geometry.curve import Curve, circle, from_points, joined

NUMBERS = st.floats(-100.0, 100.0).map(lambda number: round(number, 4))  # shapely fails below 1e-300
QUARTER = math.tan(math.pi / 8)


@st.composite
def curves(draw: st.DrawFn) -> Curve:
    """Chains of 1 to 6 segments, lines and arcs up to almost a full turn."""
    points = draw(st.lists(st.tuples(NUMBERS, NUMBERS), min_size=2, max_size=7))
    bulges = draw(st.lists(st.just(0.0) | st.floats(-3.0, 3.0), min_size=len(points) - 1, max_size=len(points) - 1))
    return Curve(np.array(points), np.array(bulges))


def dense(curve: Curve) -> np.ndarray:
    """Return points of every segment from its centre and radius, independently of Curve.points."""
    pieces = [curve.xy[:1]]
    for i, bulge in enumerate(curve.bulge):
        begin, end = curve.xy[i], curve.xy[i + 1]
        share = np.linspace(0.0, 1.0, 400)[1:, None]
        if bulge == 0.0:
            pieces.append(begin + share * (end - begin))
            continue
        sweep, chord = 4.0 * math.atan(bulge), end - begin
        left = np.array([-chord[1], chord[0]])
        centre = (
            (begin + end) / 2 + left / (2.0 * math.tan(sweep / 2.0))
            if abs(abs(bulge) - 1) > 1e-9
            else begin / 2 + end / 2
        )
        angle = math.atan2(*(begin - centre)[::-1]) + sweep * share
        pieces.append(centre + math.dist(begin, centre) * np.hstack([np.cos(angle), np.sin(angle)]))
    return np.vstack(pieces)


def square() -> Curve:
    return from_points([(0, 0), (4, 0), (4, 4), (0, 4)], closed=True)


def test_a_circle_has_its_length_area_centre_and_radius() -> None:
    ring = circle((3.0, -2.0), 5.0)
    assert ring.closed and len(ring) == 2
    assert ring.length_mm == pytest.approx(10 * math.pi)
    assert ring.area_mm2 == pytest.approx(25 * math.pi)
    assert ring.centres == pytest.approx(np.array([[3, -2], [3, -2]]))
    assert ring.radii_mm == pytest.approx([5, 5])
    assert ring.curvatures == pytest.approx([0.2, 0.2])
    assert ring.reversed().area_mm2 == pytest.approx(-25 * math.pi)


def test_a_line_has_no_centre() -> None:
    line = from_points([(0, 0), (3, 4)])
    assert np.isnan(line.centres).all() and np.isnan(line.radii_mm).all()
    assert line.length_mm == 5 and not line.closed and line.curvatures == pytest.approx([0])


def test_the_area_counts_arcs_on_both_sides() -> None:
    half_moon = Curve(np.array([(0, 0), (2, 0), (0, 0)]), np.array([1.0, 0.0]))
    assert half_moon.area_mm2 == pytest.approx(math.pi / 2)
    bitten = Curve(square().xy, np.array([-1.0, 0, 0, 0]))
    assert bitten.area_mm2 == pytest.approx(16 - 2 * math.pi)


def test_the_area_of_nearly_straight_arcs_is_not_noise() -> None:
    bent = Curve(np.array([(0.0, 0), (1000, 0), (0, 0)]), np.array([1e-8, 0.0]))
    assert bent.area_mm2 == pytest.approx(1e6 * 4e-8 / 12, rel=1e-6)


@pytest.mark.slow
@given(curves())
@settings(max_examples=60, deadline=None)
def test_lengths_and_points_agree_with_the_segments_themselves(curve: Curve) -> None:
    there = dense(curve)
    assert np.hypot(*np.diff(there, axis=0).T).sum() == pytest.approx(curve.length_mm, rel=1e-4, abs=1e-6)
    for tolerance_mm in (0.5, 0.01):
        line = shapely.LineString(curve.points(tolerance_mm))
        assert shapely.distance(line, shapely.points(there)).max() <= tolerance_mm + 1e-6
    assert curve.distances_mm(curve.points(0.01)).max() < 1e-6


@given(curves(), st.lists(st.tuples(NUMBERS, NUMBERS), min_size=1, max_size=8))
@settings(max_examples=60, deadline=None)
def test_distances_agree_with_dense_points(curve: Curve, points: list[tuple[float, float]]) -> None:
    line = shapely.LineString(curve.points(1e-4))
    assert curve.distances_mm(np.array(points)) == pytest.approx(line.distance(shapely.points(points)), abs=2e-4)


@given(curves(), st.floats(0.0, 1.0))
@settings(max_examples=60, deadline=None)
def test_a_point_at_a_length_lies_there_and_looks_along(curve: Curve, share: float) -> None:
    point, direction = curve.at_length(share * curve.length_mm)
    assert curve.distances_mm(point)[0] < 1e-6 if point.ndim == 2 else curve.distances_mm(point[None])[0] < 1e-6
    if curve.lengths_mm.min() > 1e-3:
        assert np.hypot(*direction) == pytest.approx(1.0)
        assert curve.reversed().at_length((1 - share) * curve.length_mm)[0] == pytest.approx(point, abs=1e-5)


def test_at_length_runs_through_a_quarter_turn() -> None:
    quarter = Curve(np.array([(1.0, 0), (0, 1)]), np.array([QUARTER]))
    for share in (0.0, 0.25, 1.0):
        point, direction = quarter.at_length(share * quarter.length_mm)
        angle = share * math.pi / 2
        assert point == pytest.approx((math.cos(angle), math.sin(angle)))
        assert direction == pytest.approx((-math.sin(angle), math.cos(angle)))
    assert quarter.at_length(99)[0] == pytest.approx((0, 1)) and quarter.at_length(-1)[0] == pytest.approx((1, 0))


@given(curves(), st.floats(-360, 360), NUMBERS, NUMBERS, st.floats(0.1, 5.0))
@settings(max_examples=40, deadline=None)
def test_transforms_keep_the_shape(curve: Curve, angle: float, dx: float, dy: float, factor: float) -> None:
    changed = curve.rotated(angle).moved(dx, dy).scaled(factor)
    assert changed.length_mm == pytest.approx(curve.length_mm * factor, rel=1e-6, abs=1e-6)
    back = changed.scaled(1 / factor).moved(-dx, -dy).rotated(-angle)
    assert back.xy == pytest.approx(curve.xy, abs=1e-9)
    assert curve.mirrored_x().mirrored_x() == curve
    assert curve.reversed().reversed() == curve
    assert curve.mirrored_x().distances_mm(dense(curve) * (-1, 1)).max() < 1e-6


def test_a_closed_curve_can_start_elsewhere() -> None:
    moved = square().started_at(2)
    assert moved.xy[0].tolist() == [4, 4] and moved.closed and moved.area_mm2 == 16
    with pytest.raises(GeometryError, match="closed"):
        from_points([(0, 0), (1, 0)]).started_at(1)


def test_joined_curves_must_meet() -> None:
    first, second = from_points([(0, 0), (1, 0)]), Curve(np.array([(1.0, 0), (2, 0)]), np.array([1.0]))
    assert len(joined([first, second])) == 2
    with pytest.raises(GeometryError, match=r"do not meet.*0\.5 mm"):
        joined([first, second.moved(0.5, 0)])


def test_an_arc_too_flat_to_have_a_centre_is_a_line() -> None:
    flat = Curve(np.array([(0.0, 0), (1000, 0)]), np.array([1e-18]))
    assert flat.bulge[0] == 0 and flat.points(0.01).tolist() == [[0, 0], [1000, 0]]
    small = Curve(np.array([(0.0, 0), (1000, 0)]), np.array([1e-9]))
    assert small.distances_mm(np.array([(500, -5e-7)]))[0] < 1e-10
    assert small.points(1e-8)[:, 1].min() == pytest.approx(-5e-7)


def test_doubled_points_are_dropped_and_do_no_harm() -> None:
    assert from_points([(0, 0), (0, 0), (1, 0), (1, 0)]).xy.tolist() == [[0, 0], [1, 0]]
    doubled = Curve(np.array([(0.0, 0), (0, 0), (1, 0)]), np.zeros(2))
    assert doubled.distances_mm(np.array([(0.5, 2.0), (-1, 0)])) == pytest.approx([2, 1])
    assert doubled.points(0.1).tolist() == doubled.xy.tolist() and doubled.length_mm == 1


@pytest.mark.parametrize(
    "xy, bulge",
    [
        ([], []),
        ([(0, 0)], []),
        ([(0, 0), (1, 1)], []),
        ([(0, 0), (1, 1)], [0, 0]),
        ([(0, 0, 0), (1, 1, 1)], [0]),
        ([(0, 0), (1,)], [0]),
        ([(0, 0), ("a", 1)], [0]),
        ([(0, 0), (10**400, 1)], [0]),
        ([(0, 0), (math.nan, 1)], [0]),
        ([(0, 0), (math.inf, 1)], [0]),
        ([(0, 0), (2e6, 1)], [0]),
        ([(0, 0), (1, 1)], [math.nan]),
        ([(0, 0), (1, 1)], [math.inf]),
        ([(0, 0), (1, 1)], [1e9]),
        (None, None),
        ({"a": 1}, [0]),
    ],
)
def test_what_is_no_curve_is_refused(xy: object, bulge: object) -> None:
    with pytest.raises(GeometryError):
        Curve(xy, bulge)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "points", [[], [(1, 1)], [(1, 1), (1, 1)], [(0, 0), (math.nan, 1), (2, 2)], [(0, 0, 0), (1, 1, 1)]]
)
@pytest.mark.parametrize("closed", [False, True])
def test_points_that_make_no_line_are_refused(points: list, closed: bool) -> None:
    with pytest.raises(GeometryError):
        from_points(points, closed)


@pytest.mark.parametrize("tolerance_mm", [0.0, -1.0, math.nan])
def test_a_tolerance_must_be_positive(tolerance_mm: float) -> None:
    with pytest.raises(CNCStepperError, match="tolerance"):
        square().points(tolerance_mm)


def test_a_scale_must_be_positive() -> None:
    for factor in (0.0, -1.0, math.nan):
        with pytest.raises(GeometryError, match="positive"):
            square().scaled(factor)
