# SPDX-License-Identifier: LGPL-2.1-or-later
"""Asks a process of its own (`job/editor_worker.py`) about a text that is being edited, and never waits for it.

text ──► change: only the lines that changed ──► refusals ──► times, lines for the 3D view
cursor ──► line ──► what holds after it        3D view ──► pick ──► line
"""

from __future__ import annotations

import json
import tempfile
from collections.abc import Callable
from concurrent.futures import Future
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide import QtCore

from CNCStepper.control.outcome import error_from_json
from CNCStepper.control.python_finder import PROOF, command, seek_python
from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench import tell
from CNCStepper.workbench.worker import Worker, start_worker

if TYPE_CHECKING:
    from CNCStepper.machine.profile import Machine
    from CNCStepper.state import Start

WORKER = "CNCStepper.job.editor_worker"
LOOK_EVERY_MS = 20
TEXT = "program.nc"
OF_A_TEXT = ("read", "timed", "sendable", "edited")  # answers that name the text that they are about
MOST_SENT_BY_LINE = 5000  # a longer change is sent as a file with the whole text


@dataclass(frozen=True)
class Language:
    """How a program is read: its dialect, beside which file its subroutines stand, from where, on which machine."""

    dialect: str
    file: str = ""
    machine: Machine | None = None
    start: Start | None = None


class ProgramReader(QtCore.QObject):
    """What is known of the newest text; `whole` gives all of it, when the process is started.

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
        self._process: Worker | None = None
        self._python: Future[str] | None = None
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(LOOK_EVERY_MS)
        self._timer.timeout.connect(tell.guarded(self._look))
        QtCore.QCoreApplication.instance().aboutToQuit.connect(self.end)

    def begin(self, language: Language) -> None:
        """Read the whole text in a language, now and from now on."""
        from CNCStepper.job.start_file import write_start

        self._language = language
        write_start(self.folder, language.start)
        if language.machine is not None:
            (self.folder / "machine.json").write_text(language.machine.model_dump_json(), encoding="utf-8")
        if self._process is not None:
            self._send_whole()
        elif self._python is None:
            self._python = seek_python(PROOF)
            self._timer.start()

    def change(self, first: int, removed: int, lines: list[str]) -> None:
        """Tell that lines have changed."""
        if self._process is None:
            self.begin(self._language)
        elif max(removed, len(lines)) > MOST_SENT_BY_LINE:
            self._send_whole()
        else:
            self.mark += 1
            self._send({"change": [first, removed, lines], "mark": self.mark})

    def ask(self, question: dict[str, Any]) -> None:
        """Ask something about the text; what is asked before the process is there is not answered."""
        if self._process is not None:
            self._send(question)

    def end(self) -> None:
        """End the process; nothing is told any more."""
        self._timer.stop()
        self._python = None
        process, self._process = self._process, None
        if process is not None:
            process.stop()

    def forget(self) -> None:
        """End the process and take its folder away."""
        self.end()
        self._folder.cleanup()

    def _look(self) -> None:
        """Start the process as soon as its Python is found."""
        if self._python is None or not self._python.done():
            return
        self._timer.stop()
        python, self._python = self._python, None
        try:
            words = command(python.result(), WORKER, str(self.folder))
            heard, lost = tell.guarded(self._hear), tell.guarded(self._lost)
            self._process = start_worker(self, words, heard, lost)
        except CNCStepperError as error:
            self._fail(error)
            return
        self._send_whole()

    def _send_whole(self) -> None:
        self.mark += 1
        language = self._language
        machine = language.machine is not None
        (self.folder / TEXT).write_bytes(self._whole().encode("utf-8", "surrogatepass"))
        self._send({"as": {"dialect": language.dialect, "file": language.file, "machine": machine}})
        self._send({"text": TEXT, "mark": self.mark})

    def _send(self, question: dict[str, Any]) -> None:
        assert self._process is not None
        self._process.write(json.dumps(question).encode("ascii") + b"\n")

    def _hear(self) -> None:
        """Take the answers whose lines are whole."""
        while self._process is not None and (line := self._process.line()):
            answer = json.loads(line)
            if "error" in answer:
                self._fail(error_from_json(answer["error"]))
            elif all(answer.get(kind, self.mark) == self.mark for kind in OF_A_TEXT):
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

    def _lost(self) -> None:
        """Tell that the process ended by itself."""
        if self._process is not None:
            self._fail(
                CNCStepperError(
                    "editor-lost",
                    "the process that reads the program has ended",
                    advice="change the text to start it again",
                )
            )

    def _fail(self, error: CNCStepperError) -> None:
        self.end()
        self.failed.emit(error)
