# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slow places of many paths at once are those of each path alone, and lie where arcs and corners are."""

from __future__ import annotations

import random

import numpy as np
import pytest

from CNCStepper.cycles.sheet_cutting.sheet_model import ArcRule, CornerRule
from CNCStepper.cycles.sheet_cutting.slow_places import slow_places
from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.geometry.shapes.rectangle import rectangle

KERF_MM = 1.5
ARCS, CORNERS = ArcRule(radius_mm=5.0), CornerRule(angle_deg=60.0, distance_mm=2.0)


def random_paths(seed: int) -> list[Curve]:
    """Return paths with and without corners and narrow arcs, open and closed."""
    rng = random.Random(seed)
    makers = (
        lambda: circle((rng.uniform(-50.0, 50.0), 0.0), rng.uniform(1.0, 12.0)),
        lambda: rectangle((0.0, 0.0), (rng.uniform(20.0, 60.0), rng.uniform(20.0, 60.0)), rng.choice([0.0, 0.75, 3.0])),
        lambda: from_points([(10.0 * number, rng.uniform(0.0, 30.0)) for number in range(5)]),
    )
    return [rng.choice(makers)() for _ in range(20)]


@pytest.mark.parametrize("seed", range(1, 9))
def test_many_paths_at_once_are_as_slow_as_each_alone(seed: int) -> None:
    paths = random_paths(seed)
    together = slow_places(paths, ARCS, CORNERS, KERF_MM, 1)
    alone = [slow_places([path], ARCS, CORNERS, KERF_MM, 1)[0] for path in paths]
    for one, other in zip(together, alone, strict=True):
        assert (one.shares == other.shares).all() and (one.corners == other.corners).all()
    kinds = {(path.closed, bool((one.shares < 1.0).any()), bool(len(one.corners)))
             for path, one in zip(paths, together, strict=True)}  # fmt: skip
    assert {(True, False, False), (True, True, False), (True, False, True), (False, False, True)} <= kinds, seed


def test_a_corner_is_slow_before_and_behind_and_an_open_path_turns_at_no_end() -> None:
    square, line = rectangle((0.0, 0.0), (40.0, 30.0)), from_points([(0.0, 0.0), (10.0, 0.0), (10.0, 20.0)])
    of_square, of_line = slow_places([square, line], None, CORNERS, KERF_MM, 1)
    assert np.sort(of_square.corners[:, 0]) == pytest.approx([-2.0, 38.0, 68.0, 108.0])
    assert of_line.corners.tolist() == [[8.0, 12.0]]
    assert (of_square.shares == 1.0).all()


def test_the_arc_round_a_corner_of_the_drawing_is_a_corner_no_narrow_arc() -> None:
    half_mm = KERF_MM / 2.0
    path = rectangle((-half_mm, -half_mm), (40.0 + half_mm, 30.0 + half_mm), half_mm).reversed()
    (found,) = slow_places([path], ARCS, CORNERS, KERF_MM, 1)
    assert (found.shares == 1.0).all() and len(found.corners) == 4
    assert np.diff(found.corners, axis=1) == pytest.approx(4.0 + np.pi / 2.0 * half_mm)
