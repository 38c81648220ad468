# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tools that FreeCAD has pasted along with operations, which use those of their originals: they go when all is pasted.

While FreeCAD pastes nothing can be deleted, so that this is a transaction of its own; undo and redo take it together
with the paste.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from CNCStepper.workbench.document import undo_steps
from CNCStepper.workbench.features.base import is_job
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr

_titles: set[str] = set()  # of the transactions that took tools away, in the languages that there were


def remove_soon(tool: Any) -> None:
    """Delete a tool that no operation uses, as soon as FreeCAD has pasted; without a window it stays."""
    import FreeCAD

    if FreeCAD.GuiUp:
        from PySide import QtCore

        QtCore.QTimer.singleShot(0, guarded(partial(_remove, tool.Document.Name, tool.Name)))


def _remove(document_name: str, name: str) -> None:
    import FreeCAD

    document = FreeCAD.listDocuments().get(document_name)
    tool = document.getObject(name) if document is not None else None
    if tool is None or any(not is_job(user) for user in tool.InList):
        return
    title = tr("Use the tool of the job")
    _titles.add(title)
    undo_steps.begin(document, title)
    for job in tool.InList:
        job.Tools = [other for other in job.Tools if other is not tool]
    document.removeObject(name)
    document.commitTransaction()


def follow_undo(document: Any) -> None:
    """Undo the paste too, where the tool that it brought along has just come back."""
    if document.RedoNames and document.RedoNames[0] in _titles:
        _soon(document.undo)


def follow_redo(document: Any) -> None:
    """Take the pasted tool away again, where the paste has just been done again."""
    if document.RedoNames and document.RedoNames[0] in _titles:
        _soon(document.redo)


def _soon(act: Callable[[], Any]) -> None:
    from PySide import QtCore

    QtCore.QTimer.singleShot(0, guarded(lambda: act()))  # FreeCAD's own functions have no signature to look at
