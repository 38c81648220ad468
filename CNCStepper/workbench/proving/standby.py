# SPDX-License-Identifier: LGPL-2.1-or-later
"""A process that has loaded all that a proof needs and waits for its question: Python and kernels take a second.

    view of a job attached ──► prepare() ──► some quiet time ──► the process waits
    ProofRun ──► take() ──► the process, else None; the next one is prepared when that proof is mostly done

A process proves one program and ends, so a cancelled proof never leaves anything to the next one.
"""

from __future__ import annotations

from concurrent.futures import Future
from typing import Any

from PySide import QtCore

from CNCStepper.control.processes.python_finder import PROOF, command, find_python_in_background
from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.services import jit_guard
from CNCStepper.workbench.services.background_process import Worker
from CNCStepper.workbench.services.messages import guarded

WORKER = "CNCStepper.workers.proof"
QUIET_MS = 1000  # between what a person did and the start
NEXT_MS = 4000  # after a process was taken
LOOK_EVERY_MS = 50


class Standby(QtCore.QObject):
    """At most one process that waits; where none can be started the proof itself says why."""

    def __init__(self, parent: Any = None):
        super().__init__(parent)
        self._process: Worker | None = None
        self._ready = False
        self._python: Future[str] | None = None
        self._timer = QtCore.QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(guarded(self._start))
        QtCore.QCoreApplication.instance().aboutToQuit.connect(self.end)

    @property
    def pid(self) -> int | None:
        """The number of the process that waits, None while there is none."""
        return self._process.pid if self._process is not None else None

    @property
    def is_ready(self) -> bool:
        """Whether the process that waits has loaded everything."""
        return self._process is not None and self._ready

    def prepare(self, after_ms: int = QUIET_MS) -> None:
        """Start a process after that time, unless one waits or is on its way."""
        if self._process is None and not self._timer.isActive():
            self._timer.start(after_ms)

    def take(self, parent: QtCore.QObject) -> Worker | None:
        """Give the process that waits to a new owner, and have another one prepared; None where none waits."""
        process, self._process = self._process, None
        if process is not None:
            process.told.disconnect()
            process.ended.disconnect()
            process.setParent(parent)
        self._timer.start(NEXT_MS)
        return process

    def end(self) -> None:
        """End the process that waits."""
        self._timer.stop()
        process, self._process = self._process, None
        if process is not None:
            process.stop()

    def _start(self) -> None:
        """Start a process as soon as its Python is found and no kernel is being compiled."""
        if jit_guard.compiling_elsewhere:
            self._timer.start(NEXT_MS)
            return
        if self._python is None:
            self._python = find_python_in_background(PROOF)
        if not self._python.done():
            self._timer.start(LOOK_EVERY_MS)
            return
        python, self._python = self._python, None
        try:
            self._process = Worker(command(python.result(), WORKER), self)
        except CNCStepperError:
            return  # the proof meets the same and answers with it
        self._ready = False
        self._process.told.connect(self._loaded)
        self._process.ended.connect(guarded(self._lost))

    def _loaded(self) -> None:
        """Take its one line for what it is: everything is loaded."""
        self._ready = self._process is not None and bool(self._process.line())

    def _lost(self) -> None:
        """Forget a process that ended by itself: the next proof starts its own, and answers with what it meets."""
        process, self._process = self._process, None
        if process is not None:
            process.deleteLater()


_standby: Standby | None = None


def prepare() -> None:
    """Have a process wait for this window's next proof soon."""
    global _standby
    if _standby is None:
        _standby = Standby(QtCore.QCoreApplication.instance())
    _standby.prepare()


def take(parent: QtCore.QObject) -> Worker | None:
    """Return the process that waits, which then belongs to `parent`; None where there is none."""
    return _standby.take(parent) if _standby is not None else None
