# SPDX-License-Identifier: LGPL-2.1-or-later
"""A parametric curve as few lines and arcs, never farther from it than a tolerance.

Each arc has its ends on the curve and its apex where the curve crosses the perpendicular bisector
of the chord, so that the error swings to both sides and is as small as an arc of that length allows
(to leading order in its length):

          . - M - .
        '     |h    '        M: the curve's own point on the bisector
      p0 ----------- p1      bulge = 2 h / chord

Invariants: ends lie on the curve; the deviation of every arc was measured on SAMPLES even points of the
curve and at uneven ones between them, so that no ripple can hide in step with the samples, and lies within the
tolerance. `fit_curve` first looks for corners and cusps, which stay where they are; `fit_arcs` is for what is smooth.

Where a parametric curve has a corner or a cusp: where its direction jumps, however closely one looks.

Three neighbouring samples between which the way turns by more than SHARP are looked at again, finer, about the
sharpest of them; a bend becomes gentle on the way, a corner stays as sharp until it is found to SAME_SUM_MM.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence

import numpy as np

from CNCStepper.cancellation import checkpoint
from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve, joined
from CNCStepper.tolerances import SAME_SUM_MM

CORNER_SAMPLES = 256
SHARP_RAD = np.radians(10.0)
FINER = 8  # times, at each look
LOOKS = 18  # FINER ** LOOKS is beyond the resolution of a float
Function = Callable[[np.ndarray], np.ndarray]  # parameters float64[m] -> float64[m, 2]


def corner_parameters(point: Function, first: float, last: float, knots: Sequence[float] = ()) -> list[float]:
    """Return the parameters of the corners between `first` and `last`, in that direction.

    A corner at one of the `knots` is that knot exactly.
    """
    low, high = min(first, last), max(first, last)
    inner = np.array([knot for knot in sorted(knots) if low < knot < high])
    every = np.unique(
        np.concatenate([np.linspace(low, high, CORNER_SAMPLES + 1), inner, _between([low, *inner, high])])
    )
    turns = _turns(point(every))
    found = [
        _sharpened(point, *every[number : number + 3].tolist()) for number in np.flatnonzero(turns > SHARP_RAD).tolist()
    ]
    apart = _without_twins([place for place in found if place is not None], (high - low) / CORNER_SAMPLES**2, inner)
    return apart if last > first else apart[::-1]


def _sharpened(point: Function, low: float, middle: float, high: float) -> float | None:
    """Return where between `low` and `high` the corner is; None when it is only a bend."""
    for _ in range(LOOKS):
        fine = np.concatenate([np.linspace(low, middle, FINER, endpoint=False), np.linspace(middle, high, FINER + 1)])
        places = point(fine)
        turns = _turns(places)
        sharpest = int(turns.argmax())
        if not turns[sharpest] > SHARP_RAD:
            return None
        low, middle, high = fine[sharpest : sharpest + 3].tolist()
        if np.hypot(*np.diff(places[sharpest : sharpest + 3], axis=0).T).sum() <= SAME_SUM_MM:
            break
    return middle


def _turns(places: np.ndarray) -> np.ndarray:
    """Return by how much the way turns at each inner one of the points, rad, 0 where two are the same."""
    steps = np.diff(places @ (1.0, 1j))
    return np.abs(np.angle(steps[1:] * np.conj(steps[:-1])))


def _between(bounds: Sequence[float]) -> np.ndarray:
    ascending = np.asarray(bounds, float)
    return (ascending[:-1, None] + np.diff(ascending)[:, None] * np.array([0.23, 0.51, 0.79])).ravel()


def _without_twins(ascending: list[float], same: float, knots: np.ndarray) -> list[float]:
    """Return the corners, each once: two samples beside one find it twice."""
    kept: list[float] = []
    for place in sorted(ascending):
        near = knots[np.abs(knots - place) <= same]
        exact = float(near[np.abs(near - place).argmin()]) if len(near) else place
        if not kept or exact - kept[-1] > same:
            kept.append(exact)
    return kept


SAMPLES = 33
SAMPLED = 0.99  # of the tolerance: between samples the deviation may be this much larger
GOLDEN = np.sort(np.arange(1, 18) * 0.6180339887498949 % 1.0)  # shares of a stretch, in step with nothing
MOST_ARCS = 10_000
FINEST = 0.01  # of the remaining stretch: how closely the longest arc is sought
# parameters float64[m] -> float64[m, 2]


def fit_curve(
    point: Function, first: float, last: float, tolerance_mm: float, knots: Sequence[float] = (), closed: bool = False
) -> Curve:
    """Return lines and arcs along `point` as `fit_arcs` does, with a vertex at each of its corners and cusps.

    `knots` are parameters between which the curve is simple, as those of a B-spline: it is sampled between any two.
    `closed` puts the end exactly on the start.
    """
    stops = [first, *corner_parameters(point, first, last, knots), last]
    curve = joined(fit_arcs(point, *stretch, tolerance_mm, knots) for stretch in itertools.pairwise(stops))
    return Curve(np.vstack([curve.xy[:-1], curve.xy[:1]]), curve.bulge) if closed else curve


def fit_arcs(point: Function, first: float, last: float, tolerance_mm: float, knots: Sequence[float] = ()) -> Curve:
    """Return arcs along `point` from parameter `first` to `last`, none farther from it than `tolerance_mm`.

    The curve must be smooth between. Raises GeometryError when the tolerance cannot be reached.
    """
    inner = np.sort(np.asarray(knots, float))
    if not tolerance_mm > 0:
        advice = "give a tolerance above 0"
        raise GeometryError("fit", "the tolerance must be above 0", value=f"{tolerance_mm:g} mm", advice=advice)
    parameters, bulges = [first], []
    while parameters[-1] != last:
        checkpoint()
        end, bulge = _longest(point, parameters[-1], last, SAMPLED * tolerance_mm, inner)
        parameters.append(end)
        bulges.append(bulge)
        if len(bulges) > MOST_ARCS:
            what, advice = "the tolerance is too small for this curve", "take a larger tolerance"
            raise GeometryError("fit", what, value=f"{tolerance_mm:g} mm", advice=advice)
    return Curve(point(np.array(parameters)), np.array(bulges))


def _longest(point: Function, begin: float, last: float, tolerance_mm: float, knots: np.ndarray) -> tuple[float, float]:
    """Return how far one arc serves, found by halving, and its bulge; the way's end where it serves that far."""
    bulge, deviation_mm = _arc(point, begin, last, knots)
    if deviation_mm <= tolerance_mm:
        return last, bulge
    good, bad, best = begin, last, None
    while best is None or abs(bad - good) > FINEST * abs(last - begin):
        middle = 0.5 * (good + bad)
        if middle in (good, bad):
            advice = "split it there"
            raise GeometryError("fit", "the curve is not smooth here", value=f"parameter {begin:g}", advice=advice)
        bulge, deviation_mm = _arc(point, begin, middle, knots)
        if deviation_mm <= tolerance_mm:
            good, best = middle, bulge
        else:
            bad = middle
    return good, best


