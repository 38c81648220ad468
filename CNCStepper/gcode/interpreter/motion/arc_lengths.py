# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path length of every row of a table, and its angle about a centre."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from CNCStepper.toolpath import ARC_CW, LINE, PLANE_AXES, Chunk

FULL_TURN = 2.0 * np.pi


class Ways(NamedTuple):
    """Of every row, float64[n]. length_mm: NaN where it begins at a place that is not known.

    sweep_rad: of arcs, counter-clockwise positive, all turns; 0 on lines. radius_mm: of arcs where they begin.
    """

    length_mm: np.ndarray
    sweep_rad: np.ndarray
    radius_mm: np.ndarray


def ways_of(table: Chunk, begins: np.ndarray, ends: np.ndarray) -> Ways:
    """Return the ways of rows between these places, float64[n, 3], mm; the radius changes evenly along an arc."""
    way = ends - begins
    way[np.isnan(begins) & np.isnan(ends)] = 0.0
    flat_begin, flat_end = flat(table.plane, begins - table.centre), flat(table.plane, ends - table.centre)
    arcs = table.kind > LINE
    signs = np.where(table.kind == ARC_CW, -1.0, 1.0)
    angles = signs * angles_between(flat_begin, flat_end)
    whole = (flat_begin == flat_end).all(axis=1)
    angles = np.where((angles > 0) & ~whole, angles, angles + FULL_TURN)
    angles = np.where(whole, FULL_TURN, angles) + FULL_TURN * np.maximum(table.turns.astype(float) - 1.0, 0.0)
    radii = np.hypot(*flat_begin.T), np.hypot(*flat_end.T)
    normal = way[np.arange(len(way)), np.array(PLANE_AXES)[table.plane, 2]]
    round_mm = np.hypot(angles * (radii[0] + radii[1]) / 2.0, normal)
    straight_mm = np.sqrt((way * way).sum(axis=1))
    return Ways(
        np.where(arcs, round_mm, straight_mm), np.where(arcs, signs * angles, 0.0), np.where(arcs, radii[0], 0.0)
    )


def flat(planes: np.ndarray, vectors: np.ndarray) -> np.ndarray:
    """Return the two coordinates of vectors, float64[n, 3], in the plane of each."""
    return np.take_along_axis(vectors, np.array(PLANE_AXES)[planes, :2], axis=1)


def angles_between(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Return the angle from each vector, float64[n, 2], to another, counter-clockwise, in [-pi, pi]."""
    cross = one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]
    return np.arctan2(cross, (one * other).sum(axis=1))
