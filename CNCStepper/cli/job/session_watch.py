# SPDX-License-Identifier: LGPL-2.1-or-later
"""A terminal watching a session: progress, pauses, and Ctrl-C."""

from __future__ import annotations

import signal
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from rich.console import Console, ConsoleOptions, RenderableType, RenderResult
from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeElapsedColumn
from rich.text import Text as StyledText

from CNCStepper.cli.common.keep_open import tell_kept
from CNCStepper.cli.common.language import translated
from CNCStepper.cli.job.pause_prompt import PausePrompt, why
from CNCStepper.cli.job.status_text import live
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.service.service_job import ServiceJob, start_job
from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.job_phase import LEG_BEGINS, WAITING, Phase
from CNCStepper.control.session.status import Outcome, SenderStatus
from CNCStepper.errors import Text

if TYPE_CHECKING:
    from CNCStepper.recovery.retract.retract_client import ButtonClient

LOOK_EVERY_S = 0.05
UNANSWERED = -1  # the number of no stand


def watch(job: SendJob, resume_pauses: bool, keep_min: float = 0.0) -> Outcome:
    """Start `job`, show its progress, answer its pauses, and return how it ended.

    It runs in the connection that is open at its port, or in one that stays open for `keep_min`; where that is 0, in a
    sender's process of its own.
    """
    has_start = any(entry["act"] == "start" for entry in job.inputs)
    with start_job(job, 60.0 * keep_min) as client:
        with Moving() as progress:
            outcome = _Watch(client, progress, resume_pauses, has_start).run()
        if isinstance(client, ServiceJob) and client.is_open:
            tell_kept(job.port, keep_min)
        return outcome


class Moving(Progress):
    """The progress of one job: phase, bar and time, and below them the line of `live`."""

    def __init__(self, console: Console | None = None) -> None:
        console = console or Console(stderr=True)
        self._status = SenderStatus()
        phase = TextColumn("{task.description:<10}")
        super().__init__(phase, BarColumn(), TaskProgressColumn(), TimeElapsedColumn(), console=console)
        self._job = self.add_task("connecting", total=None)

    def show(self, status: SenderStatus) -> None:
        """Show a status of the job."""
        self._status = status
        done = status.done * status.total
        self.update(self._job, description=status.phase, completed=done, total=status.total or None)

    def get_renderables(self) -> Iterable[RenderableType]:
        """Yield the bar, and what moves."""
        yield self.make_tasks_table(self.tasks)
        yield _Live(self._status)


class _Live:
    """The text of `live` for a status, in lines of the terminal's width."""

    def __init__(self, status: SenderStatus):
        self._status = status

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        if words := live(self._status, options.max_width):
            yield StyledText(words)


class _Watch:
    def __init__(self, client: SessionClient | ServiceJob, progress: Moving, resume_pauses: bool, has_start: bool):
        self._client = client
        self._progress = progress
        self._resume_pauses = resume_pauses
        self._has_start = has_start  # a button at the machine, so that nobody need answer here
        self._pause_prompt = PausePrompt(client, self._print, self._tell)
        self._answered = UNANSWERED  # the stand that has had its answer
        self._phase = ""
        self._leader: ButtonClient | None = None  # from the first stand on

    def run(self) -> Outcome:
        """Return the outcome; Ctrl-C holds the machine, a request to end this process stops it safely."""
        signal.signal(signal.SIGTERM, lambda *_: self._client.stop())
        while self._client.outcome is None:
            try:
                self._look()
            except KeyboardInterrupt:
                self._interrupted()
        return self._client.wait(self._progress.show)

    def _look(self) -> None:
        for event in self._client.poll(LOOK_EVERY_S):
            if event["event"] == "status":
                status = SenderStatus.from_json(event["status"])
                self._phase = status.phase
                self._progress.show(status)
                self._stand(status)
            else:
                self._print(event)

    def _interrupted(self) -> None:
        """Hold, as whoever interrupts can answer; stop a job that is paused already where nobody can be asked."""
        if self._phase in WAITING and not self._pause_prompt.is_there:
            self._client.stop()
            return
        self._has_start, self._answered = False, UNANSWERED
        self._client.hold()

    def _print(self, event: dict[str, Any]) -> None:
        if event["event"] in ("message", "warning", "refused"):
            self._tell(event["text"])
        if event["event"] in ("warning", "refused"):  # perhaps what was answered
            self._answered = UNANSWERED

    def _tell(self, text: str) -> None:
        self._progress.console.print(translated(text), markup=False)

    def _stand(self, status: SenderStatus) -> None:
        """Ask once for each pause what to do."""
        if status.phase in LEG_BEGINS:
            self._follow_buttons()
        if status.phase not in WAITING or status.stand <= self._answered:
            return
        self._answered = status.stand
        if status.phase == Phase.PAUSED and self._resume_pauses:
            self._tell(Text("pause: {message}; going on", message=status.message or "M0"))
            self._client.resume(status.stand)
        elif self._has_start:
            self._tell(Text("{why}. Its start button goes on, Ctrl-C asks here", why=why(status)))
        else:
            self._ask(status)

    def _follow_buttons(self) -> None:
        """Do from now on what the machine's own buttons want of the way along the cut, also while a person is asked."""
        if self._leader is None:
            from CNCStepper.recovery.retract.retract_client import ButtonClient

            self._leader = ButtonClient(self._client.session_file, self._tell)
            self._leader.start()

    def _ask(self, status: SenderStatus) -> None:
        """Prompt, with the progress line removed."""
        self._progress.stop()
        try:
            self._answered = self._pause_prompt.ask(status)
        finally:
            self._progress.start()
