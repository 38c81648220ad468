# SPDX-License-Identifier: LGPL-2.1-or-later
"""The names and units of the `$` settings, as grbl 1.1 lists them; the numbers from 100 on are of axes.

    $100 steps per mm of X   $101 of Y   $102 of Z   ...   $110 highest speed   $120 acceleration   $130 travel

grblHAL and FluidNC answer to the same numbers and have more of their own, which have no name here.
"""

from __future__ import annotations

from typing import NamedTuple

from CNCStepper.control.protocol.grbl.settings import ACCELERATION, LASER_MODE, MAX_RATE, MAX_RPM, STEPS_PER_MM
from CNCStepper.errors import Text

JUNCTION_DEVIATION, ARC_TOLERANCE = 11, 12
SOFT_LIMITS, HOMING, HOMING_SIDES = 20, 22, 23
MIN_RPM, TRAVEL = 31, 130
AXES = "XYZABC"
AXES_FROM, AXES_TO = STEPS_PER_MM, TRAVEL + 9


class SettingName(NamedTuple):
    """What a setting is, in English, and its unit, "" for a number without one."""

    name: str
    unit: str = ""


NAMES = {
    0: SettingName("step pulse", "µs"),
    1: SettingName("delay before the motors are switched off", "ms"),
    2: SettingName("inverted step pins", "mask"),
    3: SettingName("inverted directions", "mask"),
    4: SettingName("inverted enable pin"),
    5: SettingName("inverted limit pins"),
    6: SettingName("inverted probe pin"),
    10: SettingName("what a status report holds", "mask"),
    JUNCTION_DEVIATION: SettingName("junction deviation", "mm"),
    ARC_TOLERANCE: SettingName("arc tolerance", "mm"),
    13: SettingName("reports in inches"),
    SOFT_LIMITS: SettingName("soft limits"),
    21: SettingName("hard limits"),
    HOMING: SettingName("homing cycle"),
    HOMING_SIDES: SettingName("axes that home to their negative end", "mask"),
    24: SettingName("slow homing speed", "mm/min"),
    25: SettingName("fast homing speed", "mm/min"),
    26: SettingName("debounce of the limit switches", "ms"),
    27: SettingName("way back from a limit switch", "mm"),
    MAX_RPM: SettingName("highest spindle speed", "rpm"),
    MIN_RPM: SettingName("lowest spindle speed", "rpm"),
    LASER_MODE: SettingName("laser mode"),
}
OF_AXES = {
    STEPS_PER_MM: SettingName("{axis}: steps per mm", "1/mm"),
    MAX_RATE: SettingName("{axis}: highest speed", "mm/min"),
    ACCELERATION: SettingName("{axis}: acceleration", "mm/s²"),
    TRAVEL: SettingName("{axis}: travel", "mm"),
}


def setting_name(number: int) -> SettingName:
    """Return what a setting is; one that grbl does not list has no name."""
    first, axis = number - number % 10, number % 10
    if first in OF_AXES and axis < len(AXES):
        template, unit = OF_AXES[first]
        return SettingName(Text(template, axis=AXES[axis]), unit)
    return NAMES.get(number, SettingName(""))
