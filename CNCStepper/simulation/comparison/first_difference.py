# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where two tool paths part: both are followed together, however each is divided into moves.

    first    o-------o-----------o--------o        the end that comes next, of either path, must lie on the segment
    second   o---o---------------o---o----o        of the other one; then that path goes on with its next segment

Arcs are chords here, so an arc and the chords that stand for it are the same path. A rapid is never the same as a cut.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from CNCStepper.kernels import njit
from CNCStepper.simulation.tip_segments import Segments
from CNCStepper.tolerances import SAME_CONVERTED_FEED


class Course(NamedTuple):
    """A path to follow: its segments with a length, in order, and of each whether it cuts, its feed and its modes.

    cuts: bool[n]. feed_mm_min: float64[n]. mode: int64[n], equal where tool, spindle and coolant are the same.
    """

    segments: Segments
    cuts: np.ndarray
    feed_mm_min: np.ndarray
    mode: np.ndarray


class Parting(NamedTuple):
    """Rows of both tables of moves at which something differs first; -1 for the end of a path, None for nowhere.

    path: where the tool goes elsewhere, or a rapid is a cut. feed, mode: where the same path is cut at another feed, or
    with another tool, spindle or coolant.
    """

    path: tuple[int, int] | None
    feed: tuple[int, int] | None
    mode: tuple[int, int] | None


def first_differences(first: Course, second: Course, same_mm: float) -> Parting:
    """Follow two paths together and return where they differ first; feeds and modes are compared up to there."""
    found = followed(*_arrays(first), *_arrays(second), same_mm, SAME_CONVERTED_FEED)
    pairs = [_rows(first, second, *pair) for pair in found.tolist()]
    return Parting(*pairs)


def _arrays(course: Course) -> tuple[np.ndarray, ...]:
    points = (np.ascontiguousarray(each, float) for each in (course.segments.begin, course.segments.end))
    return (*points, course.cuts, course.feed_mm_min, course.mode)


def _rows(first: Course, second: Course, here: int, there: int) -> tuple[int, int] | None:
    """Return the rows of two segments; NOWHERE is none, and a number behind the last segment the path's end."""
    if here == NOWHERE:
        return None
    places = ((first, here), (second, there))
    one, other = (int(of.segments.row[place]) if place < len(of.segments) else -1 for of, place in places)
    return one, other


NOWHERE = -1
HALF = 0.5  # of the shorter segment: what two have in common must be that long for their feeds to be compared


@njit
def followed(begin, end, cuts, feed, mode, begin2, end2, cuts2, feed2, mode2, same_mm, same_feed):
    """Return the first segments of both paths that differ in path, feed and mode, int64[3, 2]."""
    found = np.full((3, 2), NOWHERE)
    i, j = 0, 0
    here, there = np.empty(3), np.empty(3)
    if len(begin):
        here[:] = begin[0]
    if len(begin2):
        there[:] = begin2[0]
    if len(begin) and len(begin2) and _between(here, there) > same_mm:
        found[0] = 0, 0
        return found
    while i < len(begin) and j < len(begin2):
        left, left2 = _between(here, end[i]), _between(there, end2[j])
        if cuts[i] != cuts2[j]:  # what is left of one path may be shorter than the tolerance
            if _between(there, end[i]) <= same_mm and left <= same_mm:
                i = _next(i, begin, here)
            elif _between(here, end2[j]) <= same_mm and left2 <= same_mm:
                j = _next(j, begin2, there)
            else:
                break
            continue
        common = min(left, left2)
        if common >= HALF * min(_between(begin[i], end[i]), _between(begin2[j], end2[j])):
            if found[1, 0] == NOWHERE and abs(feed[i] - feed2[j]) > same_feed * max(feed[i], feed2[j]):
                found[1] = i, j
            if found[2, 0] == NOWHERE and mode[i] != mode2[j]:
                found[2] = i, j
        if left <= left2:
            if _project(end[i], there, end2[j]) > same_mm:
                break
            i = _next(i, begin, here)
            if _between(there, end2[j]) <= same_mm:
                j = _next(j, begin2, there)
        else:
            if _project(end2[j], here, end[i]) > same_mm:
                break
            j = _next(j, begin2, there)
            if _between(here, end[i]) <= same_mm:
                i = _next(i, begin, here)
    while i < len(begin) and j == len(begin2) and len(begin2) and _between(end[i], end2[j - 1]) <= same_mm:
        i += 1  # what is left within the tolerance round the other path's end
    while j < len(begin2) and i == len(begin) and len(begin) and _between(end2[j], end[i - 1]) <= same_mm:
        j += 1
    if i < len(begin) or j < len(begin2):
        found[0] = i, j
    return found


@njit
def _next(at, begin, place):
    """Go on to the next segment, at whose begin the path is then."""
    if at + 1 < len(begin):
        place[:] = begin[at + 1]
    return at + 1


@njit
def _between(one, other):
    x, y, z = one[0] - other[0], one[1] - other[1], one[2] - other[2]
    return math.sqrt(x * x + y * y + z * z)


@njit
def _project(place, begin, end):
    """Return how far a place is from a segment, and move the segment's begin to what is nearest to the place."""
    along, square = 0.0, 0.0
    for axis in range(3):
        way = end[axis] - begin[axis]
        along += (place[axis] - begin[axis]) * way
        square += way * way
    share = min(max(along / square, 0.0), 1.0) if square > 0.0 else 0.0
    for axis in range(3):
        begin[axis] += share * (end[axis] - begin[axis])
    return _between(place, begin)
