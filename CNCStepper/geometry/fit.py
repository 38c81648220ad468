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
SAMPLED = 0.99  # of the tolerance: between samples the deviation may be this much larger
MOST_ARCS = 10_000
FINEST = 0.01  # of the remaining stretch: how closely the longest arc is sought
Function = Callable[[np.ndarray], np.ndarray]  # parameters float64[m] -> float64[m, 2]


def fit_arcs(point: Function, first: float, last: float, tolerance_mm: float) -> Curve:
    """Return arcs along `point` from parameter `first` to `last`, none farther from it than `tolerance_mm`.

    The curve must be smooth between. Raises GeometryError when the tolerance cannot be reached.
    """
    if not tolerance_mm > 0:
        raise GeometryError("fit", "the tolerance must be above 0", value=f"{tolerance_mm:g} mm")
    parameters, bulges = [first], []
    while parameters[-1] != last:
        end, bulge = _longest(point, parameters[-1], last, SAMPLED * tolerance_mm)
        parameters.append(end)
        bulges.append(bulge)
        if len(bulges) > MOST_ARCS:
            raise GeometryError("fit", "the tolerance is too small for this curve", value=f"{tolerance_mm:g} mm")
    return Curve(point(np.array(parameters)), np.array(bulges))


def _longest(point: Function, begin: float, last: float, tolerance_mm: float) -> tuple[float, float]:
    """Return how far one arc serves, found by halving, and its bulge; the way's end where it serves that far."""
    bulge, deviation_mm = _arc(point, begin, last)
    if deviation_mm <= tolerance_mm:
        return last, bulge
    good, bad, best = begin, last, None
    while best is None or abs(bad - good) > FINEST * abs(last - begin):
        middle = 0.5 * (good + bad)
        if middle in (good, bad):
            raise GeometryError("fit", "the curve is not smooth here", value=f"parameter {begin:g}")
        bulge, deviation_mm = _arc(point, begin, middle)
        if deviation_mm <= tolerance_mm:
            good, best = middle, bulge
        else:
            bad = middle
    return good, best


def _arc(point: Function, begin: float, end: float) -> tuple[float, float]:
    """Return the bulge of the arc for a stretch of the curve and how far the curve leaves it.

    Seen from the first end along the chord of length c, the circle with sagitta h is f(x, y) = 0 with
    f = h (x² + y² - c x) + (c²/4 - h²) y, and the distance from it 2 |f| / (|grad f| + c²/4 + h²).
    """
    samples = point(np.linspace(begin, end, SAMPLES)) @ (1.0, 1j)
    chord = samples[-1] - samples[0]
    length = abs(chord)
    local = (samples - samples[0]) * (np.conj(chord) / length if length else 0.0)
    x, y = local.real, local.imag
    if not (np.diff(x) > 0.0).all():
        return 0.0, float(np.abs(samples - samples[0]).max())  # it turns back: serves where it is smaller than that
    h = float(np.interp(length / 2.0, x, y))
    square = length**2 / 4.0
    f = h * (x * x + y * y - length * x) + (square - h * h) * y
    gradient = np.hypot(h * (2.0 * x - length), 2.0 * h * y + square - h * h)
    return -2.0 * h / length, float((2.0 * np.abs(f) / (gradient + square + h * h)).max())
