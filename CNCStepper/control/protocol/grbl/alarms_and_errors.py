# SPDX-License-Identifier: LGPL-2.1-or-later
"""Alarm and error codes as texts: meaning and remedy of a number; those of grbl 1.1.

gnea/grbl `doc/csv`; ALARM:10 is that of its double axes. Each other firmware has its own table beside this one.
"""

from __future__ import annotations

from dataclasses import dataclass

CORRECT_LINE = "correct that line of the program"
HOME_AGAIN = "find the cause, then home the machine: its position is lost"


@dataclass(frozen=True)
class Code:
    """What a number means and what to do; `position_kept` is of interest for alarms only."""

    meaning: str
    advice: str
    position_kept: bool = True


def lost(meaning: str, advice: str = HOME_AGAIN) -> Code:
    """Return the code of an alarm after which the machine's position cannot be trusted."""
    return Code(meaning, advice, position_kept=False)


GRBL_ERRORS: dict[int, Code] = {
    1: Code("a word does not begin with a letter", CORRECT_LINE),
    2: Code("a number is missing or cannot be read", CORRECT_LINE),
    3: Code("the $ command is not known", "use one that `$` lists"),
    4: Code("a value is negative where only positive ones are allowed", CORRECT_LINE),
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
    21: Code("two words of one modal group are in one line", CORRECT_LINE),
    22: Code("no feed rate was set", "give an F word before the first feed move"),
    23: Code("the value must be a whole number", CORRECT_LINE),
    24: Code("two commands of one line both use axis words", "split that line in two"),
    25: Code("a word is twice in one line", CORRECT_LINE),
    26: Code("the command lacks its axis words", CORRECT_LINE),
    27: Code("the line number is not between 0 and 9999999", "leave the N words out"),
    28: Code("a P or L value is missing", CORRECT_LINE),
    29: Code("the work systems G59.1 to G59.3 do not exist here", "use G54 to G59"),
    30: Code("G53 works only with G0 and G1", CORRECT_LINE),
    31: Code("axis words stand where no command uses them", CORRECT_LINE),
    32: Code("the arc has no axis word of its plane", CORRECT_LINE),
    33: Code("the arc's end does not lie on its circle", "write the arc with more decimals"),
    34: Code("the arc's radius does not fit its end point", "use I and J instead of R"),
    35: Code("the arc lacks its centre offset in the plane", CORRECT_LINE),
    36: Code("words were left over that no command uses", CORRECT_LINE),
    37: Code("G43.1 may move only the tool-length axis", CORRECT_LINE),
    38: Code("the tool number is too large", "use a tool number up to 255"),
}

GRBL_ALARMS: dict[int, Code] = {
    1: lost("a limit switch was hit"),
    2: Code(
        "a move would end outside the travel (soft limit)",
        "correct work zero or program, then unlock with $X; the position is kept",
    ),
    3: lost("the controller was reset while moving"),
    4: Code("the probe was not in its start state", "check the probe's wiring and plate, then unlock with $X"),
    5: Code("the probe touched nothing", "start nearer to the part, then unlock with $X"),
    6: lost("homing was interrupted by a reset", "home the machine again"),
    7: lost("the safety door was opened while homing", "close it and home again"),
    8: lost("a limit switch stayed pressed after homing", "raise the pull-off $27 or check the switch"),
    9: lost("homing found no limit switch", "check the switches, and travel $130 to $132"),
    10: lost("the second limit switch of a double axis was not found", "check both switches"),
}
