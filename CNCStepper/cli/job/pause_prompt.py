# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prompts at a terminal for each pause of a job; an answer counts for that pause alone.

The question at a pause of a job, and the message without a terminal to ask.

The answers to a pause of a job: go on, stop, jog, set the zero, override, end stepping.

Session events while the operator is asked: printed at once, above the answer being typed.

One thread waits for the answer, as it can on every system; another one reads the session's events until then.
"""

from __future__ import annotations

import re
import sys
import time
from collections.abc import Callable
from threading import Event, Thread
from types import TracebackType
from typing import Any

import click

from CNCStepper.cli.common.language import translated
from CNCStepper.cli.job.override import HELP as OVERRIDES
from CNCStepper.cli.job.override import read_override
from CNCStepper.cli.job.status_text import overrides_in_words
from CNCStepper.control.service.service_job import ServiceJob
from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.job_phase import WAITING, Phase
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.errors import CNCStepperError, Text
from CNCStepper.word_pattern import words_beside


def why(status: SenderStatus) -> str:
    """Return the reason of the pause."""
    return status.message or (Text("The program pauses") if status.phase == Phase.PAUSED else Text("The machine holds"))


def question(status: SenderStatus) -> Text:
    """Return the question about a pause: its reason and the possible answers."""
    touches = Text(", zero z touches off") if status.phase == Phase.PAUSED else ""
    jogs: str = Text(", z-0.1 jogs{touches} ({place})", touches=touches, place=_work_place(status))
    return Text(
        "{why}. Enter goes on, s stops{jogs}, ? says more{back}",
        why=why(status),
        jogs=jogs if status.machine_state in ("Idle", "Tool") else "",
        back=Text("; `cncstepper back` goes back") if status.phase != "door" and status.machine_state != "Tool" else "",
    )


def unasked(status: SenderStatus) -> Text:
    """Return the sentence about a pause where standard input has ended and is no terminal."""
    go = "cncstepper go --pause" if status.phase == Phase.PAUSED else "cncstepper go"
    return Text(
        "{why}. Nobody can answer here, so the machine waits. In any terminal `{go}` goes on, "
        "`cncstepper back` goes back, `cncstepper stop` stops; so does Ctrl-C here",
        why=why(status),
        go=go,
    )


def reminder(status: SenderStatus, waits: bool) -> Text:
    """Return the sentence for an open question whose pause is over; waits: somebody is asked again."""
    if waits:
        return Text("Meanwhile: {why}. Press Enter to be asked about that", why=why(status))
    return Text("Meanwhile the job has gone on ({phase}). Press Enter to see it", phase=status.phase)


def _work_place(status: SenderStatus) -> str:
    return " ".join(f"{axis}{value:.3f}" for axis, value in zip("XYZ", status.wpos_mm or (), strict=False))


PendingRequests = list[tuple[str, dict[str, Any]]]  # commands of a session with their values

GO_ON: PendingRequests = [("resume", {})]
STOP: PendingRequests = [("stop", {})]
STOP_WORDS = ("s", "stop", "q", "quit", "n", "no")
JOG_FEED_MM_MIN = 500.0
LONGEST_MM = 1000.0
HELP = Text(
    "press Enter alone to go on or s to stop; x10 y-5 z0.1 jogs (f100: that fast), zero z touches off; "
    "overrides: {overrides}",
    overrides=OVERRIDES,
)
JOG_LETTERS = "XYZF"
_ZERO = re.compile(r"zero ([xyz]{1,3})")


def read_answer(text: str) -> PendingRequests:
    """Return the request of an answer; raises ValueError with a text for an invalid one, and for a question mark."""
    words = " ".join(text.lower().split())
    if not words:
        return GO_ON
    if words in STOP_WORDS:
        return STOP
    if words == "all":
        return [("by_line", {"on": False}), *GO_ON]
    if zero := _ZERO.fullmatch(words):
        return [("set_zero", {"axes": zero[1].upper()})]
    if override := read_override(words):
        return [("override", override)]
    if words == "?":
        raise ValueError(HELP)
    return [("jog", _way(words, text))]


def is_end(requests: PendingRequests) -> bool:
    """Return whether the job leaves its pause with these requests."""
    return any(name in ("resume", "stop") for name, _ in requests)


def _way(words: str, text: str) -> dict[str, float]:
    found, other = words_beside(words)
    values = {letter: float(number) for letter, number in found}
    if other or len(values) < len(found) or set(values) - set(JOG_LETTERS) or not set(values) - {"F"}:
        raise ValueError(Text("'{text}' is no answer: {help}", text=text, help=HELP))
    if any(abs(value) > LONGEST_MM for letter, value in values.items() if letter != "F") or values.get("F", 1) <= 0:
        what = Text("'{text}' is no jog: at most {most_mm:g} mm, with a feed above 0", text=text, most_mm=LONGEST_MM)
        raise ValueError(what)
    way = {f"{axis.lower()}_mm": values.get(axis, 0.0) for axis in "XYZ"}
    return way | {"feed_mm_min": values.get("F", JOG_FEED_MM_MIN)}


class Answer(click.ParamType):
    """One answer; anything else is asked again, for going on moves the machine."""

    name = "answer"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> PendingRequests:
        """Return the requests of a typed answer."""
        try:
            return value if isinstance(value, list) else read_answer(value)
        except ValueError as error:
            self.fail(Text("{error}", error=error), param, ctx)


LOOK_EVERY_S = 0.05


class SessionListener:
    """A context for the question about a pause; at its end it raises the error of a lost link.

    hear: gets every event but the statuses. tell: gets words.
    """

    def __init__(
        self,
        client: SessionClient | ServiceJob,
        asked: SenderStatus,
        on_message: Callable[[dict[str, Any]], None],
        tell: Callable[[str], None],
    ):
        self._client, self._on_message, self._tell = client, on_message, tell
        self._told = (asked.stand, True)
        self._over = Event()
        self._error: CNCStepperError | None = None
        self._listener = Thread(target=self._listen, name="meanwhile", daemon=True)

    def __enter__(self) -> None:
        self._listener.start()

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self._over.set()
        self._listener.join()
        if self._error:
            raise self._error

    def _listen(self) -> None:
        try:
            while not self._over.is_set() and self._client.outcome is None:
                for event in self._client.poll(LOOK_EVERY_S):
                    self._take(event)
        except CNCStepperError as error:
            self._error = error
        if self._error or self._client.outcome:
            self._tell(Text("\nThe job has ended. Press Enter to see how"))

    def _take(self, event: dict[str, Any]) -> None:
        if event["event"] != "status":
            self._on_message(event)
            return
        status = SenderStatus.from_json(event["status"])
        stand = (status.stand, status.phase in WAITING)
        if stand != self._told:
            self._told = stand
            self._tell(Text("\n{words}", words=reminder(status, stand[1])))


TOUCHED_S = 0.5  # until a jog, a new zero or an override shows at the latest
OVER = Text("That was not done: it answered to a stand that is over")


class PausePrompt:
    """Asks about the pauses of one session.

    hear: gets every event of the session that comes meanwhile but the statuses. tell: gets words. is_there: whether
    somebody can be asked, which shows at the first question.
    """

    def __init__(
        self,
        client: SessionClient | ServiceJob,
        on_message: Callable[[dict[str, Any]], None],
        tell: Callable[[str], None],
    ) -> None:
        self.is_there = True
        self._client, self._on_message, self._tell = client, on_message, tell

    def ask(self, status: SenderStatus) -> int:
        """Prompt until the job resumes or is stopped; return the id of the last pause."""
        asked = status
        while status.phase in WAITING and self._client.outcome is None:
            asked, requests = status, self._answer(status)
            if not self.is_there:
                self._tell(Text("\n{words}", words=unasked(asked)))
                break
            status = self._look(asked)
            if requests != STOP and (status.stand != asked.stand or status.phase not in WAITING):
                if requests != GO_ON:
                    self._tell(OVER)
                continue
            self._request(requests, asked.stand)
            if is_end(requests):
                break
            status = self._touched(status)
        return asked.stand

    def _answer(self, status: SenderStatus) -> PendingRequests:
        """Return the request; without a terminal return none and set `is_there` to False."""
        if not self.is_there:
            return []
        try:
            with SessionListener(self._client, status, self._on_message, self._tell):
                asked = translated(question(status))
                return click.prompt(asked, default="", show_default=False, err=True, type=Answer())
        except click.Abort as abort:
            self.is_there = sys.stdin.isatty() or not isinstance(abort.__context__, EOFError)
            return STOP if self.is_there else []

    def _request(self, requests: PendingRequests, stand: int) -> None:
        for name, values in requests:
            self._client.ask(name, **(values | {"stand": stand} if name == "resume" else values))

    def _look(self, status: SenderStatus) -> SenderStatus:
        """Return the machine's status now."""
        self._client.ask("status")
        seen: list[SenderStatus] = []
        while not seen and self._client.outcome is None:
            for event in self._client.poll(LOOK_EVERY_S):
                if event["event"] == "status":
                    seen.append(SenderStatus.from_json(event["status"]))
                else:
                    self._on_message(event)
        return seen[-1] if seen else status

    def _touched(self, status: SenderStatus) -> SenderStatus:
        """Wait until a jog has begun and ended, or a zero or an override is set; return the machine's status then."""
        begin_s, overrides = time.monotonic(), overrides_in_words(status)
        while (time.monotonic() - begin_s < TOUCHED_S or status.machine_state == "Jog") and not self._client.outcome:
            status = self._look(status)
            time.sleep(LOOK_EVERY_S)
        if overrides_in_words(status) != overrides:
            self._tell(overrides_in_words(status))
        return status
