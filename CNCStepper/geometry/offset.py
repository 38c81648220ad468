# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Parallel curves of chains of lines and arcs, exact: the parallel of a line is a line, that of an arc an arc.

         . - - - - - - .        every segment is moved to its left by the distance; a corner that opens to the
       /  . - - - - .    \      left gives an arc round itself; arcs that turn left by less than the distance
      |  |   wall    |    |     vanish. What so arises crosses itself and each other, is cut there, and a piece
       \  ' - - - - '    /      stays if it is as far from all source segments as the distance.
         ' - - - - - - '

A piece is wholly right or wholly wrong: it could change only where it is at the distance from a second segment,
and there it crosses that one's parallel. So nothing is guessed from turning numbers, and collapse, splitting and
merging of islands are no cases of their own. After X.-Z. Liu et al., "An offset algorithm for polyline curves",
Computers in Industry 58 (2007), with the distance as the only judge.

Where a shape is exactly as wide as twice the distance, rounding decides whether a piece is right, and the pieces
may not close; then the distance is changed by a small part of the tolerance, first so that more is left. Where that
does not help, the chains have steps far shorter than the tolerance: such ones are joined up.
"""

from __future__ import annotations

import itertools
import math

import numpy as np

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.box_tree import WIDTH, place_at, write_row
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.curve_bundle import Bundle, bundle_of, long_enough
from CNCStepper.geometry.loop_pieces import LOOKED_AT, chained, crossed, looked_at_mm
from CNCStepper.geometry.proximity_tree import DEAD, FAR, looks, spines_of
from CNCStepper.kernels import njit
from CNCStepper.tolerances import COINCIDENT_MM, OFFSET_ROUNDING_MM, SAME_MM

CUSP_RAD = 1e-6  # so near to a half turn the curvatures say which way a corner turns
STROKE_RAD = 1e-9  # so near to it the line runs back on itself
FLAT_MM = 1e-6  # an arc that rises less is taken for its chord
TRIALS = (0, -1, 1, -2, 2, -3, 3, -5, 5, -8, 8)
STEP = 1 / 64  # of the tolerance
SHORT = (0.0, 1 / 64, 1 / 16, 1 / 4, 1 / 2)  # of the tolerance: steps of chains up to so long are joined up


def left_loops(source: Bundle, distance_mm: float, tolerance_mm: float) -> Bundle:
    """Return the closed curves `distance_mm` > 0 to the left of closed ones that do not cross.

    The material lies to the left: loops around it run counter-clockwise, those around holes clockwise, and so do
    the curves returned. The distance holds within `tolerance_mm`. Raises GeometryError when no closed curves are found.
    """
    for share, trial in itertools.product(SHORT, TRIALS):
        tried_mm = distance_mm + trial * STEP * tolerance_mm
        closes, found = _parallel(source, max(share * tolerance_mm, SAME_MM), tried_mm)
        if closes:
            return found
    raise GeometryError(
        "offset",
        "no closed curves at that distance were found",
        value=f"{distance_mm:g} mm",
        limit=f"{tolerance_mm:g} mm",
        advice="change the distance or the tolerance a little",
    )


def parallels(curve: Curve, distance_mm: float, tolerance_mm: float) -> list[Curve]:
    """Return the curves at `distance_mm` to the left of one, open or closed, to its right where it is below 0.

    They run as the curve does and keep the distance from all of it: where it comes too near to itself, crosses
    itself or turns too sharply, they are cut off. Pieces shorter than the tolerance are left out.
    """
    if not (tolerance_mm > 0 and np.isfinite(distance_mm)):
        what, advice = "a tolerance must be above 0", "give a tolerance above 0"
        raise GeometryError("offset-tolerance", what, value=f"{tolerance_mm:g} mm", advice=advice)
    if abs(distance_mm) <= SAME_MM:
        return [curve]
    if distance_mm < 0:
        return [found.reversed() for found in parallels(curve.reversed(), -distance_mm, tolerance_mm)]
    _, found = _parallel(bundle_of([curve]), SAME_MM, distance_mm, both_sides=True)
    return [piece for piece in found.curves() if piece.length_mm > tolerance_mm]


def _parallel(source: Bundle, shortest_mm: float, distance_mm: float, both_sides: bool = False) -> tuple[bool, Bundle]:
    """Return whether all that is found at a distance to the left of chains closes, and its loops.

    Where a chain is open or crosses itself, `both_sides` of it and its ends bound what is far enough.
    """
    rows, follower, _ = source_of(*source, shortest_mm)
    spines = spines_of(rows)
    raw, own = raw_parallel(rows, follower, distance_mm)
    lefts = len(raw)
    if both_sides:
        right, beside = raw_parallel(rows, follower, -distance_mm)
        caps = _caps(rows, follower, distance_mm)
        raw, own = np.concatenate([raw, right, caps]), np.concatenate([own, beside, np.zeros(len(caps), int)])
    seen = _seen(raw, own, rows, spines, distance_mm - OFFSET_ROUNDING_MM)
    alive = np.flatnonzero(seen != DEAD)
    lefts = int(np.searchsorted(alive, lefts))
    if not lefts:
        return True, Bundle(np.zeros((0, 2)), np.zeros(0), np.zeros(0, int))
    raw, own, seen = raw[alive], own[alive], seen[alive]
    pieces, nodes = crossed(raw, own, rows, spines, distance_mm - 10.0 * OFFSET_ROUNDING_MM)
    far = _far(pieces, raw, own, seen, lefts, rows, spines, distance_mm - OFFSET_ROUNDING_MM)
    closes, *found = chained(raw, pieces, far, nodes)
    return closes, Bundle(*found)


@njit
def source_of(xy, bulge, counts, shortest_mm):
    """Return the rows of a bundle, which of them follows which (-1 at the end of an open chain), and its chain.

    Runs of segments that are shorter together are left out. int64[n] both.
    """
    rows, count, first = np.empty((len(bulge), WIDTH)), 0, 0
    follower, owner = np.empty(len(bulge), np.int64), np.empty(len(bulge), np.int64)
    for chain in range(len(counts)):
        begin = first + chain
        vertices, last = xy[begin : begin + counts[chain] + 1], first + counts[chain]
        laid, closed = _lay_chain(rows[count:], vertices, bulge[first:last], shortest_mm)
        for row in range(count, count + laid):
            follower[row], owner[row] = row + 1, chain
        if laid:
            follower[count + laid - 1] = count if closed else -1
        count, first = count + laid, last
    return rows[:count], follower[:count], owner[:count]


@njit
def _lay_chain(rows, vertices, bulge, shortest_mm):
    """Write the rows of one chain without short runs; return how many they are and whether it is closed."""
    keep = np.flatnonzero(long_enough(vertices, bulge, shortest_mm))
    closed = math.hypot(vertices[0, 0] - vertices[-1, 0], vertices[0, 1] - vertices[-1, 1]) <= COINCIDENT_MM
    for row in range(len(keep)):
        here, after = keep[row], keep[(row + 1) % len(keep)]
        if not closed and row + 1 == len(keep):
            after = len(bulge)
        (bx, by), (ex, ey) = vertices[here], vertices[after]
        flat = abs(bulge[here]) * math.hypot(ex - bx, ey - by) / 2.0 <= FLAT_MM
        write_row(rows, row, bx, by, ex, ey, 0.0 if flat else 4.0 * math.atan(bulge[here]))
    return len(keep), closed


@njit
def _seen(raw, own, rows, spines, far_mm):
    """Return the result of a look for each row of the raw parallel: DEAD when all of it is too near."""
    there, dead = np.empty((len(raw), 2)), np.empty(len(raw))
    for row in range(len(raw)):
        there[row, 0], there[row, 1] = place_at(raw, row, LOOKED_AT * raw[row, 10])
        dead[row] = far_mm - (1.0 - LOOKED_AT) * raw[row, 10]
    return looks(rows, spines, there, own, far_mm, dead)


@njit
def _far(pieces, raw, own, seen, lefts, rows, spines, far_mm):
    """Return which pieces of the first rows, `lefts` of them, are far enough, int64[k]; of whole rows it is `seen`."""
    there, owns, asked = np.empty((len(pieces.row), 2)), np.empty(len(pieces.row), np.int64), 0
    for piece in range(len(pieces.row)):
        row = pieces.row[piece]
        if row < lefts and pieces.last_mm[piece] - pieces.first_mm[piece] < raw[row, 10]:
            there[asked, 0], there[asked, 1] = place_at(raw, row, looked_at_mm(pieces, piece))
            owns[asked] = own[row]
            asked += 1
    judged = looks(rows, spines, there[:asked], owns, far_mm, np.full(asked, far_mm))
    far, asked = np.zeros(len(pieces.row), np.bool_), 0
    for piece in range(len(pieces.row)):
        row = pieces.row[piece]
        if row < lefts and pieces.last_mm[piece] - pieces.first_mm[piece] < raw[row, 10]:
            far[piece] = judged[asked] == FAR
            asked += 1
        elif row < lefts:
            far[piece] = seen[row] == FAR
    return np.flatnonzero(far)


@njit
def _caps(rows, follower, radius_mm):
    """Return circles round the ends of the open chains, as half circles."""
    caps, count, loose = np.empty((4 * len(rows), WIDTH)), 0, np.ones((len(rows), 2), np.bool_)
    for row in range(len(rows)):
        if follower[row] >= 0:
            loose[row, 1] = loose[follower[row], 0] = False
    for row in range(len(rows)):
        for end in range(2):
            if loose[row, end]:
                x, y = rows[row, 2 * end], rows[row, 2 * end + 1]
                write_row(caps, count, x + radius_mm, y, x - radius_mm, y, math.pi)
                write_row(caps, count + 1, x - radius_mm, y, x + radius_mm, y, math.pi)
                count += 2
    return caps[:count]


@njit
def raw_parallel(rows, follower, distance_mm):
    """Return the parallel of each row to its left (to its right below 0) and the arcs round corners that open there.

    A parallel has the directions of its row; an arc round a corner those of the rows that meet there. With them
    comes the row of which each is a parallel, or that ends in the corner, int64[n].
    """
    raw, own, count = np.empty((2 * len(rows), WIDTH)), np.empty(2 * len(rows), np.int64), 0
    for row in range(len(rows)):
        scale = 1.0 - rows[row, 5] * distance_mm
        if scale > 1e-9:
            _lay_beside(raw[count], rows[row], scale, distance_mm)
            own[count] = row
            count += 1
        if follower[row] >= 0:
            turn = _corner(rows, row, follower[row], math.copysign(1.0, distance_mm))
            if turn * distance_mm < -SAME_MM:
                _lay_round(raw[count], rows[row], rows[follower[row]], turn, distance_mm)
                own[count] = row
                count += 1
    return raw[:count], own[:count]


@njit
def _lay_beside(raw, row, scale, distance_mm):
    raw[:] = row
    for end in range(2):
        raw[2 * end] -= distance_mm * row[7 + 2 * end]
        raw[2 * end + 1] += distance_mm * row[6 + 2 * end]
    raw[5] /= scale
    raw[10] *= scale


@njit
def _lay_round(raw, here, after, turn, distance_mm):
    raw[0], raw[1] = here[2] - distance_mm * here[9], here[3] + distance_mm * here[8]
    raw[2], raw[3] = here[2] - distance_mm * after[7], here[3] + distance_mm * after[6]
    raw[4], raw[5], raw[10] = turn, -1.0 / distance_mm, -turn * distance_mm
    raw[6:8], raw[8:10] = here[8:10], after[6:8]


@njit
def _corner(rows, here, after, side):
    """Return the angle by which a chain turns where one row ends and another begins, rad; side: 1 left, -1 right.

    A line that runs back on itself turns away from either side.
    """
    bx, by, ax, ay = rows[here, 8], rows[here, 9], rows[after, 6], rows[after, 7]
    turn = math.atan2(bx * ay - by * ax, bx * ax + by * ay)
    opening = rows[here, 5] + rows[after, 5]  # of the two sides of a cusp: above 0 to the left
    if abs(turn) > math.pi - (CUSP_RAD if opening != 0.0 else STROKE_RAD):
        return side * math.pi if side * opening < 0.0 else -side * math.pi
    return turn
