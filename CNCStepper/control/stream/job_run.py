# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs one job over an open connection; it ends only when the machine is at rest and the reason is known.

    connecting --> running <--> holding --> held          `!` and `~`, asked for here or at the machine
        |             |  `--------- leg ----> retreated   back along the cut and forward again (`retract_handover.py`)
        |             |  `--> paused (M0, or line by line: `program_pause.py`), door
        |             v
        |          finishing (all acknowledged) --> done (Idle, reported twice)
        `-> refused   `-> stopping --> stopped, failed    hold, Hold:0, soft reset

Who owns the link, a `Sender` for one job or a `ConnectionService` that stays, brings it; one thread does it all: it
reads, executes commands, feeds lines and polls with `?`.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

from CNCStepper.control.operator.hardware_buttons import quicker
from CNCStepper.control.preflight.checks import check_found, try_rate
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.protocol.grbl import connect
from CNCStepper.control.protocol.grbl.capabilities import check_can
from CNCStepper.control.protocol.grbl.driver import Answered, Grbl, Received
from CNCStepper.control.protocol.grbl.motion_interlock import UNKNOWN
from CNCStepper.control.protocol.grbl.readiness import check_zero
from CNCStepper.control.protocol.grbl.status_poller import ANSWER_MISSING, StatusPoller
from CNCStepper.control.protocol.grbl.status_reports import Alarm, Feedback, Greeting, Status
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.control.session.command import STOPS, Command, Inbox
from CNCStepper.control.session.job_phase import LEG_BEGINS, Phase
from CNCStepper.control.session.status import DONE, FAILED, REFUSED, STOPPED, Outcome, SenderStatus
from CNCStepper.control.stream import stop_sequence
from CNCStepper.control.stream.backlash_side import BacklashTracker, backlash_tracker
from CNCStepper.control.stream.executed_lines import MadeLines
from CNCStepper.control.stream.feed_hold_and_resume import Phases, check_no_tool_change
from CNCStepper.control.stream.feeder import Feeder
from CNCStepper.control.stream.journal_protocol import ActiveJournal, Journals, LegJournal, NoJournal, check_not_held
from CNCStepper.control.stream.overrides import NORMAL, override_byte, restore
from CNCStepper.control.stream.path_comparison import PathWatch
from CNCStepper.control.stream.pause_id import PauseCounter
from CNCStepper.control.stream.pending_requests import PendingRequests
from CNCStepper.control.stream.position_trust import counts_steps
from CNCStepper.control.stream.program_pause import Pause
from CNCStepper.control.stream.remaining_time import Remaining
from CNCStepper.control.stream.retract_handover import LAST, PathRetract, check_place, reset_at_rest
from CNCStepper.control.stream.status_snapshot import status_snapshot
from CNCStepper.control.stream.tool_power import power_of
from CNCStepper.errors import CNCStepperError, LinkError, MachineRefusal, Text

MAY_HAVE_RESTARTED = (connect.RESTARTED, ANSWER_MISSING)  # errors; behind a restart the place is another one
IDLE_REPORTS = 2  # one alone may come between the last answer and the start of its motion
KEPT = (
    "the machine is at rest, spindle and outputs are off, its position is kept (the reset cleared G92 and tool length)"
)
LOST = "the machine's position is unknown: look that spindle and outputs are off, then home it or set its zero again"

Tell = Callable[[str, str], None]
Refuse = Callable[[Command, CNCStepperError], None]


class Stopped(Exception):
    """Somebody asked to stop."""


