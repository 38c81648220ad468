# SPDX-License-Identifier: LGPL-2.1-or-later
"""The firmwares that a sender can talk to: how much each takes, what its codes mean, and how it is recognised.

    Grbl 1.1h ['$' for help]                        grbl
    GrblHAL 1.1f ['$' or '$HELP' for help]          grblHAL    ($I: [FIRMWARE:grblHAL], [NEWOPT:...], [AXS:3:XYZ])
    Grbl 3.7 [FluidNC v3.7.8 (wifi) '$' for help]   FluidNC    ($I: [VER:3.7 FluidNC v3.7.8:])
    Grbl 1.1h ['$' for help]                        a process of ours ($I: [FIRMWARE:CNCStepper parport], [CANNOT:hold])

A greeting can be set by its owner, and grblHAL can be built to greet as grbl does: so `$I` has the last word.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from CNCStepper.control.protocol.grbl.alarms_and_errors import GRBL_ALARMS, GRBL_ERRORS, HOME_AGAIN, Code, lost
from CNCStepper.control.protocol.grbl.alarms_and_errors_fluidnc import (
    FLUIDNC_ALARMS,
    FLUIDNC_ERROR_NAMES,
    FLUIDNC_ERRORS,
)
from CNCStepper.control.protocol.grbl.alarms_and_errors_grblhal import GRBLHAL_ALARMS, GRBLHAL_ERRORS
from CNCStepper.errors import Text
from CNCStepper.machine.controller_family import FAMILIES, OWN

TOOL = "Tool"  # the state in which grblHAL waits for a person at its M6
TOOL_CHANGED = b"\xa3"  # to grblHAL in that state: nothing else comes, so that it takes jogs and a new zero
LOOK_UP = "look the number up in the documentation of the controller's version"
GRBLHAL_TAGS = ("NEWOPT", "AXS")  # of `$I`, which grbl does not have
OWN_NAME = "cncstepper "  # begins the name of a CNCStepper controller in [FIRMWARE:...]
CANNOT = "CANNOT"  # of `$I`: functions that a CNCStepper controller lacks
TOO_FAST = Code(
    "this computer cannot keep the pulse rate of this program",
    "read its message, close other programs, or choose lower speeds",
)


@dataclass(frozen=True)
class Firmware:
    """What differs from one firmware to the next; `key` begins its error codes ("grbl-error-20"), `name` is for people.

    dialects: the languages of which it reads every line as it is meant, its own first.
    small_receive: its receive buffer may be smaller than grbl's, so what it says of it holds. line_characters: of its
    longest line, without blanks where these do not count. error_names: what it may answer in place of a number.
    inches_question: how it tells whether it reports in inches, where no setting $13 does. settings: of its language.
    """

    key: str
    name: str
    errors: Mapping[int, Code]
    alarms: Mapping[int, Code]
    dialects: tuple[str, ...]
    small_receive: bool = False
    line_characters: int = 79
    blanks_count: bool = False
    error_names: Mapping[str, int] = field(default_factory=dict)
    inches_question: str = ""
    settings: str = ""

    @property
    def language(self) -> str:
        """Its own language, with settings, in which the path of lines sent is followed."""
        return f"{self.dialects[0]}:{self.settings}" if self.settings else self.dialects[0]

    def error(self, number: int) -> Code:
        """Return what `error:number` means here."""
        if number < 0:
            return Code("the controller refused the line", "read its message, and correct that line")
        return self.errors.get(number) or Code(Text("{name} lists no such error", name=self.name), LOOK_UP)

    def alarm(self, number: int) -> Code:
        """Return what `ALARM:number` means here; one that is not listed, or has no number (-1), loses the position."""
        if number < 0:
            return lost("the controller raised an alarm")
        return self.alarms.get(number) or lost(
            Text("{name} lists no such alarm", name=self.name),
            Text("{look_up}; {home_again}", look_up=LOOK_UP, home_again=HOME_AGAIN),
        )

    def error_number(self, text: str) -> int:
        """Return the number of an error that was answered by its name ("error:Bad GCode number format"), or -1."""
        return self.error_names.get(text.removeprefix("error:").strip(), -1)


# The parsers of grblHAL and FluidNC are grbl's with words added: no line that grbl accepts means another move there.
GRBL = Firmware("grbl", "grbl 1.1", GRBL_ERRORS, GRBL_ALARMS, ("grbl",))
GRBLHAL = Firmware(
    "grblhal",
    "grblHAL",
    GRBLHAL_ERRORS,
    GRBLHAL_ALARMS,
    ("grblhal", "grbl"),
    line_characters=255,
)
FLUIDNC = Firmware(
    "fluidnc",
    "FluidNC",
    FLUIDNC_ERRORS,
    FLUIDNC_ALARMS,
    ("fluidnc", "grbl"),
    small_receive=True,
    line_characters=254,
    blanks_count=True,
    error_names=FLUIDNC_ERROR_NAMES,
    inches_question="$/report_inches",
)
PINS = "outputs=pins"  # M62 to M65 switch them


def _without_homing(code: Code, advice: str) -> Code:
    """Return the code of an alarm for a machine that cannot home."""
    return code if code.position_kept else lost(code.meaning, advice)


NO_HOMING = Code("this machine cannot find its own zero", "move the tool to the work zero and set it there")
FIND_CAUSE_THEN_ZERO = "find the cause, then move the tool to the work zero and set it there: its position is lost"
SWITCH_ON_AGAIN = "find the cause, switch the lathe off and on, and set its zero by hand: its position is lost"
SWITCH_ON_OR_UNLOCK = "switch the lathe off and on, connect again and set its zero; unlock an alarm with $X"
UNLOCK = Code(GRBL_ERRORS[9].meaning, "unlock it with $X")
OWN_ERRORS = {**GRBL_ERRORS, 5: NO_HOMING, 9: UNLOCK, 90: TOO_FAST}
OWN_ALARMS = {number: _without_homing(code, FIND_CAUSE_THEN_ZERO) for number, code in GRBL_ALARMS.items()}
PARPORT = Firmware("parport", "the parallel port's controller", OWN_ERRORS, OWN_ALARMS, ("grbl",), settings=PINS)
BOARD = Firmware("board", "the USB board's controller", OWN_ERRORS, OWN_ALARMS, ("grbl",), settings=PINS)
LATHE = Firmware(
    "lathe",
    "the mini-lathe's controller",
    {
        **OWN_ERRORS,
        9: Code("the lathe is in automatic mode, or locked by an alarm", SWITCH_ON_OR_UNLOCK),
        16: Code("a jog of the lathe names one axis, X or Z, and a feed", "jog one axis after the other"),
        20: Code(GRBL_ERRORS[20].meaning, "write the program for the dialect mini-lathe"),
    },
    {number: _without_homing(code, SWITCH_ON_AGAIN) for number, code in GRBL_ALARMS.items()},
    ("mini-lathe",),
    line_characters=1000,  # many records
)
OWN_FIRMWARES = (PARPORT, BOARD, LATHE)  # processes of this computer, `machine.controller_family`
PULSE_FIRMWARES = (PARPORT, BOARD)
# What may answer at a port of which no profile is known.
BOARD_FIRMWARES = (GRBL, GRBLHAL, FLUIDNC)
FIRMWARES = (*BOARD_FIRMWARES, *OWN_FIRMWARES)


def language_of(key: str) -> str:
    """Return the language of the firmware of that key; the key itself where there is none."""
    return next((firmware.language for firmware in FIRMWARES if firmware.key == key), key)


def firmware_of_controller(controller: str) -> Firmware | None:
    """Return the firmware of a profile's controller; None where it is none that lines are sent to."""
    controller = controller.partition(":")[0]
    family = FAMILIES.get(controller, "")
    key = family if family in OWN else controller
    return next((firmware for firmware in FIRMWARES if firmware.key == key), None)


def firmware_of_greeting(greeting: str) -> Firmware:
    """Return the firmware that a greeting names; grbl where it names no other."""
    if "fluidnc" in greeting.lower():
        return FLUIDNC
    return GRBLHAL if greeting.lower().startswith("grblhal") else GRBL


def firmware_of_tag(tag: str, text: str) -> Firmware | None:
    """Return the firmware that a line `[tag:text]` of `$I` names, or None where it names none."""
    if tag == "VER" and "fluidnc" in text.lower():
        return FLUIDNC
    if tag in GRBLHAL_TAGS or (tag == "FIRMWARE" and text.lower() == "grblhal"):
        return GRBLHAL
    if tag == "FIRMWARE" and text.lower().startswith(OWN_NAME):
        return next((own for own in OWN_FIRMWARES if own.key == text.lower().removeprefix(OWN_NAME).strip()), None)
    return None
