# SPDX-License-Identifier: LGPL-2.1-or-later
"""One run of `workers/package_installer.py`, beside the window."""

from __future__ import annotations

import platform
import shutil
from collections.abc import Sequence
from concurrent.futures import Future
from pathlib import Path
from typing import Any

from PySide import QtCore

from CNCStepper.control.processes.background_thread import in_background
from CNCStepper.control.processes.bootstrap import python_version
from CNCStepper.control.processes.python_finder import command
from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.installation.pip_messages import failure
from CNCStepper.workbench.installation.pip_python import find_pip_python
from CNCStepper.workbench.services.background_process import Worker, start_worker
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workers.package_installer import installation_arguments, part_folder

WORKER = "CNCStepper.workers.package_installer"
LOOK_EVERY_MS = 50


class Installation(QtCore.QObject):
    """said: sent with each line of pip's. ended: sent at the end, with the CNCStepperError of a failure or None.

    source: a folder or zip with wheels; None: Python's package index.
    """

    said = QtCore.Signal(str)
    ended = QtCore.Signal(object)

    def __init__(self, target: Path, requirements: Sequence[str], source: Path | None, parent: Any = None):
        super().__init__(parent)
        self._target, self._source = target, source
        self._arguments = installation_arguments(target, requirements, source, "" if source else proxy())
        self._lines: list[str] = []
        self._process: Worker | None = None
        self._python: Future[str] = in_background(lambda: find_pip_python(python_version()))
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(LOOK_EVERY_MS)
        self._timer.timeout.connect(guarded(self._look))
        self._timer.start()
        QtCore.QCoreApplication.instance().aboutToQuit.connect(self.cancel)

    def cancel(self) -> None:
        """End it; nothing of it is in the folder then, and no further signals are sent."""
        self._timer.stop()
        process, self._process = self._process, None
        if process is not None:
            process.stop()
            part = part_folder(self._target, process.pid)
            in_background(lambda: shutil.rmtree(part, ignore_errors=True))

    def _look(self) -> None:
        """Start the process as soon as its Python is found."""
        if not self._python.done():
            return
        self._timer.stop()
        try:
            words = command(self._python.result(), WORKER, *self._arguments)
            self._process = start_worker(self, words, guarded(self._heard), guarded(self._over))
        except CNCStepperError as error:
            self.ended.emit(error)

    def _heard(self) -> None:
        while self._process is not None and (line := self._process.line()):
            self._lines.append(line.decode("utf-8", "replace").rstrip())
            self.said.emit(self._lines[-1])

    def _over(self) -> None:
        process, self._process = self._process, None
        if process is None:
            return
        error = None
        if process.status:
            complaints = process.complaints()
            self.said.emit(complaints)
            output = "\n".join([*self._lines, complaints])
            error = failure(output, python_version(), platform.system(), self._source is not None)
        process.deleteLater()
        self.ended.emit(error)


def proxy() -> str:
    """Return the proxy that FreeCAD's Addon Manager was told to use, "": the system's, which pip finds itself."""
    import FreeCAD

    stored = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Addons")
    if stored.GetString("proxy_type", "") == "custom":  # FreeCAD 1.1
        return f"http://{stored.GetString('proxy_host', '')}:{stored.GetInt('proxy_port', 8080)}"
    return stored.GetString("ProxyUrl", "") if stored.GetBool("UserProxyCheck", False) else ""
