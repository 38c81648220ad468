# SPDX-License-Identifier: LGPL-2.1-or-later
"""Leads the tool back along the cut from the dock: the requests of `back` with the process behind them that proves."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from CNCStepper.control.session.job_phase import Phase
from CNCStepper.control.session.status import error_from_json
from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.dock.connection import Link, error_text
from CNCStepper.workbench.dock.model.button_states import STANDING, sentences
from CNCStepper.workbench.dock.model.retract_state import FIND, RESUME, RetractFlow, request_of, why_not_back
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.request_queue import RequestQueue
from CNCStepper.workbench.services.translation import tr

WORKER = "CNCStepper.workers.path_retract"
COMMANDS = ("tell_place", "retrace")  # of the process; it is told itself why the service refuses them


class RetractRun:
    """The retract of one job at a time; say: adds a message. changed: the view is out of date."""

    def __init__(self, parent: Any, link: Link, say: Callable[[str, str], None], changed: Callable[[], None]):
        self.flow = RetractFlow()
        self._link, self._say, self._changed = link, say, changed
        lost = CNCStepperError("back-lost", "the process that calculates the retract has ended", advice="try again")
        self._questions = RequestQueue(WORKER, lost, parent=parent)
        self._questions.answered.connect(self._answered)
        self._questions.failed.connect(self._failed)

    def command(self, name: str) -> None:
        """Pass hold, resume or stop on; where the tool was taken back the job goes on from there."""
        if name == RESUME and self._link.moment.phase == Phase.RETREATED:
            self.go(RESUME, True)
        elif name == RESUME:
            self._link.command(RESUME, self._link.stand)
        else:
            self._link.command(name)

    def go(self, kind: str, value: float | bool) -> None:
        """Ask for a way; a machine that moves is held at once."""
        moment = self._link.moment
        if why := why_not_back(kind, self.flow, moment):
            self._say("refused", tr(why))
            return
        if moment.phase not in STANDING:
            self._link.command("hold")
        self._ask(kind, value)

    def advance(self) -> None:
        """Follow the controller's state; called after every poll."""
        moment = self._link.moment
        if not moment.job_runs:
            self.end()
        elif self.flow.follow(moment):
            self._ask(FIND, True)
        if request := self.flow.request_of_machine(request_of(self._link.status), moment):
            self.go(*request)

    def end(self) -> None:
        """Ask nothing any more, and end the process."""
        self.flow.forget()
        self._questions.end()

    # --- inside ----------------------------------------------------------------------------------

    def _ask(self, kind: str, value: float | bool) -> None:
        assert self._link.client  # a job runs there
        self.flow.ask(kind)
        self._questions.ask({"service": str(self._link.client.session_file), kind: value})
        self._changed()

    def _answered(self, answer: dict[str, Any]) -> None:
        if "refused" in answer:
            self._refused(error_from_json(answer["refused"]))
        else:
            self.flow.answer(answer)
            if answer.get("doubt"):
                self._say("warning", translated(answer["doubt"]))
        self._changed()

    def _refused(self, error: CNCStepperError) -> None:
        if self.flow.refuse(sentences(messages.sentence(error), translated(error.advice))) != FIND:
            self._say("refused", self.flow.trouble)

    def _failed(self, error: CNCStepperError) -> None:
        self.flow.forget()
        self.flow.refuse(error_text(error))
        self._say("warning", self.flow.trouble)
        self._changed()
