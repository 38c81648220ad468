# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Cutter compensation as LinuxCNC does it: offset moves and corners of lines and arcs.

    convex corner: an arc about it         concave corner: both moves end where their parallels meet

        . - - .                                   programmed  ------------.
      .'  o    '.   o programmed corner                         - - - . m |    m = where the tool turns
     /  .-|      \                               tool                 .   |
    |  |  |                                                           |   |

    A move is held back (`move_queue.py`) until the next one shows how far it goes:

        enter --> held move --> next move: the corner m is known, the held move ends at m --> next is held --> ...

Invariants: `programmed` is where the text says that the tool is, `current` where its centre is; after the entry
move they are one radius apart, perpendicular to the end of the last move. All points are (first, second, normal) of the
plane, in work mm, so that one text serves XY and ZX. Angles are called as in LinuxCNC's own text of this algorithm.
"""

from __future__ import annotations

from cmath import phase, rect
from math import acos, asin, cos, pi, sin, tan, tau

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.interpreter.block import Block
from CNCStepper.gcode.interpreter.cutter_compensation.compensation_codes import in_plane
from CNCStepper.gcode.interpreter.cutter_compensation.compensation_state import Compensation, Path3, QueuedMove
from CNCStepper.gcode.interpreter.cutter_compensation.move_queue import (
    end_queue_at,
    hold,
    release,
    set_endpoint,
    turned,
)
from CNCStepper.gcode.interpreter.motion.arcs import Arc
from CNCStepper.gcode.interpreter.state import stand_alone_position
from CNCStepper.tolerances import TANGENT_ENTRY
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, PLANE_AXES, PLANE_NAMES, RAPID

SMALL = 0.05  # rad: corners flatter than this are none (LinuxCNC's TOLERANCE_CONCAVE_CORNER)
GOUGE = "the compensated tool cannot reach this corner without gouging"


def straight(block: Block, motion: int, end: tuple[float, float, float], feed: float) -> None:
    """Make a compensated G0 or G1 to `end` (work mm); raises ProgramError where the tool cannot go."""
    ours = _ours(block)
    goal = in_plane(block, end)
    if not ours.entered:
        _enter_straight(block, motion, goal, feed)
    else:
        _next_straight(block, motion, goal, feed)
    _now(block, goal, end)


def arc(block: Block, motion: int, end: tuple[float, float, float], arc: Arc, feed: float) -> None:
    """Make a compensated G2 or G3 to `end` (work mm); raises ProgramError where the tool cannot go."""
    goal, centre = in_plane(block, end), in_plane(block, arc.centre)
    turns = arc.turns if motion == ARC_CCW else -arc.turns
    if not _ours(block).entered:
        _enter_arc(block, goal, complex(*centre[:2]), turns, feed)
    else:
        _next_arc(block, goal, complex(*centre[:2]), turns, feed)
    _now(block, goal, end)


def _ours(block: Block) -> Compensation:
    assert block.model.compensation is not None
    return block.model.compensation


def _now(block: Block, goal: Path3, work: tuple[float, float, float]) -> None:
    block.model.compensation = _ours(block)._replace(entered=True, programmed=goal, programmed_work=work)
    block.model.look()


def _reach(block: Block, current: complex, height: float) -> None:
    """Note where the tool's centre is when the move that is held now has been made."""
    model = block.model
    here = (current.real, current.imag, height)
    model.compensation = _ours(block)._replace(current=here)
    work = [0.0, 0.0, 0.0]
    for axis, value in zip(PLANE_AXES[PLANE_NAMES.index(model.state.plane)], here, strict=True):
        work[axis] = value
    stand_alone_position.continue_at(model, model.machine((work[0], work[1], work[2])))


def _gouges(value: str = "") -> ProgramError:
    return ProgramError("gouge", GOUGE, value=value, advice="use a smaller tool, or round the corner off")


def _here(block: Block) -> tuple[complex, float]:
    x, y, height = in_plane(block, block.model.work(block.model.position))
    return complex(x, y), height


def _enter_straight(block: Block, motion: int, goal: Path3, feed: float) -> None:
    """The first move ends offset from its goal, perpendicular to the programmed move."""
    ours = _ours(block)
    here, _ = _here(block)
    way = complex(*goal[:2]) - here
    if not abs(way) > ours.radius:
        what = "the entry move of the compensation is not longer than the tool's radius"
        limit = Text("more than {radius:g} mm", radius=ours.radius)
        raise ProgramError("entry-short", what, limit=limit, advice="begin farther away")
    alpha = phase(way) + (pi / 2 if ours.left else -pi / 2)
    end = complex(*goal[:2]) + rect(ours.radius, alpha)
    set_endpoint(block, here)
    hold(block, QueuedMove(motion, (end.real, end.imag, goal[2]), rect(1.0, alpha), feed))
    _reach(block, end, goal[2])


