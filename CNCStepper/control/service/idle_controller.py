# SPDX-License-Identifier: LGPL-2.1-or-later
"""A controller between jobs: jog, set the zero, home, unlock, override, poll its status."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from CNCStepper.control.operator import zero_and_unlock
from CNCStepper.control.operator.console import HOME as HOME_LINE
from CNCStepper.control.operator.console import JOG, MOVING_KINDS, UNLOCK, Console, kind_of
from CNCStepper.control.operator.homing import HOME, check_took
from CNCStepper.control.operator.jog import Jogger, JogMove, check_in_time
from CNCStepper.control.protocol.grbl import connect
from CNCStepper.control.protocol.grbl.capabilities import check_axes, check_can, own_axes
from CNCStepper.control.protocol.grbl.driver import HOLD, RESUME, Answered, Grbl, Received
from CNCStepper.control.protocol.grbl.firmware import TOOL_CHANGED
from CNCStepper.control.protocol.grbl.readiness import check_state
from CNCStepper.control.protocol.grbl.status_poller import StatusPoller
from CNCStepper.control.protocol.grbl.status_reports import Alarm, Feedback, Greeting, Status
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.control.session.command import Command
from CNCStepper.control.session.job_phase import Phase
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.control.stream import stop_sequence
from CNCStepper.control.stream.job_run import Refuse, Tell
from CNCStepper.control.stream.overrides import override_byte
from CNCStepper.control.stream.position_trust import (
    LOST,
    NOTHING_AGAINST,
    PositionTrust,
    trust_after_sleep,
    trust_at_connect,
    trust_at_zero,
)
from CNCStepper.control.stream.status_snapshot import status_snapshot
from CNCStepper.errors import CNCStepperError, LinkError, MachineRefusal, Text

PHASES = {
    "Idle": Phase.IDLE,
    "Jog": Phase.JOGGING,
    "Home": Phase.HOMING,
    "Hold": Phase.HELD,
    "Tool": Phase.HELD,
    "Door": Phase.DOOR,
}
MOVING = ("Run", "Jog", "Home")
LOCKED = {
    "Alarm": "the controller is locked: home the machine, or unlock it if its position is surely right",
    "Sleep": "the controller sleeps and its motors are off: unlock it, then home it or set its zero again",
}
HOMED = "the machine is homed"
CRITICAL = "Reset to continue"


class IdleController:
    """One machine between jobs; runs on the service's thread, except for `status`.

    trust: the position trust; set it again after a reset that kept the position.
    """

    def __init__(self, driver: Grbl, timing: Timing, tell: Tell, refuse: Refuse):
        self.trust = NOTHING_AGAINST
        self._driver = driver
        self._timing = timing
        self._tell = tell
        self._refuse = refuse
        self._jogger = Jogger(driver, lambda error: refuse(Command("jog"), error), tell)
        self._console = Console(driver, tell)
        self._watch = StatusPoller(timing)
        self._homing_since_s: float | None = None
        self._alarm = ""
        self._wants_reset = False
        self._does: dict[str, Callable[..., None]] = {
            "hold": self._hold,
            "resume": lambda stand=None: self._resume(),  # the service has compared its stand
            "stop": self.stop,
            "jog": lambda **way: self._jogger.step(JogMove(**way)),
            "jog_on": lambda press, **way: self._jogger.keep(press, JogMove(**way)),
            "jog_cancel": self._cancel_jog,
            "set_zero": self._set_zero,
            "home": self._home,
            "unlock": self._unlock,
            "line": self._type,
            "tell_place": self._refuse_way_back,
            "retrace": self._refuse_way_back,
            "want_back": self._refuse_way_back,
            "by_line": self._refuse_by_line,
            "switch": self._switch,
            "override": lambda **values: driver.realtime(override_byte(**values)),
        }

    @property
    def busy(self) -> bool:
        """Whether the machine moves, or something is under way to it."""
        state = self._driver.status.state if self._driver.status else ""
        under_way = self._jogger.active or self._console.active or self._homing_since_s is not None
        return under_way or state in MOVING

    @property
    def phase(self) -> str:
        """The phase of a service without a job; see `SenderStatus`."""
        if self._homing_since_s is not None:
            return "homing"
        state = self._driver.status.state if self._driver.status else ""
        return Phase.ALARM if state in LOCKED else PHASES.get(state, Phase.BUSY)

    @property
    def may_be_asked(self) -> bool:
        """Whether the controller answers to `$` commands now."""
        under_way = self._jogger.active or self._console.active
        return not self._wants_reset and not under_way and self.phase in (Phase.IDLE, Phase.ALARM)

    def status(self) -> SenderStatus:
        """Return the present status."""
        phase = self.phase
        state = self._driver.status.state if self._driver.status else ""
        message = (self._alarm or LOCKED[state]) if phase == "alarm" and state in LOCKED else ""
        trust = self.trust
        snapshot = status_snapshot(self._driver, phase, message)
        return replace(snapshot, position_known=trust.position_known, homed=trust.homed)

    def turn(self) -> None:
        """Send what is due, poll the status, and read once."""
        if self._homing_since_s is None:
            self._watch.check(self._driver, self.phase == "idle", self._console.dwell_s)
        elif self._driver.clock() - self._homing_since_s > self._timing.homing_s:
            raise LinkError("answer-missing", "the machine does not end its homing", advice="look at its switches")
        if not self._driver.unanswered:
            self._watch.last_line_s = self._driver.clock()  # what goes out from now on
        self._jogger.turn()
        every_s = self._timing.quick_poll_s if self.busy else self._timing.service_poll_s
        for report in self._driver.receive(min(self._watch.poll(self._driver, every_s), self._jogger.wait_s)):
            if isinstance(report, Answered):
                self._take_answer(report)

    def do(self, command: Command) -> None:
        """Carry out a command; raises MachineRefusal when it cannot be done now."""
        check_in_time(command, self._driver.clock())
        if not (command.name in ("hold", "stop") and self.phase == Phase.JOGGING):
            check_can(command.name, self._driver.cannot)
        self._does[command.name](**command.values)

    def on_message(self, received: list[Received]) -> None:
        """Note what ends jogs and homing, or costs the position; called for all that is received."""
        unasked = not self._driver.unanswered and not any(isinstance(report, Answered) for report in received)
        for report in received:
            self._console.on_message(report, unasked)
            if isinstance(report, Alarm):
                self._take_alarm(report)
            elif isinstance(report, Greeting):
                self._give_up()
                self._wants_reset = False
                self.lose_position()
            elif isinstance(report, Status) and report.state == "Idle":
                self._alarm = ""
            elif isinstance(report, Feedback) and report.text.endswith(CRITICAL):
                self._wants_reset = True

    def lose_position(self) -> None:
        """From now on the machine's position is unknown until it is homed or all its zeros are set."""
        self.trust = LOST

    def meet(self, before: PositionTrust, greeted: bool) -> None:
        """Take over a connected controller. before: trust until then; greeted: it has restarted."""
        self.trust = trust_at_connect(before, self._driver, greeted)

    def stop(self) -> None:
        """Bring to rest whatever moves: a jog keeps its position, homing loses it."""
        if self._homing_since_s is not None:
            self._driver.reset()
            self._give_up()
            self.lose_position()
        elif self._jogger.active or self.phase == "jogging":
            self._jogger.cancel()
        elif self.phase in (Phase.BUSY, Phase.HELD, Phase.DOOR):
            trust = self.trust
            if stop_sequence.hold_and_reset(self._driver, self._timing):
                self.trust = trust  # a reset at rest does not cost it
            else:
                self.lose_position()
        else:
            raise MachineRefusal("nothing-to-stop", "nothing moves", advice="there is nothing to stop")

    def check_no_jog(self) -> None:
        """Raise MachineRefusal while a jog or a typed line is still to be sent, answered, cancelled or done."""
        if self._console.active:
            advice = "wait until the typed line is done, or stop it"
            raise MachineRefusal("machine-busy", "the machine is not at rest", value="console", advice=advice)
        if self._jogger.active:
            advice = "wait until the jog has ended"
            raise MachineRefusal("machine-busy", "the machine is not at rest", value="jogging", advice=advice)

    def check_at_rest(self) -> None:
        """Raise MachineRefusal while something moves or is under way."""
        self.check_no_jog()
        if self.phase not in (Phase.IDLE, Phase.ALARM):
            advice = "wait until it has ended, or stop it"
            raise MachineRefusal("machine-busy", "the machine is not at rest", value=self.phase, advice=advice)

    # --- inside --------------------------------------------------------------------------------

    def _hold(self) -> None:
        if self._jogger.active or self.phase == "jogging":
            self._jogger.cancel()
        elif self.phase == "busy":
            self._driver.realtime(HOLD)
        else:
            raise MachineRefusal("nothing-to-hold", "nothing moves that could be held", advice="homing can be stopped")

    def _refuse_way_back(self, **values: object) -> None:
        raise MachineRefusal("not-held", "no job is held", advice="go back along the cut while a job is held")

    def _refuse_by_line(self, on: bool) -> None:
        raise MachineRefusal("not-running", "no job runs", advice="go line by line while a job runs")

    def _resume(self) -> None:
        if self.phase not in (Phase.HELD, Phase.DOOR):
            raise MachineRefusal("nothing-to-resume", "the machine is not held", advice="there is nothing to resume")
        status = self._driver.status
        if status and status.name == "Hold:1":  # in which grbl forgets a cycle start
            advice = "resume when it is at standstill"
            raise MachineRefusal(
                "machine-slowing", "the machine is still slowing down", value=status.name, advice=advice
            )
        if status and status.state == "Tool":
            self._driver.realtime(TOOL_CHANGED)
        self._driver.realtime(RESUME)

    def _cancel_jog(self) -> None:
        if self._jogger.active or self.phase == "jogging":
            self._jogger.cancel()

    def _set_zero(self, axes: str) -> None:
        self.check_at_rest()
        axes = zero_and_unlock.axes_to_zero(axes, self._driver.cannot)
        system = zero_and_unlock.set_zero(self._driver, axes, self._timing)
        self.trust = trust_at_zero(self.trust, axes, own_axes(self._driver.cannot))
        self._tell("message", Text("zero of {axes} set in {system}", axes=axes, system=system))

    def _unlock(self) -> None:
        self.check_at_rest()
        asleep = self.status().machine_state == "Sleep"
        trust = self.trust
        zero_and_unlock.unlock(self._driver, self._timing, self._wants_reset or asleep)
        self.trust = trust_after_sleep(trust) if asleep else trust  # a reset at rest does not cost it

    def _type(self, text: str) -> None:
        """Execute a typed line: home and unlock by the service's own functions, other lines verbatim."""
        kind = kind_of(text)
        self.check_at_rest()
        if kind == HOME_LINE:
            self._home()
        elif kind == UNLOCK:
            self._unlock()
            self._tell("answer", "ok")
        else:
            if kind == JOG:
                check_axes((axis for axis in zero_and_unlock.AXES if axis in text.upper()), self._driver.cannot)
            if kind in MOVING_KINDS:
                check_state(self._driver.status, self._driver.cannot)
            self._console.send(text, kind)

    def _home(self) -> None:
        self.check_at_rest()
        if self._wants_reset:
            zero_and_unlock.soft_reset(self._driver, self._timing)
        elif self.phase != "alarm":
            check_state(self._driver.status, self._driver.cannot)
        self._driver.send(HOME)
        self._driver.flush()
        self._homing_since_s = self._driver.clock()

    def _switch(self, line: str) -> None:
        """Send a block that only switches an output."""
        self.check_no_jog()
        check_state(self._driver.status, self._driver.cannot)
        connect.ask(self._driver, line, self._timing)

    def _take_answer(self, answer: Answered) -> None:
        if self._console.changes_steps(answer):
            self.lose_position()
        if self._console.takes(answer):
            return
        if answer.sent.text != HOME:
            self._jogger.answered(answer)
            return
        if answer.error:
            self._homing_since_s = None
            firmware = self._driver.firmware
            code = firmware.error(answer.error)
            words = Text(
                "the machine does not home: {meaning} (error:{error})", meaning=code.meaning, error=answer.error
            )
            refusal = MachineRefusal(f"{firmware.key}-error-{answer.error}", words, advice=code.advice)
            self._refuse(Command("home"), refusal)
        else:
            self._end_homing()

    def _end_homing(self) -> None:
        """Trust a machine that reports homing done after a plausible time; else stop it."""
        if self._homing_since_s is None:  # it failed: the alarm came in one piece with its `ok`
            return
        try:
            check_took(self._driver.clock() - self._homing_since_s)
        except LinkError as error:
            self.stop()
            self._refuse(Command("home"), error)
            return
        self._homing_since_s = None
        self.trust = self.trust._replace(position_known=True, homed=True)
        self._tell("message", HOMED)

    def _take_alarm(self, alarm: Alarm) -> None:
        self._alarm = str(connect.alarm_refusal(alarm, self._driver.firmware))
        self._give_up()
        if not self._driver.firmware.alarm(alarm.code).position_kept:
            self.lose_position()

    def _give_up(self) -> None:
        self._jogger.forget()
        self._console.forget()
        self._homing_since_s = None


def is_fatal(error: CNCStepperError) -> bool:
    """Return whether an error ends the connection; a controller that restarts while it is asked does not."""
    return isinstance(error, LinkError) and error.code != connect.RESTARTED
