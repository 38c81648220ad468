# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the dock to a restart: of the program that is meant, or of a job that did not end."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import TYPE_CHECKING, Any

from PySide import QtGui

from CNCStepper.control.journal.store import unfinished_at
from CNCStepper.control.session.status import error_from_json
from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.dock.model.button_states import WAITING, ControllerSnapshot
from CNCStepper.workbench.dock.model.unfinished_job import NAMES, Reading, program_of, why_not_now
from CNCStepper.workbench.dock.views import widgets
from CNCStepper.workbench.document import program_file
from CNCStepper.workbench.features.base import JOB, proxy_type
from CNCStepper.workbench.features.program import Program
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.plain_words import plain
from CNCStepper.workbench.services.request_queue import RequestQueue
from CNCStepper.workbench.services.translation import later, tr

if TYPE_CHECKING:
    from CNCStepper.control.journal.replay import JobReplay
    from CNCStepper.workbench.dock.connection import Link
    from CNCStepper.workbench.proving.latest_proof import Sender

DOES = {
    "Restart": later("Restart the program at a line, an operation, a contour or a place in the picture."),
    "Unfinished": later("Show how far the last unfinished job came, and restart it there."),
}
WORKER = "CNCStepper.workers.unfinished_job"


class RestartOfferView(QtGui.QWidget):
    """Two buttons, and above them the offer, "" for none."""

    def __init__(self, restart: Callable[[], None], unfinished: Callable[[], None]):
        super().__init__()
        self.offer = widgets.wrapped("Offer")
        ground, letters = widgets.TONES[WAITING]
        self.offer.setStyleSheet(f"background: {ground}; color: {letters}; border-radius: 4px; padding: 6px;")
        self.buttons = {
            "Restart": widgets.button("Restart", tr("Restart…"), restart),
            "Unfinished": widgets.button("Unfinished", tr("Unfinished job…"), unfinished),
        }
        layout = widgets.column(self)
        layout.addWidget(self.offer)
        layout.addLayout(widgets.row(*self.buttons.values()))
        self.show_offer("")

    def show_offer(self, text: str) -> None:
        """Show the offer, or none."""
        self.offer.setText(text)
        self.offer.setVisible(bool(text))

    def lock(self, moment: ControllerSnapshot) -> None:
        """Enable the buttons while nothing is cut."""
        for name, button in self.buttons.items():
            widgets.lock(button, why_not_now(moment), DOES[name])
        if moment.job_runs:
            self.show_offer("")


class RestartOffer:
    """The actions of the view's two buttons; an offer is searched for after each connection, and when it is lost.

    show_way_on: shows beside the state whether a job was cut off when the link was lost.
    """

    def __init__(self, link: Link, send: Sender, show_way_on: Callable[[bool], None]):
        self._link, self._send, self._reading = link, send, Reading()
        self._show_way_on = show_way_on
        self._met, self._address = False, ""
        self.view = RestartOfferView(self._restart, self._ask)
        lost = CNCStepperError("unfinished-lost", "the process that reads the last job has ended", advice="try again")
        self._questions = RequestQueue(WORKER, lost, parent=self.view)
        self._questions.answered.connect(messages.guarded(self._answered))
        self._questions.failed.connect(messages.guarded(self._failed))

    def advance(self) -> None:
        """Look for an offer at each connection and each loss of one; called after every poll of the link."""
        moment = self._link.moment
        if moment.busy:
            self._show_way_on(False)
        if moment.connected != self._met:
            self._met = moment.connected
            self._address = self._link.address or self._address
            self.view.show_offer("")
            self._show_way_on(False)
            if self._met and not moment.job_runs:
                self._reading.ask(partial(unfinished_at, self._address), self._offer)
            elif moment.phase == "gone":
                self._reading.ask(partial(unfinished_at, self._address), self._offer_way_on)
        self._reading.poll()

    def go_on(self) -> None:
        """Open the restart of the job that the lost link has cut off."""
        self._ask_about(self._address)

    def _restart(self) -> None:
        """Choose the restart of the program that is in front."""
        from CNCStepper.workbench import restart
        from CNCStepper.workbench.editor import active_program
        from CNCStepper.workbench.proving import prove_program

        if why_not := active_program.why_not():
            messages.notice(why_not)
            return
        program = active_program.take()
        if program is None:
            return
        prove_program.make(program)
        restart.open_restart(program, self._send)

    def _ask(self) -> None:
        """Ask for the job that did not end, of this machine where there is one."""
        self._ask_about(self._link.address if self._met else "")

    def _ask_about(self, port: str) -> None:
        self._questions.end()  # the newest question counts
        self.view.show_offer(tr("The path of the last job is read…"))
        self._questions.ask({"port": port, "programs": [obj.Program for obj in _programs() if obj.Program]})

    def _offer_way_on(self, story: JobReplay | None) -> None:
        self._show_way_on(story is not None and not self._link.moment.connected)

    def _offer(self, story: JobReplay | None) -> None:
        if story is not None:
            text = tr(
                "The last job of this machine, {0}, was not cut to its end. Unfinished job… shows how far it came."
            )
            self.view.show_offer(text.format(_name(story.restarted[0])))

    def _answered(self, answer: dict[str, Any]) -> None:
        """Take up the job that the process tells of, or say why there is none."""
        self._questions.end()
        self.view.show_offer("")
        if "refused" in answer:
            raise error_from_json(answer["refused"])
        if answer["job"] is None:
            messages.notice(tr("No job is unfinished."), tr("Every job with a journal was cut to its end."))
        else:
            self._take_up(answer["job"])

    def _take_up(self, job: dict[str, Any]) -> None:
        """Say what is certain of a job, and open its restart where its program is in an open document."""
        said = [(tr(NAMES[name]), plain(translated(text))) for name, text in job["told"]]
        program = program_of(job["sha256"], ((obj, program_file.load(obj)) for obj in _programs()))
        if program is None:
            text = tr("{0} was not cut to its end, and no open document has the program that was sent.")
            messages.notice(text.format(_name(job["file"])), "\n".join(map(": ".join, said)))
            return
        from CNCStepper.workbench import restart

        restart.open_restart(program, self._send, job["line"], said)

    def _failed(self, error: CNCStepperError) -> None:
        self.view.show_offer("")
        messages.error(error)


def _programs() -> Iterator[Any]:
    """Yield the jobs and edited programs of all open documents."""
    import FreeCAD

    for document in FreeCAD.listDocuments().values():
        yield from (obj for obj in document.Objects if proxy_type(obj) in (JOB, Program.Type))


def _name(file: str) -> str:
    return file or tr("a program")
