# SPDX-License-Identifier: LGPL-2.1-or-later
"""A person at a terminal watching a session: progress, pauses, and Ctrl-C."""

from __future__ import annotations

import signal
import time
from typing import TYPE_CHECKING, Any

import click
from rich.console import Console
from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeElapsedColumn

from CNCStepper.cli.live import live
from CNCStepper.cli.pause_words import STOP, Answer, is_end
from CNCStepper.control.outcome import Outcome, SenderStatus
from CNCStepper.control.retrace import STANDS
from CNCStepper.control.send_job import SendJob
from CNCStepper.control.session import SessionClient

if TYPE_CHECKING:
    from CNCStepper.job.leader import Leader

LOOK_EVERY_S = 0.05
TOUCHED_S = 0.5  # until a jog or a new zero shows at the latest
_BACK = "; `cncstepper back` goes back"  # from any stand but an open door


def watch(job: SendJob, resume_pauses: bool) -> Outcome:
    """Start the sender's process for `job`, show its progress, answer its pauses, and return how it ended."""
    columns = (TextColumn("{task.description:<10}"), BarColumn(), TaskProgressColumn(), TimeElapsedColumn())
    with (
        SessionClient.start(job) as client,
        Progress(*columns, TextColumn("{task.fields[place]}"), console=Console(stderr=True)) as progress,
    ):
        has_start = any(entry["act"] == "start" for entry in job.inputs)
        return _Watch(client, progress, resume_pauses, has_start).run()


class _Watch:
    def __init__(self, client: SessionClient, progress: Progress, resume_pauses: bool, has_start: bool):
        self._client = client
        self._progress = progress
        self._resume_pauses = resume_pauses
        self._has_start = has_start  # a button at the machine, so that nobody need answer here
        self._bar = progress.add_task("connecting", total=None, place="")
        self._answered = ("", -1)  # the stand that has had its answer: its phase and place
        self._leader: Leader | None = None  # from the first stand on

    def run(self) -> Outcome:
        """Return the outcome; Ctrl-C holds the machine, a request to end this process stops it safely."""
        signal.signal(signal.SIGTERM, lambda *_: self._client.stop())
        while self._client.outcome is None:
            try:
                self._look()
            except KeyboardInterrupt:
                self._has_start, self._answered = False, ("", -1)  # whoever interrupts is here to answer
                self._client.hold()
        return self._client.wait(self._show)

    def _look(self) -> None:
        for event in self._client.poll(LOOK_EVERY_S):
            if event["event"] == "status":
                status = SenderStatus.from_json(event["status"])
                self._show(status)
                self._stand(status)
            else:
                self._print(event)

    def _print(self, event: dict[str, Any]) -> None:
        if event["event"] in ("message", "warning", "refused"):
            self._progress.console.print(event["text"], markup=False)
        if event["event"] in ("warning", "refused"):  # perhaps what was answered
            self._answered = ("", -1)

    def _show(self, status: SenderStatus) -> None:
        self._progress.update(
            self._bar,
            description=status.phase,
            completed=status.done * status.total,
            total=status.total or None,
            place=live(status),
        )

    def _stand(self, status: SenderStatus) -> None:
        """Ask once for each stand what to do: held, paused by the program, or a door that was opened."""
        if status.phase in STANDS:
            self._follow_buttons()
        stand = (status.phase, status.acknowledged)
        if status.phase not in ("held", "paused", "door") or stand == self._answered:
            return
        self._answered = stand
        if status.phase == "paused" and self._resume_pauses:
            self._progress.console.print(f"pause: {status.message or 'M0'}; going on", markup=False)
            self._client.resume()
        elif self._has_start:
            what = f"{_why(status)}. Its start button goes on, Ctrl-C asks here"
            self._progress.console.print(what, markup=False)
        else:
            self._ask(status)

    def _follow_buttons(self) -> None:
        """Do from now on what the machine's own buttons want of the way along the cut, also while a person is asked."""
        if self._leader is None:
            from CNCStepper.job.leader import Leader

            self._leader = Leader(self._client.session_file, self._tell)
            self._leader.start()

    def _tell(self, text: str) -> None:
        self._progress.console.print(text, markup=False)

    def _ask(self, status: SenderStatus) -> None:
        """Ask until the job goes on or is stopped; nobody to ask means stop: no tool stands in the work unwatched."""
        self._progress.stop()
        wishes = self._asked(status)
        while not is_end(wishes) and not self._client.outcome:
            self._wish(wishes)
            status = self._touched(status)
            wishes = self._asked(status)
        self._progress.start()
        self._wish(wishes)

    def _asked(self, status: SenderStatus) -> list[tuple[str, dict[str, Any]]]:
        can_jog = status.phase == "paused" and status.machine_state == "Idle"
        more = f", z-0.1 jogs, zero z touches off ({_work_place(status)})" if can_jog else ""
        question = f"{_why(status)}. Enter goes on, s stops{more}{_BACK if status.phase != 'door' else ''}"
        try:
            return click.prompt(question, default="", show_default=False, err=True, type=Answer())
        except (click.Abort, EOFError):
            return STOP

    def _wish(self, wishes: list[tuple[str, dict[str, Any]]]) -> None:
        for name, values in wishes:
            self._client.ask(name, **values)

    def _touched(self, status: SenderStatus) -> SenderStatus:
        """Wait until a jog has begun and ended, or a zero is set; return how the machine stands then."""
        begin_s = time.monotonic()
        while time.monotonic() - begin_s < TOUCHED_S or status.machine_state == "Jog":
            for event in self._client.poll(LOOK_EVERY_S):
                self._print(event)
                status = SenderStatus.from_json(event["status"]) if event["event"] == "status" else status
            if self._client.outcome:
                break
        return status


def _why(status: SenderStatus) -> str:
    return status.message or ("The program pauses" if status.phase == "paused" else "The machine holds")


def _work_place(status: SenderStatus) -> str:
    return " ".join(f"{axis}{value:.3f}" for axis, value in zip("XYZ", status.wpos_mm or (), strict=False))
