# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sender of one job: opens the port, meets the controller, lets the job run, closes the port."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace

from CNCStepper.control.operator.hardware_buttons import Buttons, buttons_of
from CNCStepper.control.operator.homing import has_begun, home
from CNCStepper.control.preflight.checks import check_counts_from_here
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.protocol.grbl import connect
from CNCStepper.control.protocol.grbl.driver import Answered, Grbl, Received
from CNCStepper.control.protocol.grbl.motion_interlock import MotionInterlock
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.control.service.position_trust_file import PositionTrustFile
from CNCStepper.control.session.command import JOB_COMMANDS, Command, Inbox
from CNCStepper.control.session.status import REFUSED, Outcome, SenderStatus
from CNCStepper.control.stream.job_run import JobRun, Refuse, Stopped, Tell
from CNCStepper.control.stream.journal_protocol import Journals
from CNCStepper.control.stream.position_trust import (
    AT_HOME,
    LOST,
    check_program,
    is_lost,
    trust_after_job,
    trust_at_connect,
)
from CNCStepper.control.stream.status_snapshot import forward_messages
from CNCStepper.control.transport.link import Opener, open_unless, opener_of, restart_text
from CNCStepper.errors import MachineRefusal


class Sender:
    """Sends one job over a link of its own; `run` blocks, all else may be called from any thread.

    tell(kind, text): hears what happens, on the sender's thread, and must not block; kinds are
    "phase", "message" (the controller's or the program's words) and "warning". refuse(command, error): hears, as
    quietly, what cannot be obeyed now. opener: None opens the job's port. journal: None keeps none. kept: what was held
    of the position before, and is afterwards; None begins with nothing.
    """

    commands: tuple[str, ...] = JOB_COMMANDS

    def __init__(
        self,
        job: SendJob,
        *,
        opener: Opener | None = None,
        timing: Timing | None = None,
        clock: Callable[[], float] = time.monotonic,
        tell: Tell = lambda kind, text: None,
        refuse: Refuse = lambda command, error: None,
        journal: Journals | None = None,
        kept: PositionTrustFile | None = None,
    ):
        self.job = job
        self._opener = opener or opener_of(job.profile)
        self._timing = timing or Timing()
        self._clock = clock
        self._tell = tell
        self._inbox = Inbox(clock)
        self._kept = kept or PositionTrustFile(None)
        self._trust = self._kept.trust
        self._greeted = False  # while connecting
        self._early: list[Command] = []  # asked while connecting
        self._connecting = True
        self._buttons = Buttons(self._inbox.put, tell, clock)
        self._run = JobRun(
            job, self._inbox, timing=self._timing, clock=clock, tell=tell, refuse=refuse, journal=journal
        )

    def hold(self) -> None:
        """Request a feed hold: the machine decelerates to rest, nothing is lost."""
        self.ask(Command("hold"))

    def resume(self) -> None:
        """Request to resume after a hold, a pause of the program or a closed door."""
        self.ask(Command("resume"))

    def stop(self) -> None:
        """Ask to end the job: hold, standstill, soft reset; spindle and outputs off, position kept."""
        self.ask(Command("stop"))

    def ask(self, command: Command) -> None:
        """Ask for one of `commands`."""
        self._inbox.put(command)

    def status(self) -> SenderStatus:
        """Return the present status."""
        return self._run.status()

    def run(self) -> Outcome:
        """Send the job and return how it ended; refusals and failures are in the outcome, not raised."""
        try:
            outcome = self._run.run(self._connected)
            self._save_trust(outcome)
            return outcome
        finally:
            self._buttons.close()
            if self._inbox.link:
                self._inbox.link.close()

    def _connected(self) -> connect.ControllerInfo:
        link = open_unless(lambda: self._inbox.wants_stop, self._opener, self.job.port, self.job.baud)
        if link is None:
            raise Stopped
        self._inbox.link = link
        self._run.driver = driver = Grbl(link, self._clock, self._listen, MotionInterlock(self._is_lost))
        found = self._homed(driver) if self.job.home_first else connect.handshake(driver, self._timing)
        self._trust = trust_at_connect(self._trust, driver, self._greeted)
        if self._greeted:
            self._tell("warning", restart_text(link))
            check_counts_from_here(driver)
        check_program(self._trust, restart_counts=True)
        self._kept.keep(LOST)  # until the job has ended well
        self._buttons.wire(buttons_of(self.job.inputs))
        self._connecting = False
        for command in self._early:
            self._inbox.put(command)
        return replace(found, greeted=self._trust.position_known is False)

    def _is_lost(self) -> bool:
        """Return whether the position is lost; nothing may move a machine before its state was read."""
        return self._connecting or is_lost(self._trust, restart_counts=True)

    def _homed(self, driver: Grbl) -> connect.ControllerInfo:
        connect.wake_up(driver, self._timing, locked=True)
        before = trust_at_connect(self._trust, driver, self._greeted)
        self._tell("message", "the machine finds its own zero")
        self._trust = LOST  # until it is there
        self._kept.keep(LOST)
        try:
            home(driver, self._timing)
        except MachineRefusal as refusal:
            if not has_begun(refusal):
                self._trust = before
            raise
        self._trust, self._greeted = AT_HOME, False
        return connect.handshake(driver, self._timing)

    def _save_trust(self, outcome: Outcome) -> None:
        """Save the position trust; a job that did not begin may have seen an alarm or a restart."""
        trust = self._trust
        if self._connecting and self._run.driver:
            trust = trust_at_connect(trust, self._run.driver, self._greeted)
        elif outcome.kind != REFUSED:
            trust = trust_after_job(trust, outcome.position_known)
        self._kept.save_or_warn(trust, self._tell)

    def _listen(self, received: list[Received]) -> None:
        """Tell and count what came; a stop is done at once, while connecting all else waits for the first line."""
        if said := [report for report in received if not isinstance(report, Answered)]:
            self._buttons.on_message(said)
            forward_messages(said, self._tell)
        if self._connecting:
            self._greeted = self._greeted or connect.has_greeting(said)
        self._run.count(received)
        if self._connecting:
            for command in self._inbox.take():
                self._early.append(command)
