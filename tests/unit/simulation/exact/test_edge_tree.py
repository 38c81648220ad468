# SPDX-License-Identifier: LGPL-2.1-or-later
"""The nearest of many edges, compared with every distance that shapely finds."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from CNCStepper import kernels
from CNCStepper.simulation.exact.edge_tree import EdgeTree

SAME_MM = 1e-9
SEEDS = range(20)


def walk(random: np.random.Generator, count: int, step_mm: float) -> np.ndarray:
    """Return a way of edges, float64[n, 2, 2], some of them without length, some along an axis."""
    places = np.cumsum(random.normal(scale=step_mm, size=(count + 1, 2)), axis=0)
    level = random.random(count) < 0.2
    places[1:][level, 1] = places[:-1][level, 1]
    edges = np.stack([places[:-1], places[1:]], axis=1)
    points = random.random(count) < 0.1
    edges[points, 1] = edges[points, 0]
    return edges


def every_distance(edges: np.ndarray, others: np.ndarray) -> np.ndarray:
    """Return the distance of each of the others to each edge, float64[m, n]."""
    return shapely.distance(shapely.linestrings(others)[:, None], shapely.linestrings(edges)[None, :])


@pytest.mark.parametrize("seed", SEEDS)
def test_the_nearest_edge_of_edges_and_of_points(seed: int) -> None:
    random = np.random.default_rng(seed)
    edges = walk(random, int(random.integers(1, 120)), 2.0)
    others = walk(random, 80, random.choice([0.05, 3.0]))
    distances = every_distance(edges, others)
    found, away = EdgeTree(edges).nearest(others)
    assert np.abs(away - distances.min(axis=1)).max() < SAME_MM
    assert np.abs(distances[np.arange(len(others)), found] - away).max() < SAME_MM
    points = others[:, 0]
    from_points = shapely.distance(shapely.points(points)[:, None], shapely.linestrings(edges)[None, :])
    assert np.abs(EdgeTree(edges).distance(points) - from_points.min(axis=1)).max() < SAME_MM


def test_edges_that_cross_touch_and_lie_upon_each_other_are_no_distance_apart():
    tree = EdgeTree(np.array([[[0.0, 0], [10, 0]], [[0, 5], [10, 5]]]))
    crossing, touching, upon = [[3, -1], [3, 1]], [[4, 5], [4, 9]], [[2, 5], [20, 5]]
    _, away = tree.nearest(np.array([crossing, touching, upon, [[12, 0], [12, 1]]], float))
    assert away.tolist() == [0, 0, 0, 2]


def test_air_that_reaches_far_takes_no_precision():
    far = shapely.box(-1e5, -1e5, 1e5, 1e5).difference(shapely.box(0, 0, 100, 80))
    assert EdgeTree.of_geometry(far).distance(np.array([[50, 0.0125], [99.9, 40]])) == pytest.approx([0.0125, 0.1])


def test_where_nothing_is_compiled_shapely_answers_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    random = np.random.default_rng(5)
    edges, others = walk(random, 300, 1.0), walk(random, 200, 1.0)
    compiled = EdgeTree(edges).nearest(others)[1]
    monkeypatch.setattr(kernels, "compiles", lambda: False)
    assert np.abs(EdgeTree(edges).nearest(others)[1] - compiled).max() < SAME_MM


def test_no_edges_are_infinitely_far():
    none = EdgeTree(np.zeros((0, 2, 2)))
    assert none.nearest(np.zeros((2, 2, 2)))[1].tolist() == [np.inf, np.inf]
    assert len(none.nearest(np.zeros((0, 2, 2)))[0]) == 0
