# SPDX-License-Identifier: LGPL-2.1-or-later
"""The longest arc or line that serves points of a polyline, from one of them on (see point_fit.py).

A point is seen from the arc's begin along its tangent, as in nearest_point.py: no centre comes in.

             . - h - .          h   sagitta: the arc rises so far to the right of its chord
           /     |     \\        c   chord, from a point of the polyline to a later one
         b ------+------ e      bulge = 2 h / c, at most 1: a half circle
"""

from __future__ import annotations

import cmath
import math

import numpy as np

from CNCStepper.kernels import njit

TRIALS = 6  # corrections of a bulge; the error of each is the square of the one before
POLISHES = 2
MOST_BULGE = 1.0 + 1e-9  # a half circle


@njit
def off_arc(local, curvature, length):
    """Return how far a point lies left of an arc and how far along it; beyond an end its distance to that end."""
    away = (2.0 * local.imag - curvature * abs(local) ** 2) / (abs(curvature * local - 1j) + 1.0)
    along = local.real
    if curvature != 0.0:
        along = math.atan2(curvature * local.real, 1.0 - curvature * local.imag) / curvature
    beyond = max(-along, along - length, 0.0)
    return math.copysign(math.hypot(away, beyond), away), along


@njit
def serves(z, first, last, bulge, tolerance):
    """Return whether the polyline z[first] .. z[last], complex128, stays within the tolerance of the arc.

    On a line between two points the one nearest to the centre counts too. A polyline that runs back along the arc by
    more than the tolerance is not served: the arc would leave that out.
    """
    chord, sweep = z[last] - z[first], 4.0 * math.atan(bulge)
    if chord == 0.0:
        return False
    tangent = chord / abs(chord) * cmath.exp(-0.5j * sweep)
    curvature = 2.0 * math.sin(sweep / 2.0) / abs(chord)
    length = sweep / curvature if curvature != 0.0 else abs(chord)
    before, farthest = 0j, 0.0
    for k in range(first + 1, last + 1):
        local = (z[k] - z[first]) * tangent.conjugate()
        away, along = off_arc(local, curvature, length)
        if abs(away) > tolerance or along < farthest - tolerance:
            return False
        farthest = max(farthest, along)
        step = local - before
        if curvature != 0.0:
            foot = (step.conjugate() * (1j - curvature * before)).real / (curvature * abs(step) ** 2)
            if 0.0 < foot < 1.0 and abs(off_arc(before + foot * step, curvature, length)[0]) > tolerance:
                return False
        before = local
    return True


@njit
def corrected(z, first, last, bulge, tolerance):
    """Return the middle of the bulges that suit every point, by their rates of change.

    With the sagitta h a point p of the arc moves by |p - b| |p - e| / (c²/4 + h²) for each mm of h.
    """
    chord, sweep = z[last] - z[first], 4.0 * math.atan(bulge)
    tangent = chord / abs(chord) * cmath.exp(-0.5j * sweep)
    curvature, half = 2.0 * math.sin(sweep / 2.0) / abs(chord), abs(chord) / 2.0
    apex = half * half * (1.0 + bulge * bulge)
    least, most = -math.inf, math.inf
    for k in range(first + 1, last):
        rate = abs(z[k] - z[first]) * abs(z[k] - z[last]) / apex
        if rate > 0.0:
            away, _ = off_arc((z[k] - z[first]) * tangent.conjugate(), curvature, math.inf)
            least, most = max(least, (-tolerance - away) / rate), min(most, (tolerance - away) / rate)
    return bulge + (least + most) / 2.0 / half if least > -math.inf else bulge


@njit
def suited(z, first, last, tolerance):
    """Return whether one line or arc serves the points, and its bulge; a line wherever one does."""
    if last == first + 1 or serves(z, first, last, 0.0, tolerance):
        return True, 0.0
    bulge = 0.0
    for _ in range(TRIALS):
        if z[first] == z[last]:
            break
        bulge = corrected(z, first, last, bulge, tolerance)
        if abs(bulge) <= MOST_BULGE and serves(z, first, last, bulge, tolerance):
            return True, bulge
    return False, 0.0


@njit
def centred(z, first, last, bulge, tolerance):
    """Return a bulge that serves with less deviation than the first one found; a line stays one."""
    for _ in range(POLISHES if bulge != 0.0 else 0):
        better = corrected(z, first, last, bulge, tolerance)
        if abs(better) > MOST_BULGE or not serves(z, first, last, better, tolerance):
            break
        bulge = better
    return bulge


@njit
def fit_stretch(z, first, last, tolerance, ends, bulges):
    """Enter into `ends` and `bulges` the segments that serve z[first] .. z[last], each as long as doubling and halving
    of its reach find; return how many."""
    count = 0
    while first < last:
        good, best, bad, reach = first + 1, 0.0, last + 1, 2
        while good < last and bad > last:
            trial = min(first + reach, last)
            fits, bulge = suited(z, first, trial, tolerance)
            if fits:
                good, best = trial, bulge
            else:
                bad = trial
            reach *= 2
        while bad <= last and bad - good > 1:
            trial = (good + bad) // 2
            fits, bulge = suited(z, first, trial, tolerance)
            if fits:
                good, best = trial, bulge
            else:
                bad = trial
        ends[count], bulges[count] = good, centred(z, first, good, best, tolerance)
        count += 1
        first = good
    return count


@njit
def fit_stretches(z, breaks, tolerance):
    """Return the last point and the bulge of each segment, with an end at each of the `breaks`, int64, ascending."""
    ends, bulges = np.empty(len(z) - 1, np.int64), np.empty(len(z) - 1)
    count = 0
    for b in range(len(breaks) - 1):
        count += fit_stretch(z, breaks[b], breaks[b + 1], tolerance, ends[count:], bulges[count:])
    return ends[:count].copy(), bulges[:count].copy()
