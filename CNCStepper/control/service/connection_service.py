# SPDX-License-Identifier: LGPL-2.1-or-later
"""The connection service: holds one controller's port, carries out commands, runs jobs over the open link.

    connecting --> idle <--> jogging, homing, alarm ...        (`IdleController`)
                    ^  `---> a job's phases ---'               (`JobRun`)
                    `-----> ended: link lost, left alone, told to end

An alarm is no refusal here: the service is there to home and to unlock. A job is refused in it.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext, suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

from CNCStepper.control.journal.writer import Journal
from CNCStepper.control.operator import homing
from CNCStepper.control.operator.hardware_buttons import Buttons, buttons_of
from CNCStepper.control.operator.zero_and_unlock import fresh_status
from CNCStepper.control.preflight.checks import check_counts_from_here
from CNCStepper.control.program.bundle import copy_private
from CNCStepper.control.program.certificate import sendable
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.protocol.grbl import connect
from CNCStepper.control.protocol.grbl.driver import Answered, Grbl, Received
from CNCStepper.control.protocol.grbl.motion_interlock import MotionInterlock
from CNCStepper.control.protocol.grbl.readiness import check_state
from CNCStepper.control.protocol.grbl.status_reports import Vector
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.control.service.idle_controller import IdleController, is_fatal
from CNCStepper.control.service.position_trust_file import PositionTrustFile
from CNCStepper.control.session.command import VALUES, Command, Inbox
from CNCStepper.control.session.job_phase import Phase
from CNCStepper.control.session.status import REFUSED, Outcome, SenderStatus
from CNCStepper.control.stream.job_run import MAY_HAVE_RESTARTED, JobRun, Refuse, Stopped, Tell
from CNCStepper.control.stream.pause_id import PauseCounter
from CNCStepper.control.stream.position_trust import (
    AT_HOME,
    LOST,
    PositionTrust,
    check_program,
    is_lost,
    trust_after_job,
    trust_at_lost_link,
)
from CNCStepper.control.stream.status_snapshot import forward_messages
from CNCStepper.control.transport.link import Link, Opener, open_unless, opener_of, restart_text
from CNCStepper.errors import CNCStepperError, JobError, MachineRefusal, Text
from CNCStepper.machine.controller_family import BAUD
from CNCStepper.state import WORK_SYSTEMS


class ConnectionService:
    """One connection; `run` blocks until it ends, `ask`, `stop` and `status` may be called from any thread.

    machine: the profile, by name or file, of a machine without a controller of its own. opener: None opens the port.
    tell, refuse, ended: callbacks for events, as of a `JobRun`, and a job's end. alone_s: how long nobody has
    been there; a service that is alone and has nothing to do ends. journals: the folder for those of its jobs; None
    keeps none. kept: what was held of the position before, and is from now on; None begins with nothing. during_job:
    entered for the time of each job. job_file: for a copy of the last job.
    """

    commands: tuple[str, ...] = tuple(VALUES)

    def __init__(
        self,
        port: str,
        baud: int = BAUD,
        *,
        machine: str = "",
        job_file: Path,
        opener: Opener | None = None,
        timing: Timing | None = None,
        clock: Callable[[], float] = time.monotonic,
        tell: Tell = lambda kind, text: None,
        refuse: Refuse = lambda command, error: None,
        ended: Callable[[Outcome], None] = lambda outcome: None,
        alone_s: Callable[[], float] = lambda: 0.0,
        journals: Path | None = None,
        kept: PositionTrustFile | None = None,
        during_job: Callable[[], AbstractContextManager[None]] = nullcontext,
    ):
        self.port = port
        self._baud = baud
        self._job_file = job_file
        self._opener = opener or opener_of(machine)
        self._timing = timing or Timing()
        self._tell = tell
        self._refuse = refuse
        self._ended = ended
        self._alone_s = alone_s
        self._journals = journals
        self._kept = kept or PositionTrustFile(None)
        self._during_job = during_job
        self._clock = clock
        self._inbox = Inbox(clock)
        self._buttons = Buttons(self._inbox.put, tell, clock, self._start)
        self._driver: Grbl | None = None
        self._idle: IdleController | None = None
        self._run: JobRun | None = None
        self._trust: PositionTrust | None = (
            None  # with which the job began: its own resets at standstill do not change it
        )
        self._is_sent = False  # the job, from a command line
        self._greeted = False  # as the port was opened
        self._last_done: SendJob | None = None  # what a start button lets run again
        self._stands = PauseCounter()
        self._connected = False
        self._learned = False
        self._zero_is_old = False
        self._zero: dict[str, Any] = {}  # work system and offsets, as `SenderStatus` has them
        self._ending = False
        self._may_stop = True  # until it comes to rest
        self._phase: str = Phase.CONNECTING  # last reported

    def ask(self, command: Command) -> None:
        """Ask for one of `commands`."""
        self._inbox.put(command)

    def stop(self) -> None:
        """End the service; a job or a motion is stopped safely first."""
        self._ending = True
        self._inbox.put(Command("end"))

    def status(self) -> SenderStatus:
        """Return the present status."""
        stand = self._stands.number  # before the words of that stand
        run, idle, trust = self._run, self._idle, self._trust
        if idle is None or not self._connected:
            return SenderStatus()
        if run is None or trust is None or (status := run.status()).phase == Phase.CONNECTING:
            return replace(idle.status(), stand=stand, **self._zero)
        return replace(status, position_known=trust.position_known, homed=trust.homed, **self._zero)

    def run(self) -> None:
        """Connect and serve until `stop` or until no client is left; raises LinkError when the link breaks."""
        link = open_unless(lambda: self._ending, self._opener, self.port, self._baud)
        if link is None:
            return
        self._inbox.link = link
        try:
            self._driver = driver = Grbl(link, self._clock, self._listen, MotionInterlock(self._is_lost))
            self._idle = IdleController(driver, self._timing, self._tell, self._refuse)
            self._connect(driver, self._idle, link)
            self._serve(driver, self._idle)
        except Stopped:  # while connecting: nothing was sent
            return
        finally:
            self._buttons.close()
            link.close()

    def _is_lost(self) -> bool:
        """Return whether the position is lost now; nothing may move a machine before its state was read."""
        if self._idle is None or not self._connected:
            return True
        return is_lost(self._trust if self._run and self._trust else self._idle.trust)

    # --- the loop ------------------------------------------------------------------------------

    def _connect(self, driver: Grbl, idle: IdleController, link: Link) -> None:
        self._greeted = greeted = connect.has_greeting(connect.wake_up(driver, self._timing, locked=True))
        if greeted:
            self._tell("warning", restart_text(link))
        self._learn(driver, idle)
        idle.meet(self._kept.trust, greeted)
        self._connected = True

    def _serve(self, driver: Grbl, idle: IdleController) -> None:
        """Be there until the end; a machine of which the link or this program loses sight has lost its position."""
        try:
            with suppress(Stopped):
                while not self._over(idle):
                    self._turn(driver, idle)
                    self._save_trust(idle)
            self._may_stop = False
            self._come_to_rest(driver, idle)
        except Exception:
            idle.trust = trust_at_lost_link()
            raise
        finally:
            self._save_trust(idle)

    def _turn(self, driver: Grbl, idle: IdleController) -> None:
        idle.turn()
        if not self._learned:
            self._learn(driver, idle)
        elif self._zero_is_old and idle.may_be_asked:
            self._read_zero(driver)
        for command in self._inbox.take():
            self._execute_command(command, idle)
        self._notify_phase(idle.phase)

    def _save_trust(self, idle: IdleController) -> None:
        """Save the position trust; homing that does not end loses the position."""
        self._kept.save_or_warn(LOST if idle.phase == "homing" else idle.trust, self._tell)

    def _learn(self, driver: Grbl, idle: IdleController) -> None:
        """Read the controller's settings once it is at rest; a moving one is not asked."""
        if idle.may_be_asked:
            found = connect.learn(driver, self._timing)
            self._take_zero(found.offsets, found.modes)
            self._learned = True

    def _read_zero(self, driver: Grbl) -> None:
        """Ask where the work zero is now; where that is refused it is not known."""
        try:
            self._take_zero(connect.read_offsets(driver, self._timing), connect.read_modes(driver, self._timing))
        except CNCStepperError as error:
            if is_fatal(error):
                raise
            self._zero, self._zero_is_old = {}, False

    def _take_zero(self, offsets: dict[str, Vector], modes: str) -> None:
        """Save the work zero; a new zero replaces it."""
        assert self._driver
        driver = self._driver
        self._zero = {
            "work_system": next((word for word in modes.split() if word in WORK_SYSTEMS), ""),
            "work_offsets_mm": {name: mm for name, offset in offsets.items() if (mm := driver.mm(offset)) is not None},
        }
        self._zero_is_old = False

    def _execute_command(self, command: Command, idle: IdleController) -> None:
        try:
            if command.name in ("run", "send"):
                self._run_file(idle, **command.values, is_sent=command.name == "send")
            elif command.name == "disconnect":
                idle.check_at_rest()
                self._ending = True
            elif command.name == "again" and self._last_done:
                self._tell("job", self._last_done.file)
                self._run_job(idle, self._last_done)
            elif command.name != "end":
                self._stands.enter(idle.phase)
                self._stands.check(command)
                idle.do(command)
                self._zero_is_old = self._zero_is_old or command.name in ("set_zero", "line")
        except CNCStepperError as error:
            if is_fatal(error):
                raise
            self._refuse(command, error)

    def _listen(self, received: list[Received]) -> None:
        said = [report for report in received if not isinstance(report, Answered)]
        forward_messages(said, self._tell)
        if self._idle:
            self._idle.on_message(received)
        self._buttons.on_message(said)
        if connect.has_greeting(said):
            self._zero_is_old = True  # a reset takes G92 and the tool's length away
        if self._run:
            self._run.count(received)  # last: a stop leaves from here
        is_stopping = self._driver is not None and self._driver.is_stopping
        if self._ending and self._may_stop and self._run is None and not is_stopping:
            raise Stopped

    def _notify_phase(self, phase: str) -> None:
        self._stands.enter(phase)
        if phase != self._phase:
            self._phase = phase
            self._tell("phase", phase)

    # --- a job ---------------------------------------------------------------------------------

    def _start(self) -> Command | None:
        """Return the job of a start button while nothing runs: the last job, if it was cut to its end."""
        may_run = self._last_done and self._run is None and self._idle and self._idle.phase == "idle"
        return Command("again") if may_run else None

    def _run_file(
        self,
        idle: IdleController,
        file: str,
        zero_confirmed: bool,
        allow_differences: bool,
        is_sent: bool,
        by_line: bool | None = None,
    ) -> None:
        """Run the job of a file and report its outcome.

        is_sent: from a command line. by_line: whether it waits before each line; None: as the job says.
        """
        self._tell("job", file)
        own = {"port": self.port, "baud": self._baud}
        consents = {"zero_confirmed": zero_confirmed, "allow_differences": allow_differences}
        consents |= {} if by_line is None else {"by_line": by_line}
        try:
            idle.check_at_rest()  # a copy takes its time, and nothing is read from the controller meanwhile
            job = self._copied(Path(file), own | consents)
        except CNCStepperError as error:
            known = idle.trust.position_known is not False
            self._ended(Outcome(REFUSED, error.text, known, replace(self.status(), phase=REFUSED), error))
            return
        self._run_job(idle, job, is_sent)

    def _copied(self, file: Path, instead: dict[str, Any]) -> SendJob:
        """Return the job of a file, with other values for some fields, from a copy that nobody else writes.

        It takes the place of the job before, unless it is refused.
        """
        draft = self._job_file.with_suffix(f".new{self._job_file.suffix}")
        try:
            draft.unlink(missing_ok=True)  # of a process that was killed
            copy_private(file, draft)
            sendable(draft, private=True)
            os.replace(draft, self._job_file)
        except CNCStepperError:
            raise
        except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError, MemoryError) as error:
            raise JobError(
                "send-job", Text("the job cannot be read: {error}", error=error), advice="make it again"
            ) from error
        finally:
            draft.unlink(missing_ok=True)
        return sendable(self._job_file, private=True, **instead)

    def _run_job(self, idle: IdleController, job: SendJob, is_sent: bool = False) -> None:
        self._trust, self._is_sent = idle.trust, is_sent
        self._run = run = JobRun(
            job,
            self._inbox,
            timing=self._timing,
            clock=self._clock,
            tell=self._tell,
            refuse=self._refuse,
            journal=Journal(self._journals) if self._journals else None,
            stands=self._stands,
        )
        try:
            with self._during_job():
                outcome = run.run(self._ready)
        finally:
            self._run, self._phase = None, ""
            self._zero_is_old = True  # a program may set it
        if not run.has_begun:  # nothing was sent: the machine's text came unrequested
            if outcome.error and outcome.error.code in MAY_HAVE_RESTARTED:
                idle.lose_position()
            outcome = replace(outcome, position_known=outcome.position_known and idle.trust.position_known is not False)
        else:
            idle.trust = trust_after_job(self._trust, outcome.position_known)
        self._last_done = job if outcome.done else None
        self._ended(outcome)

    def _ready(self) -> connect.ControllerInfo:
        """Return the machine's settings, read again: they may have changed since the connection."""
        assert self._driver and self._run and self._idle
        self._buttons.wire(buttons_of(self._run.job.inputs))
        self._run.driver = self._driver
        self._idle.check_no_jog()
        if self._is_sent and self._run.job.home_first:
            self._home_first(self._driver, self._idle)
        check_state(fresh_status(self._driver, self._timing), self._driver.cannot)
        restarted = self._is_sent and self._counts_restart(self._driver, self._idle.trust)
        check_program(self._trust if restarted and self._trust else self._idle.trust)
        found = connect.learn(self._driver, self._timing)
        self._take_zero(found.offsets, found.modes)
        self._kept.keep(LOST)  # until the job has ended well
        return replace(found, greeted=restarted)

    def _counts_restart(self, driver: Grbl, trust: PositionTrust) -> bool:
        """Return whether a restarted machine is trusted for this job: it is where its zero was confirmed."""
        if not is_lost(trust) or is_lost(trust, restart_counts=True):
            return False
        if self._greeted:
            check_counts_from_here(driver)
        self._trust = trust._replace(position_known=True, counts_from_here=False)
        return True

    def _home_first(self, driver: Grbl, idle: IdleController) -> None:
        """Let the machine find its own zero before the job; until it has, and where it does not, its place is lost."""
        before = idle.trust
        self._tell("message", "the machine finds its own zero")
        idle.trust = self._trust = LOST
        self._kept.keep(LOST)
        try:
            homing.home(driver, self._timing)
        except MachineRefusal as refusal:
            if not homing.has_begun(refusal):
                with suppress(CNCStepperError):  # the greeting of the reset after it costs nothing
                    connect.wake_up(driver, self._timing, locked=True)
                idle.trust = self._trust = before
            raise
        idle.trust = self._trust = AT_HOME

    # --- the end -------------------------------------------------------------------------------

    def _over(self, idle: IdleController) -> bool:
        return self._ending or (self._alone_s() > self._timing.alone_s and not idle.busy)

    def _come_to_rest(self, driver: Grbl, idle: IdleController) -> None:
        """Stop a jog, a homing or a typed line that is still under way; a job has ended already."""
        if idle.phase in (Phase.JOGGING, Phase.HOMING, Phase.BUSY):
            idle.stop()
        idle.turn()  # is the machine still there?
        end_s = self._clock() + self._timing.hold_s
        while idle.busy and self._clock() < end_s and (driver.question_age_s() or 0.0) < self._timing.silent_s:
            idle.turn()
