# SPDX-License-Identifier: LGPL-2.1-or-later
"""The error and alarm codes of grbl 1.1 in words: what is wrong, and what to do. One table a firmware."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Code:
    """What a number means and what to do; `position_kept` is of interest for alarms only."""

    meaning: str
    advice: str
    position_kept: bool = True


_PROGRAM = "correct that line of the program"
_HOME = "find the cause, then home the machine: its position is lost"

GRBL_ERRORS: dict[int, Code] = {
    1: Code("a word does not begin with a letter", _PROGRAM),
    2: Code("a number is missing or cannot be read", _PROGRAM),
    3: Code("the $ command is not known", "use one that `$` lists"),
    4: Code("a value is negative where only positive ones are allowed", _PROGRAM),
    5: Code("homing is not enabled", "set $22=1 if the machine has limit switches"),
    6: Code("the step pulse is shorter than 3 microseconds", "set $0 to 3 or more"),
    7: Code("the stored settings could not be read and were reset", "set the machine's settings again"),
    8: Code("the command is allowed only while the machine is idle", "wait until it is idle"),
    9: Code("the controller is locked by an alarm or a jog", "home the machine, or unlock it with $X"),
    10: Code("soft limits need homing", "enable homing ($22=1) or switch soft limits off ($20=0)"),
    11: Code("the line is too long", "shorten that line"),
    12: Code("a setting asks for more steps a second than the controller can give", "lower steps/mm or maximum rate"),
    13: Code("the safety door was opened", "close the door, then resume"),
    14: Code("the stored line is too long", "shorten the start-up line"),
    15: Code("the jog ends outside the machine's travel", "jog less far"),
    16: Code("the jog command lacks its `=` or holds a forbidden word", "correct the jog command"),
    17: Code("laser mode needs a variable spindle output", "set $32=0 or use a build with PWM"),
    20: Code("the controller does not know this command", "write the program for the dialect grbl"),
    21: Code("two words of one modal group stand in one line", _PROGRAM),
    22: Code("no feed rate was set", "give an F word before the first feed move"),
    23: Code("the value must be a whole number", _PROGRAM),
    24: Code("two commands of one line both want axis words", "split that line in two"),
    25: Code("a word stands twice in one line", _PROGRAM),
    26: Code("the command lacks its axis words", _PROGRAM),
    27: Code("the line number is not between 0 and 9999999", "leave the N words out"),
    28: Code("a P or L value is missing", _PROGRAM),
    29: Code("the work systems G59.1 to G59.3 do not exist here", "use G54 to G59"),
    30: Code("G53 works only with G0 and G1", _PROGRAM),
    31: Code("axis words stand where no command uses them", _PROGRAM),
    32: Code("the arc has no axis word of its plane", _PROGRAM),
    33: Code("the arc's end does not lie on its circle", "write the arc with more decimals"),
    34: Code("the arc's radius does not fit its end point", "use I and J instead of R"),
    35: Code("the arc lacks its centre offset in the plane", _PROGRAM),
    36: Code("words were left over that no command uses", _PROGRAM),
    37: Code("G43.1 may move only the tool-length axis", _PROGRAM),
    38: Code("the tool number is too large", "use a tool number up to 255"),
}

GRBL_ALARMS: dict[int, Code] = {
    1: Code("a limit switch was hit", _HOME, position_kept=False),
    2: Code(
        "a move would end outside the travel (soft limit)",
        "correct work zero or program, then unlock with $X; the position is kept",
    ),
    3: Code("the controller was reset while moving", _HOME, position_kept=False),
    4: Code("the probe was not in its start state", "check the probe's wiring and plate, then unlock with $X"),
    5: Code("the probe touched nothing", "start nearer to the part, then unlock with $X"),
    6: Code("homing was interrupted by a reset", "home the machine again", position_kept=False),
    7: Code("the safety door was opened while homing", "close it and home again", position_kept=False),
    8: Code("a limit switch stayed pressed after homing", "raise the pull-off $27 or check the switch", False),
    9: Code("homing found no limit switch", "check the switches, and travel $130 to $132", position_kept=False),
    10: Code("the second limit switch of a double axis was not found", "check both switches", position_kept=False),
}

_UNLISTED_ERROR = Code("the controller refused the line", "look the code up in the controller's documentation")
_UNLISTED_ALARM = Code("the controller raised an alarm", _HOME, position_kept=False)


def error_code(number: int) -> Code:
    """Return what `error:number` means on grbl 1.1."""
    return GRBL_ERRORS.get(number, _UNLISTED_ERROR)


def alarm_code(number: int) -> Code:
    """Return what `ALARM:number` means on grbl 1.1; an unlisted alarm loses the position."""
    return GRBL_ALARMS.get(number, _UNLISTED_ALARM)
