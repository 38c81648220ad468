# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arcs (G2, G3): centre by I J K or radius by R, sweep, turns, and the checks that a controller makes of them.

Nothing here changes the model: an arc is worked out whole, and refused whole. Points are machine mm.

The arithmetic in the plane of an arc is written once for the interpreter and for the kernel that compiles it. Only
+ - * / and sqrt make what goes into the table, so that both give the same bits.

Arcs in the planes ZX and YZ of a work system that is turned about Z lie in no plane of the machine. The table gets
chords, whose middles lie within a tolerance of the arc:  sagitta = radius (1 - cos(angle / 2))
"""

from __future__ import annotations

from collections.abc import Iterator
from math import acos, atan2, ceil, cos, hypot, isnan, pi, sin, sqrt
from typing import NamedTuple

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects import ArcRule, Dialect
from CNCStepper.gcode.dialects.codes import AXES, MOTION_NAMES
from CNCStepper.gcode.interpreter.motion.end_points import unknown_position
from CNCStepper.gcode.interpreter.state.interpreter_state import Model, Point
from CNCStepper.gcode.syntax.line_grammar import Plan
from CNCStepper.toolpath import ARC_CW, PLANE_AXES, PLANE_NAMES

FULL_TURN = 2 * pi
TOLERANCE_MM = 0.002  # of the chords
CENTRE_WORDS = "IJK"
MOST_TURNS = 65_535
Flat = tuple[float, float]  # a point in the plane of an arc


class Arc(NamedTuple):
    """Centre (all three axes), plane and turns of an arc; sweep_rad: the angle swept in all, positive."""

    centre: Point
    plane: int
    turns: int
    radius: float
    sweep_rad: float


def arc_of(model: Model, plan: Plan, values: list[float], end: Point, motion: int, dialect: Dialect) -> Arc:
    """Return the arc from the model's position to `end`; raises ProgramError when its words make none."""
    if model.turn is not None:
        arc = arc_of(model.local(), plan, values, model.work(end), motion, dialect)
        return arc._replace(centre=model.machine(arc.centre))
    plane = PLANE_NAMES.index(model.state.plane)
    first, second, normal = PLANE_AXES[plane]
    begin, slots = model.position, plan.slots
    check_arc_words(plan, model, dialect)
    for axis in (first, second):
        if isnan(begin[axis]) or isnan(end[axis]):
            raise unknown_position(AXES[axis], "an arc needs a known start point")
    if isnan(begin[normal]) and not isnan(end[normal]):
        raise unknown_position(AXES[normal], "a helix needs a known start point")
    turns = _turns(values[slots["P"]]) if "P" in slots else 1
    rule = dialect.arc_rules[model.state.units].limits(model.scale)
    flat_begin, flat_end = (begin[first], begin[second]), (end[first], end[second])
    if "R" in slots:
        radius = values[slots["R"]] * model.scale
        flat = centre_from_radius(flat_begin, flat_end, radius, motion == ARC_CW, rule.radius_slack)
    else:
        flat = _centre_from_words(model, plan, values, plane)
    start_radius = _check_radii(flat_begin, flat_end, flat, rule, MOTION_NAMES[motion])
    swept = sweep(flat_begin, flat_end, flat, motion == ARC_CW)
    if flat_begin != flat_end and min(swept, FULL_TURN - swept) < rule.smallest_angle_rad:
        advice = "write a straight line"
        what = "the angle of the arc is so small that the controller would run a whole circle"
        raise ProgramError("arc-angle", what, value=MOTION_NAMES[motion], limit="1e-6 rad", advice=advice)
    centre = [0.0, 0.0, 0.0]
    centre[first], centre[second], centre[normal] = *flat, begin[normal] if not isnan(begin[normal]) else 0.0
    return Arc((centre[0], centre[1], centre[2]), plane, turns, start_radius, swept + (turns - 1) * FULL_TURN)


