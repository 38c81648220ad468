# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many paths of lines, cubic Bezier curves and arcs in a few columns, and the curves of lines and arcs along them.

    points    complex128[n + k]      the vertices of k paths, one path after the other
    controls  complex128[n, 2]       the two control points of each segment; those of a line or arc are not used
    bulge     float64[n]             of a line 0, of an arc as in curve.py, of a Bezier curve NaN
    sizes     int64[k]               the segments of each path, at least one

Lines and arcs come over exactly. Bezier curves are sampled so finely that their chords stay within CHORD_SHARE of the
tolerance, and the rest of it goes to point_fit's lines and arcs. The number of samples for n chords of a cubic follows
from its second differences: a chord's error is at most |B''| / (8 n²) with |B''| <= 6 max |second difference|.

    paths ──► sound ones ──► groups of at most GROUP_SAMPLES ──► samples, breaks at corners ──► one call of the kernel
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.curve_bundle import Bundle, bundles_joined
from CNCStepper.geometry.curve_columns import LIMIT_MM, STRAIGHT_MM, xy_of
from CNCStepper.geometry.fitting.fit_kernels import fit_stretches, sampled

CHORD_SHARE = 0.1  # of the tolerance: what the chords of the samples may take
SURE = 1.0 - 1e-9  # of the tolerance: what the kernel computes is rounded
SMOOTH_RAD = 0.01  # two Bezier curves that meet at a larger angle have a corner there
MOST_SAMPLES = 300_000  # of one path
MOST_SAMPLES_OF_ALL = 6_000_000  # of one drawing
GROUP_SAMPLES = 65_536  # of the paths that are sampled together: some 3 MB


class SampleBudget:
    """Counts the samples of all paths of a drawing, of which there is a bounded number: half a minute."""

    def __init__(self, most: int = MOST_SAMPLES_OF_ALL):
        self._left = most

    def take(self, count: int) -> None:
        """Count these too; raises GeometryError where they are too many with those before."""
        self._left -= count
        if self._left < 0:
            raise GeometryError(
                "fit-budget",
                "the curves of the drawing are too many and too wild for the tolerance",
                advice="take a larger tolerance, or draw lines or arcs in their place",
            )


