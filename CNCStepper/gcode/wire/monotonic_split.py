# SPDX-License-Identifier: LGPL-2.1-or-later
"""Splits a move into pieces in which no axis reverses, so that backlash is crossed only between two of them.

arc that crosses three of its four extremes      ╭──┊──╮
                                                 │     ┈      one piece more than there are extremes
move from an unknown place                      ? ──► end - gap ──► end, so that it arrives in the true sense
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import NamedTuple

from CNCStepper.gcode.interpreter.motion.arcs import FULL_TURN, sweep
from CNCStepper.geometry.quadrant_points import point_on_arc, turning_points
from CNCStepper.machine.backlash import Backlash
from CNCStepper.toolpath import ARC_CW, PLANE_AXES

Place = tuple[float, ...]


class Piece(NamedTuple):
    """A part of a move: begin and end in mm, its share of the path, and its turns as in the table."""

    begin_mm: Place
    end_mm: Place
    share: float
    turns: int


def straight_pieces(play: Backlash, begin_mm: Place, end_mm: Place) -> list[Piece]:
    """Return a straight move as one piece, or as two where it comes from an unknown place."""
    first = play.approach(begin_mm, end_mm)
    if first is None:
        return [Piece(begin_mm, end_mm, 1.0, 0)]
    return [Piece(begin_mm, first, 1.0, 0), Piece(first, end_mm, 1.0, 0)]


def arc_pieces(
    play: Backlash, begin_mm: Place, end_mm: Place, centre_mm: Place, kind: int, plane: int, turns: int
) -> list[Piece]:
    """Return an arc or helix cut where an axis with play turns back; whole where none does."""
    one, two, normal = PLANE_AXES[plane]
    begin, end, centre = ((place[one], place[two]) for place in (begin_mm, end_mm, centre_mm))
    swept = sweep(begin, end, centre, kind == ARC_CW) + (turns - 1) * FULL_TURN
    swept = -swept if kind == ARC_CW else swept
    least = tuple(1.0 / play.steps_per_mm[axis] if play.backlash_mm[axis] else math.inf for axis in (one, two))
    shares = [turn / abs(swept) for turn in turning_points(begin, centre, swept, (least[0], least[1]))]
    if not shares:
        return [Piece(begin_mm, end_mm, 1.0, turns)]
    places = [begin_mm]
    for share in shares:
        place = [0.0] * len(begin_mm)
        place[one], place[two] = point_on_arc(begin, end, centre, swept, share)
        place[normal] = begin_mm[normal] + (end_mm[normal] - begin_mm[normal]) * share
        places.append(tuple(place))
    spans = pairwise([0.0, *shares, 1.0])
    ways = pairwise([*places, end_mm])
    return [Piece(*way, last - first, 1) for way, (first, last) in zip(ways, spans, strict=True)]
