# SPDX-License-Identifier: LGPL-2.1-or-later
"""The codes of FluidNC in words (bdring/FluidNC `Error.h`, `Protocol.h`), where they differ from grbl's.

With `verbose_errors` in its configuration FluidNC answers with a name in place of the number: `FLUIDNC_ERROR_NAMES`.
"""

from __future__ import annotations

from CNCStepper.control.protocol.grbl.alarms_and_errors import CORRECT_LINE, GRBL_ALARMS, GRBL_ERRORS, Code, lost

_CONFIGURATION = "correct its configuration file, then restart the controller"
_FILE = "look at the controller's file system, then try again"
_EXPRESSION = "correct the expression in that line"
_FLOW = "correct the O-words of the macro"
_AGAIN = "send it again"

FLUIDNC_ERRORS: dict[int, Code] = GRBL_ERRORS | {
    5: Code("this is switched off in the controller's configuration", _CONFIGURATION),
    6: Code("the step pulse is too short", _CONFIGURATION),
    10: Code("the target lies outside of the machine's travel", "correct work zero or program"),
    17: Code("laser mode needs a spindle of the kind Laser", _CONFIGURATION),
    18: Code("no axis is set up for homing", _CONFIGURATION),
    19: Code("a single axis may not be homed here", "home all axes with $H"),
    20: Code("the controller does not know this command", "write the program for the dialect fluidnc or grbl"),
    38: Code("a value is larger than the controller allows", CORRECT_LINE),
    39: Code("the P word is larger than the controller allows", CORRECT_LINE),
    40: Code(
        "a control pin was active at start", "release buttons, door and emergency stop, then restart the controller"
    ),
    60: Code("the file system cannot be mounted", _FILE),
    61: Code("the file cannot be read", _FILE),
    62: Code("the folder cannot be opened", _FILE),
    63: Code("the folder does not exist", "correct the folder's name"),
    64: Code("the file is empty", "send the file again"),
    65: Code("the file does not exist", "correct the file's name"),
    66: Code("the file cannot be opened", "correct the file's name"),
    67: Code("the file system is busy", "wait a moment, then try again"),
    68: Code("the folder cannot be deleted", _FILE),
    69: Code("the file cannot be deleted", _FILE),
    70: Code("the file cannot be renamed", _FILE),
    80: Code("the setting's value is out of its range", "give a value that the setting allows"),
    81: Code("the setting cannot have this value", "give a value that the setting allows"),
    82: Code("the file cannot be created", _FILE),
    83: Code("the file system cannot be formatted", _FILE),
    90: Code("a message could not be sent", "look at the network of the controller"),
    100: Code("the setting could not be stored", _AGAIN),
    101: Code("the state of the stored settings cannot be read", "restart the controller"),
    110: Code("the controller does not accept the password", "log in again"),
    111: Code("the line ended too early", _AGAIN),
    112: Code("the file ended", "look whether the file is whole"),
    113: Code("the controller was reset before it could do that", _AGAIN),
    114: Code("there was nothing to read", _AGAIN),
    120: Code("another connection is using the controller", "close the other connection, a web page or a pendant"),
    130: Code("the jog was cancelled", "jog again if it is still wanted"),
    150: Code("a pin in the configuration is wrong", _CONFIGURATION),
    151: Code("this setting cannot be changed while the controller runs", _CONFIGURATION),
    152: Code(
        "the configuration is not valid", "read the controller's start-up messages ($SS) and correct its configuration"
    ),
    160: Code("the file could not be loaded", _AGAIN),
    161: Code("the file could not be handed out", _AGAIN),
    162: Code("this setting can only be read", _CONFIGURATION),
    170: Code("the expression divides by zero", _EXPRESSION),
    171: Code("a value in the expression does not fit its operation", _EXPRESSION),
    172: Code("the expression's result is not a finite number", _EXPRESSION),
    173: Code("the expression has an operation that is not known", _EXPRESSION),
    174: Code("a value in the expression is too large or too small", _EXPRESSION),
    175: Code("the expression cannot be read", _EXPRESSION),
    176: Code("the O-word cannot be read", _FLOW),
    177: Code("O-words work only in a macro of the controller", "send the program without O-words"),
    178: Code("the controller has no memory left for O-words", _FLOW),
    179: Code("O-words are nested too deeply", _FLOW),
    180: Code("a parameter could not be set", "correct the parameter in that line"),
    181: Code("a word has a value that it cannot have", CORRECT_LINE),
}

