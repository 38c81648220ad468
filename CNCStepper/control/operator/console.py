# SPDX-License-Identifier: LGPL-2.1-or-later
"""Console lines, one at a time: sent, answered, and done when the machine is at rest again.

line ──► sent ──► what the controller says ("console") ──► ok or error:n ──► at rest ──► "answer"

Whether a line that a person types at a console may go to the controller now, and what kind of line it is.

    $H  $X                     home and unlock: done as the service does them
    $  $$  $#  $G  $I  $N ...  questions, while it stands
    $J=G91G21X10F1000          a jog
    $110=500                   a setting, while it stands
    G0 X10, M3 S1000 ...       a line of a program

What would move a machine whose position is lost the driver refuses (`motion_interlock.py`).

All else beginning with `$` is refused with its reason. Bytes that act at once are never passed on within a line.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from CNCStepper.control.program.wire_line import check_length, check_line, dwell_s
from CNCStepper.control.protocol.grbl.character_counting import Sent
from CNCStepper.control.protocol.grbl.driver import Answered, Grbl, Received
from CNCStepper.control.protocol.grbl.firmware import Firmware
from CNCStepper.control.protocol.grbl.status_reports import Feedback, NamedSetting, Setting, Status
from CNCStepper.errors import MachineRefusal, Text
from CNCStepper.gcode.syntax.words import packed_wire
from CNCStepper.word_pattern import DECIMAL

HOME, UNLOCK, QUESTION, JOG, SETTING, PROGRAM = "home", "unlock", "question", "jog", "setting", "program"
MOVING_KINDS = (JOG, PROGRAM)  # done only when the machine is at rest again
STEPS_PER_MM = range(100, 110)
_QUESTION = re.compile(r"\$|\$\$|\$#|\$G|\$I\+?|\$N|\$SS?|\$[A-Z]*/[\w/]+")
_SETTING = re.compile(rf"\$([0-9]{{1,4}})=(?=.{{1,16}}$)({DECIMAL})")
_WHY_NOT = {
    **dict.fromkeys(
        ("$N=", "$L=", "$P=", "$T="), "pulses, relays and trials of a rate: `cncstepper machine-test` does them"
    ),
    "$C": "`cncstepper check` checks a program without the machine",
    "$SLP": "switch the machine off, or unlock and home it afterwards at the machine itself",
    "$RST": "it would erase the settings: write the settings that you want to change one by one",
    "$N": "a line that runs at every start moves the machine while nobody watches",
}


def kind_of(text: str) -> str:
    """Return the kind of a line; raises MachineRefusal for a `$` command that a console does not pass on."""
    plain = packed_wire(text)
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


def setting_of(text: str) -> tuple[int, float]:
    """Return number and value of a setting's line."""
    found = _SETTING.fullmatch(packed_wire(text))
    assert found
    return int(found[1]), float(found[2])


def check_typed(text: str, firmware: Firmware, window_bytes: int) -> None:
    """Raise ProgramError for a line that cannot be sent as it is."""
    check_line(text)
    check_length(text, firmware, window_bytes)


AT_REST = ("Idle", "Alarm", "Check")


class Console:
    """Sends one line at a time; `tell` receives "console" (the controller's text) and "answer" ("ok" or the error)."""

    def __init__(self, driver: Grbl, tell: Callable[[str, str], None]):
        self._driver = driver
        self._tell = tell
        self._sent: Sent | None = None
        self._kind = ""
        self._answered_s: float | None = None

    @property
    def active(self) -> bool:
        """Whether a line is not done yet."""
        return self._sent is not None

    @property
    def dwell_s(self) -> float:
        """How long the line under way may keep its answer back on purpose."""
        return dwell_s(self._sent.text) if self._sent else 0.0

    def send(self, text: str, kind: str) -> None:
        """Send a line; raises MachineRefusal or ProgramError when it may not go now."""
        if self.active:
            raise MachineRefusal("console-busy", "the line before is not done yet", advice="wait, hold or stop it")
        check_typed(text, self._driver.firmware, self._driver.window)
        self._driver.send(text)
        self._driver.flush()
        self._sent, self._kind, self._answered_s = self._driver.unanswered[-1], kind, None

    def takes(self, answer: Answered) -> bool:
        """Take the answer to a typed line; return False when it is the answer to another one."""
        if answer.sent is not self._sent:
            return False
        if answer.error:
            code = self._driver.firmware.error(answer.error)
            self._end(
                Text("error:{error} {meaning}; {advice}", error=answer.error, meaning=code.meaning, advice=code.advice)
            )
        elif self._kind in MOVING_KINDS:
            self._answered_s = self._driver.clock()
        else:
            self._end("ok")
        return True

    def changes_steps(self, answer: Answered) -> bool:
        """Take over a setting that was stored; return whether positions mean something else from now on."""
        if answer.error or answer.sent is not self._sent or self._kind != SETTING:
            return False
        number, value = setting_of(answer.sent.text)
        self._driver.settings[number] = value
        return number in STEPS_PER_MM

    def on_message(self, report: Received, unasked: bool = False) -> None:
        """Emit the messages that belong to the current line, and detect when the machine is at rest again.

        unasked: the report answers no line; it is passed to `tell` too.
        """
        if not self.active and not unasked:
            return
        if isinstance(report, Status) and self.active:
            self._see(report)
        elif isinstance(report, Setting):
            self._tell("console", f"${report.number}={report.value:.10g}")
        elif isinstance(report, NamedSetting):
            self._tell("console", f"${report.name}={report.text}")
        elif isinstance(report, Feedback) and report.tag != "MSG":
            self._tell("console", f"[{report.tag}:{report.text}]")

    def forget(self) -> None:
        """The controller was reset or raised an alarm: nothing is under way any more."""
        if self.active:
            self._end("given up: the controller was reset or is locked")

    def _see(self, status: Status) -> None:
        if self._answered_s is None or self._driver.status_asked_s <= self._answered_s:
            return
        if status.state in AT_REST:
            self._end("ok")

    def _end(self, answer: str) -> None:
        self._sent = None
        self._tell("answer", answer)
