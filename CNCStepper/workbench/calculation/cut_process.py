# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cuts and programs made in one background process (`cycle_cutting`); the last value wins.

    who asks ──► ask ──► the process ──► cut_answers ──► who asks makes his objects, which calculates nothing any more

Each who asks has one question at a time: a newer one takes the place of the one before, in the process too. A process
that does not turn to the newer question within a second is ended, and another one started.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from PySide import QtCore

from CNCStepper.errors import CNCStepperError, MissingPackage
from CNCStepper.workbench.calculation import result_cache
from CNCStepper.workbench.services import jit_guard
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.request_queue import RequestQueue
from CNCStepper.workbench.services.translation import later

WORKER = "CNCStepper.workers.cycle_cutting"
TURNS_WITHIN_MS = 1000
LOST = CNCStepperError(
    "cut-lost", "the process that cuts ended before it had an answer", advice="choose other values, or try again"
)
STAGES = {"fit": later("Fitting arcs…"), "cut": later("Cutting…"), "write": later("Writing the program…")}
Parts = dict[str, dict[str, Any]]  # questions by their keys


@dataclass(frozen=True)
class CutRequest:
    """A request of one client, and its callbacks: each stage's English words, and the end.

    can_wait: whether any other request goes before it.
    """

    parts: Parts
    stage: Callable[[str], None]
    answered: Callable[[], None]
    can_wait: bool = False


class CutProcess(QtCore.QObject):
    """The one process of this window, started with the first question."""

    def __init__(self, parent: Any = None):
        super().__init__(parent)
        self.unavailable = False  # there is no Python for it: objects are cut in the window, for a while at most
        self._questioner = RequestQueue(WORKER, LOST, parent=self)
        self._questioner.answered.connect(guarded(self._on_message))
        self._questioner.failed.connect(guarded(self._lost))
        self._asked: dict[Any, CutRequest] = {}
        self._current: Any = None  # who asked what the process works on
        self._mark = 0
        self._heard = False  # whether the process has told anything yet
        self._turns = QtCore.QTimer(self)
        self._turns.setSingleShot(True)
        self._turns.setInterval(TURNS_WITHIN_MS)
        self._turns.timeout.connect(guarded(self._restart))

    def prepare(self) -> None:
        """Start the process, so that the first question need not wait for it."""
        if not self._questioner.begun:
            self._questioner.ask({"mark": 0, "parts": {}, "compiled": not jit_guard.compiling_elsewhere})

    def ask(self, who: Any, asked: CutRequest) -> None:
        """Ask for `who`, in place of its earlier request."""
        same = who in self._asked and self._asked[who].parts.keys() == asked.parts.keys()
        self._asked[who] = asked
        goes_before = self._current in self._asked and self._asked[self._current].can_wait and not asked.can_wait
        if self._current is None or (self._current == who and not same) or (goes_before and self._current != who):
            self._send(who)

    def forget(self, who: Any) -> None:
        """Answer one no more."""
        if self._asked.pop(who, None) is not None and self._current == who:
            self._go_on(outdated=True)

    def _go_on(self, outdated: bool = False) -> None:
        """Turn to the next who asks; outdated: the process still works on something that nobody wants."""
        self._current = None
        if self._asked:
            self._send(min(self._asked, key=lambda who: self._asked[who].can_wait))
        elif outdated:
            self._mark += 1
            self._write({})

    def _send(self, who: Any) -> None:
        self._current = who
        self._mark += 1
        self._write(self._asked[who].parts)

    def _write(self, parts: Parts) -> None:
        begun = self._questioner.begun
        self._questioner.ask({"mark": self._mark, "parts": parts, "compiled": not jit_guard.compiling_elsewhere})
        if begun and self._heard:  # it may still be loading what it needs, which is no reason to end it
            self._turns.start()

    def _on_message(self, told: dict[str, Any]) -> None:
        self._heard = True
        if "key" in told:
            result_cache.take(told["key"], told["answer"])
        elif told.get("begun") == self._mark:
            self._turns.stop()
        elif "stage" in told and self._current in self._asked:
            self._asked[self._current].stage(STAGES[told["stage"]])
        elif told.get("done") == self._mark:
            self._finish()

    def _finish(self) -> None:
        """Tell the one whose question is answered, when the next one's is on its way."""
        asked = self._asked.pop(self._current, None)
        self._go_on()
        if asked is not None:
            asked.answered()

    def _restart(self) -> None:
        """End the process, which works on for nobody, and ask the newest question of another."""
        self._questioner.end()
        self._heard = False
        if self._current in self._asked:
            self._send(self._current)

    def _lost(self, error: CNCStepperError) -> None:
        """Take the process' end for the answer to what it was working on."""
        self._turns.stop()
        self._heard = False
        self.unavailable = isinstance(error, MissingPackage)
        for key in self._asked[self._current].parts if self._current in self._asked else ():
            if not self.unavailable and result_cache.may_ask(key):
                result_cache.keep(key, error)
        self._finish()


_process: CutProcess | None = None


def process() -> CutProcess:
    """Return the window's one process for cuts; it starts with the first question."""
    global _process
    if _process is None:
        _process = CutProcess(QtCore.QCoreApplication.instance())
    return _process
