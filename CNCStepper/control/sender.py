# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sender: streams one job to grbl, and ends only when the machine stands still and why is known.

    connecting --> running <--> holding --> held          `!` and `~`, asked for here or at the machine
        |             |  `--> paused (M0), door
        |             v
        |          finishing (all acknowledged) --> done (Idle, reported twice)
        `-> refused   `-> stopping --> stopped, failed    hold, Hold:0, soft reset

One thread does it all: it listens, obeys, feeds and asks `?`. `hold`, `resume` and `stop` may come
from any thread and wake it up.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from queue import SimpleQueue

from CNCStepper.control import connect, halt
from CNCStepper.control.feeder import Feeder
from CNCStepper.control.grbl import Answered, Grbl, Received
from CNCStepper.control.grbl_report import Alarm, Feedback, Greeting, Status, Unknown
from CNCStepper.control.outcome import DONE, FAILED, REFUSED, STOPPED, Outcome, SenderStatus
from CNCStepper.control.phases import Phases
from CNCStepper.control.readiness import check_settings, check_zero, differences
from CNCStepper.control.send_job import SendJob
from CNCStepper.control.timing import Timing
from CNCStepper.control.transport import Link, open_link
from CNCStepper.control.watch import Watch
from CNCStepper.errors import CNCStepperError, LinkError

IDLE_REPORTS = 2  # one alone may come between the last answer and the start of its motion
KEPT = "the machine stands, spindle and outputs are off, its position is kept (the reset cleared G92 and tool length)"
LOST = "the machine's position is unknown: look that spindle and outputs are off, then home it or set its zero again"


class _Stop(Exception):
    """Somebody asked to stop."""


class Sender:
    """Runs one job over one link; `run` blocks, all else may be called from any thread.

    tell(kind, text): hears what happens, on the sender's thread, and must not block; kinds are
    "phase", "message" (the controller's or the program's words) and "warning".
    """

    def __init__(
        self,
        job: SendJob,
        *,
        opener: Callable[[str, int], Link] = open_link,
        timing: Timing | None = None,
        clock: Callable[[], float] = time.monotonic,
        tell: Callable[[str, str], None] = lambda kind, text: None,
    ):
        self.job = job
        self._opener = opener
        self._timing = timing or Timing()
        self._clock = clock
        self._tell = tell
        self._commands: SimpleQueue[str] = SimpleQueue()
        self._link: Link | None = None
        self._driver: Grbl | None = None
        self._feeder = Feeder(job)
        self._phases = Phases(tell)
        self._watch = Watch(self._timing)
        self._begin_s = clock()
        self._idle_reports = 0
        self._early: list[str] = []  # asked while connecting
        self._trouble: list[Received] = []  # the alarm or greeting that ended the job

    def hold(self) -> None:
        """Ask for a feed hold: the machine slows down and stands, nothing is lost."""
        self._ask("hold")

    def resume(self) -> None:
        """Ask to go on after a hold, a pause of the program or a closed door."""
        self._ask("resume")

    def stop(self) -> None:
        """Ask to end the job: hold, standstill, soft reset; spindle and outputs off, position kept."""
        self._ask("stop")

    def status(self) -> SenderStatus:
        """Return this moment."""
        driver, last = self._driver, self._feeder.acknowledged - 1
        seen = driver.status if driver else None
        return SenderStatus(
            phase=self._phases.name,
            sent=self._feeder.sent,
            acknowledged=self._feeder.acknowledged,
            total=self._feeder.total,
            machine_state=seen.name if seen else "",
            mpos_mm=driver.mpos_mm if driver else None,
            wpos_mm=driver.wpos_mm if driver else None,
            feed_mm_min=seen.feed if seen else None,
            spindle_rpm=seen.spindle if seen else None,
            file_line=self.job.place(last).line if last >= 0 else 0,
            message=self._phases.message,
            elapsed_s=self._clock() - self._begin_s,
        )

    def run(self) -> Outcome:
        """Send the job and return how it ended; refusals and failures are in the outcome, not raised."""
        try:
            outcome = self._connected() or self._streamed()
        finally:
            if self._link:
                self._link.close()
        self._phases.set(outcome.kind)
        return outcome

    # --- before the first line -----------------------------------------------------------------

    def _connected(self) -> Outcome | None:
        try:
            self._connect()
        except _Stop:
            return self._outcome(STOPPED, "stopped before the first line was sent", True)
        except CNCStepperError as error:
            seen = self._driver.status if self._driver else None
            return self._outcome(REFUSED, str(error), seen is not None and seen.state != "Alarm", error)
        return None

    def _connect(self) -> None:
        """Check all that can be checked, first without the machine, then with it."""
        check_zero(self.job.zero_confirmed)
        self.job.check()
        self._link = self._opener(self.job.port, self.job.baud)
        self._driver = Grbl(self._link, self._clock, self._listen)
        found = connect.meet(self._driver, self._timing)
        if found.greeted:
            self._tell("warning", "the controller restarted when its port was opened; it counts from where it stands")
        self._compare(found.settings)
        self._phases.set("running")
        for command in self._early:
            self._phases.obey(command, self._driver)

    def _compare(self, settings: dict[int, float]) -> None:
        for number in sorted(set(self.job.expected) - set(settings)):
            self._tell("warning", f"the controller does not report ${number}: it was not compared")
        if not self.job.allow_differences:
            check_settings(settings, self.job.expected)
        for difference in differences(settings, self.job.expected):
            self._tell("warning", str(difference))

    # --- streaming -----------------------------------------------------------------------------

    def _streamed(self) -> Outcome:
        assert self._driver
        try:
            while self._idle_reports < IDLE_REPORTS:
                self._turn(self._driver)
        except _Stop:
            return self._halted(self._driver, None)
        except CNCStepperError as error:
            return self._halted(self._driver, error)
        except BaseException:  # whatever went wrong here, the machine must not go on alone
            self._rest(self._driver)
            raise
        return self._outcome(DONE, f"all {self._feeder.total} lines are cut, the machine is idle", True)

    def _turn(self, driver: Grbl) -> None:
        """Feed, ask, listen and obey once; at most until the next `?` is due."""
        idle = self._watch.idle(driver, self._phases.changed_s)
        self._watch.check(driver, self._feeder, idle and self._phases.feeding)
        if self._phases.feeding and self._feeder.feed(driver, idle):
            self._watch.heard_s = self._clock()
        for report in driver.receive(self._watch.poll(driver, quick=self._phases.name != "running")):
            self._take(driver, report)
        self._obey(driver)

    def _take(self, driver: Grbl, report: Received) -> None:
        if isinstance(report, Answered):
            self._watch.heard_s = self._clock()
            if report.error:
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
        finished = self._phases.name == "finishing" and self._watch.idle(driver, self._phases.changed_s)
        self._idle_reports = self._idle_reports + 1 if finished else 0

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

    # --- asked from outside --------------------------------------------------------------------

    def _ask(self, command: str) -> None:
        self._commands.put(command)
        if self._link:
            self._link.wake()

    def _listen(self, received: list[Received]) -> None:
        """Count and tell what came; while connecting, obey a stop too."""
        for report in received:
            if isinstance(report, Answered):
                self._feeder.take(report)
                if message := self.job.messages.get(report.sent.index):
                    self._tell("message", message)
            elif isinstance(report, Feedback) and report.tag in ("MSG", "echo"):
                self._tell("message", report.text)
            elif isinstance(report, Unknown):
                self._tell("warning", f"the controller said: {report.text}")
        if self._phases.name == "connecting":
            self._obey(None)

    def _obey(self, driver: Grbl | None) -> None:
        """Carry out what was asked; while connecting only a stop, all else waits for the first line."""
        while not self._commands.empty():
            command = self._commands.get()
            if command == "stop":
                raise _Stop
            if driver:
                self._phases.obey(command, driver)
            else:
                self._early.append(command)
