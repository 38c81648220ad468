# SPDX-License-Identifier: LGPL-2.1-or-later
"""The phases of a session, driven by the controller's states and by the operator's requests.

    running --hold--> holding --Hold:0--> held --resume--> running
    running --Hold at an M0--> paused --resume--> running
    running --Tool--> paused (M6 of grblHAL), 0xA3 --resume, after any jogs back there--> running
    running --Idle before a line that is waited for--> paused --resume, after any jogs back there--> running
    running --Door--> door --closed (Door:0), resume--> running
    held --reset, a way along the cut--> running --> retreated --another--> running

A request is only a request until the controller's state shows it: grbl forgets `~` while it slows down, so
resume waits for Hold:0; a status asked before the last `!` or `~` shows the time before it.
"""

from __future__ import annotations

from collections.abc import Callable

from CNCStepper.control.protocol.grbl.connect import alarm_refusal
from CNCStepper.control.protocol.grbl.driver import HOLD, RESUME, Grbl
from CNCStepper.control.protocol.grbl.firmware import TOOL, TOOL_CHANGED
from CNCStepper.control.protocol.grbl.readiness import CHECK, state_refusal
from CNCStepper.control.protocol.grbl.status_reports import Alarm, Status
from CNCStepper.control.session.job_phase import FEEDING, STANDING, Phase
from CNCStepper.control.stream.feeder import Feeder
from CNCStepper.control.stream.pause_id import PauseCounter
from CNCStepper.errors import MachineRefusal, Text

CHANGE_TOOL = "change the tool, then resume"
CUTS_NOTHING = ("Sleep", CHECK, "Starting", "ConfigAlarm", "Critical")
MOVES_OTHERWISE = ("Jog", "Home")  # than the program says, unless the program homes, or somebody jogs at a stand
DOOR_RETURNS = 3  # the substate in which a resumed machine switches its outputs on again


class Phases:
    """The phase of a session; `message` is the program's own at a pause.

    changed_s: when the last `!` or `~` was written, by the driver's clock.
    """

    def __init__(self, tell: Callable[[str, str], None], stands: PauseCounter):
        self.name: str = Phase.CONNECTING
        self.message = ""
        self.changed_s = float("-inf")
        self._tell = tell
        self._stands = stands
        self.stands = False  # paused between two lines, at a machine that can be jogged
        self._hold_asked = False
        self._resume_asked = False

    @property
    def feeding(self) -> bool:
        """Whether lines may go out."""
        return self.name in FEEDING

    def set(self, name: str, message: str = "") -> None:
        """Enter a phase and report it; nothing happens when it is the present one."""
        self.stands = False
        if name != self.name:
            self.name, self.message = name, message
            self._stands.enter(name)
            self._tell("phase", Text("{name}: {message}", name=name, message=message) if message else name)

    def restart_with(self) -> None:
        """Begin with other lines after a reset; earlier requests are dropped."""
        self._hold_asked = self._resume_asked = False
        self.set(Phase.RUNNING)

    def stand(self, message: str) -> None:
        """Pause between two lines, until the next phase is set."""
        self.set(Phase.PAUSED, message)
        self.stands = True

    def hold_or_resume(self, command: str, driver: Grbl) -> None:
        """Execute "hold" or "resume"; raises MachineRefusal where nothing can be resumed."""
        if command == "hold":
            self._resume_asked = False
            if self.feeding or self.name == Phase.HOLDING:
                self._hold_asked = True
                self._write(HOLD, driver)
                self.set(Phase.HOLDING)
        elif self.feeding:
            self._tell("warning", "there is nothing to resume: the machine is not held")
        else:
            self._resume_asked = True

    def check_no_jog(self, command: str, driver: Grbl) -> None:
        """Raise MachineRefusal for a jog in a hold, in which no controller takes one."""
        if command in ("jog", "jog_on") and self.name in (Phase.HELD, Phase.PAUSED):
            check_no_tool_change(driver)
            advice = "jog with `cncstepper jog`: it lets the controller give up its lines first"
            raise MachineRefusal("held-jog", "the controller accepts no jog while it is held", advice=advice)

    def take(self, driver: Grbl, feeder: Feeder) -> None:
        """Follow the status just received; raises MachineRefusal for a state that ends the job."""
        status = driver.status
        assert status
        if status.state == "Alarm":
            raise alarm_refusal(Alarm(-1), driver.firmware)
        if status.state in CUTS_NOTHING or (status.state in MOVES_OTHERWISE and self._cuts(driver)):
            raise state_refusal(status)
        if driver.status_asked_s <= self.changed_s:
            return
        if status.state == "Hold":
            self._in_hold(status, driver, feeder)
        elif status.state == "Door":
            self._at_door(status, driver)
        elif status.state == TOOL:
            self._at_tool_change(driver, feeder)
        elif not self.stands:
            self._moving(driver)

    def _cuts(self, driver: Grbl) -> bool:
        """Return whether nothing but the program's lines can move the machine, none of which is a `$` command."""
        under_way = bool(driver.unanswered) and driver.unanswered[0].text.startswith("$")
        return self.feeding and not self.stands and not under_way

    def _in_hold(self, status: Status, driver: Grbl, feeder: Feeder) -> None:
        still = status.substate in (0, None)
        message = None if self._hold_asked else feeder.pause_message(driver)
        if still and self._resume_asked:
            self._go_on(driver)
        elif message is not None:
            self.set(Phase.PAUSED, message)
        else:
            self.set(Phase.HELD if still else Phase.HOLDING)

    def _at_door(self, status: Status, driver: Grbl) -> None:
        if status.substate == DOOR_RETURNS:
            return
        if status.substate == 0 and self._resume_asked:
            self._go_on(driver)
            return
        if self._resume_asked:  # never kept: closing the door must not start the machine
            self._resume_asked = False
            self._tell(
                "warning",
                Text("the safety door is open or the machine is parking ({status}): resume later", status=status.name),
            )
        self.set(Phase.DOOR, "close the safety door, then resume")

    def _at_tool_change(self, driver: Grbl, feeder: Feeder) -> None:
        """Pause until the tool is changed: after its 0xA3, grblHAL takes jogs and a zero once M6 is answered.

        Else it can only be resumed.
        """
        message = feeder.tool_message(driver)
        if self._resume_asked:
            driver.realtime(TOOL_CHANGED)
            self._go_on(driver)
        elif message is None:
            self.set(Phase.PAUSED, feeder.pause_message(driver) or CHANGE_TOOL)
        elif not self.stands:
            driver.realtime(TOOL_CHANGED)
            self.stand(message or CHANGE_TOOL)

    def _moving(self, driver: Grbl) -> None:
        """The machine runs or is idle: somebody resumed it there, or it has not seen the hold yet."""
        if self.name == Phase.HOLDING and not self._resume_asked:
            self._write(HOLD, driver)
        elif self.name in STANDING or self.name == Phase.HOLDING:
            self._hold_asked = self._resume_asked = False
            self.set(Phase.RUNNING)

    def _go_on(self, driver: Grbl) -> None:
        self._hold_asked = self._resume_asked = False
        self._write(RESUME, driver)
        self.set(Phase.RUNNING)

    def _write(self, byte: bytes, driver: Grbl) -> None:
        driver.realtime(byte)
        self.changed_s = driver.clock()


def check_no_tool_change(driver: Grbl) -> None:
    """Raise MachineRefusal while the controller waits for a new tool: with a reset it would forget that it does."""
    if driver.status and driver.status.state == TOOL:
        what = "the controller waits for its new tool"
        raise MachineRefusal("tool-change", what, advice="resume, so that the change is over, and hold it again then")
