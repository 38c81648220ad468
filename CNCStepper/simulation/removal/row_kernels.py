# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kernels: which cells of a row of a tile a straight move has to look at.

They are those whose feet lie in a range along the move, on a ramp also those within a circle about its begin or
its end, but for those within another circle that a neighbour on the path cuts lower (`ramp_kernels`).
"""

from __future__ import annotations

import math

from CNCStepper.kernels import njit
from CNCStepper.simulation.removal.ramp_kernels import spared

FAR = 1e30


@njit
def inverse_of(factor):
    """Return 1 / factor, or 0 for a factor that is as good as 0."""
    return 0.0 if abs(factor) < 1e-12 else 1.0 / factor


@njit
def between(inverse, offset, low, high, first, last):
    """Narrow the range [first, last] of x to where low <= x / inverse + offset <= high; inverse 0: x plays no part."""
    if inverse == 0.0:
        return (first, last) if low <= offset <= high else (1.0, 0.0)
    one, other = (low - offset) * inverse, (high - offset) * inverse
    return max(first, min(one, other)), min(last, max(one, other))


@njit
def columns_between(first, last, x0, per_mm, columns):
    """Return the first and the last column whose centres lie in [first, last]; x0 is that of column 0."""
    if first > last:
        return 0, -1
    first = min(max((first - x0) * per_mm, 0.0), float(columns))
    last = min(max((last - x0) * per_mm, -1.0), columns - 1.0)
    return math.ceil(first), math.floor(last)


@njit
def strip_of(move, direction, turned, feet, joined, form, dx, dy):
    """Return what the rows of a move have in common: first and last y; the circle that is left out; 1 / direction."""
    length = move[3]
    ux, uy = direction
    wide = form[0] + 0.5 * (dx + dy)
    one = uy * max(min(feet[0], -feet[2]), -wide)
    other = uy * min(max(feet[1], length + feet[3]), length + wide)
    low, high = min(one, other) - wide * abs(ux), max(one, other) + wide * abs(ux)
    at_end, radius = spared(move[4], turned[2], joined, form, dx + dy)
    at = length if at_end else 0.0
    return low, high, at * ux, at * uy, radius, inverse_of(ux), inverse_of(uy)


@njit
def columns_of(y, x0, columns, strip, move, direction, feet, form, dx, dy):
    """Return first and last column of the cells of a row west of the circle that is left out, and east of it."""
    _, _, sx, sy, radius, by_ux, by_uy = strip
    ux, uy = direction
    wide = form[0] + 0.5 * (dx + dy)
    west, east = between(by_uy, -y * ux, -wide, wide, -FAR, FAR)
    west, east = between(by_ux, y * uy, feet[0], feet[1], west, east)
    if feet[2] > 0.0:
        one, other = _chord(y, 0.0, 0.0, feet[2])
        one, other = between(by_ux, y * uy, -FAR, feet[1], one, other)
        west, east = _both(west, east, one, other)
    if feet[3] > 0.0:
        one, other = _chord(y, move[3] * ux, move[3] * uy, feet[3])
        one, other = between(by_ux, y * uy, feet[0], FAR, one, other)
        west, east = _both(west, east, one, other)
    first, last = columns_between(west, east, x0, 1.0 / dx, columns)
    west, east = _chord(y, sx, sy, radius)
    if west >= east or first > last:
        return first, last, 0, -1
    skip, until = columns_between(west, east, x0, 1.0 / dx, columns)
    return first, min(last, skip - 1), max(first, until + 1), last


@njit
def _chord(y, x_mm, y_mm, radius):
    """Return the range of x in which a row lies within a circle."""
    square = radius * radius - (y - y_mm) * (y - y_mm)
    if square <= 0.0:
        return 1.0, 0.0
    half = math.sqrt(square)
    return x_mm - half, x_mm + half


@njit
def _both(west, east, one, other):
    """Return the range that holds two ranges, of which those that end before they begin hold nothing."""
    if one > other:
        return west, east
    if west > east:
        return one, other
    return min(west, one), max(east, other)
