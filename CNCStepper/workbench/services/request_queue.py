# SPDX-License-Identifier: LGPL-2.1-or-later
"""Asks a worker process (`workers/json_lines.py`) one thing after another, and never waits for it."""

from __future__ import annotations

from concurrent.futures import Future
from typing import Any

from PySide import QtCore

from CNCStepper import text_json
from CNCStepper.control.processes.python_finder import PROOF, command, find_python_in_background
from CNCStepper.control.session.status import error_from_json
from CNCStepper.errors import CNCStepperError
from CNCStepper.job.request_digest import text_of
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.background_process import Worker, start_worker

LOOK_EVERY_MS = 20


class RequestQueue(QtCore.QObject):
    """The process is started with the first question, and again with the first after its end.

    worker: the module. arguments: for it. lost: the error for a process that ends by itself. answered: sent with each
    answer. failed: sent with the error that ended the process: what was asked is not answered any more.
    """

    answered = QtCore.Signal(object)
    failed = QtCore.Signal(object)

    def __init__(self, worker: str, lost: CNCStepperError, *arguments: str, parent: Any = None):
        super().__init__(parent)
        self._words, self._error_when_lost = (worker, *arguments), lost
        self._waiting: list[dict[str, Any]] = []  # asked before the process is there
        self._process: Worker | None = None
        self._python: Future[str] | None = None
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(LOOK_EVERY_MS)
        self._timer.timeout.connect(messages.guarded(self._look))
        QtCore.QCoreApplication.instance().aboutToQuit.connect(self.end)

    @property
    def begun(self) -> bool:
        """Whether there is a process, or will be one soon."""
        return self._process is not None or self._python is not None

    def ask(self, question: dict[str, Any]) -> None:
        """Ask a question, as plain data."""
        self._waiting.append(question)
        if self._process is not None:
            self._send()
        elif self._python is None:
            self._python = find_python_in_background(PROOF)
            self._timer.start()

    def end(self) -> None:
        """End the process; no further signals are sent."""
        self._timer.stop()
        self._waiting.clear()
        self._python = None
        process, self._process = self._process, None
        if process is not None:
            process.stop()

    def _look(self) -> None:
        """Start the process as soon as its Python is found."""
        if self._python is None or not self._python.done():
            return
        self._timer.stop()
        python, self._python = self._python, None
        try:
            words = command(python.result(), *self._words)
            heard, lost = messages.guarded(self._on_message), messages.guarded(self._lost)
            self._process = start_worker(self, words, heard, lost)
        except CNCStepperError as error:
            self._fail(error)
            return
        self._send()

    def _send(self) -> None:
        assert self._process is not None
        for question in self._waiting:
            self._process.write(text_of(question).encode("ascii") + b"\n")
        self._waiting.clear()

    def _on_message(self) -> None:
        """Hand on the answers whose lines are whole."""
        while self._process is not None and (line := self._process.line()):
            answer = text_json.loads(line)
            if "error" in answer:
                self._fail(error_from_json(answer["error"]))
            else:
                self.answered.emit(answer)

    def _lost(self) -> None:
        """Tell that the process ended by itself."""
        if self._process is not None:
            self._fail(self._error_when_lost)

    def _fail(self, error: CNCStepperError) -> None:
        self.end()
        self.failed.emit(error)
