# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arcs along a parametric curve: within the tolerance both ways, measured densely by shapely."""

from __future__ import annotations

import math

import numpy as np
import pytest
from shapely import LineString, points, prepare

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.fit import fit_arcs


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
