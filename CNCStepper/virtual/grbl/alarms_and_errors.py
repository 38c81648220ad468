# SPDX-License-Identifier: LGPL-2.1-or-later
"""The error codes of grbl 1.1 with which a board refuses a line; 162 is FluidNC's."""

from __future__ import annotations

from CNCStepper.errors import MachineRefusal

ERRORS = {
    1: "a word does not begin with a letter",
    2: "a word has no number, or one that is not valid",
    3: "this $ command is not known",
    4: "a value that must not be negative is negative",
    5: "homing is not enabled",
    6: "the step pulse must last at least 3 microseconds",
    8: "this $ command needs the machine to be idle",
    9: "g-code is locked out in alarm and while jogging",
    10: "soft limits need homing to be enabled",
    11: "the line is longer than 79 characters without blanks and comments",
    15: "the jog would leave the machine's travel",
    16: "a jog takes only G20 G21 G53 G90 G91, axis words and F",
    20: "this command is not supported",
    21: "two commands of one modal group stand in the block",
    22: "no feed rate is set",
    23: "this command needs a whole number",
    24: "two commands of the block both want the axis words",
    25: "a word is repeated in the block",
    26: "the command needs axis words",
    27: "the line number is too large",
    28: "a P or L word is missing",
    29: "this work coordinate system does not exist",
    30: "G53 needs G0 or G1",
    31: "axis words stand in the block while G80 is in force",
    32: "the arc has no axis word in its plane",
    33: "the target is not valid: an arc whose ends lie on two radii, or a probe that goes nowhere",
    34: "no circle of this radius joins the two points",
    35: "the arc has no I J K word in its plane",
    36: "a word of the block is used by no command",
    37: "G43.1 takes a Z word and no other axis",
    38: "the tool number is too large",
    39: "there is no digital output of this number",
    40: "a tool change is pending, and no motion but jogs is taken",
    54: "the retract plane lies below the bottom of the hole",
    162: "this setting can only be read: it stands in the configuration file",
}

ALARM_HARD_LIMIT, ALARM_SOFT_LIMIT, ALARM_RESET_IN_MOTION = 1, 2, 3
ALARM_PROBE_START, ALARM_PROBE_NO_CONTACT = 4, 5
ALARM_HOMING_RESET, ALARM_HOMING_DOOR, ALARM_HOMING_NOT_FOUND = 6, 7, 9


def refused(code: int) -> MachineRefusal:
    """Return the refusal with grbl's error `code`; its `code` is what goes on the wire ("error:33")."""
    return MachineRefusal(f"error:{code}", ERRORS[code])
