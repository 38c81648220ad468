# SPDX-License-Identifier: LGPL-2.1-or-later
"""BezierPath: a connected path of lines, cubic Bezier curves and arcs, and the curve of lines and arcs along it.

    points    complex128[n + 1]      the vertices
    controls  complex128[n, 2]       the two control points of each segment; those of a line or arc are not used
    bulge     float64[n]             of a line 0, of an arc as in curve.py, of a Bezier curve NaN

Lines and arcs come over exactly. Bezier curves are sampled so finely that their chords stay within CHORD_SHARE of the
tolerance, and the rest of it goes to point_fit's lines and arcs. The number of samples for n chords of a cubic follows
from its second differences: a chord's error is at most |B''| / (8 n²) with |B''| <= 6 max |second difference|.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.curve_columns import LIMIT_MM, xy_of
from CNCStepper.geometry.fitting.fit_kernels import fit_stretches
from CNCStepper.tolerances import SAME_MM

CHORD_SHARE = 0.1  # of the tolerance: what the chords of the samples may take
SURE = 1.0 - 1e-9  # of the tolerance: what the kernel computes is rounded
SMOOTH_RAD = 0.01  # two Bezier curves that meet at a larger angle have a corner there
MOST_SAMPLES = 300_000  # of one path
MOST_SAMPLES_OF_ALL = 6_000_000  # of one drawing
SHORT = 64  # segments: such a path of lines is quicker in plain Python
THIRD = 1.0 / 3.0


@dataclass(frozen=True, eq=False)
class BezierPath:
    """A path; see the module's text. `PathPen` makes one."""

    points: np.ndarray
    controls: np.ndarray
    bulge: np.ndarray

    def __len__(self) -> int:
        return len(self.bulge)

    @property
    def closed(self) -> bool:
        """Whether the path ends exactly where it begins."""
        return bool(self.points[0] == self.points[-1])

    def transformed(self, matrix: np.ndarray) -> BezierPath:
        """Return the path with each point p at matrix[:, :2] @ p + matrix[:, 2].

        Arcs stay arcs only under turns and even scales: the caller knows that there are none, or sees to it.
        """
        (a, c, e), (b, d, f) = np.asarray(matrix, float)[:2].tolist()
        first, second = complex(a + d, b - c) / 2.0, complex(a - d, b + c) / 2.0
        shift = complex(e, f)

        def placed(z: np.ndarray) -> np.ndarray:
            return np.asarray(first * z + second * np.conj(z) + shift)

        turned = self.bulge if a * d - b * c >= 0.0 else -self.bulge
        return BezierPath(placed(self.points), placed(self.controls), turned)

    def curve(self, tolerance_mm: float, budget: SampleBudget | None = None) -> Curve:
        """Return lines and arcs along the path, mm, within `tolerance_mm` of it; its samples are taken from a budget.

        Raises GeometryError for a path of no length, coordinates out of bounds and a path too long for its tolerance.
        """
        if not len(self.bulge) or not (np.abs(self.points) <= 2.0 * LIMIT_MM).all():
            raise GeometryError("curve-range", "a path has no length, or a coordinate that is no length in mm")
        curved = np.isnan(self.bulge)
        if not curved.any():
            return Curve(xy_of(self.points), self.bulge)
        counts = self._counts(curved, CHORD_SHARE * tolerance_mm)
        if budget is not None:
            budget.take(int(counts.sum()))
        z, breaks = self._sampled(curved, counts)
        ends, bulges = fit_stretches(z, breaks, (1.0 - CHORD_SHARE) * tolerance_mm * SURE)
        arcs = np.flatnonzero(~curved & (self.bulge != 0.0))
        if len(arcs):
            bulges = np.array(bulges)
            bulges[np.searchsorted(ends, np.cumsum(counts)[arcs])] = self.bulge[arcs]
        return Curve(xy_of(z[np.concatenate([[0], ends])]), bulges)

    def _counts(self, curved: np.ndarray, chord_error_mm: float) -> np.ndarray:
        """Return into how many chords each segment is cut, int64[n]."""
        p0, p3, c1, c2 = self.points[:-1], self.points[1:], self.controls[:, 0], self.controls[:, 1]
        bend = np.maximum(np.abs(p0 - 2.0 * c1 + c2), np.abs(c1 - 2.0 * c2 + p3))
        wanted = np.where(curved, np.sqrt(0.75 * bend / chord_error_mm), 1.0)
        if not wanted.sum() <= MOST_SAMPLES:  # NaN too
            raise GeometryError("fit-large", "a path is too long for its tolerance", advice="take a larger tolerance")
        return np.maximum(np.ceil(wanted), 1.0).astype(np.int64)

    def _sampled(self, curved: np.ndarray, counts: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the samples, complex128[m], and the numbers of those at which a segment of the result must end."""
        row = np.repeat(np.arange(len(counts)), counts)
        last = np.cumsum(counts)
        t = (np.arange(len(row)) - np.repeat(last - counts, counts) + 1.0) / counts[row]
        s = 1.0 - t
        p0, p3 = self.points[:-1][row], self.points[1:][row]
        c1, c2 = self.controls[row, 0], self.controls[row, 1]
        z = np.where(curved[row] & (t < 1.0), s * s * s * p0 + 3.0 * s * t * (s * c1 + t * c2) + t * t * t * p3, p3)
        smooth = curved[:-1] & curved[1:] & ~self._corners()
        breaks = np.concatenate([[0], last[:-1][~smooth], last[-1:]]).astype(np.int64)
        return np.concatenate([self.points[:1], z]), breaks

    def _corners(self) -> np.ndarray:
        """Return at which inner vertices the direction jumps, bool[n - 1]; controls on their own ends look through."""
        p0, p3, c1, c2 = self.points[:-1], self.points[1:], self.controls[:, 0], self.controls[:, 1]
        leaves = np.where(c1 != p0, c1, np.where(c2 != p0, c2, p3)) - p0
        arrives = p3 - np.where(c2 != p3, c2, np.where(c1 != p3, c1, p0))
        return np.asarray(np.abs(np.angle(leaves[1:] * np.conj(arrives[:-1]))) > SMOOTH_RAD)


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


class PathPen:
    """Draws one path: begins at a point, then takes lines, Bezier curves and arcs. Segments of no length are left out.

    Points are complex numbers, x + iy.
    """

    def __init__(self, start: complex):
        self._points = [start]
        self._controls: list[tuple[complex, complex]] = []
        self._bulge: list[float] = []

    def __len__(self) -> int:
        return len(self._bulge)

    @property
    def place(self) -> complex:
        """Where the path has come to."""
        return self._points[-1]

    @property
    def start(self) -> complex:
        """Where it begins."""
        return self._points[0]

    def line(self, end: complex) -> None:
        """Draw a line."""
        self.arc(0.0, end)

    def arc(self, bulge: float, end: complex) -> None:
        """Draw an arc by its bulge."""
        if end != self._points[-1]:
            self._add(end, end, end, bulge)

    def quadratic(self, control: complex, end: complex) -> None:
        """Draw a Bezier curve of degree 2, as the same one of degree 3."""
        begin = self._points[-1]
        self.cubic(begin + 2.0 * THIRD * (control - begin), end + 2.0 * THIRD * (control - end), end)

    def cubic(self, control_1: complex, control_2: complex, end: complex) -> None:
        """Draw a Bezier curve of degree 3."""
        if not control_1 == control_2 == end == self._points[-1]:
            self._add(control_1, control_2, end, float("nan"))

    def close(self, same: float = SAME_MM) -> None:
        """Draw a line to the begin; an end that is within `same` of it is put there."""
        if self._bulge and abs(self._points[-1] - self._points[0]) <= same:
            self._points[-1] = self._points[0]
        else:
            self.line(self._points[0])

    def curve(self, tolerance_mm: float, budget: SampleBudget | None = None) -> Curve:
        """Return what was drawn as lines and arcs in mm, as `BezierPath.curve` does; quick where it is short."""
        points, bulge = self._points, self._bulge
        if len(bulge) <= SHORT and not any(bulge) and all(map(_is_near, points)):
            return Curve.trusted(np.array([(z.real, z.imag) for z in points]), np.zeros(len(bulge)))
        return self.path().curve(tolerance_mm, budget)

    def path(self) -> BezierPath:
        """Return what was drawn."""
        controls = np.array(self._controls, complex).reshape(-1, 2)
        return BezierPath(np.array(self._points, complex), controls, np.array(self._bulge, float))

    def _add(self, control_1: complex, control_2: complex, end: complex, bulge: float) -> None:
        self._points.append(end)
        self._controls.append((control_1, control_2))
        self._bulge.append(bulge)


def _is_near(z: complex) -> bool:
    """Return whether a point is one in mm; false for NaN."""
    return abs(z.real) <= LIMIT_MM and abs(z.imag) <= LIMIT_MM
