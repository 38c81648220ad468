# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a move ends and where its arc has its centre, with all the checks that a controller makes.

Nothing here changes the model: a move is worked out whole, and refused whole. Points are machine mm.
"""

from __future__ import annotations

from math import atan2, hypot, isnan, pi, sqrt
from typing import NamedTuple

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.codes import AXES, MOTION_NAMES
from CNCStepper.gcode.dialects import ArcRule, Dialect
from CNCStepper.gcode.model import Model, Point
from CNCStepper.gcode.parse import Plan
from CNCStepper.state import UNKNOWN
from CNCStepper.toolpath import ARC_CW, PLANE_AXES, PLANE_NAMES

CENTRE_WORDS = "IJK"
MOST_TURNS = 65_535
SMALLEST_INVERSE_FEED = 0.1  # units a minute; RS274 never goes below
FULL_TURN = 2 * pi
Flat = tuple[float, float]  # a point in the plane of an arc


class Arc(NamedTuple):
    """Centre (all three axes), plane and turns of an arc; sweep_rad: the angle swept in all, positive."""

    centre: Point
    plane: int
    turns: int
    radius: float
    sweep_rad: float


def end_point(model: Model, plan: Plan, values: list[float]) -> Point:
    """Return where the axis words lead; raises ProgramError for incremental words from an unknown position."""
    x, y, z = model.position
    in_x, in_y, in_z = plan.axes
    scale = model.scale
    if model.absolute:
        offset_x, offset_y, offset_z = model.offset
        if in_x >= 0:
            x = values[in_x] * scale + offset_x
        if in_y >= 0:
            y = values[in_y] * scale + offset_y
        if in_z >= 0:
            z = values[in_z] * scale + offset_z
        return x, y, z
    end = [x, y, z]
    for axis, slot in enumerate(plan.axes):
        if slot >= 0:
            if isnan(end[axis]):
                raise _unknown(AXES[axis], "an incremental move needs a known position")
            end[axis] += values[slot] * scale
    return end[0], end[1], end[2]


def machine_end_point(model: Model, plan: Plan, values: list[float], dialect: Dialect) -> Point:
    """Return where a G53 move ends; where the work zero is not known that is an unknown place in the table."""
    if not (model.absolute or dialect.machine_moves_incremental):
        raise ProgramError("machine-move", "G53 takes absolute coordinates only", value="G53", advice="write G90 first")
    end = list(model.position)
    for axis, slot in enumerate(plan.axes):
        if slot >= 0:
            end[axis] = values[slot] * model.scale if model.zero_known else UNKNOWN
    return end[0], end[1], end[2]


def arc_of(model: Model, plan: Plan, values: list[float], end: Point, motion: int, dialect: Dialect) -> Arc:
    """Return the arc from the model's position to `end`; raises ProgramError when its words make none."""
    plane = PLANE_NAMES.index(model.state.plane)
    first, second, normal = PLANE_AXES[plane]
    begin, slots = model.position, plan.slots
    _check_plane_words(plan, plane, dialect)
    for axis in (first, second):
        if isnan(begin[axis]) or isnan(end[axis]):
            raise _unknown(AXES[axis], "an arc needs a known start point")
    if isnan(begin[normal]) and not isnan(end[normal]):
        raise _unknown(AXES[normal], "a helix needs a known start point")
    turns = _turns(values[slots["P"]]) if "P" in slots else 1
    rule = dialect.arc_rules[model.state.units]
    flat_begin, flat_end = (begin[first], begin[second]), (end[first], end[second])
    if "R" in slots:
        radius = values[slots["R"]] * model.scale
        flat = centre_from_radius(flat_begin, flat_end, radius, motion == ARC_CW, rule.radius_slack * model.scale)
    else:
        flat = _centre_from_words(model, plan, values, plane)
    start_radius = _check_radii(flat_begin, flat_end, flat, rule, model.scale, MOTION_NAMES[motion])
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
    x2, y2 = end[0] - centre[0], end[1] - centre[1]
    angle = atan2(x1 * y2 - y1 * x2, x1 * x2 + y1 * y2)
    angle = -angle if clockwise else angle
    return angle if angle > 0 else angle + FULL_TURN


def inverse_time_feed(f_word: float, begin: Point, end: Point, arc: Arc | None, scale: float) -> float:
    """Return the feed in mm/min of a move that is to take 1/F minutes."""
    if any(isnan(value) for value in (*begin, *end)):
        raise _unknown("F", "an inverse-time feed needs a known position")
    x, y, z = (end[axis] - begin[axis] for axis in range(3))
    if arc is None:
        length = sqrt(x * x + y * y + z * z)
    else:
        length = hypot(arc.radius * arc.sweep_rad, (x, y, z)[PLANE_AXES[arc.plane][2]])
    return max(SMALLEST_INVERSE_FEED * scale, length * f_word)


