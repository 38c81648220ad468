# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points as few lines and arcs: their polyline and the result stay within a tolerance of each other.

Each segment ends on points of the polyline and reaches as far as one line or arc serves; of the bulges that
would serve it takes the middle one. Corners are ends of segments, so they stay exactly where they are:

        before -- p            a corner: the way turns by CORNER_DEG or more between the stretches of
                   \\           REACH tolerances before and after p, and nowhere more within them
                  after

The result never has more segments than the polyline.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve, from_points
from CNCStepper.geometry.curve_columns import complex_of, xy_of
from CNCStepper.geometry.fitting.fit_kernels import fit_stretches

CORNER_DEG = 30.0
REACH = 6.0  # tolerances: noise within one of them turns the way by less than CORNER_DEG over that stretch
SURE = 1.0 - 1e-9  # of the tolerance: the kernel's results are rounded


def fit_points(points: Iterable[Iterable[float]], tolerance_mm: float, closed: bool = False) -> Curve:
    """Return lines and arcs along the polyline through `points`, closed back to the first one when asked.

    No place of the one is farther than `tolerance_mm` from the other; the first and last point stay. Raises
    GeometryError for fewer than two different points or a tolerance that is not above 0.
    """
    return refitted(from_points(points, closed), tolerance_mm)


def refitted(curve: Curve, tolerance_mm: float) -> Curve:
    """Return fewer lines and arcs along a polyline, as `fit_points` does; a curve with arcs is returned as it is."""
    if not tolerance_mm > 0:
        advice = "give a tolerance above 0"
        raise GeometryError("fit", "the tolerance must be above 0", value=f"{tolerance_mm:g} mm", advice=advice)
    if curve.bulge.any():
        return curve
    curve = curve.without_short()
    z = complex_of(curve.xy)
    breaks = np.unique(np.concatenate([[0], corners(z, tolerance_mm), [len(z) - 1]])).astype(np.int64)
    ends, bulges = fit_stretches(np.ascontiguousarray(z), breaks, tolerance_mm * SURE)
    return Curve(xy_of(z[np.concatenate([[0], ends])]), bulges)


def corners(z: np.ndarray, tolerance_mm: float) -> np.ndarray:
    """Return the numbers of the points, complex128[n], at which the polyline has a corner, ascending."""
    place = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(z)))])
    before, after = (np.interp(place + way, place, z) for way in (-REACH * tolerance_mm, REACH * tolerance_mm))
    turn = np.abs(np.angle((after - z) * np.conj(z - before)))
    turn[[0, -1]] = 0.0
    return sharpest(place, turn, np.radians(CORNER_DEG), REACH * tolerance_mm / 2.0)


def sharpest(place: np.ndarray, turn: np.ndarray, least_rad: float, reach: float) -> np.ndarray:
    """Return the points that turn the path by `least_rad` at least, and as much as any within reach; place ascends."""
    sharp = np.flatnonzero(turn >= least_rad)
    return sharp[turn[sharp] >= _greatest_near(place[sharp], turn[sharp], reach)]


def _greatest_near(place: np.ndarray, turn: np.ndarray, reach: float) -> np.ndarray:
    """Return for each place, ascending, the greatest turn of those within reach, by doubling windows."""
    first, last = np.searchsorted(place, place - reach, "left"), np.searchsorted(place, place + reach, "right")
    levels = [turn]
    while len(turn) and 2 ** len(levels) <= int((last - first).max(initial=1)):
        step = 2 ** (len(levels) - 1)
        levels.append(np.maximum(levels[-1][:-step], levels[-1][step:]))
    level = np.frexp(np.maximum(last - first, 1))[1] - 1
    greatest = np.empty(len(turn))
    for number, windows in enumerate(levels):
        rows = np.flatnonzero(level == number)
        greatest[rows] = np.maximum(windows[first[rows]], windows[last[rows] - 2**number])
    return greatest
