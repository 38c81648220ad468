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
POLISHES = 1
MOST_BULGE = 1.0 + 1e-9  # a half circle
GUESSES = 3
MOST_GROWTH = 8.0  # of a guess over the count before
SECOND_ORDER = 8.0  # times the square of a change of the sagitta over half the chord: what a correction leaves out
NO, YES, UNSURE = 0, 1, 2


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
def off_middle(z, first, last, curvature, tangent):
    """Return how far the point halfway lies off an arc."""
    local = (z[(first + last) // 2] - z[first]) * tangent.conjugate()
    turned = complex(1.0 - curvature * local.imag, curvature * local.real)
    return abs(2.0 * local.imag - curvature * abs(local) ** 2) / (abs(turned) + 1.0)


@njit
def advances(z, first, last, bulge, tolerance):
    """Return YES where each point lies farther along the arc and all within the tolerance, NO where one lies off it.

    UNSURE where a point lies behind the one before it or beyond an end, or where the chord between two of them may lie
    off the arc: serves() takes angles then. A radius turns from `ux, uy` on; its cross products take no angle.
    """
    chord = z[last] - z[first]
    if chord == 0.0 or abs(bulge) > 1.0:
        return UNSURE
    size, swell = abs(chord), 1.0 + bulge * bulge
    half_turn = complex(1.0 - bulge * bulge, 2.0 * bulge) / swell  # by half the sweep
    turned = chord / size * half_turn.conjugate()
    tx, ty, sx, sy = turned.real, turned.imag, z[first].real, z[first].imag
    curvature = 4.0 * bulge / (swell * size)
    if abs(curvature) * tolerance > 0.25:  # so near the centre chords cut deep
        return UNSURE
    sense = math.copysign(1.0, curvature)
    end_x, end_y = (half_turn * half_turn).real, (half_turn * half_turn).imag
    if off_middle(z, first, last, curvature, turned) > tolerance:
        return NO
    x0 = y0 = away0 = 0.0
    for k in range(first + 1, last + 1):
        dx, dy = z[k].real - sx, z[k].imag - sy
        x, y = dx * tx + dy * ty, dy * tx - dx * ty
        ux, uy = 1.0 - curvature * y, curvature * x
        away = (2.0 * y - curvature * (x * x + y * y)) / (math.sqrt(ux * ux + uy * uy) + 1.0)
        if abs(away) > tolerance:
            return NO
        px, py = x - x0, y - y0
        step = px * px + py * py
        if curvature == 0.0:
            if px < 0.0 or (x > size and k < last):
                return UNSURE
        else:
            forward = (1.0 - curvature * y0) * uy - curvature * x0 * ux
            inside = ux * end_y - uy * end_x
            if sense * forward < 0.0 or x < 0.0 or (sense * inside < 0.0 and k < last):
                return UNSURE
            if max(sense * away, sense * away0) + abs(curvature) * step / 3.0 > tolerance:  # nearer to the centre
                foot = (py * (1.0 - curvature * y0) - px * curvature * x0) / (curvature * step)
                if 0.0 < foot < 1.0:
                    x1, y1 = x0 + foot * px, y0 + foot * py
                    square, vx, vy = x1 * x1 + y1 * y1, 1.0 - curvature * y1, curvature * x1
                    if abs(2.0 * y1 - curvature * square) / (math.sqrt(vx * vx + vy * vy) + 1.0) > tolerance:
                        return NO
        x0, y0, away0 = x, y, away
    return YES


@njit
def serves(z, first, last, bulge, tolerance):
    """Return whether the polyline z[first] .. z[last], complex128, stays within the tolerance of the arc.

    On a line between two points the one nearest to the centre counts too. A polyline that runs back along the arc by
    more than the tolerance is not served: the arc would leave that out.
    """
    quick = advances(z, first, last, bulge, tolerance)
    return quick == YES or (quick == UNSURE and serves_by_angle(z, first, last, bulge, tolerance))


@njit
def serves_by_angle(z, first, last, bulge, tolerance):
    """Return what serves() does, by the angle of each point."""
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
    """Return the middle of the bulges that suit every point, by their rates of change, how far the points are then off
    at most, as a change of the sagitta, and whether any may suit.

    With the sagitta h a point p of the arc moves by |p - b| |p - e| / (c²/4 + h²) for each mm of h. None suits where
    the bounds exclude each other by more than the change of h itself leaves out.
    """
    chord, swell = z[last] - z[first], 1.0 + bulge * bulge
    size = abs(chord)
    tangent = chord / size * complex(1.0 - bulge * bulge, -2.0 * bulge) / swell
    tx, ty = tangent.real, tangent.imag
    curvature, half = 4.0 * bulge / (swell * size), size / 2.0
    apex = half * half * swell
    least, most = -math.inf, math.inf
    for k in range(first + 1, last):
        dx, dy = z[k].real - z[first].real, z[k].imag - z[first].imag
        ex, ey = z[k].real - z[last].real, z[k].imag - z[last].imag
        square = dx * dx + dy * dy
        product = square * (ex * ex + ey * ey)
        if product > 0.0:
            over_rate = apex / math.sqrt(product)
            x, y = dx * tx + dy * ty, dy * tx - dx * ty
            if x < 0.0:
                away, _ = off_arc(complex(x, y), curvature, math.inf)
            else:
                ux, uy = 1.0 - curvature * y, curvature * x
                away = (2.0 * y - curvature * square) / (math.sqrt(ux * ux + uy * uy) + 1.0)
            least, most = max(least, (-tolerance - away) * over_rate), min(most, (tolerance - away) * over_rate)
    if least == -math.inf:
        return bulge, 0.0, True
    change, excess = (least + most) / 2.0, least - most
    return bulge + change / half, tolerance + excess / 2.0, excess <= SECOND_ORDER * change * change / half


@njit
def suited(z, first, last, guess, tolerance):
    """Return whether one line or arc serves the points, its bulge, and how far the points are off the last arc tried.

    A line serves wherever it can, with 0 for how far. The search for an arc begins with the bulge `guess`.
    """
    if last == first + 1 or serves(z, first, last, 0.0, tolerance):
        return True, 0.0, 0.0
    bulge, off = guess, 0.0
    for _ in range(TRIALS):
        if z[first] == z[last]:
            break
        bulge, off, may_suit = corrected(z, first, last, bulge, tolerance)
        if not may_suit:
            break
        if abs(bulge) <= MOST_BULGE and serves(z, first, last, bulge, tolerance):
            return True, bulge, off
    return False, bulge if abs(bulge) <= MOST_BULGE else 0.0, off


@njit
def centred(z, first, last, bulge, tolerance):
    """Return a bulge that serves with less deviation than the first one found; a line stays one."""
    for _ in range(POLISHES if bulge != 0.0 else 0):
        better, _, _ = corrected(z, first, last, bulge, tolerance)
        if abs(better) > MOST_BULGE or not serves(z, first, last, better, tolerance):
            break
        bulge = better
    return bulge


@njit
def fit_stretch(z, first, last, tolerance, ends, bulges):
    """Enter into `ends` and `bulges` the segments that serve z[first] .. z[last], each as long as a search finds;
    return how many.

    The search begins with the count of the segment before. How far points lie off an arc grows with the cube of its
    length: that gives GUESSES further counts; then counts are doubled and halved.
    """
    count, usual, rate = 0, 2, 0.0
    while first < last:
        good, best, bad = first + 1, 0.0, last + 1
        trial, guesses = min(first + usual, last), GUESSES
        while bad - good > 1:
            guess = max(-1.0, min(rate * (trial - first), 1.0))
            fits, bulge, off = suited(z, first, trial, guess, tolerance)
            if bulge != 0.0:
                rate = bulge / (trial - first)
            if fits:
                good, best = trial, bulge
            else:
                bad = trial
            if off > 0.0 and guesses > 0:
                reach, guesses = int((trial - first) * min((tolerance / off) ** (1.0 / 3.0), MOST_GROWTH)), guesses - 1
            else:
                reach = (good + bad) // 2 - first if bad <= last else 2 * (trial - first)
            trial = min(max(first + reach, good + 1), bad - 1)
        ends[count], bulges[count] = good, centred(z, first, good, best, tolerance)
        count += 1
        first, usual = good, max(good - first, 2)
    return count


@njit
def fit_stretches(z, breaks, tolerance):
    """Return the last point and the bulge of each segment, with an end at each of the `breaks`, int64, ascending."""
    ends, bulges = np.empty(len(z) - 1, np.int64), np.empty(len(z) - 1)
    count = 0
    for b in range(len(breaks) - 1):
        count += fit_stretch(z, breaks[b], breaks[b + 1], tolerance, ends[count:], bulges[count:])
    return ends[:count].copy(), bulges[:count].copy()


@njit
def sampled(points, controls, sizes, counts):
    """Return the samples of paths (path_columns.py), complex128[m], where each path starts in them, int64[k], and where
    each segment ends, int64[n]; a Bezier curve is cut into `counts`, int64[n], chords, each other segment is one."""
    z, starts, last = np.empty(counts.sum() + len(sizes), np.complex128), np.empty_like(sizes), np.empty_like(counts)
    row = at = 0
    for path in range(len(sizes)):
        starts[path], z[at] = at, points[row + path]
        for _ in range(sizes[path]):
            p0, p3, count = points[row + path], points[row + path + 1], counts[row]
            c1, c2 = controls[row, 0], controls[row, 1]
            for k in range(1, count):
                t = k / count
                s = 1.0 - t
                z[at + k] = s * s * s * p0 + 3.0 * s * t * (s * c1 + t * c2) + t * t * t * p3
            at += count
            z[at], last[row] = p3, at
            row += 1
        at += 1
    return z, starts, last