def centre_from_radius(begin: Flat, end: Flat, radius: float, clockwise: bool, slack: float) -> Flat:
    """Return the centre of the arc with this radius (R word); a negative one is more than half a circle.

    The centre lies on the perpendicular over the middle of the chord; `slack` is how much too short the
    radius may be, then the arc is a half circle.
    """
    x, y = end[0] - begin[0], end[1] - begin[1]
    chord = hypot(x, y)
    if chord == 0:
        what = "an arc by radius may not end where it starts"
        raise ProgramError("arc-ends", what, value="R", advice="give its centre with I, J or K")
    if chord / 2 - abs(radius) > slack:
        what = "the radius is too small to reach the end of the arc"
        limit = f"at least {chord / 2:.4f} mm"
        raise ProgramError("arc-radius", what, value="R", limit=limit, advice="correct R or the end point")
    height = sqrt(max(0.0, radius * radius - chord * chord / 4))
    left = -1.0 if clockwise == (radius > 0) else 1.0
    return begin[0] + x / 2 - left * height * y / chord, begin[1] + y / 2 + left * height * x / chord


def _centre_from_words(model: Model, plan: Plan, values: list[float], plane: int) -> Flat:
    absolute = model.state.arc_centres == "absolute"
    centre = []
    for axis in PLANE_AXES[plane][:2]:
        letter = CENTRE_WORDS[axis]
        if letter in plan.slots:
            origin = model.offset[axis] if absolute else model.position[axis]
            centre.append(values[plan.slots[letter]] * model.scale + origin)
        elif absolute:
            what = f"{letter} is missing: absolute arc centres need both words"
            raise ProgramError("arc-words", what, value=MOTION_NAMES[plan.motion], advice=f"add {letter}")
        else:
            centre.append(model.position[axis])
    return centre[0], centre[1]


def _check_plane_words(plan: Plan, plane: int, dialect: Dialect) -> None:
    """Refuse arc words that do not fit the plane in force."""
    first, second, normal = PLANE_AXES[plane]
    name, centre = PLANE_NAMES[plane], CENTRE_WORDS[first] + CENTRE_WORDS[second]
    if CENTRE_WORDS[normal] in plan.slots:
        what = f"{CENTRE_WORDS[normal]} is no centre word in plane {name}"
        raise ProgramError(
            "unused-word", what, value=CENTRE_WORDS[normal], advice="select the plane with G17, G18, G19"
        )
    in_plane = plan.axes[first] >= 0 or plan.axes[second] >= 0
    if not in_plane and (dialect.arc_needs_plane_axis or "R" in plan.slots):
        what = f"the arc needs {AXES[first]} or {AXES[second]} in plane {name}"
        raise ProgramError("arc-plane", what, value=MOTION_NAMES[plan.motion], advice="write its end point")
    if "R" in plan.slots and plan.has(centre):
        what = "an arc takes either R or a centre"
        raise ProgramError("unused-word", what, value="R", advice="take out R")
    if "R" not in plan.slots and not plan.has(centre):
        what = f"the arc has neither {centre[0]} nor {centre[1]} nor R"
        raise ProgramError("arc-words", what, value=MOTION_NAMES[plan.motion], advice="give its centre")


def _check_radii(begin: Flat, end: Flat, centre: Flat, rule: ArcRule, scale: float, word: str) -> float:
    """Return the radius at the start; raises ProgramError where the end does not lie on the same circle."""
    radius = hypot(begin[0] - centre[0], begin[1] - centre[1])
    at_end = hypot(end[0] - centre[0], end[1] - centre[1])
    if min(radius, at_end) < rule.smallest_radius * scale:
        limit = f"{rule.smallest_radius * scale:g} mm"
        raise ProgramError("arc-radius", "the arc has no radius", value=word, limit=limit, advice="write a line")
    difference = abs(radius - at_end)
    too_much = difference > rule.gap * scale or difference > rule.relative * max(radius, at_end)
    if difference > rule.slack * scale and too_much:
        what = f"the radius at the end of the arc is {at_end:.4f} mm and at its start {radius:.4f} mm"
        limit = f"a difference of {max(rule.slack * scale, min(rule.gap * scale, rule.relative * radius)):.4f} mm"
        raise ProgramError("arc-ends", what, value=word, limit=limit, advice="correct the centre or the end point")
    return radius


def _turns(value: float) -> int:
    if value != int(value) or not 1 <= value <= MOST_TURNS:
        what = "the number of turns is a whole number from 1"
        raise ProgramError("bad-value", what, value="P", limit=f"1 to {MOST_TURNS}", advice="correct P")
    return int(value)


def _unknown(word: str, what: str) -> ProgramError:
    return ProgramError(
        "unknown-position", what, value=word, advice="move there first with absolute coordinates, or give the start"
    )
