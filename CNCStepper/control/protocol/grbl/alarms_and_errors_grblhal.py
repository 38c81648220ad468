# SPDX-License-Identifier: LGPL-2.1-or-later
"""The codes of grblHAL in words (grblHAL/core `errors.h`, `alarms.h`), where they differ from grbl's."""

from __future__ import annotations

from CNCStepper.control.protocol.grbl.alarms_and_errors import CORRECT_LINE, GRBL_ALARMS, GRBL_ERRORS, Code, lost

_CARD = "look at the memory card, then try again"
_EXPRESSION = "correct the expression in that line"
_FLOW = "correct the O-words of the macro"

GRBLHAL_ERRORS: dict[int, Code] = GRBL_ERRORS | {
    6: Code("the step pulse is shorter than 2 microseconds", "set $0 to 2 or more"),
    18: Code("the controller was reset before it could do that", "send it again"),
    19: Code("a value is zero or negative where only positive ones are allowed", CORRECT_LINE),
    20: Code("the controller does not know this command", "write the program for the dialect grblhal or grbl"),
    29: Code("the controller does not have this work system", "use one of those that `$#` lists"),
    38: Code("the tool number is too large, or the tool table has no such tool", "use a tool that the table has"),
    39: Code("a value is outside of its range", CORRECT_LINE),
    40: Code("a tool change is pending, and this command must wait for its end", "end the tool change, then resume"),
    41: Code("the spindle does not turn, but the motion goes by its turns", "switch the spindle on before that line"),
    42: Code("threads can be cut only in the plane ZX", "write G18 before that line"),
    43: Code("the feed is higher than the machine's axes can go", "lower the feed of that line"),
    44: Code("the spindle speed is out of the spindle's range", "use a speed between $31 and $30"),
    45: Code(
        "a limit switch is pressed; only homing is allowed", "home the machine, or move it off the switch by hand"
    ),
    46: Code("the machine must be homed first", "home the machine"),
    47: Code("the tool changer does not know which tool it holds", "set it with M61 Q and the tool's number"),
    48: Code("two words of the line contradict each other", CORRECT_LINE),
    49: Code(
        "the controller's own test at power-up failed", "switch it off and on again; if it stays, look at its wiring"
    ),
    50: Code("the emergency stop is active", "release the emergency stop, then reset the controller"),
    51: Code("a motor driver reports a fault", "look at motors and drivers, then reset the controller"),
    52: Code("the setting's value is out of its range", "give a value that the setting allows"),
    53: Code("this build of the controller has no such setting", "leave that setting out"),
    54: Code("the retract plane lies below the bottom of the hole", "raise the R word of the drilling cycle"),
    55: Code(
        "two self-squaring axes cannot be homed at the same time", "give them different homing passes ($44 to $46)"
    ),
    56: Code("the work system is locked", "unlock it in the settings, or use another work system"),
    57: Code("a `%` is neither at the begin nor at the end of the file", "remove the lines with `%`"),
    58: Code("the auxiliary port does not exist or is in use", "correct the P word, or the board's settings"),
    60: Code("the memory card cannot be mounted", _CARD),
    61: Code("the file cannot be read", _CARD),
    62: Code("the folder cannot be opened", _CARD),
    63: Code("the folder does not exist", "correct the folder's name"),
    64: Code("no memory card is mounted", "put the card in, then mount it with $FM"),
    65: Code("no file system is mounted", "mount it first"),
    66: Code("the file system can only be read", "write to another one"),
    67: Code("the file system could not be formatted", _CARD),
    70: Code("Bluetooth could not be started", "look at the Bluetooth settings"),
    71: Code("the expression has an operation that is not known", _EXPRESSION),
    72: Code("the expression divides by zero", _EXPRESSION),
    73: Code("a value in the expression is too large or too small", _EXPRESSION),
    74: Code("a value in the expression does not fit its operation", _EXPRESSION),
    75: Code("the expression cannot be read", _EXPRESSION),
    76: Code("the expression's result is not a finite number", _EXPRESSION),
    77: Code("the controller asks for a login", "log in first"),
    78: Code("the controller does not allow this to this user", "log in as a user with that permission"),
    79: Code(
        "this is not allowed while an emergency stop or a limit is active", "clear the cause, then reset the controller"
    ),
    80: Code("O-words work only in a macro on the controller's card", "send the program without O-words"),
    81: Code("the O-word cannot be read", _FLOW),
    82: Code("O-words are nested too deeply", _FLOW),
    83: Code("the controller has no memory left for O-words", _FLOW),
    84: Code("the file cannot be opened", "correct the file's name"),
    253: Code("a macro has stopped with an error of its own", "read the message that the macro gives"),
}

GRBLHAL_ALARMS: dict[int, Code] = GRBL_ALARMS | {
    10: lost("the emergency stop was pressed", "release it, reset the controller, then home the machine"),
    11: lost("the machine must be homed before it may move", "home the machine"),
    12: lost("a limit switch is pressed", "move the machine off the switch, reset, then home it"),
    13: lost(
        "the probe touched something where nothing was to be touched", "free the probe, reset, then home the machine"
    ),
    14: lost("the spindle does not reach its speed", "look at spindle and inverter, reset, then home the machine"),
    15: lost("the second limit switch of a self-squaring axis was not found", "check both switches, then home again"),
    16: lost(
        "the controller's own test at power-up failed", "switch it off and on again; if it stays, look at its wiring"
    ),
    17: lost("a motor driver reports a fault", "look at motors and drivers, reset, then home the machine"),
    18: lost("homing is set up wrongly", "correct the homing settings ($22 to $27, $44 to $46)"),
    19: lost(
        "a device on the Modbus does not answer as it should", "check its cable and settings, then home the machine"
    ),
    20: lost("an input and output expander failed", "check its cable and supply, then home the machine"),
    21: lost("the controller's permanent memory failed", "set the machine's settings again, then home it"),
}