class PathColumns(NamedTuple):
    """Columns of paths; see the module's text."""

    points: np.ndarray
    controls: np.ndarray
    bulge: np.ndarray
    sizes: np.ndarray

    @property
    def first(self) -> np.ndarray:
        """The first segment of each path, int64[k]."""
        return np.cumsum(self.sizes) - self.sizes

    @property
    def path(self) -> np.ndarray:
        """The path of each segment, int64[n]."""
        return np.repeat(np.arange(len(self.sizes)), self.sizes)

    @property
    def ends(self) -> tuple[np.ndarray, np.ndarray]:
        """Where each segment begins and ends, complex128[n] both."""
        begin = np.arange(len(self.bulge)) + self.path
        return self.points[begin], self.points[begin + 1]

    def some(self, kept: np.ndarray) -> PathColumns:
        """Return the paths for which `kept`, bool[k], is true."""
        segments = np.repeat(kept, self.sizes)
        vertices = np.repeat(kept, self.sizes + 1)
        return PathColumns(self.points[vertices], self.controls[segments], self.bulge[segments], self.sizes[kept])

    def curves(self, tolerance_mm: float, budget: SampleBudget | None = None) -> list[Curve | GeometryError]:
        """Return what `bundle` does, a curve or an error for each path."""
        bundle, errors = self.bundle(tolerance_mm, budget)
        curves = iter(bundle.curves())
        return [errors[number] if number in errors else next(curves) for number in range(len(self.sizes))]

    def bundle(
        self, tolerance_mm: float, budget: SampleBudget | None = None
    ) -> tuple[Bundle, dict[int, GeometryError]]:
        """Return lines and arcs along the paths, mm, within `tolerance_mm` of them, and why some have none, by number.

        Raises GeometryError where the samples of all are more than the budget has.
        """
        wanted, state = self._wanted(CHORD_SHARE * tolerance_mm)
        sound = state == SOUND
        errors = {number: _refusal(int(state[number])) for number in np.flatnonzero(~sound).tolist()}
        if not sound.any():
            return bundles_joined([]), errors
        paths = self if sound.all() else self.some(sound)
        counts = np.maximum(np.ceil(wanted[np.repeat(sound, self.sizes)]), 1.0).astype(np.int64)
        if budget is not None:
            budget.take(int(counts[np.isnan(paths.bulge)].sum()))
        bundles, fine = zip(*paths._in_groups(counts, tolerance_mm), strict=True)
        bundle, kept = bundles_joined(bundles), np.concatenate(fine)
        numbers = np.flatnonzero(sound)
        for row in np.flatnonzero(~kept).tolist():
            errors[int(numbers[row])] = _no_curve(bundle.taken(np.array([row])))
        return bundle.where(kept), errors

    def _wanted(self, chord_error_mm: float) -> tuple[np.ndarray, np.ndarray]:
        """Return into how many chords each segment is to be cut, float64[n], and the state of each path, int64[k]."""
        (p0, p3), c1, c2 = self.ends, self.controls[:, 0], self.controls[:, 1]
        first = self.first
        with np.errstate(invalid="ignore", over="ignore"):
            bend = np.maximum(np.abs(p0 - 2.0 * c1 + c2), np.abs(c1 - 2.0 * c2 + p3))
            wanted = np.where(np.isnan(self.bulge), np.sqrt(0.75 * bend / chord_error_mm), 1.0)
            near = np.abs(self.points) <= 2.0 * LIMIT_MM
        is_near = np.logical_and.reduceat(near, first + np.arange(len(first)))
        is_short = np.add.reduceat(wanted, first) <= MOST_SAMPLES  # not for NaN
        return wanted, np.where(is_near, np.where(is_short, SOUND, LARGE), FAR)

    def _in_groups(self, counts: np.ndarray, tolerance_mm: float) -> Iterator[tuple[Bundle, np.ndarray]]:
        """Yield what `_fitted` returns of sound paths, sampled together in groups that need little memory."""
        group = np.cumsum(np.add.reduceat(counts, self.first)) // GROUP_SAMPLES
        for number in np.unique(group).tolist():
            kept = group == number
            own = self if kept.all() else self.some(kept)
            yield own._fitted(counts[np.repeat(kept, self.sizes)], tolerance_mm)

    def _fitted(self, counts: np.ndarray, tolerance_mm: float) -> tuple[Bundle, np.ndarray]:
        """Return the curve of each path, and which of them are in bounds, bool[k].

        `counts`, int64[n], says into how many chords their segments are cut.
        """
        z, starts, last = sampled(self.points, self.controls, self.sizes, counts)
        stops = ~self._is_smooth()
        breaks = np.sort(np.concatenate([starts, last[stops]]))
        ends, bulges = fit_stretches(z, breaks, (1.0 - CHORD_SHARE) * tolerance_mm * SURE)
        arcs = np.flatnonzero(~np.isnan(self.bulge) & (self.bulge != 0.0))
        bulges[np.searchsorted(ends, last[arcs])] = self.bulge[arcs]
        vertices = np.concatenate([[0], ends])
        xy = xy_of(z[vertices])
        rises_mm = np.abs(bulges) * np.abs(np.diff(z[vertices])) / 2.0
        bulges = np.where(rises_mm > STRAIGHT_MM, bulges, 0.0)
        begins = np.searchsorted(vertices, starts)
        finishes = np.searchsorted(vertices, last[self.first + self.sizes - 1])
        is_near = np.logical_and.reduceat((np.abs(xy) <= LIMIT_MM).all(axis=1), begins)
        is_round = np.logical_and.reduceat(rises_mm <= LIMIT_MM, begins)
        between = finishes[:-1]  # from the end of a path to the begin of the next one
        return Bundle(xy, np.delete(bulges, between), finishes - begins), is_near & is_round

    def _is_smooth(self) -> np.ndarray:
        """Return which segments are Bezier curves that go on smoothly in a next one of their path, bool[n]."""
        curved, path = np.isnan(self.bulge), self.path
        smooth = np.zeros(len(curved), bool)
        smooth[:-1] = curved[:-1] & curved[1:] & (path[:-1] == path[1:]) & ~self._corners()
        return smooth

    def _corners(self) -> np.ndarray:
        """Return at which inner vertices the direction jumps, bool[n - 1]; controls on their own ends look through."""
        (p0, p3), c1, c2 = self.ends, self.controls[:, 0], self.controls[:, 1]
        leaves = np.where(c1 != p0, c1, np.where(c2 != p0, c2, p3)) - p0
        arrives = p3 - np.where(c2 != p3, c2, np.where(c1 != p3, c1, p0))
        return np.asarray(np.abs(np.angle(leaves[1:] * np.conj(arrives[:-1]))) > SMOOTH_RAD)


SOUND, FAR, LARGE = range(3)


def _refusal(state: int) -> GeometryError:
    if state == LARGE:
        return GeometryError("fit-large", "a path is too long for its tolerance", advice="take a larger tolerance")
    advice = "draw it larger, or leave it out"
    return GeometryError("curve-range", "a path has no length, or a coordinate that is no length in mm", advice=advice)


def _no_curve(path: Bundle) -> GeometryError:
    """Return why a path that is out of bounds is no curve."""
    try:
        Curve(path.xy, path.bulge)
    except GeometryError as error:
        return error
    return _refusal(FAR)  # out of bounds by a rounding
