# SPDX-License-Identifier: LGPL-2.1-or-later
"""A parametric curve as few arcs, never farther from it than a tolerance.

Each arc has its ends on the curve and its apex where the curve crosses the perpendicular bisector
of the chord, so that the error swings to both sides and is as small as an arc of that length allows
(to leading order in its length):

          . - M - .
        '     |h    '        M: the curve's own point on the bisector
      p0 ----------- p1      bulge = 2 h / chord

Invariants: ends lie on the curve; the deviation of every arc was measured on SAMPLES points of the
curve and lies within the tolerance.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve

SAMPLES = 33
MOST_ARCS = 10_000
FINEST = 1e-3  # of the remaining stretch: how closely the longest arc is sought
Function = Callable[[np.ndarray], np.ndarray]  # parameters float64[m] -> float64[m, 2]


def fit_arcs(point: Function, first: float, last: float, tolerance_mm: float) -> Curve:
    """Return arcs along `point` from parameter `first` to `last`, none farther from it than `tolerance_mm`.

    The curve must be smooth between. Raises GeometryError when the tolerance cannot be reached.
    """
    ends, bulges = [point(np.array([first]))[0]], []
    begin = first
    while begin != last:
        begin, arc = _longest(point, begin, last, tolerance_mm)
        ends.append(arc.xy[1])
        bulges.append(arc.bulge[0])
        if len(bulges) > MOST_ARCS:
            raise GeometryError("fit", "the tolerance is too small for this curve", value=f"{tolerance_mm:g} mm")
    return Curve(np.array(ends), np.array(bulges))


def _longest(point: Function, begin: float, last: float, tolerance_mm: float) -> tuple[float, Curve]:
    """Return how far one arc serves, found by halving, and that arc; the way's end where it serves that far."""
    arc, deviation_mm = _arc(point, begin, last)
    if deviation_mm <= tolerance_mm:
        return last, arc
    good, bad, best = begin, last, None
    while best is None or abs(bad - good) > FINEST * abs(last - begin):
        middle = 0.5 * (good + bad)
        if middle in (good, bad):
            raise GeometryError("fit", "the curve is not smooth here", value=f"parameter {begin:g}")
        arc, deviation_mm = _arc(point, begin, middle)
        if deviation_mm <= tolerance_mm:
            good, best = middle, arc
        else:
            bad = middle
    return good, best


def _arc(point: Function, begin: float, end: float) -> tuple[Curve, float]:
    """Return the arc for a stretch of the curve and how far the curve leaves it."""
    samples = point(np.linspace(begin, end, SAMPLES))
    chord = samples[-1] - samples[0]
    length_mm = float(np.hypot(*chord))
    along = (samples - samples[0]) @ chord / length_mm**2
    left_mm = (samples - samples[0]) @ np.array([-chord[1], chord[0]]) / length_mm
    sagitta_mm = float(np.interp(0.5, along, left_mm))
    arc = Curve(samples[[0, -1]], np.array([-2.0 * sagitta_mm / length_mm]))
    return arc, float(arc.distances_mm(samples).max())
