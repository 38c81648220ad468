# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drivers that do what no sender may: a judge that lets them pass is none."""

from __future__ import annotations

from CNCStepper.control.protocol.grbl.driver import Answered, Grbl, Received
from CNCStepper.control.protocol.grbl.status_reports import OK, Alarm, Answer, Feedback, Greeting, Report

PATIENCE_S = 3.0


class IgnoresMissingOk(Grbl):
    """Takes a line for done when the machine has been idle for a while."""

    _heard_s = 0.0

    def receive(self, wait_s: float) -> list[Received]:
        received = super().receive(wait_s)
        if any(isinstance(report, Answered) for report in received) or not self.unanswered:
            self._heard_s = self.clock()
        elif self.clock() - self._heard_s > PATIENCE_S and self.status and self.status.state == "Idle":
            made_up = [self._taken(OK)]
            self._listen(made_up)
            received += made_up
        return received


class ResendsAfterError(Grbl):
    """Sends a line again that was refused, behind those that are under way."""

    def _answered(self, answer: Answer) -> Received:
        if not answer.error or not self.unanswered or self.unanswered[0].index < 0:
            return super()._answered(answer)
        sent = self.counting.answered()
        self.send(sent.text, sent.index)
        self.flush()
        return Feedback("MSG", "sent again")


class CountsTwice(Grbl):
    """Takes every answer for two, and does not wonder about those that are too many."""

    def receive(self, wait_s: float) -> list[Received]:
        received = super().receive(wait_s)
        made_up = [self._taken(OK) for report in received if _is_of_job(report) and self.unanswered]
        self._listen(made_up)
        return received + made_up

    def _answered(self, answer: Answer) -> Received:
        return super()._answered(answer) if self.unanswered else Feedback("MSG", "too many")


def _is_of_job(report: Received) -> bool:
    return isinstance(report, Answered) and report.sent.index >= 0


class GoesOnAfterGreeting(Grbl):
    """Hears neither alarms nor greetings."""

    def _taken(self, report: Report) -> Received:
        deaf = isinstance(report, (Alarm, Greeting)) and self.unanswered
        return super()._taken(Feedback("MSG", "") if deaf else report)
