# SPDX-License-Identifier: LGPL-2.1-or-later
"""BezierPath: a connected path of lines, cubic Bezier curves and arcs, and the pen that draws one.

    points    complex128[n + 1]      the vertices
    controls  complex128[n, 2]       the two control points of each segment; those of a line or arc are not used
    bulge     float64[n]             of a line 0, of an arc as in curve.py, of a Bezier curve NaN

path_columns.py makes curves of lines and arcs of them, of many paths at once.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.fitting.path_columns import PathColumns, SampleBudget
from CNCStepper.tolerances import SAME_MM

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
        if not len(self.bulge):
            what = "a path has no length, or a coordinate that is no length in mm"
            advice = "draw it larger, or leave it out"
            raise GeometryError("curve-range", what, advice=advice)
        columns = PathColumns(self.points, self.controls, self.bulge, np.array([len(self.bulge)]))
        return required(columns.curves(tolerance_mm, budget)[0])


class PathPen:
    """Draws one path: begins at a point, then takes lines, Bezier curves and arcs. Segments of no length are left out.

    Points are complex numbers, x + iy.
    """

    __slots__ = ("_bulge", "_controls", "_points")

    def __init__(self, start: complex):
        self._points = [start]
        self._controls: list[complex] = []  # two a segment
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

    def lines(self, ends: Iterable[complex]) -> None:
        """Draw lines from one point to the next."""
        last = self._points[-1]
        for end in ends:
            if end != last:
                self._points.append(end)
                self._controls += (end, end)
                self._bulge.append(0.0)
                last = end

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

    def path(self) -> BezierPath:
        """Return what was drawn."""
        controls = np.array(self._controls, complex).reshape(-1, 2)
        return BezierPath(np.array(self._points, complex), controls, np.array(self._bulge, float))

    def _add(self, control_1: complex, control_2: complex, end: complex, bulge: float) -> None:
        self._points.append(end)
        self._controls += (control_1, control_2)
        self._bulge.append(bulge)


class PathGatherer:
    """Gathers what pens have drawn, until all of it becomes columns."""

    def __init__(self) -> None:
        self._points: list[complex] = []
        self._controls: list[complex] = []
        self._bulge: list[float] = []
        self._sizes: list[int] = []

    def __len__(self) -> int:
        """How many segments there are."""
        return len(self._bulge)

    def add(self, pen: PathPen) -> None:
        """Add the path of a pen, which has drawn at least one segment."""
        self._points += pen._points
        self._controls += pen._controls
        self._bulge += pen._bulge
        self._sizes.append(len(pen._bulge))

    def columns(self) -> PathColumns:
        """Return all paths."""
        controls = np.array(self._controls, complex).reshape(-1, 2)
        points, bulge = np.array(self._points, complex), np.array(self._bulge, float)
        return PathColumns(points, controls, bulge, np.array(self._sizes, np.int64))


def required(curve: Curve | GeometryError) -> Curve:
    """Return the curve; raises the error that stands in its place."""
    if isinstance(curve, GeometryError):
        raise curve
    return curve
