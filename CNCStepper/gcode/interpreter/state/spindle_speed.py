# SPDX-License-Identifier: LGPL-2.1-or-later
"""The speed of the spindle at a place: under G96 it follows X."""

from __future__ import annotations

from math import inf, isnan, tau

from CNCStepper.gcode.interpreter.state.model import Model, Point


def rpm_at(model: Model, end: Point) -> float:
    """Return the speed in turns a minute at a place: the one commanded, or what the surface speed asks for there."""
    if not model.state.surface_m_min:
        return model.state.spindle_rpm
    radius = abs(model.work(end)[0])
    rpm = model.state.surface_m_min * 1000.0 / (tau * radius) if radius else inf
    return 0.0 if isnan(rpm) else min(rpm, model.largest_rpm)
