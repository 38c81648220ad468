# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kernels: lines and arcs cut where they cross, and loops made of the pieces that a caller keeps.

Places no farther apart than SAME_MM are one node. What is kept must arrive at each node as often as it leaves it:
then every piece lies on a loop, and where several leave a node the loop turns as far left as it can, so that
loops touch but never cross.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from CNCStepper.geometry.box_tree import direction_at, place_at, tree_of
from CNCStepper.geometry.curve_columns import STRAIGHT_MM
from CNCStepper.geometry.intersections import crossings
from CNCStepper.kernels import njit
from CNCStepper.tolerances import SAME_MM, SAME_PIECE_MM

LOOKED_AT = 0.382  # of a piece: its very middle may touch something by symmetry, this place by no such chance
SHORT_MM = 4.0 * SAME_MM  # a shorter piece that returns to its node is none


class LoopPieces(NamedTuple):
    """Pieces of rows (see box_tree.py): row, lengths on it, nodes, all [m]; `last_mm` < `first_mm` runs backwards."""

    row: np.ndarray
    first_mm: np.ndarray
    last_mm: np.ndarray
    begin: np.ndarray
    end: np.ndarray


@njit
def some_of(pieces, which):
    """Return some of the pieces, int64[k]."""
    return LoopPieces(
        pieces.row[which],
        pieces.first_mm[which],
        pieces.last_mm[which],
        pieces.begin[which],
        pieces.end[which],
    )


@njit
def crossed(rows, own, near, spines, limit_mm):
    """Return the rows cut where they cross, no nearer than a limit to the rows `near`, and the nodes, float64[k, 2].

    own, spines: as for `crossings`.
    """
    boxes, tree = tree_of(rows, SAME_MM)
    return cut(rows, crossings(rows, own, boxes, tree, near, spines, limit_mm))


@njit
def chained(rows, pieces, which, nodes):
    """Return whether all chains of some pieces, int64[k], close, and these in the columns of a bundle
    (curve_bundle.py)."""
    some = without_twins(rows, some_of(pieces, which), len(nodes))
    xy, bulge, counts = loops(rows, some, nodes)
    return balanced(some, len(nodes)), xy, bulge, counts


@njit
def cut(rows, met):
    """Return the rows cut at their crossings `met`, and the nodes."""
    count, crossings = len(rows), len(met)
    row, length = np.empty(2 * (count + crossings), np.int64), np.empty(2 * (count + crossings))
    places = np.empty((2 * (count + crossings), 2))
    for here in range(count):
        for end in range(2):
            at = here + end * count
            row[at], length[at] = here, end * rows[here, 10]
            places[at, 0], places[at, 1] = rows[here, 2 * end], rows[here, 2 * end + 1]
    for crossing in range(crossings):
        for side in range(2):
            at = 2 * count + crossing + side * crossings
            row[at], length[at] = int(met[crossing, 2 * side]), met[crossing, 2 * side + 1]
            places[at, 0], places[at, 1] = met[crossing, 4], met[crossing, 5]
    node, nodes = merged(places)
    order = _in_order(length, row, count)
    first = np.empty(len(order), np.int64)
    last, real = np.empty(len(order), np.int64), 0
    for index in range(len(order) - 1):
        here, after = order[index], order[index + 1]
        there = node[here] != node[after] or length[after] - length[here] > SHORT_MM
        if row[here] == row[after] and there:
            first[real], last[real] = here, after
            real += 1
    first, last = first[:real], last[:real]
    return LoopPieces(row[first], length[first], length[last], node[first], node[last]), nodes


@njit
def _in_order(length, row, count):
    """Return the order of lengths along rows, row by row; most rows have only their two ends, which are in order."""
    order, first = grouped(np.arange(len(row)), row, count)
    for here in range(count):
        own = order[first[here] : first[here + 1]]
        if len(own) > 2:
            own[:] = own[np.argsort(length[own], kind="mergesort")]
    return order


