# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kernels: where along a ramp the cutter is lowest over a cell, and which cells another ramp of a chain cuts lower.

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
from CNCStepper.simulation.cutter_profile import lead

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
    if tip > 0.0 and corner > 0.0:  # asks less than its lead does
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