def _next_straight(block: Block, motion: int, goal: Path3, feed: float) -> None:
    ours = _ours(block)
    current, old = complex(*ours.current[:2]), complex(*ours.programmed[:2])
    new = complex(*goal[:2])
    if new == old:  # along the normal only
        hold(block, QueuedMove(motion, (*ours.current[:2], goal[2]), 0j, feed))
        _reach(block, current, goal[2])
        return
    theta, alpha = phase(current - old), phase(new - old)
    if ours.left:
        beta = (theta + tau if theta < alpha else theta) - alpha - pi / 2
    else:
        beta = (alpha + tau if alpha < theta else alpha) - theta - pi / 2
    gamma = pi / 2 if ours.left else -pi / 2
    beside = rect(ours.radius, alpha + gamma)
    concave = beta < -SMALL or beta > pi + SMALL or (beta > pi - SMALL and _round_outside(block))
    if concave:
        _into_concave(block, new - old, beta, theta, gamma)
    elif beta > SMALL:
        _round_corner(block, motion, old + beside, feed)
    else:
        release(block, current)
    end = new + beside
    hold(block, QueuedMove(motion, (end.real, end.imag, goal[2]), new - old, feed))
    _reach(block, end, goal[2])


def _round_outside(block: Block) -> bool:
    """Whether the held move is an arc with the tool on its outside."""
    held = _ours(block).held
    return bool(held) and held[0].is_arc and not _inside(block, held[0].turns)


def _inside(block: Block, turns: int) -> bool:
    """Whether the tool runs inside an arc of that sense."""
    return _ours(block).left == (turns > 0)


def _round_corner(block: Block, motion: int, middle: complex, feed: float) -> None:
    """Go about a convex corner: an arc; a rapid cuts it off, because there are no rapid arcs."""
    ours = _ours(block)
    current, old = complex(*ours.current[:2]), complex(*ours.programmed[:2])
    end_queue_at(block, current)
    release(block)
    height = ours.current[2]
    if motion == LINE:
        _add_corner_arc(block, middle, old, height, feed)
    else:
        hold(block, QueuedMove(RAPID, (middle.real, middle.imag, height), 0j, 0.0))
    release(block, middle)


def _add_corner_arc(block: Block, middle: complex, corner: complex, height: float, feed: float) -> None:
    turns = -1 if _ours(block).left else 1
    hold(block, QueuedMove(_arc_motion(turns), (middle.real, middle.imag, height), 0j, feed, corner, turns))


def _arc_motion(turns: int) -> int:
    return ARC_CCW if turns > 0 else ARC_CW


def _into_concave(block: Block, way: complex, beta: float, theta: float, gamma: float) -> None:
    """End the held move where its parallel meets that of the line to come."""
    ours = _ours(block)
    if not (ours.held and ours.held[0].is_arc):
        half = (beta + pi) / 2
        if half == 0.0:
            raise _gouges()
        middle = complex(*ours.current[:2]) + rect(ours.radius / tan(half), theta + gamma)
    else:
        middle = _arc_meets_line(block, ours.held[0], way)
    end_queue_at(block, middle)
    release(block, middle)


def _arc_meets_line(block: Block, held: QueuedMove, way: complex) -> complex:
    """Return where the held arc meets the parallel of a line that begins at the programmed point."""
    ours = _ours(block)
    inside, sense = _inside(block, held.turns), 1.0 if held.turns > 0 else -1.0
    radius = abs(held.centre - complex(*held.end[:2]))
    programmed_radius = radius + ours.radius if inside else radius - ours.radius
    theta = phase(way) + sense * pi / 2
    alpha = theta - phase(held.centre - complex(*ours.programmed[:2]))
    distance = programmed_radius * cos(alpha)  # of the arc's centre from the line
    share = (distance - ours.radius if inside else distance + ours.radius) / radius
    if not -1.0 <= share <= 1.0:
        raise _gouges()
    aside = acos(share) * sense
    return held.centre + rect(radius, theta + pi + (-aside if inside else aside))


# arcs


