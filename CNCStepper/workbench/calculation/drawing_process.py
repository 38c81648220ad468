# SPDX-License-Identifier: LGPL-2.1-or-later
"""Asks the process that reads drawings (`workers/drawing_reader.py`), and never waits for it.

One question is with the process at a time; the others wait in turn. A newer question of the same client takes the
place of its older one, also while the process works on that.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from PySide import QtCore

from CNCStepper.control.session.status import error_from_json
from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.request_queue import RequestQueue

WORKER = "CNCStepper.workers.drawing_reader"
LOST = CNCStepperError("drawing-lost", "the process that reads drawings has ended", advice="try it again")


@dataclass(frozen=True)
class DrawingRequest:
    """A question, and its callbacks: the answer, the refusal, and the share that is done."""

    question: dict[str, Any]
    answered: Callable[[dict[str, Any]], None]
    refused: Callable[[CNCStepperError], None]
    share: Callable[[float], None] = lambda share: None


class DrawingProcess(QtCore.QObject):
    """The one process of this window, started with the first question."""

    def __init__(self, parent: Any = None):
        super().__init__(parent)
        self._queue = RequestQueue(WORKER, LOST, parent=self)
        self._queue.answered.connect(guarded(self._on_message))
        self._queue.failed.connect(guarded(self._fail))
        self._asked: dict[Any, DrawingRequest] = {}
        self._current: Any = None
        self._mark = 0

    def ask(self, who: Any, request: DrawingRequest) -> None:
        """Ask for `who`, in place of its earlier question."""
        self._asked[who] = request
        if self._current is None or self._current == who:
            self._send(who)

    def forget(self, who: Any) -> None:
        """Answer one no more."""
        if self._asked.pop(who, None) is not None and self._current == who:
            self._mark += 1  # what is still said of it is about nobody's question
            self._go_on()

    def stop(self, who: Any) -> None:
        """Let a search end with the best so far, which is its answer."""
        if self._current == who:
            self._queue.ask({"stop": self._mark})

    def _send(self, who: Any) -> None:
        self._current = who
        self._mark += 1
        self._queue.ask({"mark": self._mark, **self._asked[who].question})

    def _go_on(self) -> None:
        self._current = None
        if self._asked:
            self._send(next(iter(self._asked)))

    def _on_message(self, told: dict[str, Any]) -> None:
        if told["mark"] != self._mark or self._current is None:
            return
        if "share" in told:
            self._asked[self._current].share(told["share"])
            return
        request = self._asked.pop(self._current)
        self._go_on()
        if "refused" in told:
            request.refused(error_from_json(told["refused"]))
        else:
            request.answered(told["answer"])

    def _fail(self, error: CNCStepperError) -> None:
        if self._current is not None:
            request = self._asked.pop(self._current)
            self._go_on()
            request.refused(error)


_process: DrawingProcess | None = None


def process() -> DrawingProcess:
    """Return the window's one process that reads drawings; it starts with the first question."""
    global _process
    if _process is None:
        _process = DrawingProcess(QtCore.QCoreApplication.instance())
    return _process