def sweep(begin: Flat, end: Flat, centre: Flat, clockwise: bool) -> float:
    """Return the angle of an arc in (0, 2 pi]; equal ends make a full circle."""
    if begin == end:
        return FULL_TURN
    x1, y1 = begin[0] - centre[0], begin[1] - centre[1]
    return sweep_rad(x1, y1, end[0] - centre[0], end[1] - centre[1], clockwise)


def centre_from_radius(begin: Flat, end: Flat, radius: float, clockwise: bool, slack: float) -> Flat:
    """Return the centre of the arc with this radius (R word); a negative one is more than half a circle.

    `slack` is how much too short the radius may be, then the arc is a half circle.
    """
    chord = length(end[0] - begin[0], end[1] - begin[1])
    if chord == 0:
        what = "an arc by radius may not end where it starts"
        raise ProgramError("arc-ends", what, value="R", advice="give its centre with I, J or K")
    if chord / 2 - abs(radius) > slack:
        what = "the radius is too small to reach the end of the arc"
        limit = Text("at least {chord:.4f} mm", chord=chord / 2)
        raise ProgramError("arc-radius", what, value="R", limit=limit, advice="correct R or the end point")
    return centre_by_radius(*begin, *end, radius, clockwise)


def _centre_from_words(model: Model, plan: Plan, values: list[float], plane: int) -> Flat:
    absolute = model.state.arc_centres == "absolute"
    centre = []
    for axis in PLANE_AXES[plane][:2]:
        letter = CENTRE_WORDS[axis]
        if letter in plan.slots:
            origin = model.offset[axis] if absolute else model.position[axis]
            centre.append(values[plan.slots[letter]] * model.scale + origin)
        else:
            centre.append(model.position[axis])
    return centre[0], centre[1]


def check_arc_words(plan: Plan, model: Model, dialect: Dialect) -> None:
    """Refuse arc words that do not fit the plane in force, whatever their numbers."""
    name = model.state.plane
    first, second, normal = PLANE_AXES[PLANE_NAMES.index(name)]
    centre = CENTRE_WORDS[first] + CENTRE_WORDS[second]
    if CENTRE_WORDS[normal] in plan.slots:
        what: str = Text("{centre_word} is no centre word in plane {name}", centre_word=CENTRE_WORDS[normal], name=name)
        raise ProgramError(
            "unused-word", what, value=CENTRE_WORDS[normal], advice="select the plane with G17, G18, G19"
        )
    in_plane = plan.axes[first] >= 0 or plan.axes[second] >= 0 or plan.polar
    if not in_plane and (dialect.arc_needs_plane_axis or "R" in plan.slots):
        what = Text("the arc needs {axis} or {axis2} in plane {name}", axis=AXES[first], axis2=AXES[second], name=name)
        raise ProgramError("arc-plane", what, value=MOTION_NAMES[plan.motion], advice="write its end point")
    if "R" in plan.slots and plan.has(centre):
        what = "an arc takes either R or a centre"
        raise ProgramError("unused-word", what, value="R", advice="take out R")
    if "R" not in plan.slots and not plan.has(centre):
        what = Text("the arc has neither {centre} nor {centre2} nor R", centre=centre[0], centre2=centre[1])
        raise ProgramError("arc-words", what, value=MOTION_NAMES[plan.motion], advice="give its centre")
    missing = next((letter for letter in centre if letter not in plan.slots), "")
    if missing and "R" not in plan.slots and model.state.arc_centres == "absolute":
        what = Text("{missing} is missing: absolute arc centres need both words", missing=missing)
        raise ProgramError(
            "arc-words", what, value=MOTION_NAMES[plan.motion], advice=Text("add {letter}", letter=missing)
        )


