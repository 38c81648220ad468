# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task of a restart: it lists the places, shows the path, proves the chosen restart, and sends it.

program ──► reader: lines, path, contours, place under a click ──► choice ──► proof ──► words, findings ──► dock
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from PySide import QtCore

from CNCStepper.control.session.status import error_from_json
from CNCStepper.recovery.restart.restart_places import RequestedPlace
from CNCStepper.recovery.restart.restart_proof_folder import RestartPlace
from CNCStepper.workbench.dock.model.button_states import sentences
from CNCStepper.workbench.document import program_file
from CNCStepper.workbench.document.core_job import machine_of
from CNCStepper.workbench.editor.program_source import ObjectSource
from CNCStepper.workbench.editor.reader_client import ProgramReader
from CNCStepper.workbench.editor.view_session import EditorStage
from CNCStepper.workbench.features.program import job_behind
from CNCStepper.workbench.panels.view_task_panel import ViewTask
from CNCStepper.workbench.proving import latest_proof
from CNCStepper.workbench.proving.latest_proof import LatestProof, Sender
from CNCStepper.workbench.restart.panel import RestartPanel
from CNCStepper.workbench.restart.restart_places import Row, line_of, rows_of, title_of
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.object_observers import ProgramObserver
from CNCStepper.workbench.services.translation import tr
from CNCStepper.workbench.simulation.view_session import Stage, view_of

if TYPE_CHECKING:
    from CNCStepper.errors import CNCStepperError

SETTLED_MS = 400  # so long a choice stands still before it is proven


class RestartTask(ViewTask):
    """The object for FreeCAD's task panel; `form` is its widget. An edit of the program is shown at once."""

    def __init__(self, program: Any, send: Sender, line: int = 0, said: Sequence[tuple[str, str]] = ()):
        """Take what `open_restart` is given."""
        self.form = RestartPanel(program.Label, said)
        self._program, self._document_name, self._sender = program, program.Document.Name, send
        self._source = ObjectSource(program)
        self._where = RequestedPlace(line=line) if line else None
        self._proof = LatestProof(self.form.show_result, self._refuse, lambda text: self.form.say(text, busy=True))
        self._stage: Stage | None = None
        self._has_left = False
        self._path = EditorStage(self._clicked)
        self._reader = ProgramReader(lambda: program_file.load(program))
        self._watch = ProgramObserver(program, self._changed, self._close_soon, self._document_closing)
        self._settled = QtCore.QTimer()
        self._settled.setSingleShot(True)
        self._settled.setInterval(SETTLED_MS)
        self._settled.timeout.connect(messages.guarded(self._prove))
        self._connect()

    # ---- the life of the task ----

    def begin(self) -> None:
        """Read the program in its present state in the document."""
        if self._has_left:
            return
        machine = machine_of(job_behind(self._program))
        self._reader.begin(self._source.language(machine))

    def end(self, *_: Any) -> None:
        """Leave nothing behind: no process, no timer, no node; Qt keeps this object with the timer that calls it."""
        if self._has_left:
            return
        self._has_left = True
        self._watch.end()
        self._settled.stop()
        self._settled.deleteLater()
        self._proof.give_up()
        self._reader.forget()
        self._reader.deleteLater()
        self._path.clear()
        if self._stage is not None:
            self._stage.restore()
            self._stage = None

    def _connect(self) -> None:
        reader, form, guarded = self._reader, self.form, messages.guarded
        reader.read.connect(guarded(self._read))
        reader.timed.connect(guarded(self._show_path))
        reader.listed.connect(guarded(self._list))
        reader.at_line.connect(guarded(lambda answer: self._path.show_line(answer["way"])))
        reader.place_picked.connect(guarded(self._pick))
        reader.failed.connect(guarded(self._refuse))
        form.place_chosen.connect(guarded(self._choose_row))
        form.line_chosen.connect(guarded(self._choose_line))
        form.entering_chosen.connect(guarded(self._prove_soon))
        form.send.connect(guarded(self._send))
        form.destroyed.connect(self.end)  # however FreeCAD closes the panel

    # ---- what the reading tells ----

    def _read(self, answer: dict[str, Any]) -> None:
        self.form.show_lines(answer["lines"])

    def _show_path(self, answer: dict[str, Any]) -> None:
        """Show the path alone, seen from above at a slant, and ask for the list."""
        self._path.show(self._source, self._reader.folder / answer["path"])
        view = view_of(self._program.Document)
        if self._stage is None and view is not None:
            self._stage = Stage(self._program, view)
            self._stage.look()
        self._reader.ask({"contours": True})

    def _list(self, answer: dict[str, Any]) -> None:
        if "error_of_contours" in answer:
            self._refuse(error_from_json(answer["error_of_contours"]))
            return
        rows = [replace(row, name=title_of(row.name)) for row in rows_of(answer)]
        self.form.show_rows(rows, answer["more"])
        self.form.say(tr("No place is chosen yet."))
        if self._where is not None:
            self._choose(self._where)

    def _pick(self, answer: dict[str, Any]) -> None:
        """Choose the place that was clicked; a click beside the cuts means nothing."""
        if answer["place"] is not None:
            self._choose(RequestedPlace(at_mm=tuple(answer["place"])))
            self._path.show_line([[answer["place"], answer["place"]]])

    # ---- the choice ----

    def _clicked(self, question: dict[str, Any]) -> None:
        self._reader.ask({"place": question})

    def _choose_row(self, row: Row) -> None:
        self._choose(row.where)

    def _choose_line(self, line: int, time: int) -> None:
        self._choose(RequestedPlace(line=line, time=time))

    def _choose(self, where: RequestedPlace) -> None:
        self._where = where
        self.form.show_choice(where)
        self.form.ask_time(bool(where.time))
        if line := line_of(where, self.form.places.rows):
            self._reader.ask({"line": line})
        self._prove_soon()

    def _prove_soon(self) -> None:
        """Prove as soon as nothing is changed any more."""
        if self._where is None:
            return
        self._proof.give_up()
        self.form.say(tr("The restart is made and proven…"), busy=True)
        self._settled.start()

    @property
    def _place(self) -> RestartPlace:
        assert self._where is not None
        return RestartPlace(self._where, self.form.entering.overlap_mm, self.form.entering.height_mm)

    # ---- the proof ----

    def _prove(self) -> None:
        self._proof.begin(self._program, latest_proof.start_here(), self._place)

    def _refuse(self, error: CNCStepperError) -> None:
        """Say why there is no restart; a line that is run more than once lets its run be chosen."""
        self._proof.give_up()
        if error.code == "restart-time":
            self.form.ask_time(True)
        self.form.say(sentences(messages.sentence(error), translated(error.advice)))

    def _send(self) -> None:
        """Hand the restart to the dock, which asks for the work zero and sends it."""
        program, place = self._program, self._place
        self.reject()
        self._sender(program, place)

    # ---- what happens to the program meanwhile ----

    def _changed(self) -> None:
        """Read the new program; a place in the old one is none in the new one."""
        self._proof.give_up()
        self._settled.stop()
        self._where = None
        self.form.say(tr("The program has changed: it is read again."), busy=True)
        QtCore.QTimer.singleShot(0, messages.guarded(self.begin))

    def _close_soon(self) -> None:
        QtCore.QTimer.singleShot(0, messages.guarded(self.reject))

    def _document_closing(self, name: str) -> None:
        if name == self._document_name:
            self._close_soon()
