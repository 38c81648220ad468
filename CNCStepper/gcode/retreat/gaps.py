# SPDX-License-Identifier: LGPL-2.1-or-later
"""The motors' moves along the tool's way, where the play of the axes is taken up in the text (`take_up.py`).

    tool    ◄────── x        held on its way there, and taken back
    motors  ◄──── ◄─┼── x    they stood ahead of it on the other side, or anywhere in the gap: what is left of it first

Where nobody knows on which side the motors stand, as after a jog, they come to the way so that they are known to.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence, Set
from dataclasses import replace

from CNCStepper.gcode.one_way import Piece, arc_pieces
from CNCStepper.gcode.retreat.move import Move, Point
from CNCStepper.gcode.retreat.over import DOWN_MM_MIN, OVER_MM_MIN, Axes, over
from CNCStepper.gcode.retreat.stretch import Part
from CNCStepper.machine.play import Motors, Play
from CNCStepper.toolpath import LINE, RAPID

UP = 2  # the axis
DOWNWARDS = -1


def taken_up(moves: Iterable[tuple[Move, Part]], motors: Motors) -> Iterator[tuple[Move, Part]]:
    """Yield the motors' moves that lead the tool along some of its own, which `motors` follows.

    motors.at_mm: where they stand before the first, anywhere in their gaps.
    """
    for move, (row, first, last) in moves:
        share = first
        for piece in _one_way(move, motors.play):
            stood_mm = motors.at_mm
            ready_mm = motors.go(piece.begin_mm, piece.end_mm)
            if ready_mm is not None:
                yield crossing(stood_mm, ready_mm, move, motors.play), (row, share, share)
            part = row, share, share + (last - first) * piece.share
            yield _beside(move, piece, _point(ready_mm or stood_mm), _point(motors.at_mm)), part
            share = part[2]


def crossing(stood_mm: Sequence[float], ready_mm: Sequence[float], move: Move, play: Play) -> Move:
    """Return the move of the motors alone beside a move of the tool: no faster, and without a beam."""
    if move.kind == RAPID or play.beam:
        return Move(RAPID, _point(stood_mm), _point(ready_mm))
    return Move(LINE, _point(stood_mm), _point(ready_mm), feed_mm_min=move.feed_mm_min)


def over_gaps(here_mm: Point, there_mm: Point, top_mm: float, play: Play) -> Iterator[tuple[Axes, float]]:
    """Yield the places and speeds of the motors' way from where they were jogged to, as `over`, to `landed_mm`.

    Each axis ends by a way longer than its gap: X and Y above the place, in the sense in which they are true, Z down.
    """
    clear_mm = max(here_mm[UP], top_mm, landed_mm(there_mm, play)[UP] + play.backlash_mm[UP])
    x_mm, y_mm = (there_mm[axis] - play.true_sense[axis] * play.backlash_mm[axis] for axis in (0, 1))
    yield from over(here_mm, (x_mm, y_mm, clear_mm), clear_mm)
    yield (there_mm[0], there_mm[1], None), OVER_MM_MIN
    yield (None, None, landed_mm(there_mm, play)[UP]), DOWN_MM_MIN


def back_over_gaps(
    here_mm: Sequence[float],
    there_mm: Sequence[float],
    ahead_mm: Sequence[float],
    loose: Set[int],
    top_mm: float,
    play: Play,
) -> Iterator[tuple[Axes, float]]:
    """Yield the places and speeds of the motors' way back to where they stood, as far ahead of the tool as they were.

    loose: the axes of which nobody knows on which side they stand, Z where X or Y is; the others stand as they stood.
    The tool comes to its place and stays there, while the motors cross what is left of their gaps.
    """
    tool = (place - ahead * (axis in loose) for axis, (place, ahead) in enumerate(zip(there_mm, ahead_mm, strict=True)))
    yield from over_gaps(_point(here_mm), _point(tuple(tool)), top_mm, play.of_axes(loose))
    yield _point(there_mm), DOWN_MM_MIN


def landed_mm(there_mm: Point, play: Play) -> Point:
    """Return where the motors stand that have come to a place of the tool by `over_gaps`."""
    return there_mm[0], there_mm[1], there_mm[UP] + play.ahead_mm(UP, DOWNWARDS)


def _one_way(move: Move, play: Play) -> list[Piece]:
    """Return a move cut where an axis turns back."""
    if not move.is_arc:
        return [Piece(move.begin, move.end, 1.0, 0)]
    return arc_pieces(play, move.begin, move.end, move.centre, move.kind, move.plane, move.turns)


def _beside(move: Move, piece: Piece, begin_mm: Point, end_mm: Point) -> Move:
    """Return a piece of the tool's move as the motors go it, about a centre as far beside as they are."""
    x, y, z = (place + motor - tool for place, motor, tool in zip(move.centre, end_mm, piece.end_mm, strict=True))
    centre = (x, y, z) if move.is_arc else move.centre
    return replace(move, begin=begin_mm, end=end_mm, centre=centre, turns=piece.turns)


def _point(place_mm: Sequence[float]) -> Point:
    x, y, z = place_mm
    return x, y, z
