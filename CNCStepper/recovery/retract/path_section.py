# SPDX-License-Identifier: LGPL-2.1-or-later
"""The moves along a stretch of the way, in either sense: each with the part of the way that it is."""

from __future__ import annotations

from collections.abc import Iterator
from math import ceil, tau

from CNCStepper.recovery.retract.move_curve import Move
from CNCStepper.recovery.retract.path import Place, RetractPath
from CNCStepper.toolpath import LINE, RAPID

SHORT_MM = 0.01  # shorter arcs become lines: their rounded ends would say another angle
MOST_SWEEP_RAD = 0.75 * tau  # of one move: beyond it rounded ends could make a whole circle of it, or none

Part = tuple[int, float, float]  # row, from share, to share


def stretch_moves(way: RetractPath, begin: Place, end: Place) -> Iterator[tuple[Move, Part]]:
    """Yield the moves between two places, the first from the machine's position, less than a step away.

    Rows that lead nowhere are left out.
    """
    row = min(max(begin.row, 0), len(way) - 1)
    move = way.move(row)
    there_mm = move.at(begin.share)
    yield Move(_straight(move), there_mm, there_mm, feed_mm_min=move.feed_mm_min), (row, begin.share, begin.share)
    for row, first, last in way.stretch(begin, end):
        if not way.move(row).is_still:
            for one, part in _pieces(way.move(row), first, last):
                yield one, (row, *part)


def _pieces(move: Move, first: float, last: float) -> Iterator[tuple[Move, tuple[float, float]]]:
    """Yield a part of a move in pieces that rounding cannot turn into something else."""
    share = last - first
    if not move.is_arc or move.length_mm * abs(share) < SHORT_MM:
        yield Move(_straight(move), move.at(first), move.at(last), feed_mm_min=move.feed_mm_min), (first, last)
        return
    count = ceil(abs(move.sweep_rad * share) / MOST_SWEEP_RAD)
    for number in range(count):
        ends = first + share * number / count, first + share * (number + 1) / count
        yield move.part(*ends), ends


def _straight(move: Move) -> int:
    """Return the kind of the straight move that goes as fast."""
    return RAPID if move.kind == RAPID else LINE
