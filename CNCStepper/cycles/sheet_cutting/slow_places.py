# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the rules for narrow arcs and corners slow paths down, for all paths at once: a sheet has thousands."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from CNCStepper.cycles.sheet_cutting.sheet_model import ArcRule, CornerRule
from CNCStepper.geometry.curve import Curve

NONE_MM = 0.01  # a drawn arc of a smaller radius is a corner
LEAST_BEND = 1e-9  # 1/mm: what bends less is a line
SWEEP, BEND, AHEAD, BEHIND = 4, 5, slice(6, 8), slice(8, 10)  # columns of rows; see geometry/box_tree.py


@dataclass(frozen=True)
class SlowPlaces:
    """Where a path is slow. shares: of the feed, by its arcs, float64[n], one a segment; 1 for full feed.

    corners: the stretches round corners, float64[k, 2], lengths from the path's start; they may lie beyond its ends.
    """

    shares: np.ndarray
    corners: np.ndarray


def slow_places(
    paths: Sequence[Curve], arcs: ArcRule | None, corners: CornerRule | None, kerf_mm: float, side: int
) -> list[SlowPlaces]:
    """Return where each path is slow; side: +1 where the part lies right of the paths."""
    if not (arcs and arcs.radius_mm) and not (corners and corners.angle_deg):
        return [SlowPlaces(np.ones(len(path)), np.zeros((0, 2))) for path in paths]
    rows = np.concatenate([path.rows for path in paths])
    ends = np.cumsum([len(path) for path in paths])
    radii = _drawn_radii_mm(rows[:, BEND], kerf_mm, side)
    shares = np.ones(len(rows))
    if arcs and arcs.radius_mm:
        shares[(radii < arcs.radius_mm) & (radii >= NONE_MM)] = arcs.feed_share
    near = [np.zeros((0, 2))] * len(paths)
    if corners and corners.angle_deg:
        near = _corner_stretches(paths, rows, ends, radii < NONE_MM, corners)
    begins = [0, *ends[:-1].tolist()]
    return [SlowPlaces(shares[first:last], stretches)
            for first, last, stretches in zip(begins, ends.tolist(), near, strict=True)]  # fmt: skip


def _corner_stretches(
    paths: Sequence[Curve], rows: np.ndarray, ends: np.ndarray, tight: np.ndarray, rule: CornerRule
) -> list[np.ndarray]:
    """Return the stretches round the corners of each path; tight: which rows are arcs round a corner of the drawing."""
    counts = np.diff(ends, prepend=0)
    cosines = _turn_cosines(paths, rows, ends - counts, ends - 1)
    before = np.concatenate([path.before_mm[:-1] for path in paths])
    turning = tight & (np.abs(rows[:, SWEEP]) > math.radians(rule.angle_deg))
    sharp = cosines < math.cos(math.radians(rule.angle_deg))
    found = np.flatnonzero(turning | sharp)
    from_mm, to_mm = before[found], before[found] + np.where(turning[found], rows[found, 10], 0.0)
    stretches = np.column_stack([from_mm - rule.distance_mm, to_mm + rule.distance_mm])
    bounds = np.searchsorted(found, [0, *ends.tolist()]).tolist()
    return [stretches[first:last] for first, last in itertools.pairwise(bounds)]


def _turn_cosines(paths: Sequence[Curve], rows: np.ndarray, first: np.ndarray, last: np.ndarray) -> np.ndarray:
    """Return the cosine of the turn at the begin of each row; 1 at the begin of an open path. first, last: rows."""
    before = np.arange(len(rows)) - 1
    before[first] = last
    cosines = np.asarray((rows[:, AHEAD] * rows[before, BEHIND]).sum(axis=1))
    cosines[first[[not path.closed for path in paths]]] = 1.0
    return cosines


def _drawn_radii_mm(bends: np.ndarray, kerf_mm: float, side: int) -> np.ndarray:
    """Return the radius of the drawn arc to which each arc of a path is parallel; huge for lines."""
    radii = 1.0 / np.maximum(np.abs(bends), LEAST_BEND)
    return np.asarray(radii + np.where(bends * side < 0.0, -1.0, 1.0) * kerf_mm / 2.0)