class JobRun:
    """Runs one job; `run` blocks, `status` may be called from any thread.

    tell(kind, text): hears what happens and must not block; kinds are "phase", "message" (the
    program's words) and "warning". refuse(command, error): hears what cannot be obeyed now. journal: permits each
    line before it is sent. stands: those of the connection, where it has had some before.
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
        journal: Journals | None = None,
        stands: PauseCounter | None = None,
    ):
        self.job = job
        self.driver: Grbl | None = None  # before it is connected
        self._inbox = inbox
        self._timing = quicker(timing, job.inputs)
        self._clock = clock
        self._tell = tell
        self._refuse = refuse
        self._new_journal = journal or NoJournal()
        self._journal: ActiveJournal = self._new_journal
        self._feeder, self._made = Feeder(job, self._journal), MadeLines()
        self._remaining = Remaining(job.plan)
        self._pause_counter = stands or PauseCounter()
        self._phases = Phases(tell, self._pause_counter)
        self._watch = StatusPoller(self._timing)
        self._stand = Pause(self._timing, tell, refuse)
        self._path_retract = PathRetract(job)
        self._requests = PendingRequests(clock, refuse)
        self._by_line = job.by_line
        self._just_said = ""  # the controller's message, where nothing else has come since
        self._path: PathWatch | None = None  # before the first line
        self._gaps: BacklashTracker | None = None  # without backlash compensation
        self._begin_s = clock()
        self._idle_reports = 0
        self._done = 0  # lines that are surely cut
        self._trouble: list[Received] = []  # the alarm or greeting that ended the job
        self._may_stop = True  # until the machine is brought to rest
        self._cannot_stop: MachineRefusal | None = None  # why what was sent runs on

    def status(self) -> SenderStatus:
        """Return the present status."""
        stand = self._pause_counter.number  # before the words of that stand
        before, feeder = self._path_retract.lines_before, self._feeder  # a leg brings another, of lines of its own
        return replace(
            status_snapshot(self.driver, self._phases.name, self._phases.message),
            sent=max(0, before + feeder.sent),
            acknowledged=max(0, before + feeder.acknowledged),
            total=before + feeder.total,
            file=feeder.job.file,
            file_line=feeder.job.known_line(min(self._done, feeder.acknowledged)),
            file_line_sent=feeder.job.known_line(feeder.sent),
            elapsed_s=self._clock() - self._begin_s,
            remaining_s=self._remaining.remaining_s,
            done=self._remaining.done,
            stand=stand,
            wanted_back_mm=self._requests.back_mm,
            wanted_rest=self._requests.rest,
        )

    @property
    def has_begun(self) -> bool:
        """Whether lines may have been sent; then the run itself resets the controller."""
        return self._path is not None

    def count(self, received: list[Received]) -> None:
        """Hear what came, also while the machine is brought to rest: count the answers to the job's lines."""
        self._journal.on_message(received)
        for report in received:
            self._made.take(report, self._feeder.acknowledged)
            if isinstance(report, Answered):
                self._feeder.take(report)
                if message := self.job.messages.get(report.sent.index):
                    self._tell("message", message)
            elif isinstance(report, Greeting) and self._phases.stands:
                self._trouble.append(report)  # also one that comes while a zero is set
            elif isinstance(report, Status) and self._path and not self._stand.is_off_path:
                self._path.take(report, self._feeder.acknowledged, self._feeder.sent)
        self._journal.note_made(self._made.lines)
        if self._may_stop and self._inbox.wants_stop:
            self._stop_now(received)

    def _stop_now(self, received: list[Received]) -> None:
        """Leave whatever is waited for: a stop is asked for."""
        self._may_stop = False
        self._trouble += (report for report in received if isinstance(report, (Alarm, Greeting)))
        for command in self._inbox.take():  # what was asked for before it does not count any more
            if command.name in STOPS:
                self._refuse_stop(command)
                break
        raise Stopped

    def _refuse_stop(self, command: Command) -> None:
        """Say where what was sent runs on all the same; nothing more is sent."""
        if self.driver and self.has_begun and (refusal := self._refusal("stop")):
            self._cannot_stop = refusal
            self._refuse(command, refusal)

    def run(self, connected: Callable[[], connect.ControllerInfo]) -> Outcome:
        """Send the job and return how it ended; refusals and failures are in the outcome, not raised.

        connected: sets `driver` to that of an idle machine and returns what it found; called once the job
        itself is found good. It may raise `Stopped` or any error of ours.
        """
        outcome = self._begun(connected) or self._streamed()
        self._may_stop = False
        if self._path and (left_line := self._path.left_line) is not None:
            self._journal.mark_uncertain(left_line)
        self._warn(self._journal.end(outcome))
        self._phases.set(outcome.kind)
        return outcome

    # --- before the first line -----------------------------------------------------------------

    def _begun(self, connected: Callable[[], connect.ControllerInfo]) -> Outcome | None:
        found: connect.ControllerInfo | None = None
        try:
            check_zero(self.job.zero_confirmed)
            self.job.check()
            self._gaps = backlash_tracker(self.job)
            found = connected()
            assert self.driver
            check_found(self.job, self.driver, found, self._tell)
            try_rate(self.job, self.driver, self._timing)
            self._new_journal.begin(self.job, self.driver, found)
            self._path_retract.begin(self.driver, found)
            self._feeder.power = power_of(self.job, self.driver, found.modes)
            self._path = PathWatch(self.job, self.driver, found, self._tell, self._gaps)
            self._made = MadeLines()  # behind the greeting of a controller that was just opened
        except Stopped:
            known = not self._trouble and (not self.job.home_first or found is not None)
            return self._outcome(STOPPED, "stopped before the first line was sent", known)
        except CNCStepperError as error:
            known = self._stands(found) and error.code not in (UNKNOWN, *MAY_HAVE_RESTARTED)
            return self._outcome(REFUSED, error.text, known, error)
        self._phases.set("running")
        return None

    def _stands(self, found: connect.ControllerInfo | None) -> bool:
        """Return whether the machine was seen where it can be trusted; one that homes first only once it was found."""
        return counts_steps(self.driver) and (found is not None or not self.job.home_first)

    # --- streaming -----------------------------------------------------------------------------

    def _streamed(self) -> Outcome:
        assert self.driver and self._path
        try:
            self._execute_command(self.driver)  # what was asked while connecting, before the first line
            while self._idle_reports < IDLE_REPORTS:
                self._turn(self.driver)
                self._path.check()
            self._path.check_end(self._feeder.sent)
        except Stopped:
            return self._halted(self.driver, None)
        except CNCStepperError as error:
            return self._halted(self.driver, error)
        except BaseException:  # after any error here, the machine must not keep moving alone
            self._rest(self.driver)
            raise
        return self._outcome(
            DONE, Text("all {total} lines are cut, the machine is idle", total=self.status().total), True
        )

    def _turn(self, driver: Grbl) -> None:
        """Feed, poll, read and execute commands once; at most until the next `?` is due."""
        for report in self._trouble:
            if isinstance(report, Greeting):
                raise connect.restart_refusal(report)
        idle = self._watch.idle(driver, self._phases.changed_s)
        dwell_s = self._feeder.dwell_s(driver) if idle else 0.0
        self._watch.check(driver, idle and self._phases.feeding, dwell_s, self._feeder.place_at_work)
        self._keep_journal(driver, idle)
        if self._phases.feeding and self._feeder.feed(driver, idle):
            self._watch.last_line_s = self._clock()
            if self._path:
                self._path.read_on(self._feeder.sent)
        every_s = self._timing.poll_s if self._phases.name == "running" else self._timing.quick_poll_s
        received = driver.receive(min(self._watch.poll(driver, every_s), self._stand.turn()))
        self._trouble += (report for report in received if isinstance(report, (Alarm, Greeting)))
        for report in received:
            self._take(driver, report)
        self._feeder.power.hold(driver)
        self._execute_command(driver)
        self._requests.turn(self._phases.name in LEG_BEGINS)
        if self._phases.stands and self._stand.is_left(driver):
            self._leave_pause(driver)

    def _leave_pause(self, driver: Grbl) -> None:
        if self._path and self._stand.is_off_path:
            found = connect.look_again(driver, self._timing)
            self._path.restart_from_here(found, self._feeder.sent)
            self._journal.note_zero(found, self._feeder.sent)
        self._stand.end()
        self._feeder.leave_pause()
        self._phases.set("running")

    def _keep_journal(self, driver: Grbl, idle: bool) -> None:
        """Write due records; a job whose next lines cannot be put on the disk is held."""
        self._warn(self._journal.keep(self._feeder.sent, self._feeder.acknowledged, idle and not driver.unanswered))
        if self._journal.holds(self._feeder.sent) and self._phases.feeding:
            self._phases.hold_or_resume("hold", driver)

    def _warn(self, texts: list[str]) -> None:
        for text in texts:
            self._tell("warning", text)

    def _take(self, driver: Grbl, report: Received) -> None:
        if isinstance(report, Answered):
            self._watch.last_line_s = self._clock()
            if report.sent.index < 0:
                self._stand.answered(report)
            elif report.error:
                raise self._feeder.refusal(report, driver.firmware)
        elif isinstance(report, Alarm):
            raise connect.alarm_refusal(report, driver.firmware, self._just_said)
        elif isinstance(report, Greeting):
            raise connect.restart_refusal(report)
        self._just_said = report.text if isinstance(report, Feedback) and report.tag == "MSG" else ""
        if isinstance(report, Status):
            if not self._stand.is_off_path:
                self._path_retract.note(driver, self._feeder, self._phases.name)
            self._follow_state(driver)
            self._count_idle(driver)
            self._note_progress()

    def _note_progress(self) -> None:
        """Learn how many lines are cut and how long the others take; all acknowledged ones are where the job rests."""
        assert self._path
        rests = self._idle_reports >= IDLE_REPORTS or self._phases.name in (Phase.PAUSED, Phase.RETREATED)
        acknowledged, elapsed_s = self._feeder.acknowledged, self._clock() - self._begin_s
        self._done = acknowledged if rests else max(self._done, self._path.done(acknowledged), self._made.lines)
        line, total = self.job.known_line(self._done), self._feeder.total
        self._remaining.take(self._phases.name, elapsed_s, line, self._done, total)

    def _follow_state(self, driver: Grbl) -> None:
        stood = self._phases.stands
        self._phases.take(driver, self._feeder)
        if self._phases.stands and not stood:  # at a change of tools
            self._stand.begin(driver, self._feeder.sent, self._gaps)

    def _count_idle(self, driver: Grbl) -> None:
        if self._feeder.complete and self._phases.feeding:
            if self._path_retract.leads_to_pause:
                self._feeder.power.stand(driver)
            self._phases.set(Phase.FINISHING)
        message = self._feeder.pause_text(driver) if self._phases.name == "running" else None
        awaited = self._phases.name == Phase.FINISHING or message is not None
        finished = awaited and not driver.unanswered and self._watch.idle(driver, self._phases.changed_s)
        self._idle_reports = self._idle_reports + 1 if finished else 0
        if self._idle_reports < IDLE_REPORTS:
            return
        if message is not None:
            self._idle_reports = 0
            self._stand.begin(driver, self._feeder.sent, self._gaps)
            self._phases.stand(message)
        elif self._path_retract.ends_leg():
            self._idle_reports = 0
            self._stand_back(driver)

    def _execute_command(self, driver: Grbl) -> None:
        for command in self._inbox.take():
            if command.name in STOPS:
                self._refuse_stop(command)
                raise Stopped
            try:
                self._do(command, driver)
            except CNCStepperError as error:
                if isinstance(error, LinkError):
                    raise
                self._refuse(command, error)

    def _do(self, command: Command, driver: Grbl) -> None:
        self._pause_counter.check(command)
        if not self._phases.stands:
            check_can(command.name, driver.cannot)
        if command.name in ("tell_place", "retrace"):
            self._go_back(driver, command)
        elif command.name == "want_back":
            self._phases.hold_or_resume("hold", driver)
            self._requests.request_retract(command)
        elif command.name == "resume" and (self._phases.name == Phase.RETREATED or self._feeder.power.is_stopped):
            self._requests.request_resume(command)
        elif command.name == "by_line":
            self._by_line = self._feeder.by_line = command.values["on"]
        elif self._phases.stands and command.name in self._stand.commands:
            self._stand.do(command)
            if command.name == "set_zero":
                self._journal.note_zero(connect.look_again(driver, self._timing), self._feeder.sent)
        elif command.name in ("hold", "resume"):
            self._requests.take()
            if command.name == "resume":
                check_not_held(self._journal, self._feeder.sent)
            self._phases.hold_or_resume(command.name, driver)
        elif command.name == "override":
            driver.realtime(override_byte(**command.values))
        elif command.name != "jog_cancel":  # a released button has no command here
            self._phases.check_no_jog(command.name, driver)
            raise MachineRefusal("job-runs", "a job runs", advice="wait until it has ended, or stop it")

    def _go_back(self, driver: Grbl, command: Command) -> None:
        """Report the machine's place on its path to a client, or run the leg that the client has made."""
        self._requests.take()
        check_no_tool_change(driver)
        self._stand.check_way_back()
        file = Path(command.values["file"])
        if command.name == "retrace":
            self._go_along(driver, file)
        else:
            self._path_retract.tell(driver, self._phases.name, file, self._stand.is_off_path)
            self._tell("place", str(file))

    def _go_along(self, driver: Grbl, file: Path) -> None:
        """Run a leg at a machine at rest; a refusal after its reset leaves it there, spindle off."""
        leg = self._path_retract.read(file, self._phases.name)
        leg.job.check()
        self._phases.stands = False  # the greeting that comes now was asked for
        overrides = driver.overrides or NORMAL
        found = reset_at_rest(driver, self._timing)
        self._stand_back(driver)
        check_found(leg.job, driver, found, self._tell)
        check_place(driver, leg)
        restore(driver, overrides, self._timing)
        self._stand.end()
        self._path_retract.start(leg)
        if self._gaps:
            self._gaps.begin(leg.ahead_mm)
        self._path = PathWatch(leg.job, driver, found, self._tell, self._gaps)
        rest = self._path_retract.lines_before if leg.is_rest else None
        self._journal = LegJournal.from_now(self._journal, self._feeder.sent, self._feeder.acknowledged, rest)
        self.job, self._feeder, self._idle_reports, self._done = leg.job, Feeder(leg.job, self._journal), 0, 0
        self._made = MadeLines()
        self._feeder.by_line = self._by_line and leg.is_rest
        self._feeder.power = power_of(self._path_retract.program, driver, found.modes)
        self._phases.restart_with()

    def _stand_back(self, driver: Grbl) -> None:
        """Wait for the next leg: the machine is idle, so that it can be jogged."""
        self._phases.set(Phase.RETREATED, LAST)
        self._stand.begin(driver, self._feeder.sent, leads_on=False)
        self._phases.stands = True

    # --- the end -------------------------------------------------------------------------------

    def _halted(self, driver: Grbl, error: CNCStepperError | None) -> Outcome:
        """Bring the machine to rest and report the reason and the state."""
        restarted = self._may_have_restarted(error)  # before the reset, which clears the evidence
        at_rest, broken = self._rest(driver)
        known = at_rest and not restarted and not (self._path and self._path.restarted)
        error = error or broken or (self._path.excursion if self._path else None)
        why = (
            error.text
            if error
            else Text("stopped as asked after {acknowledged} lines", acknowledged=self.status().acknowledged)
        )
        left_s = driver.status.left_s if driver.status else None
        runs_on = self._cannot_stop or (self._refusal("stop") if left_s else None)
        state = runs_on or (KEPT if known else LOST)
        if left_s:
            state = Text("{state}; it runs on for {left_s:.0f} s", state=state, left_s=left_s)
        return self._outcome(
            FAILED if error else STOPPED,
            Text("{why}. Now {state}", why=why, state=state),
            known and not runs_on,
            error,
        )

    def _refusal(self, what: str) -> MachineRefusal | None:
        """Return why the machine cannot do something, None where it can."""
        try:
            check_can(what, self.driver.cannot if self.driver else ())
        except MachineRefusal as refusal:
            return refusal
        return None

    def _may_have_restarted(self, error: CNCStepperError | None) -> bool:
        """Return whether an answer is missing, perhaps since the controller restarted unheard."""
        missing = error is not None and error.code == ANSWER_MISSING
        return missing and self._path is not None and self._path.may_have_restarted(self._feeder.sent)

    def _rest(self, driver: Grbl) -> tuple[bool, LinkError | None]:
        """Return whether the position is kept, and the error when the link broke meanwhile."""
        self._may_stop = False
        self._phases.set("stopping")
        try:
            if self._trouble:
                return stop_sequence.reset(driver, self._timing, self._trouble), None
            return stop_sequence.hold_and_reset(driver, self._timing), None
        except LinkError as broken:
            with suppress(LinkError):  # a last try to switch the outputs off, if the link still works
                driver.reset()
            return False, broken

    def _outcome(self, kind: str, text: str, known: bool, error: CNCStepperError | None = None) -> Outcome:
        return Outcome(kind, text, known, replace(self.status(), phase=kind), error)