def _check_radii(begin: Flat, end: Flat, centre: Flat, rule: ArcRule, word: str) -> float:
    """Return the radius at the start; raises ProgramError where the end does not lie on the same circle."""
    radius = length(begin[0] - centre[0], begin[1] - centre[1])
    at_end = length(end[0] - centre[0], end[1] - centre[1])
    if min(radius, at_end) < rule.smallest_radius:
        limit = f"{rule.smallest_radius:g} mm"
        raise ProgramError("arc-radius", "the arc has no radius", value=word, limit=limit, advice="write a line")
    if not radii_agree(radius, at_end, rule.slack, rule.gap, rule.relative):
        what = Text(
            "the radius at the end of the arc is {at_end:.4f} mm and at its start {radius:.4f} mm",
            at_end=at_end,
            radius=radius,
        )
        limit = Text("a difference of {slack:.4f} mm", slack=max(rule.slack, min(rule.gap, rule.relative * radius)))
        raise ProgramError("arc-ends", what, value=word, limit=limit, advice="correct the centre or the end point")
    return radius


def _turns(value: float) -> int:
    if value != int(value) or not 1 <= value <= MOST_TURNS:
        what = "the number of turns is a whole number from 1"
        raise ProgramError("bad-value", what, value="P", limit=f"1 to {MOST_TURNS}", advice="correct P")
    return int(value)


def chords(model: Model, motion: int, arc: Arc, end: Point) -> Iterator[Point]:
    """Yield the ends of chords along an arc from the model's position to `end` (machine mm)."""
    begin_work, end_work, centre_work = model.work(model.position), model.work(end), model.work(arc.centre)
    first, second, normal = PLANE_AXES[arc.plane]
    x, y = begin_work[first] - centre_work[first], begin_work[second] - centre_work[second]
    begin, end_flat, centre = ((point[first], point[second]) for point in (begin_work, end_work, centre_work))
    angle = sweep(begin, end_flat, centre, motion == ARC_CW) + (arc.turns - 1) * FULL_TURN
    angle = -angle if motion == ARC_CW else angle
    widest = 2 * acos(max(0.0, 1 - TOLERANCE_MM / hypot(x, y)))
    count = max(1, ceil(abs(angle) / widest))
    for step in range(1, count):
        turn, share = angle * step / count, step / count
        place = [0.0, 0.0, 0.0]
        place[first] = centre_work[first] + x * cos(turn) - y * sin(turn)
        place[second] = centre_work[second] + x * sin(turn) + y * cos(turn)
        place[normal] = begin_work[normal] + share * (end_work[normal] - begin_work[normal])
        yield model.machine((place[0], place[1], place[2]))
    yield end


def length(x: float, y: float) -> float:
    """Return the length of a vector."""
    return sqrt(x * x + y * y)


def centre_by_radius(
    begin_x: float, begin_y: float, end_x: float, end_y: float, radius: float, clockwise: bool
) -> tuple[float, float]:
    """Return the centre of the arc with this radius (R word) between two points that differ.

    It lies on the perpendicular over the middle of the chord; a negative radius is more than half a circle, one that
    is shorter than half the chord makes half a circle.
    """
    x, y = end_x - begin_x, end_y - begin_y
    chord = sqrt(x * x + y * y)
    height = sqrt(max(0.0, radius * radius - chord * chord / 4))
    left = -1.0 if clockwise == (radius > 0) else 1.0
    return begin_x + x / 2 - left * height * y / chord, begin_y + y / 2 + left * height * x / chord


def radii_agree(radius: float, at_end: float, slack: float, gap: float, relative: float) -> bool:
    """Return whether the radii at both ends of an arc are so alike that a controller takes it (`ArcRule`)."""
    difference = abs(radius - at_end)
    too_much = difference > gap or difference > relative * max(radius, at_end)
    return not (difference > slack and too_much)


def sweep_rad(x1: float, y1: float, x2: float, y2: float, clockwise: bool) -> float:
    """Return the angle from one vector to another in (0, 2 pi]."""
    angle = atan2(x1 * y2 - y1 * x2, x1 * x2 + y1 * y2)
    angle = -angle if clockwise else angle
    return angle if angle > 0 else angle + FULL_TURN
