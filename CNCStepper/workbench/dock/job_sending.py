# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sends one job, its restart or a G-code file: the steps of `flow` with proof, findings and the controller's process.

What is sent is proven for the work zero that the machine has when it starts: while a person is asked for the zero, a
proof for another one is made again.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from CNCStepper.errors import CNCStepperError, JobError
from CNCStepper.state import Start
from CNCStepper.workbench.dock.connection import Link, error_text
from CNCStepper.workbench.dock.model.button_states import sentences
from CNCStepper.workbench.dock.model.send_steps import Flow
from CNCStepper.workbench.proving.latest_proof import LatestProof
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.translation import tr

if TYPE_CHECKING:
    from CNCStepper.recovery.restart.restart_proof_folder import RestartPlace


class Sending:
    """The flow of one job at a time.

    show_findings: fills the list of the checks. connect: opens the port that is chosen. changed: called when
    something new is to be shown. by_line: says whether the machine waits before each line.
    """

    def __init__(
        self,
        parent: Any,
        link: Link,
        show_findings: Callable[[Sequence[Any]], None],
        connect: Callable[[], None],
        changed: Callable[[], None],
        by_line: Callable[[], bool],
    ):
        self.flow = Flow()
        self.program_lines: Sequence[str] = ()
        self._parent, self._link = parent, link
        self._show_findings, self._connect, self._changed = show_findings, connect, changed
        self._by_line = by_line
        self._job: Any = None
        self._place: RestartPlace | None = None
        self._proof = LatestProof(self._proved, self._failed, self._progress)
        self._result: Any = None
        self._asked: Start | None = None  # what the last proof was asked to begin from
        self._seen: set[tuple[str, int, str]] = set()  # the findings with which a person has decided to go on

    def send(self, job: Any, place: RestartPlace | None = None) -> None:
        """Begin with a job object, or with its restart at a place.

        While one is being cut this is refused with a message.
        """
        if self._link.moment.job_runs:
            messages.note(tr("A job is being cut already: wait for its end, or stop it."))
            return
        self._proof.give_up()
        self._job, self._place, self._seen = job, place, set()
        self.flow.begin(tr("{0}, restart").format(job.Label) if place else job.Label)
        self._check()
        self._changed()

    @property
    def cut(self) -> tuple[Any, Any] | None:
        """The program that is being cut, or was just cut, with its proof; None before, after, and for a restart."""
        if self.flow.step not in ("cutting", "ended") or self._place is not None or self._result is None:
            return None
        return self._job, self._result

    def forget(self) -> None:
        """Know nothing of the job that is being cut, when another window began it."""
        self.program_lines = ()

    def confirm_step(self) -> None:
        """Answer the question of the present step with yes."""
        if self._result is not None:
            self._keep_up()
        if self.flow.again:
            return
        if self.flow.step == "connect":
            self._connect()
        elif self.flow.happen("onward") and self.flow.step == "starting":
            self._start()
        self._advance()
        self._changed()

    def away(self) -> None:
        """Give up before the cut, or close what has ended."""
        self._proof.give_up()
        self.flow.leave()
        self._changed()

    def take(self, event: dict[str, Any]) -> None:
        """Follow an event of the controller's process."""
        if event["event"] == "outcome" and self._link.client:
            self._ended(self._link.client.outcome)
        elif event["event"] == "refused" and event.get("command") == "run":
            self.flow.happen("refusal", sentences(translated(event["text"])))

    def advance(self) -> None:
        """Follow the controller's state; called after every poll."""
        phase = self._link.moment.phase
        if phase in ("off", "gone", "unreached"):
            self.flow.happen("lost", self._link.moment.message)
        elif self._link.moment.job_runs:
            self.flow.happen("cutting")
        self._advance()

    # --- inside ----------------------------------------------------------------------------------

    def _check(self) -> None:
        """Prove the job's program from the machine's present zero, where that is known."""
        from CNCStepper.workbench import api

        self._asked = self._link.start
        try:
            api.require_valid(self._job)
        except CNCStepperError as error:
            self._failed(error)
            return
        except ReferenceError:  # as FreeCAD says it
            self._failed(JobError("job-deleted", "the job was deleted", advice="send another one"))
            return
        self._proof.begin(self._job, self._asked, self._place, self._parent)

    def _keep_up(self) -> None:
        """Check once more where the machine's zero is not the one that the program was checked with."""
        if self.flow.step == "connect":
            self._proof.give_up()
        if self.flow.step == "differs" and self._result.begins != self._link.start:
            self.flow.happen("moved")
        proven_for = self._asked if self._proof.running else self._result.begins
        if self.flow.step != "zero" or proven_for == self._link.start:
            return
        self._proof.give_up()
        self.flow.again = self._result.begins != self._link.start
        self.flow.detail = ""
        if self.flow.again:
            self.flow.detail = tr("The program is checked again, with the work zero that the machine has now.")
            self._check()
        self._changed()

    def _progress(self, text: str) -> None:
        if not self.flow.again:
            self.flow.detail = text
        self._changed()

    def _proved(self, result: Any) -> None:
        self._result = result
        self.program_lines = result.program_lines
        worth_seeing = [finding for finding in result.findings if finding.severity != "info"]
        self._show_findings(worth_seeing)
        marks = {(finding.code, finding.place.line, finding.text) for finding in worth_seeing}
        what = "errors" if result.refused else "warnings" if marks - self._seen else "clean"
        self._seen |= marks
        if not self.flow.happen(what):  # checked again, and nothing new: what was asked before is still asked
            self.flow.again, self.flow.detail = False, ""
        self._advance()
        self._changed()

    def _failed(self, error: CNCStepperError) -> None:
        self.flow.happen("failure", sentences(messages.sentence(error), translated(error.advice)))
        self._changed()

    def _advance(self) -> None:
        """Ask for the work zero as soon as a controller is there, for a program that was checked with it."""
        if self._link.moment.connected:
            self.flow.happen("idle")
        if self._result is not None:
            self._keep_up()

    def _start(self) -> None:
        result = self._result
        consents = {"zero_confirmed": True, "allow_differences": self.flow.anyway}
        self._link.command("run", result.send_file, **consents, by_line=self._by_line())

    def _ended(self, outcome: Any) -> None:
        if outcome.error is not None and outcome.error.code == "settings-differ" and not self.flow.anyway:
            self.flow.happen("differences", error_text(outcome.error))
        else:
            self.flow.end(outcome.kind, sentences(translated(outcome.text)))
        self._changed()
