# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges of a solid as curves: exact, in one order however they come, splines judged by ezdxf's B-spline."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from ezdxf.math import BSpline, Vec3

from CNCStepper.drawing.solids.edge_curves import loops_of
from CNCStepper.errors import JobError

TOLERANCE_MM = 0.005
SEEDS = range(20)


def arc(centre: tuple[float, float], radius: float, first: float, last: float) -> list[Any]:
    return ["ellipse", *centre, radius, 0.0, 0.0, radius, first, last]


SLOT = [
    ["line", -5.0, -2.0, 5.0, -2.0],
    arc((5, 0), 2, -math.pi / 2, math.pi / 2),
    ["line", 5.0, 2.0, -5.0, 2.0],
    arc((-5, 0), 2, math.pi / 2, 3 * math.pi / 2),
]


def divided(edge: list[Any], share: float) -> list[list[Any]]:
    kind, *values = edge
    if kind == "line":
        x, y = (values[axis] + share * (values[axis + 2] - values[axis]) for axis in (0, 1))
        return [["line", *values[:2], x, y], ["line", x, y, *values[2:]]]
    middle = values[6] + share * (values[7] - values[6])
    return [["ellipse", *values[:7], middle], ["ellipse", *values[:6], middle, values[7]]]


def turned(edge: list[Any]) -> list[Any]:
    """Return an edge from its end to its begin."""
    kind, *values = edge
    if kind == "line":
        return ["line", *values[2:], *values[:2]]
    x, y, ax, ay, bx, by, first, last = values
    return ["ellipse", x, y, ax, ay, -bx, -by, -last, -first]


@pytest.mark.parametrize("seed", SEEDS)
def test_edges_divided_turned_and_mixed_give_the_same_chains(seed: int) -> None:
    rng = np.random.default_rng(seed)
    drawn = [*SLOT, arc((0, 0), 1, 0, math.tau), ["line", 20.0, 0.0, 21.0, 1.0]]
    edges = [part for edge in drawn for part in (divided(edge, 0.37) if rng.random() < 0.5 else [edge])]
    edges = [turned(edge) if rng.random() < 0.5 else edge for edge in edges]
    found = loops_of([edges[index] for index in rng.permutation(len(edges))], TOLERANCE_MM)
    meant = loops_of(drawn, TOLERANCE_MM)
    assert [len(chain) for chain in found] == [len(chain) for chain in meant] == [4, 2, 1], f"seed {seed}"
    for own, other in zip(found, meant, strict=True):
        assert own.xy == pytest.approx(other.xy, abs=1e-9) and own.bulge == pytest.approx(other.bulge, abs=1e-9)
    slot, hole, _ = found
    assert slot.area_mm2 == pytest.approx(40 + 4 * math.pi) and hole.area_mm2 == pytest.approx(math.pi)


def test_a_circle_seen_from_below_is_the_same_circle() -> None:
    above = loops_of([arc((1, 2), 3, 0, math.tau)], TOLERANCE_MM)
    below = loops_of([["ellipse", 1.0, 2.0, 0.0, 3.0, 3.0, 0.0, 0.0, math.tau]], TOLERANCE_MM)
    assert above == below


def test_an_ellipse_and_a_rational_spline_are_within_the_tolerance() -> None:
    (oval,) = loops_of([["ellipse", 1.0, 2.0, 9.0, 0.0, 0.0, 4.0, 0.0, math.tau]], TOLERANCE_MM)
    t = np.linspace(0, math.tau, 3001)
    assert oval.closed and oval.distances_mm(np.column_stack([1 + 9 * np.cos(t), 2 + 4 * np.sin(t)])).max() <= 0.005
    poles, weights = [(0, 0), (5, 9), (10, -9), (15, 9), (20, 0)], [1, 2, 0.5, 3, 1]
    knots = [0, 0, 0, 0, 1, 2, 2, 2, 2]
    (curve,) = loops_of([["spline", 3, poles, weights, knots]], TOLERANCE_MM)
    judge = BSpline([Vec3(*pole) for pole in poles], 4, knots, weights)
    places = np.array([(point.x, point.y) for point in judge.points(np.linspace(0, 2, 3001).tolist())])
    assert curve.distances_mm(places).max() <= TOLERANCE_MM
    assert curve.xy[0] == pytest.approx(places[0]) and curve.xy[-1] == pytest.approx(places[-1])


@pytest.mark.parametrize(
    "edge",
    [
        ["line", 0, 0, 1],
        ["line", 0, 0, "one", 1],
        ["line", 0, 0, math.nan, 1],
        ["helix", 0],
        [],
        ["spline", 3, [(0, 0)], [1], [0, 1]],
        ["spline", 99, [(0, 0)] * 100, [1] * 100, list(range(200))],
    ],
)
def test_what_is_no_edge_is_refused(edge: list[Any]) -> None:
    with pytest.raises((JobError, ValueError)):
        loops_of([edge], TOLERANCE_MM)