@njit
def grouped(order, key, count):
    """Return an order sorted by keys from 0 to `count` - 1, equal ones as they were, and where each key begins."""
    first = np.zeros(count + 2, np.int64)
    for index in order:
        first[key[index] + 2] += 1
    for number in range(count):
        first[number + 2] += first[number + 1]
    found = np.empty_like(order)
    for index in order:
        found[first[key[index] + 1]] = index
        first[key[index] + 1] += 1
    return found, first[: count + 1]


@njit
def merged(places):
    """Return for each place, float64[m, 2], the number of its node, int64[m], and the nodes, float64[k, 2]."""
    askew = places[:, 0] * math.cos(1.0) + places[:, 1] * math.sin(1.0)  # no drawing has many places along this line
    order = np.argsort(askew, kind="mergesort")
    node, count, open_ = np.empty(len(order), np.int64), 0, 0
    for index in range(len(order)):
        here = order[index]
        node[here] = -1
        while askew[here] - askew[order[open_]] > SAME_MM:
            open_ += 1
        for before in range(index - 1, open_ - 1, -1):
            there = order[before]
            if math.hypot(places[here, 0] - places[there, 0], places[here, 1] - places[there, 1]) <= SAME_MM:
                node[here] = node[there]
                break
        if node[here] < 0:
            node[here] = count
            count += 1
    nodes = np.empty((count, 2))
    for place in range(len(places) - 1, -1, -1):  # the first place of a node names it
        nodes[node[place], 0], nodes[node[place], 1] = places[place, 0], places[place, 1]
    return node, nodes


@njit
def looked_at_mm(pieces, piece):
    """Return the length on its row at which a piece is judged."""
    return pieces.first_mm[piece] + LOOKED_AT * (pieces.last_mm[piece] - pieces.first_mm[piece])


@njit
def without_twins(rows, pieces, count):
    """Return one of the pieces that lie on each other, and none where two lie on each other in opposite directions.

    count: of the nodes.
    """
    keep = np.ones(len(pieces.row), np.bool_)
    low, high = np.minimum(pieces.begin, pieces.end), np.maximum(pieces.begin, pieces.end)
    order = grouped(grouped(np.arange(len(low)), high, count)[0], low, count)[0]
    first = 0
    for index in range(1, len(order) + 1):
        one = order[first]
        if index < len(order) and low[order[index]] == low[one] and high[order[index]] == high[one]:
            continue
        if index - first > 1:
            _settle(rows, pieces, order[first:index], keep)
        first = index
    return some_of(pieces, np.flatnonzero(keep))


@njit
def _settle(rows, pieces, group, keep):
    """Drop from pieces between the same two nodes the doubles and the opposites."""
    middle = np.empty((len(group), 2))
    for index in range(len(group)):
        piece = group[index]
        half_mm = (pieces.first_mm[piece] + pieces.last_mm[piece]) / 2.0
        middle[index, 0], middle[index, 1] = place_at(rows, pieces.row[piece], half_mm)
    for index in range(len(group)):
        for after in range(index + 1, len(group)):
            one, other = group[index], group[after]
            away = math.hypot(middle[index, 0] - middle[after, 0], middle[index, 1] - middle[after, 1])
            if keep[one] and keep[other] and away <= SAME_PIECE_MM:
                keep[other] = False
                keep[one] = pieces.begin[one] == pieces.begin[other]


@njit
def balanced(pieces, count):
    """Return whether at each of the nodes, `count` of them, as many pieces arrive as leave."""
    more = np.zeros(count, np.int64)
    for piece in range(len(pieces.row)):
        more[pieces.begin[piece]] += 1
        more[pieces.end[piece]] -= 1
    return not more.any()


@njit
def loops(rows, pieces, nodes):
    """Return the chains that the pieces make, closed ones where the pieces are balanced, in the columns of a bundle."""
    walk, bounds = _walk(rows, pieces, len(nodes))
    xy, bulge = np.empty((len(walk) + len(bounds), 2)), np.empty(len(walk))
    counts, segments = np.empty(len(bounds) - 1, np.int64), 0
    for loop in range(len(counts)):
        chain = walk[bounds[loop] : bounds[loop + 1]]
        counts[loop] = _lay_chain(rows, pieces, nodes, chain, xy[segments + loop :], bulge[segments:])
        segments += counts[loop]
    return xy[: segments + len(counts)], bulge[:segments], counts