def _enter_arc(block: Block, goal: Path3, centre: complex, turns: int, feed: float) -> None:
    """The first move as an arc: through the tool's place and beside the end, tangent there to the programmed arc."""
    ours = _ours(block)
    here, height = _here(block)
    end, radius = complex(*goal[:2]), ours.radius
    if abs(end - here) <= radius or (_inside(block, turns) and abs(here - centre) <= radius):
        what = "the entry arc of the compensation is not larger than the tool's radius"
        limit = Text("more than {radius:g} mm", radius=radius)
        raise ProgramError("entry-short", what, limit=limit, advice="begin farther away")
    gamma = phase(centre - end) if _inside(block, turns) else phase(end - centre)
    end += rect(radius, gamma)
    direction = phase(centre - end)
    angle = phase(here - end) - direction
    if abs(cos(angle)) < TANGENT_ENTRY:
        raise _gouges()
    centre = end + rect(abs(here - end) / 2 / cos(angle), direction)
    if ours.orientation not in (0, 9):  # a lathe tool's own point moves first, else the arc is none
        hold(block, QueuedMove(LINE, (here.real, here.imag, height), 0j, feed))
        set_endpoint(block, here)
    sweep = turned(here, centre, turns, end)
    hold(block, QueuedMove(_arc_motion(turns), (end.real, end.imag, goal[2]), 0j, feed, centre, turns, sweep))
    _reach(block, end, goal[2])


def _next_arc(block: Block, goal: Path3, centre: complex, turns: int, feed: float) -> None:
    ours = _ours(block)
    current, old, new = complex(*ours.current[:2]), complex(*ours.programmed[:2]), complex(*goal[:2])
    inside, arc_radius = _inside(block, turns), abs(centre - new)
    theta = phase(current - old) + (-pi / 2 if ours.left else pi / 2)
    delta = phase(centre - old)
    alpha = delta - pi / 2 if turns > 0 else delta + pi / 2
    beta = _normal_angle(theta - alpha if ours.left else alpha - theta)
    if inside and arc_radius <= ours.radius:
        what = "the arc's radius is not larger than the tool's"
        limit = Text("more than {radius:g} mm", radius=ours.radius)
        raise ProgramError("arc-radius", what, limit=limit, advice="use a smaller tool")
    end = new + rect(ours.radius, phase(centre - new) if inside else phase(new - centre))
    away = delta if inside else delta + pi
    concave = beta < -SMALL or beta > pi + SMALL or (abs(beta - pi) < SMALL and not inside)
    if concave:
        middle = _concave_corner(block, centre, arc_radius, turns, beta, theta)
        end_queue_at(block, middle)
        release(block, middle)
    elif beta > SMALL:
        middle = old + rect(ours.radius, away)
        release(block, None)
        _add_corner_arc(block, middle, old, ours.current[2], feed)
        release(block, middle)
    else:
        release(block, current)
    sweep = turned(old, centre, turns, new)
    hold(block, QueuedMove(_arc_motion(turns), (end.real, end.imag, goal[2]), 0j, feed, centre, turns, sweep))
    _reach(block, end, goal[2])


def _normal_angle(beta: float) -> float:
    if beta > 1.5 * pi:
        return beta - tau
    return beta + tau if beta < -pi / 2 else beta


def _concave_corner(block: Block, centre: complex, arc_radius: float, turns: int, beta: float, theta: float) -> complex:
    """Return where the held move meets the parallel of the arc to come."""
    ours = _ours(block)
    inside, sense = _inside(block, turns), 1.0 if turns > 0 else -1.0
    radius = arc_radius - ours.radius if inside else arc_radius + ours.radius
    if ours.held and ours.held[0].is_arc:
        return _arc_meets_arc(block, ours.held[0], centre, radius, sense)
    share = (arc_radius * sin(beta - pi / 2) + (ours.radius if inside else -ours.radius)) / radius
    if not -1.0 <= share <= 1.0:
        raise _gouges()
    angle = theta + sense * asin(share) if inside else theta + pi - sense * asin(share)
    return centre + rect(radius, angle)


def _arc_meets_arc(block: Block, held: QueuedMove, centre: complex, radius: float, sense: float) -> complex:
    """Return where two circles meet, on the tool's side."""
    old_radius, apart = abs(held.centre - complex(*held.end[:2])), abs(held.centre - centre)
    if old_radius == 0 or apart == 0:
        raise _gouges()
    share = (old_radius**2 + apart**2 - radius**2) / (2 * old_radius * apart)
    if not -1.0 <= share <= 1.0:
        raise _gouges()
    back = acos(share) * (sense if _inside(block, held.turns) else -sense)
    return held.centre + rect(old_radius, phase(centre - held.centre) + back)
