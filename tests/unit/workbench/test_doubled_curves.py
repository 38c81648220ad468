# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves that are drawn along others are found, whatever their arcs; judged by the distances of all pairs."""

from __future__ import annotations

import numpy as np
import pytest

from CNCStepper.geometry.curve import Curve
from CNCStepper.tolerances import SAME_CURVE_MM
from CNCStepper.workbench.drawings.joined_curves import _doubled

SEEDS = range(40)
PLACES = 50


def random_curves(rng: np.random.Generator) -> list[Curve]:
    """Return open curves of lines and arcs up to nearly whole circles, and stretches of some of them."""
    curves = []
    for _ in range(6):
        bulge = rng.choice([0.0, 0.4, -1.0, 6.0, -15.0], 3) * rng.uniform(0.5, 1.0, 3)
        curves.append(Curve(rng.uniform(-20.0, 20.0, (4, 2)), bulge))
    for whole in rng.choice(6, 3, replace=False):
        first_mm, last_mm = np.sort(rng.uniform(0.0, curves[whole].length_mm, 2))
        part = curves[whole].part(first_mm, last_mm)
        curves.append(part.reversed() if rng.random() < 0.5 else part)
        curves.append(part.moved(0.0, 3 * SAME_CURVE_MM))  # which is near to it and not along it
    return curves


def doubled_by_all_pairs(curves: list[Curve]) -> set[int]:
    found: set[int] = set()
    order = sorted(range(len(curves)), key=lambda number: (-round(curves[number].length_mm, 2), number))
    for place, number in enumerate(order):
        places, _ = curves[number].at_length(np.linspace(0.0, curves[number].length_mm, PLACES))
        longer = [curves[other] for other in order[:place] if other not in found]
        if any(other.distances_mm(places).max() < SAME_CURVE_MM for other in longer):
            found.add(number)
    return found


@pytest.mark.parametrize("seed", SEEDS)
def test_what_is_drawn_along_another_curve_is_found(seed: int) -> None:
    curves = random_curves(np.random.default_rng(seed))
    found = _doubled(curves)
    assert set(found) == doubled_by_all_pairs(curves)
    assert len(found) >= 3


def test_the_random_stretches_leave_the_box_of_their_curves_vertices() -> None:
    outside = 0
    for seed in SEEDS:
        curves = random_curves(np.random.default_rng(seed))
        for out, kept in _doubled(curves).items():
            low, high = curves[kept].xy.min(axis=0), curves[kept].xy.max(axis=0)
            outside += bool((curves[out].xy < low - 1.0).any() or (curves[out].xy > high + 1.0).any())
    assert outside > len(SEEDS) / 2
