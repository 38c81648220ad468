# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prompts at a terminal for each pause of a job; an answer counts for that pause alone."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from typing import Any

import click

from CNCStepper.cli.job.pause_answers import GO_ON, STOP, Answer, PendingRequests, is_end
from CNCStepper.cli.job.pause_question import question, unasked
from CNCStepper.cli.job.session_listener import LOOK_EVERY_S, SessionListener
from CNCStepper.cli.job.status_text import overrides_in_words
from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.control.stream.pause_id import WAITING

TOUCHED_S = 0.5  # until a jog, a new zero or an override shows at the latest
OVER = "That was not done: it answered to a stand that is over"


class PausePrompt:
    """Asks about the stands of one session.

    hear: gets every event of the session that comes meanwhile but the statuses. tell: gets words. is_there: whether
    somebody can be asked, which shows at the first question.
    """

    def __init__(
        self, client: SessionClient, on_message: Callable[[dict[str, Any]], None], tell: Callable[[str], None]
    ) -> None:
        self.is_there = True
        self._client, self._on_message, self._tell = client, on_message, tell

    def ask(self, status: SenderStatus) -> int:
        """Ask until the job goes on or is stopped; return the number of the stand that was asked about last."""
        asked = status
        while status.phase in WAITING and self._client.outcome is None:
            asked, wishes = status, self._answer(status)
            if not self.is_there:
                self._tell(f"\n{unasked(asked)}")
                break
            status = self._look(asked)
            if wishes != STOP and (status.stand != asked.stand or status.phase not in WAITING):
                if wishes != GO_ON:
                    self._tell(OVER)
                continue
            self._wish(wishes, asked.stand)
            if is_end(wishes):
                break
            status = self._touched(status)
        return asked.stand

    def _answer(self, status: SenderStatus) -> PendingRequests:
        """Return what is wanted; nothing, and `is_there` is false from now on, where nobody can be asked."""
        if not self.is_there:
            return []
        try:
            with SessionListener(self._client, status, self._on_message, self._tell):
                return click.prompt(question(status), default="", show_default=False, err=True, type=Answer())
        except click.Abort as abort:
            self.is_there = sys.stdin.isatty() or not isinstance(abort.__context__, EOFError)
            return STOP if self.is_there else []

    def _wish(self, wishes: PendingRequests, stand: int) -> None:
        for name, values in wishes:
            self._client.ask(name, **(values | {"stand": stand} if name == "resume" else values))

    def _look(self, status: SenderStatus) -> SenderStatus:
        """Return how the machine stands now."""
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
        """Wait until a jog has begun and ended, or a zero or an override is set; return how the machine stands then."""
        begin_s, overrides = time.monotonic(), overrides_in_words(status)
        while (time.monotonic() - begin_s < TOUCHED_S or status.machine_state == "Jog") and not self._client.outcome:
            status = self._look(status)
            time.sleep(LOOK_EVERY_S)
        if overrides_in_words(status) != overrides:
            self._tell(overrides_in_words(status))
        return status
