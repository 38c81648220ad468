# SPDX-License-Identifier: LGPL-2.1-or-later
"""Polar coordinates: @ is the distance from the zero of the work system and ^ the angle from X, degrees."""

from __future__ import annotations

from cmath import phase, rect
from math import radians
from typing import TYPE_CHECKING

from CNCStepper.errors import ProgramError

if TYPE_CHECKING:
    from CNCStepper.gcode.interpreter.state.model import Model
    from CNCStepper.gcode.syntax.line_grammar import Plan


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
