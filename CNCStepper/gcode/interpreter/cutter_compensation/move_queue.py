# SPDX-License-Identifier: LGPL-2.1-or-later
"""The queue of compensated moves: each waits for the next move to show its end.

    held: [move, note, move, ...]      notes (feeds, dwells, coolant, comments) wait with the moves, in their order

When the end is known, it is given to every held move: more than one waits only while the tool goes up and down over the
same point. A move whose way is turned round by its new end would gouge, and is refused.
"""

from __future__ import annotations

from cmath import phase
from math import tau

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.block import Block
from CNCStepper.gcode.interpreter.cutter_compensation.compensation_state import Path3, QueuedMove
from CNCStepper.gcode.interpreter.motion.arcs import Arc
from CNCStepper.tolerances import SAME_TEXT_RADIUS
from CNCStepper.toolpath import PLANE_AXES, PLANE_NAMES

MORE_SWEEP = 0.001  # rad
LEFT_OF_TIP, RIGHT_OF_TIP = (2, 6, 1), (3, 8, 4)  # orientations of lathe tools, along X
BEHIND_TIP, BEFORE_TIP = (2, 7, 3), (1, 5, 4)  # along Z


def turned(begin: complex, centre: complex, turns: int, end: complex) -> float:
    """Return the angle from `begin` to `end` about `centre`, counter-clockwise positive, whole turns included."""
    alpha, beta = phase(begin - centre), phase(end - centre)
    if turns > 0:
        return (beta + tau if beta <= alpha else beta) - alpha + (turns - 1) * tau
    return beta - (alpha + tau if alpha <= beta else alpha) + (turns + 1) * tau


def hold(block: Block, move: QueuedMove) -> None:
    """Put a move behind those that wait."""
    model = block.model
    assert model.compensation is not None
    move = move._replace(line=block.line, state=model.state, further=block.next_further)
    model.compensation = model.compensation._replace(held=(*model.compensation.held, move))


def set_endpoint(block: Block, begin: complex | None) -> None:
    """Note where the first held move begins."""
    model = block.model
    assert model.compensation is not None
    model.compensation = model.compensation._replace(endpoint=begin)


def end_queue_at(block: Block, end: complex) -> None:
    """Let all held moves end at `end`; raises ProgramError where one would gouge."""
    model = block.model
    assert model.compensation is not None
    ours = model.compensation
    moved = tuple(move if move.note else _ended(block, move, end, ours.endpoint) for move in ours.held)
    model.compensation = ours._replace(held=moved)


def _ended(block: Block, move: QueuedMove, end: complex, begin: complex | None) -> QueuedMove:
    if move.is_arc:
        difference = abs(abs(complex(*move.end[:2]) - move.centre) - abs(end - move.centre))
        if difference > SAME_TEXT_RADIUS * block.model.scale:
            raise _gouges("the compensated arc would have two radii")
        if move.sweep and begin is not None:
            sweep = turned(begin, move.centre, move.turns, end)
            if abs(sweep) > abs(move.sweep) + MORE_SWEEP:
                raise _gouges("the arc in the concave corner cannot be reached by the tool without gouging")
    elif begin is not None and (move.direction.conjugate() * (end - begin)).real < 0:
        raise _gouges("the line in the concave corner cannot be reached by the tool without gouging")
    return move._replace(end=(end.real, end.imag, move.end[2]))


def _gouges(what: str) -> ProgramError:
    return ProgramError("gouge", what, advice="use a smaller tool, or another contour")


def release(block: Block, endpoint: complex | None = None) -> None:
    """Make the moves that wait, and what waits between them; the next one begins at `endpoint`, where it is known."""
    model = block.model
    assert model.compensation is not None
    waiting = model.compensation.held
    model.compensation = model.compensation._replace(held=(), endpoint=endpoint)
    for move in waiting:
        if move.note:
            block.do(move.note[0], *move.note[1])
        else:
            _make(block, move)


def _make(block: Block, move: QueuedMove) -> None:
    model = block.model
    end = _work(block, move.end)
    arc = None
    if move.is_arc:
        centre = _work(block, (move.centre.real, move.centre.imag, move.end[2]))
        arc = Arc(model.machine(centre), PLANE_NAMES.index(model.state.plane), abs(move.turns), 0.0, 0.0)
    block.emit(move.motion, model.machine(end), arc, move.feed, move.line, move.state, move.further)


def _work(block: Block, point: Path3) -> Path3:
    """Return a point of the plane as X, Y, Z; that of a lathe tool is the tip's, beside the centre of its radius."""
    model, place = block.model, [0.0, 0.0, 0.0]
    assert model.compensation is not None
    for axis, value in zip(PLANE_AXES[PLANE_NAMES.index(model.state.plane)], point, strict=True):
        place[axis] = value
    radius, way = model.compensation.radius, model.compensation.orientation
    if model.state.plane == "ZX":
        place[0] += radius * ((way in RIGHT_OF_TIP) - (way in LEFT_OF_TIP))
        place[2] += radius * ((way in BEFORE_TIP) - (way in BEHIND_TIP))
    return place[0], place[1], place[2]
