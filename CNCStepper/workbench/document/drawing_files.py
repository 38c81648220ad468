# SPDX-License-Identifier: LGPL-2.1-or-later
"""Imported drawings and their files: read at once or beside the window, and looked at for changes.

read_now(obj)                          scripts, without a window: waits
Reading(obj, …).begin()                the window: a process reads, the objects are made a little at a time
watch()                                once a second a thread looks at the files of all open documents
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from pathlib import Path
from typing import Any

from CNCStepper.control.processes.background_thread import in_background
from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.document import undo_steps
from CNCStepper.workbench.document.drawing_work import DrawingWork
from CNCStepper.workbench.features.base import proxy_type
from CNCStepper.workbench.features.drawings.drawing import (
    CHANGED,
    CURRENT,
    MISSING,
    Drawing,
    applied,
    form_of,
    path_of,
    question_of,
    set_state,
    state_of,
)
from CNCStepper.workbench.services.messages import guarded, note, polled
from CNCStepper.workbench.services.translation import tr

Looked = tuple[tuple[str, str], Any, str]  # document and name of an object, its FileState when it was read, the new one
LOOK_EVERY_MS = 1000
STEP_S = 0.01  # so long are objects made before the window sees to its events
DONE = object()


def read_now(obj: Any) -> None:
    """Read the file of a drawing into its group; raises JobError, and then changes nothing."""
    from CNCStepper.job.drawings.imported_drawing import read_imported

    form, limits = form_of(obj)
    for _ in applied(obj, read_imported(path_of(obj), form, limits)):
        pass


def look_now(obj: Any) -> str:
    """Return whether the file of a drawing is as it was read, and say so at the object."""
    state = _looked_at(path_of(obj), state_of(obj))
    if state:
        set_state(obj, state)
    return str(obj.FileState)


def _looked_at(path: Path, state: Any) -> str:
    """Return the state of a file, "" where nothing was read from it."""
    from CNCStepper.job.drawings.linked_file import has_changed

    if state is None:
        return ""
    try:
        return CHANGED if has_changed(path, state) else CURRENT
    except CNCStepperError:  # not there, or not to be read now
        return MISSING


class Reading(DrawingWork):
    """One reading of a drawing's file beside the window; after a refusal nothing has changed."""

    _steps: Iterator[None] | None = None

    def question(self) -> dict[str, Any]:
        """Return what the process is asked; raises JobError for a bad option."""
        return question_of(self.obj)

    def take(self, answer: dict[str, Any]) -> None:
        """Make the objects of what was read."""
        from CNCStepper.job.drawings.imported_drawing import unpacked

        self._steps = applied(self.obj, unpacked(answer))
        self._step()

    def _step(self) -> None:
        """Make some objects, and more when the window has seen to its events."""
        from PySide import QtCore

        if self._steps is None or not self.goes_on:
            return
        until_s = time.perf_counter() + STEP_S
        try:
            while time.perf_counter() < until_s:
                if next(self._steps, DONE) is DONE:
                    self.finish()
                    return
        except CNCStepperError as error:
            self.refuse(error)
            return
        QtCore.QTimer.singleShot(0, guarded(self._step))


def ask_file(folder: str, take: Callable[[str], None]) -> None:
    """Ask for the file of a drawing, first in a folder, and return at once; `take` is called with the file."""
    import FreeCADGui
    from PySide import QtCore, QtGui

    from CNCStepper.job.drawings.read_any import ALL_READERS

    endings = " ".join(f"*{suffix} *{suffix.upper()}" for suffix in ALL_READERS)
    dialog = QtGui.QFileDialog(FreeCADGui.getMainWindow(), tr("Import drawing"), folder)
    dialog.setObjectName("CNCStepper_Import_drawing")
    dialog.setFileMode(QtGui.QFileDialog.FileMode.ExistingFile)
    dialog.setNameFilters([tr("Drawings ({0})").format(endings), tr("All files ({0})").format("*")])
    dialog.setOption(QtGui.QFileDialog.Option.HideNameFilterDetails)
    dialog.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
    dialog.fileSelected.connect(guarded(take))
    dialog.open()


_readings: list[Reading] = []


def reload(obj: Any) -> None:
    """Read the file of a drawing again, as one undo step of its own; a refusal is shown and changes nothing."""
    from CNCStepper.workbench.services import messages

    document = obj.Document
    undo_steps.begin(document, tr("Reload {0}").format(obj.Label))

    def done() -> None:
        document.commitTransaction()
        document.recompute()
        note(tr("{0} is as its file again").format(obj.Label))
        _readings.clear()

    def failed(error: CNCStepperError) -> None:
        document.abortTransaction()
        _readings.clear()
        messages.error(error)

    reading = Reading(obj, done, failed)
    _readings[:] = [reading]
    try:
        reading.begin()
    except CNCStepperError:
        document.abortTransaction()
        raise


class _Watch:
    """The one look at the files of all open documents."""

    def __init__(self) -> None:
        from PySide import QtCore

        self._future: Future[list[Looked]] | None = None
        self._timer = QtCore.QTimer(QtCore.QCoreApplication.instance())
        self._timer.setInterval(LOOK_EVERY_MS)
        self._timer.timeout.connect(polled(self._look))
        self._timer.start()

    def _look(self) -> None:
        """Say what the thread has found, and let it look again."""
        if self._future is not None:
            if not self._future.done():
                return
            future, self._future = self._future, None
            _tell(future.result())
        drawings = [((obj.Document.Name, obj.Name), path_of(obj), state_of(obj)) for obj in drawings_of_all()]
        if drawings:
            self._future = in_background(
                lambda: [(place, state, _looked_at(path, state)) for place, path, state in drawings]
            )


_watches: list[_Watch] = []


def watch() -> None:
    """Look at the files of imported drawings from now on; again changes nothing."""
    if not _watches:
        _watches.append(_Watch())


def drawings_of_all() -> list[Any]:
    """Return the imported drawings of all open documents."""
    import FreeCAD

    found = (
        obj
        for document in FreeCAD.listDocuments().values()
        for obj in document.findObjects("App::DocumentObjectGroupPython")
    )
    return [obj for obj in found if proxy_type(obj) == Drawing.Type]


def _tell(found: list[Looked]) -> None:
    """Say at the objects, and once in the status bar, which files have changed or are gone.

    One that was read anew meanwhile is looked at again.
    """
    import FreeCAD

    for (document, name), read, state in found:
        obj = FreeCAD.listDocuments()[document].getObject(name) if document in FreeCAD.listDocuments() else None
        if obj is None or not state or obj.FileState == state or state_of(obj) != read:
            continue
        if FreeCAD.getActiveTransaction() is not None:
            continue
        set_state(obj, state)
        if state == CHANGED:
            note(tr("{0}: its file has changed; Reload in the tree takes it anew").format(obj.Label))
        elif state == MISSING:
            note(tr("{0}: its file is not there any more; what was read stays").format(obj.Label))