def _arc(point: Function, begin: float, end: float, knots: np.ndarray) -> tuple[float, float]:
    """Return the bulge of the arc for a stretch of the curve and how far the curve leaves it."""
    even = np.linspace(begin, end, SAMPLES)
    every = np.concatenate([even, _uneven(begin, end, knots)])
    samples = point(every) @ (1.0, 1j)
    chord = samples[SAMPLES - 1] - samples[0]
    length = abs(chord)
    local = (samples - samples[0]) * (np.conj(chord) / length if length else 0.0)
    order = np.argsort(every if end > begin else -every, kind="stable")
    if not (np.diff(local.real[:SAMPLES]) > 0.0).all() or (np.diff(local.real[order]) < 0.0).any():
        return 0.0, float(np.abs(samples - samples[0]).max())  # it turns back: serves where it is smaller than that
    h = float(np.interp(length / 2.0, local.real[:SAMPLES], local.imag[:SAMPLES]))
    off = _deviations(local, length, h)
    return -2.0 * h / length, float(max(off[:SAMPLES].max(), SAMPLED * off[SAMPLES:].max()))


def _deviations(local: np.ndarray, length: float, h: float) -> np.ndarray:
    """Return how far points, seen from the first end along the chord, are from the circle of the arc with sagitta h.

    It is f(x, y) = 0 with f = h (x² + y² - c x) + (c²/4 - h²) y, and the distance from it
    2 |f| / (|grad f| + c²/4 + h²).
    """
    x, y, square = local.real, local.imag, length**2 / 4.0
    f = h * (x * x + y * y - length * x) + (square - h * h) * y
    gradient = np.hypot(h * (2.0 * x - length), 2.0 * h * y + square - h * h)
    return 2.0 * np.abs(f) / (gradient + square + h * h)


def _uneven(begin: float, end: float, knots: np.ndarray) -> np.ndarray:
    """Return parameters that no even step meets, spread over the stretch, and over each one between two knots."""
    low, high = min(begin, end), max(begin, end)
    inner = knots[(knots > low) & (knots < high)]
    bounds = np.concatenate([[begin], inner if end > begin else inner[::-1], [end]])
    shares = GOLDEN if len(inner) else np.sort(np.concatenate([GOLDEN, 1.0 - GOLDEN]))
    return (bounds[:-1, None] + np.diff(bounds)[:, None] * shares).ravel()
