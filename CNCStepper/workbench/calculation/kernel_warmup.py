# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compiles the kernels once after an installation, in a background process.

begin() ──► no stamp? ──► workers/kernel_warm_up.py in a Python of FreeCAD's version ──► stamp ──► what had to wait is
made
                          meanwhile kernels run as plain Python (jit_guard.py)
"""

from __future__ import annotations

from concurrent.futures import Future
from importlib.metadata import PackageNotFoundError
from typing import Any

from PySide import QtCore

from CNCStepper.control.processes.bootstrap import python_version
from CNCStepper.control.processes.python_finder import PROOF, command, find_python_in_background
from CNCStepper.dependencies import FAST
from CNCStepper.errors import CNCStepperError, Text
from CNCStepper.workbench import packages
from CNCStepper.workbench.calculation.recompute import remake
from CNCStepper.workbench.features.base import proxy_type
from CNCStepper.workbench.services import jit_guard
from CNCStepper.workbench.services.background_process import Worker, start_worker

WORKER = "CNCStepper.workers.kernel_warm_up"
NEEDS = (*PROOF, FAST)
LOOK_EVERY_MS = 50

_run: KernelWarmup | None = None


class KernelWarmup(QtCore.QObject):
    """One run of the compiling process; `ended` is sent when waiting work may go on."""

    ended = QtCore.Signal()

    def __init__(self, parent: Any = None):
        super().__init__(parent)
        jit_guard.compiling_elsewhere = True
        self._process: Worker | None = None
        self._python: Future[str] = find_python_in_background(NEEDS, python_version())
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(LOOK_EVERY_MS)
        self._timer.timeout.connect(self._look)
        self._timer.start()
        QtCore.QCoreApplication.instance().aboutToQuit.connect(self.cancel)

    def cancel(self) -> None:
        """End the process; what it has compiled is kept."""
        self._timer.stop()
        jit_guard.compiling_elsewhere = False
        process, self._process = self._process, None
        if process is not None:
            process.stop()

    def _look(self) -> None:
        if not self._python.done():
            return
        self._timer.stop()
        try:
            words = command(self._python.result(), WORKER)
            self._process = start_worker(self, words, lambda: None, self._ended)
        except CNCStepperError as error:
            self._end(str(error))

    def _ended(self) -> None:
        if self._process is not None:
            self._end(self._process.complaints())

    def _end(self, said: str) -> None:
        """Let kernels be loaded, or compiled where that failed, and make what had to wait."""
        process, self._process = self._process, None
        if process is not None:
            process.deleteLater()
        jit_guard.compiling_elsewhere = False
        if _cold():
            _log(Text("the kernels were not compiled in advance: {said}", said=said))
        _make_what_waits()
        self.ended.emit()


def begin() -> KernelWarmup | None:
    """Start to compile what is not compiled yet; returns what runs, None where nothing need be."""
    global _run
    if _run is None and QtCore.QCoreApplication.instance() is not None and _cold():
        _run = KernelWarmup(QtCore.QCoreApplication.instance())
    return running()


def running() -> KernelWarmup | None:
    """Return what `begin` has started, None when that has ended."""
    return _run if jit_guard.compiling_elsewhere else None


def are_compiled() -> bool:
    """Return whether numba has compiled all kernels of these sources."""
    return _stamped() is True


def _cold() -> bool:
    """Return whether there is numba and nothing that it has compiled of these sources."""
    packages.make_available()
    return _stamped() is False


def _stamped() -> bool | None:
    """Return whether the stamp is there that all is compiled, None without numba."""
    try:
        from CNCStepper import kernel_cache

        return kernel_cache.stamp().exists()
    except (PackageNotFoundError, ModuleNotFoundError):
        return None


def _make_what_waits() -> None:
    import FreeCAD

    for document in FreeCAD.listDocuments().values():
        waiting = [obj for obj in document.Objects if proxy_type(obj) and _waits(obj)]
        for obj in waiting:
            obj.touch()
        if waiting:
            remake(document)


def _waits(obj: Any) -> bool:
    return obj.Proxy.refusal is not None and obj.Proxy.refusal.code == jit_guard.WAITS


def _log(text: str) -> None:
    import FreeCAD

    FreeCAD.Console.PrintLog(f"CNCStepper: {text}\n")
