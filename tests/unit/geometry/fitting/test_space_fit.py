# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points in space as few lines, arcs and helices."""

from __future__ import annotations

import math

import numpy as np
import pytest

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.fitting.space_fit import fit_space, is_straight, serves_points, straight


def helix(count: int, rise: float) -> np.ndarray:
    angle = np.linspace(0.0, 3.0, count)
    return np.column_stack([5 * np.cos(angle), 5 * np.sin(angle), rise * angle])


@pytest.mark.parametrize("plane", [0, 1, 2])
def test_a_circle_in_each_plane_is_one_arc(plane: int) -> None:
    points = np.roll(helix(100, 0.0), plane, axis=1)
    (piece,) = fit_space(points, 0.01)
    assert piece.last == 99
    assert piece.plane == {0: 0, 1: 2, 2: 1}[plane]
    assert abs(piece.bulge) == pytest.approx(math.tan(3.0 / 4.0), rel=1e-3)
    assert serves_points(points, piece.plane, piece.bulge, 0.01)
    assert not serves_points(points, piece.plane, 0.9 * piece.bulge, 0.01)


def test_a_helix_and_an_uneven_rise() -> None:
    (piece,) = fit_space(helix(200, 0.7), 0.01)
    assert piece.bulge == pytest.approx(math.tan(3.0 / 4.0), rel=1e-3)
    uneven = helix(200, 0.7)
    uneven[:, 2] = uneven[:, 2] ** 2
    pieces = fit_space(uneven, 0.01)
    assert len(pieces) > 1
    assert not serves_points(uneven, 0, piece.bulge, 0.01)


def test_straight_in_space_and_never_back() -> None:
    way = np.linspace(0, 1, 50)[:, None] * [3.0, 2.0, 1.0]
    assert fit_space(way, 0.01) == straight(way, 0.01)
    assert [piece.last for piece in straight(way, 0.01)] == [49]
    there_and_back = np.vstack([way, way[::-1][1:]])
    assert not is_straight(there_and_back[:80], 0.01)


def test_a_tolerance_is_above_zero() -> None:
    with pytest.raises(GeometryError):
        fit_space(helix(5, 0.0), 0.0)