FLUIDNC_ALARMS: dict[int, Code] = {number: code for number, code in GRBL_ALARMS.items() if number < 10} | {
    8: lost("a limit switch stayed pressed after homing", "raise pulloff_mm in its configuration, or check the switch"),
    9: lost("homing found no limit switch", "check the switches, and max_travel_mm in its configuration"),
    10: lost("the spindle does not follow the program", "look at spindle and inverter, then home the machine"),
    11: lost(
        "an input was active at start", "release buttons, door, switches and emergency stop, then home the machine"
    ),
    12: lost(
        "a limit switch was pressed before homing, and which one is not clear", "move the machine off it, then home"
    ),
    13: lost("the machine was stopped at once", "find the cause, then home the machine: its position is lost"),
    14: lost("the machine must be homed before it may move", "home the machine"),
    15: lost("the controller has just started", "home the machine, or unlock it if it stands where it should"),
    16: lost("an input and output expander was reset", "check its cable and supply, then home the machine"),
    17: lost("a program on the controller stopped at an error", "correct that program, then home the machine"),
    18: lost("a limit switch was hit while probing", "free the machine from the switch, then home it"),
}

_NAMES = """
1 Expected GCodecommand letter
2 Bad GCode number format
3 Invalid $ statement
4 Negative value
5 Setting disabled
6 Step pulse too short
7 Failed to read settings
8 Command requires idle state
9 GCode cannot be executed in lock or alarm state
10 Soft limit error
11 Line too long
12 Max step rate exceeded
13 Check door
15 Max travel exceeded during jog
16 Invalid jog command
17 Laser mode requires PWM output
18 No Homing/Cycle defined in settings
19 Single axis homing not allowed
20 Unsupported GCode command
21 Gcode modal group violation
22 Gcode undefined feed rate
23 Gcode command value not integer
24 Gcode axis command conflict
25 Gcode word repeated
26 Gcode no axis words
27 Gcode invalid line number
28 Gcode value word missing
29 Gcode unsupported coordinate system
30 Gcode G53 invalid motion mode
31 Gcode extra axis words
32 Gcode no axis words in plane
33 Gcode invalid target
34 Gcode arc radius error
35 Gcode no offsets in plane
36 Gcode unused words
37 Gcode G43 dynamic axis error
38 Gcode max value exceeded
39 P param max exceeded
40 Check startup pins
40 Check control pins
60 Failed to mount device
61 Read failed
62 Failed to open directory
63 Directory not found
64 File empty
65 File not found
66 Failed to open file
67 Device is busy
68 Failed to delete directory
69 Failed to delete file
70 Failed to rename file
80 Number out of range for setting
81 Invalid value for setting
82 Failed to create file
83 Failed to format filesystem
90 Failed to send message
100 Failed to store setting
101 Failed to get setting status
110 Authentication failed!
111 End of line
112 End of file
113 System Reset
114 No Data
120 Another interface is busy
130 Jog Cancelled
150 Bad Pin Specification
151 Bad Runtime Config Setting
152 Configuration is invalid. Check boot messages for ERR's.
160 File Upload Failed
161 File Download Failed
162 Read-only setting
170 Expression Divide By Zero
171 Expression Invalid Argument
173 Expression Unknown Operator
174 Expression Argument Out of Range
175 Expression Syntax Error
176 Flow Control Syntax Error
177 Flow Control Not Executing Macro
178 Flow Control Out of Memory
179 Flow Control Stack Overflow
180 Parameter Assignment Failed
181 Gcode invalid word value
"""

FLUIDNC_ERROR_NAMES: dict[str, int] = {
    name: int(number) for number, _, name in (line.partition(" ") for line in _NAMES.strip().splitlines())
}
