# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kernels: which cells of a row of a tile a straight move has to look at.

They are those whose feet lie in a range along the move, on a ramp also those within a circle about its begin or
its end, but for those within another circle that a neighbour on the path cuts lower.

Kernels: where along a ramp the cutter is lowest over a cell, and which cells another ramp of a chain cuts lower.

Over one cell the cutter's height along the path is a convex function of the place. In a chain of joined moves
a cell is therefore lowest where that function stops falling; a move on which it only falls, and goes on
falling in the next one, has nothing to say about the cell, nor has one on which it only rises from its begin.

    height over a cell  \\                       Cells whose area reaches over the cutter's rim are never left
                         `-.          .-'        out: how much of them is cut counts by the move.
        moves of a chain  | `-.____.-' |
        left out: 1, 3    1      2     3
"""

from __future__ import annotations

import math

from CNCStepper.kernels import njit
from CNCStepper.simulation.cutter_solid import lead

AFTER_LAST, BEFORE_NEXT = 1, 2  # bits of `joined`, as in removal_moves
LEFT_OUT = math.nan
SURE_MM = 1e-6  # the places of two moves where a cell is lowest agree by it


@njit
def spared(rise, next_rise, joined, form, cell_mm):
    """Return whether cells about the ramp's end are left out, or else about its begin, and the radius of these.

    Within that radius the profile is nowhere steeper than the ramp. A radius of few cells is not worth it: then 0.
    """
    at_end, radius = False, 0.0
    if rise > 0.0 and joined & AFTER_LAST:
        radius = plain(rise, form)
    elif rise < 0.0 and joined & BEFORE_NEXT and next_rise < 0.0:
        at_end, radius = True, min(plain(rise, form), plain(next_rise, form))
    radius = min(radius, form[0] - cell_mm)
    return at_end, radius if radius > 2.0 * cell_mm else 0.0


@njit
def plain(rise, form):
    """Return the radius up to which the profile is nowhere steeper than a slope."""
    radius, tip, corner, slope = form
    steep = abs(rise)
    if corner > 0.0:
        return tip + corner * steep / math.sqrt(1.0 + steep * steep)
    return radius if slope <= steep else tip


@njit
def place_of(foot, beside, length, rise, following, joined, form, cell_mm):
    """Return how far from the ramp's begin the cutter is lowest over a cell that it covers, or LEFT_OUT.

    following: cosine and sine of the turn to the move after it, and its slope; zeros for none.
    """
    radius, tip, corner, _ = form
    safe = radius - cell_mm
    if tip > 0.0 and corner > 0.0:  # needs less than its lead does
        if climbs(foot, beside, rise, form) > 0.0:
            return LEFT_OUT if joined & AFTER_LAST and is_within(foot, beside, safe) else 0.0
        past = foot - length
        if climbs(past, beside, rise, form) < 0.0:
            next_foot = past * following[0] - beside * following[1]
            next_beside = beside * following[0] + past * following[1]
            goes_on = is_within(past, beside, safe) and climbs(next_foot, next_beside, following[2], form) < 0.0
            return LEFT_OUT if joined & BEFORE_NEXT and goes_on else length
    half = math.sqrt(max(radius * radius - beside * beside, 0.0))
    s = foot + lead(beside, rise, form)
    if s < -SURE_MM and joined & AFTER_LAST and is_within(foot, beside, safe):
        return LEFT_OUT
    return min(max(s, foot - half, 0.0), foot + half, length)


@njit
def is_within(foot, beside, radius):
    """Say whether a place is nearer than `radius`."""
    return foot * foot + beside * beside <= radius * radius


@njit
def climbs(foot, beside, rise, form):
    """Return a number with the sign of the slope, along a move, of the cutter's height over a cell.

    The cell lies `foot` mm ahead of the axis and `beside` mm beside the move; 0 where it lies out of reach or the
    sign is not sure. The cutter has a floor and a round corner.
    """
    radius, tip, corner, _ = form
    square = foot * foot + beside * beside
    if square > radius * radius:
        return 0.0
    if square <= tip * tip:
        return rise
    out = math.sqrt(square)
    beyond = out - tip
    slope = rise * out * math.sqrt(max(corner * corner - beyond * beyond, 0.0)) - beyond * foot
    return 0.0 if abs(slope) <= SURE_MM else slope


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
    """Return the common values of a move's rows: first and last y; the circle that is left out; 1 / direction."""
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
