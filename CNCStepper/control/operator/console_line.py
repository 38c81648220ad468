# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a line that a person types at a console may go to the controller now, and what kind of line it is.

    $H  $X                     home and unlock: done as the desk does them
    $  $$  $#  $G  $I  $N ...  questions, while it stands
    $J=G91G21X10F1000          a jog
    $110=500                   a setting, while it stands
    G0 X10, M3 S1000 ...       a line of a program

What would move a machine whose position is lost the driver refuses (`motion_interlock.py`).

All else beginning with `$` is refused with its reason. Bytes that act at once are never passed on within a line.
"""

from __future__ import annotations

import re

from CNCStepper.control.program.wire_line import check_length, check_line
from CNCStepper.control.protocol.grbl.firmware import Firmware
from CNCStepper.errors import MachineRefusal, Text

HOME, UNLOCK, QUESTION, JOG, SETTING, PROGRAM = "home", "unlock", "question", "jog", "setting", "program"
MOVING_KINDS = (JOG, PROGRAM)  # done only when the machine stands again
STEPS_PER_MM = range(100, 110)
_QUESTION = re.compile(r"\$|\$\$|\$#|\$G|\$I\+?|\$N|\$SS?|\$[A-Z]*/[\w/]+")
_SETTING = re.compile(r"\$([0-9]{1,4})=(?=.{1,16}$)([-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+))")
_WHY_NOT = {
    "$C": "`cncstepper check` checks a program without the machine",
    "$SLP": "switch the machine off, or unlock and home it afterwards at the machine itself",
    "$RST": "it would forget the settings: write the settings that are to change one by one",
    "$N": "a line that runs by itself at every start moves without anybody who looks",
}


def kind_of(text: str) -> str:
    """Return the kind of a line; raises MachineRefusal for a `$` command that a console does not pass on."""
    plain = plain_line(text)
    if not plain.startswith("$"):
        return PROGRAM
    if plain in ("$H", "$X"):
        return HOME if plain == "$H" else UNLOCK
    if plain.startswith("$J="):
        return JOG
    if _SETTING.fullmatch(plain):
        return SETTING
    if _QUESTION.fullmatch(plain):
        return QUESTION
    why = next(
        (why for begin, why in _WHY_NOT.items() if plain.startswith(begin)), "`$` lists what the controller knows"
    )
    raise MachineRefusal("console-command", Text("the console does not pass on {text}", text=text[:20]), advice=why)


def plain_line(text: str) -> str:
    """Return a line as the controller reads it: capitals without blanks."""
    return text.replace(" ", "").upper()


def setting_of(text: str) -> tuple[int, float]:
    """Return number and value of a setting's line."""
    found = _SETTING.fullmatch(plain_line(text))
    assert found
    return int(found[1]), float(found[2])


def check_typed(text: str, firmware: Firmware, window_bytes: int) -> None:
    """Raise ProgramError for a line that cannot be sent as it is."""
    check_line(text)
    check_length(text, firmware, window_bytes)
