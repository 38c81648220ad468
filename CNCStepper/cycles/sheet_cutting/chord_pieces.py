# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many curves as short runs of chords in one search tree, for exact bounds on distances between thousands of them.

A run has at most RUN chords, so that a query looks at few of them, however long a curve is. A distance measured to the
runs differs from that to the curves by at most FLAT_MM.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np
import shapely

from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.curve_columns import Segments, xy_of

RUN = 12  # chords
FLAT_MM = 0.001


class ChordPieces:
    """Runs of chords of some curves; owner: int64[n], the number of the curve of each run, as given by `owners`.

    chords: the points of each whole curve by its number.
    """

    def __init__(self, curves: Sequence[Curve], owners: Sequence[int] | None = None):
        numbers = list(range(len(curves)) if owners is None else owners)
        self.chords = dict(zip(numbers, points_of(curves, FLAT_MM), strict=True))
        parts = [_runs(self.chords[number]) for number in numbers]
        counts = [int(runs[-1]) + 1 for _, runs in parts]
        self.owner = np.repeat(np.array(numbers, np.int64), counts)
        if not parts:
            self.lines = np.zeros(0, object)
            return
        first = np.cumsum([0, *counts[:-1]])
        coords = np.concatenate([coords for coords, _ in parts])
        index = np.concatenate([runs + begin for (_, runs), begin in zip(parts, first, strict=True)])
        self.lines = shapely.linestrings(coords, indices=index)

    @cached_property
    def tree(self) -> shapely.STRtree:
        """The search tree over the runs."""
        return shapely.STRtree(self.lines)

    def near(self, shapes: np.ndarray, distance_mm: float | np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return pairs of a shape and a run that is within a distance of it, int64[k] both."""
        if not len(self.lines) or not len(shapes):
            return np.zeros(0, np.int64), np.zeros(0, np.int64)
        found = self.tree.query(shapes, predicate="dwithin", distance=distance_mm)
        return found[0], found[1]

    def pairs(self, distance_mm: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the pairs of different curves within a distance, once each, and how far runs of theirs are apart.

        A pair of curves may come several times, with the distance of other runs.
        """
        one, other = self.near(self.lines, distance_mm)
        first, second = self.owner[one], self.owner[other]
        once = first < second
        return first[once], second[once], shapely.distance(self.lines[one[once]], self.lines[other[once]])


def points_of(curves: Sequence[Curve], flat_mm: float) -> list[np.ndarray]:
    """Return points on each curve, float64[m, 2], whose chords stay within flat_mm of it; all curves at once."""
    if not curves:
        return []
    segments = Segments(*(np.concatenate(column) for column in zip(*(curve.segments for curve in curves), strict=True)))
    share = np.minimum(flat_mm * np.abs(segments.curvature) / 2.0, 1.0)
    steps = np.maximum(4.0 * np.arcsin(np.sqrt(share)), 1e-6)
    counts = np.where(segments.sweep, np.maximum(np.ceil(np.abs(segments.sweep) / steps), 2.0), 1.0).astype(int)
    _, parts = segments.divided(counts)
    ends, first = xy_of(parts.end), np.cumsum([0, *(len(curve) for curve in curves)])
    bounds = np.concatenate([[0], np.cumsum(counts)])[first]
    return [
        np.vstack([curve.xy[:1], ends[begin:end]])
        for curve, begin, end in zip(curves, bounds[:-1].tolist(), bounds[1:].tolist(), strict=True)
    ]


def _runs(chords: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the points of a chain, those between two runs twice, and the run of each."""
    count = len(chords) - 1
    runs = max(-(-count // RUN), 1)
    run = np.minimum(np.arange(count) // RUN, runs - 1)
    doubled = np.concatenate([[0], np.flatnonzero(np.diff(run)) + 1])
    take = np.sort(np.concatenate([np.arange(count + 1), doubled[1:]]))
    number = np.zeros(len(take), np.int64)
    number[np.searchsorted(take, doubled[1:], side="right") - 1] = 1
    return chords[take], np.cumsum(number)
