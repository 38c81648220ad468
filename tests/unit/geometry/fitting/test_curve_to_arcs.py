# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arcs along a parametric curve: within the tolerance both ways, measured densely by shapely."""

from __future__ import annotations

import math

import numpy as np
import pytest
from shapely import LineString, points, prepare

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.fitting.curve_to_arcs import corner_parameters, fit_arcs, fit_curve


def ellipse(t: np.ndarray) -> np.ndarray:
    return np.column_stack([40 * np.cos(t), 25 * np.sin(t)])


def thin_ellipse(t: np.ndarray) -> np.ndarray:
    return np.column_stack([40 * np.cos(t), 5 * np.sin(t)])


def spiral(t: np.ndarray) -> np.ndarray:
    return np.column_stack([t * np.cos(t), t * np.sin(t)])


def wave(t: np.ndarray) -> np.ndarray:
    return np.column_stack([10 * t, 4 * np.sin(t)])


def unevenly_run(t: np.ndarray) -> np.ndarray:
    return np.column_stack([10 * t**3, t**4])


SHAPES = [(ellipse, 0, 2 * math.pi), (thin_ellipse, 0, math.pi), (spiral, 1, 20)]
SHAPES += [(wave, 0, 10), (unevenly_run, 0, 2), (wave, 10, 0)]


def deviations_mm(curve: Curve, function, first: float, last: float) -> tuple[float, float]:
    """Return how far the drawn curve leaves the arcs and the arcs leave the drawn curve."""
    there = function(np.linspace(first, last, 4_001))
    here = curve.points(5e-6)
    drawn, arcs = LineString(there), LineString(here)
    prepare([drawn, arcs])
    away = arcs.distance(points(there[::5])).max()
    back = drawn.distance(points(here[:: max(1, len(here) // 600)])).max()
    return float(away), float(back)


@pytest.mark.parametrize("function, first, last", SHAPES)
@pytest.mark.parametrize("tolerance_mm", [0.2, 0.01])
def test_arcs_stay_within_the_tolerance_both_ways(function, first: float, last: float, tolerance_mm: float) -> None:
    curve = fit_arcs(function, first, last, tolerance_mm)
    assert curve.xy[[0, -1]] == pytest.approx(function(np.array([first, last], float)), abs=1e-12)
    assert max(deviations_mm(curve, function, first, last)) <= tolerance_mm + 2e-5


def test_a_tenth_of_the_tolerance_takes_about_twice_the_arcs() -> None:
    counts = [len(fit_arcs(ellipse, 0, 2 * math.pi, tolerance_mm)) for tolerance_mm in (0.1, 0.01, 0.001)]
    assert counts[0] <= 12 and counts[1] <= 20 and counts[2] <= 42


def test_a_circle_and_a_line_are_taken_as_they_are() -> None:
    half = fit_arcs(lambda t: np.column_stack([7 * np.cos(t), 7 * np.sin(t)]), 0, 3.1, 1e-6)
    assert len(half) == 1 and half.radii_mm == pytest.approx([7])
    line = fit_arcs(lambda t: np.column_stack([t, 2 * t]), 0, 5, 1e-6)
    assert len(line) == 1 and line.bulge[0] == 0


@pytest.mark.parametrize("tolerance_mm", [0.0, -1.0, math.nan])
def test_a_tolerance_that_is_none_is_refused(tolerance_mm: float) -> None:
    with pytest.raises(GeometryError, match="above 0"):
        fit_arcs(ellipse, 0, 1, tolerance_mm)


def test_what_is_no_curve_is_refused() -> None:
    with np.errstate(invalid="ignore"), pytest.raises(GeometryError, match="not smooth"):
        fit_arcs(lambda t: np.column_stack([t, np.where(t > 0.3, math.nan, 0.0)]), 0, 1, 0.01)


def test_what_is_smaller_than_the_tolerance_is_a_line() -> None:
    curve = fit_arcs(lambda t: np.column_stack([1e-4 * np.cos(t), 1e-4 * np.sin(t)]), 0, 6.0, 0.01)
    assert len(curve) == 1


def test_a_tolerance_below_rounding_is_refused() -> None:
    with pytest.raises(GeometryError):
        fit_arcs(ellipse, 0, 1, 1e-300)


def test_the_measure_sees_a_shifted_arc() -> None:
    curve = fit_arcs(ellipse, 0, math.pi / 2, 0.01)
    assert max(deviations_mm(curve.moved(0.02, 0.0), ellipse, 0, math.pi / 2)) > 0.015


def astroid(t: np.ndarray) -> np.ndarray:
    return np.column_stack([10 * np.cos(t) ** 3, 10 * np.sin(t) ** 3])


def vee(t: np.ndarray) -> np.ndarray:
    return np.column_stack([10 * t, 7 * np.abs(t - 0.3)])


def rounded_vee(t: np.ndarray) -> np.ndarray:
    return np.column_stack([10 * t, 7 * np.sqrt((t - 0.3) ** 2 + 1e-6)])


def rippled(t: np.ndarray) -> np.ndarray:
    return np.column_stack([10 * t, 0.3 * np.sin(32 * math.pi * t)])  # every even sample of 33 is on the line


@pytest.mark.parametrize(
    "function, first, last, corners",
    [
        (lambda t: np.column_stack([10 * t**2, 10 * t**3]), -1, 1, [0]),
        (astroid, 0, 2 * math.pi, [math.pi / 2, math.pi, 1.5 * math.pi]),
        (astroid, 2 * math.pi, 0, [1.5 * math.pi, math.pi, math.pi / 2]),
        (vee, -1, 1, [0.3]),
        (rounded_vee, -1, 1, []),
        (lambda t: np.column_stack([t - np.sin(t), 1 - np.cos(t)]), 1, 20, [2 * math.pi, 4 * math.pi, 6 * math.pi]),
        (thin_ellipse, 0, 2 * math.pi, []),
        (rippled, 0, 1, []),
    ],
    ids=["cusp", "astroid", "backwards", "corner", "bend", "cycloid", "smooth", "rippled"],
)
def test_corners_and_cusps_are_vertices(function, first: float, last: float, corners: list[float]) -> None:
    assert corner_parameters(function, first, last) == pytest.approx(corners, abs=1e-4)
    curve = fit_curve(function, first, last, 0.01)
    if corners:
        places = function(np.array(corners))
        assert np.hypot(*(curve.xy[:, None] - places).T).min(axis=1).max() < 1e-6
    assert max(deviations_mm(curve, function, first, last)) <= 0.01 + 2e-5


def test_a_corner_at_a_knot_is_that_knot() -> None:
    assert corner_parameters(vee, -1, 1, [0.3, 0.5]) == [0.3]
    assert fit_curve(vee, -1, 1, 0.01, [0.3, 0.5]).xy.tolist() == vee(np.array([-1, 0.3, 1])).tolist()


def test_a_bump_between_two_knots_is_seen() -> None:
    def bumped(t: np.ndarray) -> np.ndarray:
        return np.column_stack([100 * t, np.exp(-(((t - 0.4567) / 0.0005) ** 2))])

    knots = np.linspace(0, 1, 801).tolist()
    curve = fit_curve(bumped, 0, 1, 0.01, knots)
    assert np.abs(curve.distances_mm(bumped(np.linspace(0.45, 0.46, 4001)))).max() <= 0.01


def test_a_closed_curve_ends_on_its_start() -> None:
    assert fit_curve(ellipse, 0, 2 * math.pi, 0.01, closed=True).closed
