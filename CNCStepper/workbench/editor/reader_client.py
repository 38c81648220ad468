# SPDX-License-Identifier: LGPL-2.1-or-later
"""Asks a process of its own (`workers/program_editor.py`) about a text that is being edited, and never waits for it.

text ──► change: only the lines that changed ──► refusals ──► times, lines for the 3D view
cursor ──► line ──► what holds after it        3D view ──► pick ──► line
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide import QtCore

from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.request_queue import RequestQueue

if TYPE_CHECKING:
    from CNCStepper.machine.profile import Machine
    from CNCStepper.state import Start

WORKER = "CNCStepper.workers.program_editor"
TEXT = "program.nc"
OF_A_TEXT = ("read", "timed", "sendable", "edited")  # answers that name the text that they are about
MOST_SENT_BY_LINE = 5000  # a longer change is sent as a file with the whole text


@dataclass(frozen=True)
class Language:
    """How a program is read: its dialect, the file beside its subroutines, its start and machine."""

    dialect: str
    file: str = ""
    machine: Machine | None = None
    start: Start | None = None


class ProgramReader(QtCore.QObject):
    """What is known of the newest text; `whole` gives all of it, whenever it is read anew.

    read, timed, sendable, at_line, picked, place_picked, listed, edited: sent with the process's answers. failed: with
    an error; the next change starts the process again.
    """

    read = QtCore.Signal(object)
    timed = QtCore.Signal(object)
    sendable = QtCore.Signal(object)
    at_line = QtCore.Signal(object)
    picked = QtCore.Signal(object)
    place_picked = QtCore.Signal(object)
    listed = QtCore.Signal(object)
    edited = QtCore.Signal(object)
    failed = QtCore.Signal(object)

    def __init__(self, whole: Callable[[], str], parent: Any = None):
        super().__init__(parent)
        self._whole = whole
        self._language = Language("grbl")
        self._folder = tempfile.TemporaryDirectory(prefix="cncstepper-", ignore_cleanup_errors=True)
        self.folder = Path(self._folder.name)
        self.mark = 0
        what, advice = "the process that reads the program has ended", "change the text to start it again"
        lost = CNCStepperError("editor-lost", what, advice=advice)
        self._questions = RequestQueue(WORKER, lost, str(self.folder), parent=self)
        self._questions.answered.connect(guarded(self._on_message))
        self._questions.failed.connect(self.failed)

    def begin(self, language: Language) -> None:
        """Read the whole text in a language, now and from now on."""
        from CNCStepper.job.start_state_file import write_start

        self._language = language
        write_start(self.folder, language.start)
        if language.machine is not None:
            (self.folder / "machine.json").write_text(language.machine.model_dump_json(), encoding="utf-8")
        self._send_whole()

    def change(self, first: int, removed: int, lines: list[str]) -> None:
        """Tell that lines have changed."""
        if not self._questions.begun:
            self.begin(self._language)
        elif max(removed, len(lines)) > MOST_SENT_BY_LINE:
            self._send_whole()
        else:
            self.mark += 1
            self._questions.ask({"change": [first, removed, lines], "mark": self.mark})

    def ask(self, question: dict[str, Any]) -> None:
        """Ask something about the text; nothing is answered while none is read."""
        if self._questions.begun:
            self._questions.ask(question)

    def end(self) -> None:
        """End the process; no further signals are sent."""
        self._questions.end()

    def forget(self) -> None:
        """End the process and take its folder away."""
        self.end()
        self._folder.cleanup()

    def _send_whole(self) -> None:
        self.mark += 1
        language = self._language
        machine = language.machine is not None
        (self.folder / TEXT).write_bytes(self._whole().encode("utf-8", "surrogatepass"))
        self._questions.ask({"as": {"dialect": language.dialect, "file": language.file, "machine": machine}})
        self._questions.ask({"text": TEXT, "mark": self.mark})

    def _on_message(self, answer: dict[str, Any]) -> None:
        """Hand on what is said of the newest text."""
        if all(answer.get(kind, self.mark) == self.mark for kind in OF_A_TEXT):
            self._hand_out(answer)

    def _hand_out(self, answer: dict[str, Any]) -> None:
        kinds = {
            "read": self.read,
            "timed": self.timed,
            "sendable": self.sendable,
            "line": self.at_line,
            "pick": self.picked,
            "place": self.place_picked,
            "contours": self.listed,
            "edited": self.edited,
        }
        next(signal for kind, signal in kinds.items() if kind in answer).emit(answer)
