# SPDX-License-Identifier: LGPL-2.1-or-later
"""The loops round what lies within any of some closed curves and within none of others, or within an odd number.

The curves are cut where they cross, and of each piece both sides are looked at: one that has what is wanted on one
side only is kept, run so that it is on the left.
"""

from __future__ import annotations

import numpy as np

from CNCStepper.geometry.box_tree import direction_at, place_at
from CNCStepper.geometry.curve_bundle import Bundle
from CNCStepper.geometry.loop_pieces import LoopPieces, chained, crossed, looked_at_mm
from CNCStepper.geometry.offset import source_of
from CNCStepper.geometry.proximity_tree import spines_of
from CNCStepper.geometry.winding_number import windings
from CNCStepper.kernels import njit

EVEN_ODD = -1


def bounds(source: Bundle, outlines: int, small_mm: float, beside_mm: float) -> tuple[bool, Bundle]:
    """Return whether all loops close, and the loops round what some closed curves hold.

    They bound what lies within the first curves, `outlines` of them, and within none of the others; with EVEN_ODD what
    an odd number of turns of all curves goes round. Shorter steps than `small_mm` are left out; `beside_mm` is how far
    beside a piece its two sides are looked at.
    """
    rows, _, owner = source_of(*source, small_mm)
    pieces, nodes = crossed(rows, np.arange(len(rows)), rows, spines_of(rows), 0.0)
    spokesman = _spokesmen(pieces, owner, len(source.counts), len(nodes))
    left, right = _sides(rows, pieces, owner, spokesman, outlines, beside_mm)
    closes, *found = chained(rows, _turned(pieces, right & ~left), np.flatnonzero(left != right), nodes)
    return closes, Bundle(*found)


def _turned(pieces: LoopPieces, which: np.ndarray) -> LoopPieces:
    """Return the pieces, some of them run backwards."""
    row, first, last, begin, end = pieces
    return LoopPieces(
        row,
        np.where(which, last, first),
        np.where(which, first, last),
        np.where(which, end, begin),
        np.where(which, begin, end),
    )


@njit
def _spokesmen(pieces, owner, curves, count):
    """Return for each piece the piece that answers for it: of a curve that nothing meets one for all.

    Curves meet at nodes, `count` of them, where more than two pieces end: also those that share corners or edges only.
    """
    ends, met, longest = np.zeros(count, np.int64), np.zeros(curves, np.bool_), np.full(curves, -1)
    for piece in range(len(pieces.row)):
        ends[pieces.begin[piece]] += 1
        ends[pieces.end[piece]] += 1
    length_mm = pieces.last_mm - pieces.first_mm
    for piece in range(len(pieces.row)):
        curve = owner[pieces.row[piece]]
        met[curve] |= ends[pieces.begin[piece]] > 2 or ends[pieces.end[piece]] > 2
        if longest[curve] < 0 or length_mm[piece] >= length_mm[longest[curve]]:
            longest[curve] = piece
    spokesman = np.arange(len(pieces.row))
    for piece in range(len(pieces.row)):
        curve = owner[pieces.row[piece]]
        if not met[curve]:
            spokesman[piece] = longest[curve]
    return spokesman


@njit
def _sides(rows, pieces, owner, spokesman, outlines, beside_mm):
    """Return for each piece whether the wanted area is to its left and to its right, as at its representative."""
    asked = np.flatnonzero(spokesman == np.arange(len(spokesman)))
    places = np.empty((2 * len(asked), 2))
    for index in range(len(asked)):
        row, there_mm = pieces.row[asked[index]], looked_at_mm(pieces, asked[index])
        (x, y), (ux, uy) = place_at(rows, row, there_mm), direction_at(rows, row, there_mm)
        for side, aside_mm in enumerate((beside_mm, -beside_mm)):
            places[2 * index + side] = x - aside_mm * uy, y + aside_mm * ux
    within, without = np.zeros(len(places), np.bool_), np.zeros(len(places), np.bool_)
    first = 0
    while first < len(rows):
        last = first + np.searchsorted(owner[first:], owner[first], side="right")
        turns = windings(rows[first:last], places)
        if outlines == EVEN_ODD:
            within ^= turns % 2 != 0
        elif owner[first] < outlines:
            within |= turns != 0
        else:
            without |= turns != 0
        first = last
    wanted, left, right = within & ~without, np.zeros(len(spokesman), np.bool_), np.zeros(len(spokesman), np.bool_)
    number = np.zeros(len(spokesman), np.int64)
    number[asked] = np.arange(len(asked))
    for piece in range(len(spokesman)):
        asked_of = number[spokesman[piece]]
        left[piece], right[piece] = wanted[2 * asked_of], wanted[2 * asked_of + 1]
    return left, right
