# SPDX-License-Identifier: LGPL-2.1-or-later
"""One job's run over an open connection; it ends only when the machine stands still and why is known.

    connecting --> running <--> holding --> held          `!` and `~`, asked for here or at the machine
        |             |  `--> paused (M0, or line by line: `stand.py`), door
        |             v
        |          finishing (all acknowledged) --> done (Idle, reported twice)
        `-> refused   `-> stopping --> stopped, failed    hold, Hold:0, soft reset

Who owns the link, a `Sender` for one job or a `Desk` that stays, brings it; one thread does it all: it
listens, obeys, feeds and asks `?`.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace

from CNCStepper.control import connect, halt
from CNCStepper.control.buttons import quicker
from CNCStepper.control.command import Command, Inbox
from CNCStepper.control.feeder import Feeder
from CNCStepper.control.first_modes import check_modes, mode_differences
from CNCStepper.control.grbl import Answered, Grbl, Received
from CNCStepper.control.grbl_report import Alarm, Greeting, Status, Vector
from CNCStepper.control.moment import moment
from CNCStepper.control.outcome import DONE, FAILED, REFUSED, STOPPED, Outcome, SenderStatus
from CNCStepper.control.overrides import override_byte
from CNCStepper.control.phases import Phases
from CNCStepper.control.readiness import check_offsets, check_settings, check_zero, differences, offset_differences
from CNCStepper.control.send_job import SendJob
from CNCStepper.control.stand import Stand
from CNCStepper.control.timing import Timing
from CNCStepper.control.watch import Watch
from CNCStepper.errors import CNCStepperError, LinkError, MachineRefusal

IDLE_REPORTS = 2  # one alone may come between the last answer and the start of its motion
KEPT = "the machine stands, spindle and outputs are off, its position is kept (the reset cleared G92 and tool length)"
LOST = "the machine's position is unknown: look that spindle and outputs are off, then home it or set its zero again"

Tell = Callable[[str, str], None]
Refuse = Callable[[Command, CNCStepperError], None]


class Stopped(Exception):
    """Somebody asked to stop."""


class JobRun:
    """Runs one job; `run` blocks, `status` may be called from any thread.

    tell(kind, text): hears what happens and must not block; kinds are "phase", "message" (the
    program's words) and "warning". refuse(command, error): hears what cannot be obeyed now.
    """

    def __init__(
        self,
        job: SendJob,
        inbox: Inbox,
        *,
        timing: Timing,
        clock: Callable[[], float] = time.monotonic,
        tell: Tell = lambda kind, text: None,
        refuse: Refuse = lambda command, error: None,
    ):
        self.job = job
        self.driver: Grbl | None = None  # before it is connected
        self._inbox = inbox
        self._timing = quicker(timing, job.inputs)
        self._clock = clock
        self._tell = tell
        self._refuse = refuse
        self._feeder = Feeder(job)
        self._phases = Phases(tell)
        self._watch = Watch(self._timing)
        self._stand = Stand(self._timing, tell, refuse)
        self._begin_s = clock()
        self._idle_reports = 0
        self._trouble: list[Received] = []  # the alarm or greeting that ended the job

    def status(self) -> SenderStatus:
        """Return this moment."""
        last = self._feeder.acknowledged - 1
        return replace(
            moment(self.driver, self._phases.name, self._phases.message),
            sent=self._feeder.sent,
            acknowledged=self._feeder.acknowledged,
            total=self._feeder.total,
            file=self.job.file,
            file_line=self.job.place(last).line if last >= 0 else 0,
            elapsed_s=self._clock() - self._begin_s,
        )

    def count(self, received: list[Received]) -> None:
        """Hear what came, also while the machine is brought to rest: count the answers to the job's lines."""
        for report in received:
            if isinstance(report, Greeting) and self._phases.stands:
                self._trouble.append(report)  # also one that comes while a zero is set
            elif isinstance(report, Answered):
                self._feeder.take(report)
                if message := self.job.messages.get(report.sent.index):
                    self._tell("message", message)

    def run(self, connected: Callable[[], connect.Found]) -> Outcome:
        """Send the job and return how it ended; refusals and failures are in the outcome, not raised.

        connected: sets `driver` to that of an idle machine and returns what it found; called once the job
        itself is found good. It may raise `Stopped` or any error of ours.
        """
        outcome = self._begun(connected) or self._streamed()
        self._phases.set(outcome.kind)
        return outcome

    # --- before the first line -----------------------------------------------------------------

    def _begun(self, connected: Callable[[], connect.Found]) -> Outcome | None:
        try:
            check_zero(self.job.zero_confirmed)
            self.job.check()
            self._compare(connected())
        except Stopped:
            return self._outcome(STOPPED, "stopped before the first line was sent", True)
        except CNCStepperError as error:
            seen = self.driver.status if self.driver else None
            return self._outcome(REFUSED, str(error), seen is not None and seen.state != "Alarm", error)
        self._phases.set("running")
        return None

    def _compare(self, found: connect.Found) -> None:
        for number in sorted(set(self.job.expected) - set(found.settings)):
            self._tell("warning", f"the controller does not report ${number}: it was not compared")
        moved, modes = self._moved_offsets(found), self._left_modes(found)
        if not self.job.allow_differences:
            check_settings(found.settings, self.job.expected)
            check_offsets(moved)
            check_modes(modes)
        for difference in [*differences(found.settings, self.job.expected), *moved, *modes]:
            self._tell("warning", str(difference))

    def _moved_offsets(self, found: connect.Found) -> list[str]:
        return offset_differences(self._offsets_mm(found), found.modes, self.job.work_offsets_mm, self.job.work_system)

    def _left_modes(self, found: connect.Found) -> list[str]:
        return mode_differences(found.modes, self._offsets_mm(found), self.job.lines)

    def _offsets_mm(self, found: connect.Found) -> dict[str, Vector | None]:
        assert self.driver
        return {name: self.driver.mm(offset) for name, offset in found.offsets.items()}

    # --- streaming -----------------------------------------------------------------------------

    def _streamed(self) -> Outcome:
        assert self.driver
        try:
            self._obey(self.driver)  # what was asked while connecting, before the first line
            while self._idle_reports < IDLE_REPORTS:
                self._turn(self.driver)
        except Stopped:
            return self._halted(self.driver, None)
        except CNCStepperError as error:
            return self._halted(self.driver, error)
        except BaseException:  # whatever went wrong here, the machine must not go on alone
            self._rest(self.driver)
            raise
        return self._outcome(DONE, f"all {self._feeder.total} lines are cut, the machine is idle", True)

    def _turn(self, driver: Grbl) -> None:
        """Feed, ask, listen and obey once; at most until the next `?` is due."""
        for report in self._trouble:
            if isinstance(report, Greeting):
                raise connect.restart_refusal(report)
        idle = self._watch.idle(driver, self._phases.changed_s)
        self._watch.check(
            driver, idle and self._phases.feeding, self._feeder.dwell_s(driver), self._feeder.place_at_work()
        )
        if self._phases.feeding and self._feeder.feed(driver, idle):
            self._watch.heard_s = self._clock()
        every_s = self._timing.poll_s if self._phases.name == "running" else self._timing.quick_poll_s
        for report in driver.receive(min(self._watch.poll(driver, every_s), self._stand.turn())):
            self._take(driver, report)
        self._obey(driver)
        if self._phases.stands and self._stand.is_left(driver):
            self._feeder.leave_stand()
            self._phases.set("running")

    def _take(self, driver: Grbl, report: Received) -> None:
        if isinstance(report, Answered):
            self._watch.heard_s = self._clock()
            if report.sent.index < 0:
                self._stand.answered(report)
            elif report.error:
                raise self._feeder.refusal(report)
        elif isinstance(report, (Alarm, Greeting)):
            self._trouble.append(report)
            raise connect.alarm_refusal(report) if isinstance(report, Alarm) else connect.restart_refusal(report)
        elif isinstance(report, Status):
            self._phases.take(driver, self._feeder)
            self._count_idle(driver)

    def _count_idle(self, driver: Grbl) -> None:
        if self._feeder.complete and self._phases.feeding:
            self._phases.set("finishing")
        message = self._feeder.stand_message(driver) if self._phases.name == "running" else None
        awaited = self._phases.name == "finishing" or message is not None
        finished = awaited and self._watch.idle(driver, self._phases.changed_s)
        self._idle_reports = self._idle_reports + 1 if finished else 0
        if message is not None and self._idle_reports == IDLE_REPORTS:
            self._idle_reports = 0
            self._stand.begin(driver, self._feeder.sent)
            self._phases.stand(message)

    def _obey(self, driver: Grbl) -> None:
        for command in self._inbox.take():
            if command.name in ("stop", "end"):
                raise Stopped
            try:
                self._do(command, driver)
            except CNCStepperError as error:
                if isinstance(error, LinkError):
                    raise
                self._refuse(command, error)

    def _do(self, command: Command, driver: Grbl) -> None:
        if command.name == "by_line":
            self._feeder.by_line = command.values["on"]
        elif self._phases.stands and command.name in self._stand.commands:
            self._stand.do(command)
        elif command.name in ("hold", "resume"):
            self._phases.obey(command.name, driver)
        elif command.name == "override":
            driver.realtime(override_byte(**command.values))
        elif command.name != "jog_cancel":  # a button let go has nothing to say here
            raise MachineRefusal("job-runs", "a job runs", advice="wait until it has ended, or stop it")

    # --- the end -------------------------------------------------------------------------------

    def _halted(self, driver: Grbl, error: CNCStepperError | None) -> Outcome:
        """Bring the machine to rest and say why and how it stands."""
        known, broken = self._rest(driver)
        error = error or broken
        why = str(error) if error else f"stopped as asked after {self._feeder.acknowledged} lines"
        return self._outcome(FAILED if error else STOPPED, f"{why}. Now {KEPT if known else LOST}", known, error)

    def _rest(self, driver: Grbl) -> tuple[bool, LinkError | None]:
        """Return whether the position is kept, and the error when the link broke on the way."""
        self._phases.set("stopping")
        try:
            if self._trouble:
                return halt.reset(driver, self._timing, self._trouble), None
            return halt.hold_and_reset(driver, self._timing), None
        except LinkError as broken:
            with suppress(LinkError):  # a last try to switch the outputs off, if the way there still works
                driver.reset()
            return False, broken

    def _outcome(self, kind: str, text: str, known: bool, error: CNCStepperError | None = None) -> Outcome:
        return Outcome(kind, text, known, replace(self.status(), phase=kind), error)
