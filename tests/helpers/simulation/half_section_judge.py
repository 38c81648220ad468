# SPDX-License-Identifier: LGPL-2.1-or-later
"""An independent judge of turned parts: points on a grid, each tried against the tool at many places of each move.

It shares nothing with the simulation: no shapely, no hulls; a point is in an outline by the crossing rule.
"""

from __future__ import annotations

import itertools

import numpy as np


def inside(points: np.ndarray, outline: np.ndarray) -> np.ndarray:
    """Return which points, float64[n, 2], lie in a closed outline, float64[k, 2], by counting crossings."""
    within = np.zeros(len(points), bool)
    for (z0, r0), (z1, r1) in zip(outline, np.roll(outline, -1, axis=0), strict=True):
        spans = (r0 > points[:, 1]) != (r1 > points[:, 1])
        with np.errstate(divide="ignore", invalid="ignore"):
            at = z0 + (points[:, 1] - r0) * (z1 - z0) / (r1 - r0)
        within ^= spans & (points[:, 0] < at)
    return within


def cut_points(points: np.ndarray, outline: np.ndarray, path: np.ndarray, step_mm: float) -> np.ndarray:
    """Return which points a tool on a polyline of control points, float64[m, 2], cuts, at places `step_mm` apart."""
    gone = np.zeros(len(points), bool)
    for begin, end in itertools.pairwise(path):
        for share in np.linspace(0, 1, max(2, int(np.hypot(*(end - begin)) / step_mm) + 2)):
            rest = np.flatnonzero(~gone)
            gone[rest] |= inside(points[rest] - (begin + (end - begin) * share), outline)
    return gone