@njit
def _lay_chain(rows, pieces, nodes, chain, xy, bulge):
    """Write the columns of a chain of pieces and return how many segments it has.

    Pieces that continue each other on their row become one.
    """
    closed = pieces.begin[chain[0]] == pieces.end[chain[-1]]
    head, count, sweep = 0, 0, 0.0
    while closed and head < len(chain) and _goes_on(pieces, chain[head - 1], chain[head]):
        head += 1
    for index in range(len(chain)):
        here = chain[(head + index) % len(chain)]
        if index == 0 or not _goes_on(pieces, chain[(head + index - 1) % len(chain)], here):
            xy[count] = nodes[pieces.begin[here]]
            count, sweep = count + 1, 0.0
        xy[count] = nodes[pieces.end[here]]
        sweep += rows[pieces.row[here], 5] * (pieces.last_mm[here] - pieces.first_mm[here])
        turned = math.tan(sweep / 4.0)
        rise_mm = abs(turned) * math.hypot(xy[count, 0] - xy[count - 1, 0], xy[count, 1] - xy[count - 1, 1]) / 2.0
        bulge[count - 1] = turned if rise_mm > STRAIGHT_MM else 0.0
    return count


@njit
def _goes_on(pieces, one, other):
    """Return whether a piece begins on its row where another ends."""
    return pieces.row[one] == pieces.row[other] and abs(pieces.last_mm[one] - pieces.first_mm[other]) <= SAME_MM


@njit
def _walk(rows, pieces, count):
    """Return the pieces in the order of the loops, and where in it each loop begins; `count` is that of the nodes."""
    total = len(pieces.row)
    order, first = grouped(np.arange(total), pieces.begin, count)
    more = np.zeros(count, np.int64)  # leave a node than arrive there
    for piece in range(total):
        more[pieces.begin[piece]] += 1
        more[pieces.end[piece]] -= 1
    walk, bounds, done, chains = np.empty(total, np.int64), np.zeros(total + 1, np.int64), 0, 0
    used = np.zeros(total, np.bool_)
    for opens in (True, False):  # an open chain is begun at its begin
        for seed in range(total):
            if used[seed] or (opens and more[pieces.begin[seed]] <= 0):
                continue
            here = seed
            while here >= 0:
                walk[done] = here
                used[here] = True
                done += 1
                leaving = order[first[pieces.end[here]] : first[pieces.end[here] + 1]]
                here = _leftmost(rows, pieces, here, leaving, used, seed)
            chains += 1
            bounds[chains] = done
    return walk, bounds[: chains + 1]


@njit
def _leftmost(rows, pieces, here, leaving, used, seed):
    """Return which of the pieces that leave a node turns leftmost; -1 for none or where the loop closes."""
    ix, iy, _ = _way(rows, pieces, here, pieces.last_mm[here])
    best, most, most_bend = -1, -10.0, 0.0
    for other in leaving:
        if used[other] and other != seed:
            continue
        ox, oy, bend = _way(rows, pieces, other, pieces.first_mm[other])
        turn = math.atan2(ix * oy - iy * ox, ix * ox + iy * oy)
        if turn > math.pi - 1e-7:
            turn = -math.pi  # straight back is the last choice
        if turn > most + 1e-7 or (turn > most - 1e-7 and bend > most_bend):
            best, most, most_bend = other, turn, bend
    return best if best != seed else -1


@njit
def _way(rows, pieces, piece, length_mm):
    """Return in which direction a piece runs at a length on its row, x and y, and how it bends."""
    row, forth = pieces.row[piece], 1.0 if pieces.last_mm[piece] >= pieces.first_mm[piece] else -1.0
    x, y = direction_at(rows, row, length_mm)
    return forth * x, forth * y, forth * rows[row, 5]
