# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many chains of lines and arcs in three columns: what kernels take and give.

xy      float64[n + c, 2]   the vertices of all chains, each with its last one; a closed one ends where it begins
bulge   float64[n]          of all segments, as those of a Curve
counts  int64[c]            how many segments each chain has
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from CNCStepper.geometry.arc_length import area_of
from CNCStepper.geometry.box_tree import WIDTH, rows_of
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.curve_columns import require_lengths
from CNCStepper.kernels import njit
from CNCStepper.tolerances import COINCIDENT_MM


class Bundle(NamedTuple):
    """The columns; see the module's text."""

    xy: np.ndarray
    bulge: np.ndarray
    counts: np.ndarray

    @property
    def first(self) -> np.ndarray:
        """The first segment of each chain, int64[c]; add the chain's number for its first vertex."""
        return np.cumsum(self.counts) - self.counts

    @property
    def closed(self) -> np.ndarray:
        """Which chains end where they begin, bool[c]."""
        last = np.cumsum(self.counts + 1) - 1
        return np.hypot(*(self.xy[last] - self.xy[last - self.counts]).T) <= COINCIDENT_MM

    def reversed(self) -> Bundle:
        """Return the chains run backwards, the last one first."""
        return Bundle(self.xy[::-1].copy(), -self.bulge[::-1], self.counts[::-1].copy())

    def where(self, which: np.ndarray) -> Bundle:
        """Return some of the chains, bool[c]."""
        if which.all():
            return self
        vertices, segments = np.repeat(which, self.counts + 1), np.repeat(which, self.counts)
        return Bundle(self.xy[vertices], self.bulge[segments], self.counts[which])

    def taken(self, rows: np.ndarray) -> Bundle:
        """Return the chains of these numbers, int64[k], in their order."""
        if np.array_equal(rows, np.arange(len(self.counts))):
            return self
        counts = self.counts[rows]
        return Bundle(
            self.xy[runs(self.first[rows] + rows, counts + 1)], self.bulge[runs(self.first[rows], counts)], counts
        )

    def blocks(self, most: int) -> Iterator[Bundle]:
        """Yield the chains in bundles of at most so many, which share the columns."""
        first = self.first
        for begin in range(0, len(self.counts), most):
            counts = self.counts[begin : begin + most]
            segment, segments, vertex = int(first[begin]), int(counts.sum()), int(first[begin]) + begin
            yield Bundle(
                self.xy[vertex : vertex + segments + len(counts)], self.bulge[segment : segment + segments], counts
            )

    def curves(self) -> list[Curve]:
        """Return the chains as curves; raises GeometryError where a coordinate is no length in mm."""
        require_lengths(self.xy)
        found, first = [], 0
        for number, count in enumerate(self.counts.tolist()):
            begin = first + number
            found.append(Curve.trusted(self.xy[begin : begin + count + 1], self.bulge[first : first + count]))
            first += count
        return found


def runs(first: np.ndarray, counts: np.ndarray) -> np.ndarray:
    """Return the numbers first, first + 1 ... of each run, `counts` of them, one run after the other."""
    return np.arange(counts.sum()) + np.repeat(first - (np.cumsum(counts) - counts), counts)


def bundles_joined(bundles: Sequence[Bundle]) -> Bundle:
    """Return the chains of bundles as one; none of no bundles."""
    if not bundles:
        return Bundle(np.empty((0, 2)), np.empty(0), np.empty(0, int))
    return bundles[0] if len(bundles) == 1 else Bundle(*map(np.concatenate, zip(*bundles, strict=True)))


def bundle_of(curves: Sequence[Curve]) -> Bundle:
    """Return curves as a bundle."""
    xy = np.ascontiguousarray(np.concatenate([curve.xy for curve in curves]))
    bulge = np.concatenate([curve.bulge for curve in curves])
    return Bundle(xy, bulge, np.array([len(curve) for curve in curves]))


@njit
def areas(xy, bulge, counts):
    """Return the signed area of each chain of a bundle, float64[c]."""
    found, first = np.empty(len(counts)), 0
    for chain in range(len(counts)):
        last = first + counts[chain]
        found[chain] = area_of(xy[first + chain : last + chain + 1], bulge[first:last])
        first = last
    return found


@njit
def bundled_rows(xy, bulge, counts):
    """Return the rows of all chains of a bundle (box_tree.py), float64[n, 11]."""
    rows, first = np.empty((len(bulge), WIDTH)), 0
    for chain in range(len(counts)):
        last = first + counts[chain]
        rows[first:last] = rows_of(xy[first + chain : last + chain + 1], bulge[first:last])
        first = last
    return rows


@njit
def long_enough(xy, bulge, shortest_mm):
    """Return which segments of a chain stay when a run of short ones becomes one as soon as it is long enough."""
    keep, run_mm = np.zeros(len(bulge), np.bool_), 0.0
    for row in range(len(bulge)):
        chord_mm = math.hypot(xy[row + 1, 0] - xy[row, 0], xy[row + 1, 1] - xy[row, 1])
        half = 2.0 * math.atan(abs(bulge[row]))
        run_mm += chord_mm * half / math.sin(half) if half > 0.0 else chord_mm
        if run_mm > shortest_mm:
            keep[row], run_mm = True, 0.0
    return keep


@njit
def short_ones(xy, bulge, counts, shortest_mm):
    """Return which segments of the chains of a bundle go when runs of short ones are joined up, bool[n].

    Of a chain that would keep less than three, none goes.
    """
    short, first = np.zeros(len(bulge), np.bool_), 0
    for chain in range(len(counts)):
        last = first + counts[chain]
        keep = long_enough(xy[first + chain : last + chain + 1], bulge[first:last], shortest_mm)
        if keep.sum() >= 3:
            short[first:last] = ~keep
        first = last
    return short
