# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a move ends: the axis words in work or machine coordinates, absolute, incremental or polar.

Nothing here changes the model. Points are machine mm.

Polar coordinates: @ is the distance from the zero of the work system and ^ the angle from X, degrees.
"""

from __future__ import annotations

from cmath import phase, rect
from dataclasses import replace
from math import isnan, radians

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.dialects.codes import AXES, MOTION_NAMES
from CNCStepper.gcode.interpreter.state.interpreter_state import Model, Point
from CNCStepper.gcode.interpreter.state.parameters import FURTHER, length_scale
from CNCStepper.gcode.syntax.line_grammar import Plan
from CNCStepper.state import UNKNOWN

STOCK_WORDS = ("G70", "G71", "G72", "G73")  # whose U and W are no places


def end_point(model: Model, plan: Plan, values: list[float]) -> Point:
    """Return where the axis words lead; raises ProgramError for incremental words from an unknown position."""
    if model.turn is not None or model.compensation is not None or plan.polar:
        return model.machine(_work_end(model.local(), plan, values))
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
                raise unknown_position(AXES[axis], "an incremental move needs a known position")
            end[axis] += values[slot] * scale
    return end[0], end[1], end[2]


def _work_end(local: Model, plan: Plan, values: list[float]) -> Point:
    """Return the end in work coordinates; `local` has them for its machine coordinates."""
    if not plan.polar:
        return end_point(local, plan, values)
    x, y, z = end_point(local, replace(plan, axes=(-1, -1, plan.axes[2]), polar=False), values)
    return *polar_end(local, plan, values, complex(x, y)), z


def without_increments(model: Model, plan: Plan, values: list[float]) -> tuple[Plan, list[float]]:
    """Return a lathe's words with U and W as the X and Z that they lead to; those of a cycle stay.

    Raises ProgramError for both words of one axis, and from an unknown position.
    """
    if not plan.further or MOTION_NAMES[plan.motion] in STOCK_WORDS:
        return plan, values
    slots, axes = dict(plan.slots), list(plan.axes)
    for letter, axis in (("U", 0), ("W", 2)):
        if letter not in slots:
            continue
        if axes[axis] >= 0:
            what = Text("{letter} and {axis} are the same axis", letter=letter, axis=AXES[axis])
            raise ProgramError("axis-conflict", what, value=letter, advice="take one of them out")
        here = model.programmed_work()[axis] / model.scale * (2.0 if axis == 0 and model.diameter else 1.0)
        if isnan(here):
            raise unknown_position(letter, "an incremental word needs a known position")
        axes[axis] = slots[AXES[axis]] = slots.pop(letter)
        values[axes[axis]] += here
    return replace(plan, slots=slots, axes=(axes[0], axes[1], axes[2]), further=False), values


def further_end(model: Model, plan: Plan, values: list[float]) -> tuple[float, ...]:
    """Return where A B C U V W lead, machine coordinates; nothing while none of them has been named."""
    if not plan.further:
        return model.further
    end = list(model.further or (0.0,) * len(FURTHER))
    for index, letter in enumerate(FURTHER):
        if letter in plan.slots:
            value = values[plan.slots[letter]] * length_scale(index + 3, model.scale)
            base = 0.0 if plan.machine else model.further_offset[index] if model.absolute else end[index]
            end[index] = value + base
    return tuple(end)


def polar_end(local: Model, plan: Plan, values: list[float], here: complex) -> tuple[float, float]:
    """Return the end that @ (distance) and ^ (angle, degrees) give from the zero of the work system."""
    if plan.axes[0] >= 0 or plan.axes[1] >= 0:
        what = "@ and ^ stand for X and Y"
        raise ProgramError("polar", what, value="X" if plan.axes[0] >= 0 else "Y", advice="take it out")
    if here == 0 and not (local.absolute and "^" in plan.slots):
        what = "the angle is not known at the zero of the work system"
        raise ProgramError("polar", what, value="@" if "@" in plan.slots else "^", advice="give ^ with G90")
    radius, angle = (values[plan.slots[letter]] if letter in plan.slots else None for letter in "@^")
    length_mm, turn = abs(here), phase(here)
    if radius is not None:
        length_mm = radius * local.scale + (0.0 if local.absolute else length_mm)
    if angle is not None:
        turn = radians(angle) + (0.0 if local.absolute else turn)
    end = rect(length_mm, turn)
    return end.real, end.imag


def machine_end_point(model: Model, plan: Plan, values: list[float], dialect: Dialect) -> Point:
    """Return where a G53 move ends; where the work zero is not known that is an unknown place in the table."""
    if not (model.absolute or dialect.machine_moves_incremental):
        raise ProgramError("machine-move", "G53 takes absolute coordinates only", value="G53", advice="write G90 first")
    if plan.polar:
        raise ProgramError("polar", "G53 takes X and Y only", value="G53", advice="write the end point itself")
    end = list(model.position)
    for axis, slot in enumerate(plan.axes):
        if slot >= 0:
            end[axis] = values[slot] * model.scale if model.zero_known else UNKNOWN
    return end[0], end[1], end[2]


def unknown_position(word: str, what: str) -> ProgramError:
    """Return the refusal of a move whose `word` needs a position that is not known."""
    return ProgramError(
        "unknown-position", what, value=word, advice="move there first with absolute coordinates, or give the start"
    )
