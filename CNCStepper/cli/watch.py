# SPDX-License-Identifier: LGPL-2.1-or-later
"""A person at a terminal watching a session: progress, pauses, and Ctrl-C."""

from __future__ import annotations

import signal

import click
from rich.console import Console
from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeElapsedColumn

from CNCStepper.control.outcome import Outcome, SenderStatus
from CNCStepper.control.send_job import SendJob
from CNCStepper.control.session import SessionClient

LOOK_EVERY_S = 0.05
STOP_WORDS = ("s", "stop", "q", "quit", "n", "no")


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
            elif event["event"] in ("message", "warning"):
                self._progress.console.print(event["text"], markup=False)

    def _show(self, status: SenderStatus) -> None:
        place = f"line {status.file_line}" if status.file_line else ""
        if status.wpos_mm:
            place += "  " + " ".join(f"{axis}{value:.3f}" for axis, value in zip("XYZ", status.wpos_mm, strict=False))
        self._progress.update(
            self._bar, description=status.phase, completed=status.acknowledged, total=status.total or None, place=place
        )

    def _stand(self, status: SenderStatus) -> None:
        """Ask once for each stand what to do: held, paused by the program, or a door that was opened."""
        stand = (status.phase, status.acknowledged)
        if status.phase not in ("held", "paused", "door") or stand == self._answered:
            return
        self._answered = stand
        if status.phase == "paused" and self._resume_pauses:
            self._progress.console.print(f"pause: {status.message or 'M0'}; going on", markup=False)
            self._client.resume()
        elif self._has_start:
            what = f"{status.message or 'The machine holds'}. Its start button goes on, Ctrl-C asks here"
            self._progress.console.print(what, markup=False)
        else:
            self._ask(status)

    def _ask(self, status: SenderStatus) -> None:
        """Ask until the answer is one of the two; nobody to ask means stop: no tool stands in the work unwatched."""
        question = f"{status.message or 'The machine holds'}. Enter goes on, s stops"
        self._progress.stop()
        try:
            answer = click.prompt(question, default="", show_default=False, err=True, type=_GO_ON_OR_STOP)
        except (click.Abort, EOFError):
            answer = "s"
        self._progress.start()
        if answer == "s":
            self._client.stop()
        else:
            self._client.resume()


class _GoOnOrStop(click.ParamType):
    """Enter alone, or a word for stop; anything else is asked again, for going on moves the machine."""

    name = "answer"

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> str:
        word = value.strip().lower()
        if word and word not in STOP_WORDS:
            self.fail(f"'{value}' is neither: press Enter alone to go on, or s to stop", param, ctx)
        return word and "s"


_GO_ON_OR_STOP = _GoOnOrStop()
