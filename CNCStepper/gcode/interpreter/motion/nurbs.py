# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves of weighted control points (NURBS), and the points on them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

LEAST_ORDER = 3


class Nurbs(NamedTuple):
    """The control points of a G5.2 so far, in work mm, their weights and the order."""

    points: tuple[tuple[float, float], ...]
    weights: tuple[float, ...]
    order: int = LEAST_ORDER


def nurbs_knots(nurbs: Nurbs) -> np.ndarray:
    """Return the knots, float64[points + order]: whole steps, `order` times each end (LinuxCNC's choice)."""
    steps = np.arange(len(nurbs.points) + nurbs.order, dtype=float) - (nurbs.order - 1)
    return np.clip(steps, 0.0, len(nurbs.points) - nurbs.order + 1)


def nurbs_points(nurbs: Nurbs, at: np.ndarray) -> np.ndarray:
    """Return points of the curve, float64[m, 2], by de Boor's recursion of basis functions (Piegl, Tiller 1997)."""
    knots, count = nurbs_knots(nurbs), len(nurbs.points)
    at = np.asarray(at, float)
    inside = np.minimum(at, np.nextafter(knots[-1], 0.0))  # the last point belongs to the last span
    basis = [((knots[i] <= inside) & (inside < knots[i + 1])).astype(float) for i in range(len(knots) - 1)]
    for degree in range(1, nurbs.order):
        basis = [
            _share(at - knots[i], knots[i + degree] - knots[i]) * basis[i]
            + _share(knots[i + degree + 1] - at, knots[i + degree + 1] - knots[i + 1]) * basis[i + 1]
            for i in range(len(basis) - 1)
        ]
    weighted = np.array(basis[:count]) * np.array(nurbs.weights)[:, None]
    return (weighted.T @ np.array(nurbs.points)) / weighted.sum(axis=0)[:, None]


def _share(part: np.ndarray, whole: float) -> np.ndarray:
    return part / whole if whole else np.zeros_like(part)
