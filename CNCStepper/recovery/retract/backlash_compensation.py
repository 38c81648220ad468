# SPDX-License-Identifier: LGPL-2.1-or-later
"""The motors' moves along the tool's way, where the wire text compensates backlash.

    tool    ◄────── x        held on its way there, and taken back
    motors  ◄──── ◄─┼── x    they stood ahead of it on the other side, or anywhere in the gap: what is left of it first

Where nobody knows on which side the motors stand, as after a jog, they come to the way so that they are known to.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from CNCStepper.gcode.wire.monotonic_split import Piece, arc_pieces
from CNCStepper.machine.backlash import Backlash, Motors
from CNCStepper.recovery.retract.move_curve import Move, Point
from CNCStepper.recovery.retract.path_section import Part
from CNCStepper.toolpath import LINE, RAPID


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


def crossing(stood_mm: Sequence[float], ready_mm: Sequence[float], move: Move, play: Backlash) -> Move:
    """Return the motors' move across the backlash at a move of the tool: no faster, and without a beam."""
    if move.kind == RAPID or play.beam:
        return Move(RAPID, _point(stood_mm), _point(ready_mm))
    return Move(LINE, _point(stood_mm), _point(ready_mm), feed_mm_min=move.feed_mm_min)


def _one_way(move: Move, play: Backlash) -> list[Piece]:
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
