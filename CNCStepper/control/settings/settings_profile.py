# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a controller's settings to a machine profile, and back: steps, speeds, accelerations, travel, limits, spindle.

grbl counts its machine position from 0 down to the negative travel, wherever its switches are; that is the travel that
a profile gets. A profile whose travel is as long already keeps its place.
"""

from __future__ import annotations

import copy
from collections.abc import Mapping
from typing import Any

from CNCStepper.control.protocol.grbl.settings import (
    ACCELERATION,
    LASER_MODE,
    MAX_RATE,
    MAX_RPM,
    STEPS_PER_MM,
    expected_settings,
)
from CNCStepper.control.settings.setting_names import (
    ARC_TOLERANCE,
    HOMING,
    HOMING_SIDES,
    JUNCTION_DEVIATION,
    MIN_RPM,
    TRAVEL,
)
from CNCStepper.control.settings.settings_comparison import same_value
from CNCStepper.machine.profile import AXIS_NAMES, Machine

AXIS_KEYS = {STEPS_PER_MM: "steps_per_mm", MAX_RATE: "max_rate_mm_min", ACCELERATION: "acceleration_mm_s2"}
PLANNER_KEYS = {JUNCTION_DEVIATION: "junction_deviation_mm", ARC_TOLERANCE: "arc_tolerance_mm"}


def profile_from_settings(content: Mapping[str, Any], settings: Mapping[int, float]) -> dict[str, Any]:
    """Return a profile's content with the values that a controller's settings give; all else stays.

    Axes that the profile does not have stay out of it: a laser over a fixed bed has no Z, though its board has one.
    """
    made = copy.deepcopy(dict(content))
    for place, name in enumerate(AXIS_NAMES):
        if name in made.get("axis", {}):
            _take_axis(made["axis"][name], settings, place)
    made.setdefault("planner", {}).update(
        {key: number(settings[place]) for place, key in PLANNER_KEYS.items() if settings.get(place)}
    )
    if "spindle" in made:
        _take_spindle(made["spindle"], settings)
    return made


def number(value: float) -> float | int:
    """Return a value as a profile writes it: whole ones without a point."""
    return int(value) if float(value).is_integer() else value


def settings_of_profile(machine: Machine) -> dict[int, float]:
    """Return the settings that a profile gives: those that a job is checked against, travel, planner and homing."""
    planner, axes = machine.planner, machine.numbered_axes
    wanted = expected_settings(machine)
    wanted |= {JUNCTION_DEVIATION: planner.junction_deviation_mm, ARC_TOLERANCE: planner.arc_tolerance_mm}
    wanted |= {TRAVEL + place: axis.travel_max_mm - axis.travel_min_mm for place, _, axis in axes}
    if machine.has_spindle:
        wanted[MIN_RPM] = machine.spindle.min_rpm
    if any(axis.homing != "none" for _, _, axis in axes):
        wanted[HOMING_SIDES] = float(sum(1 << place for place, _, axis in axes if axis.homing == "min"))
    return dict(sorted(wanted.items()))


def _take_axis(axis: dict[str, Any], settings: Mapping[int, float], place: int) -> None:
    axis.update(
        {key: number(settings[first + place]) for first, key in AXIS_KEYS.items() if settings.get(first + place)}
    )
    if STEPS_PER_MM + place in settings:
        axis.pop("drive", None)  # it may contradict what the controller really uses
    travel = settings.get(TRAVEL + place, 0.0)
    if travel > 0 and not same_value(axis.get("travel_max_mm", 0.0) - axis.get("travel_min_mm", 0.0), travel):
        axis.update(travel_min_mm=number(-travel), travel_max_mm=0)
    if HOMING in settings:
        axis["homing"] = _side(int(settings.get(HOMING_SIDES, 0)), place) if settings[HOMING] else "none"


def _side(mask: int, place: int) -> str:
    return "min" if mask >> place & 1 else "max"


def _take_spindle(spindle: dict[str, Any], settings: Mapping[int, float]) -> None:
    if settings.get(MAX_RPM):
        spindle["max_rpm"] = number(settings[MAX_RPM])
    if MIN_RPM in settings:
        spindle["min_rpm"] = number(settings[MIN_RPM])
    if LASER_MODE in settings:
        spindle["laser"] = bool(settings[LASER_MODE])
