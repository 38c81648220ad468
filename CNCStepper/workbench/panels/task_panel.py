# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of one object: everything between opening it and OK or Cancel is one undo step."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.document import undo_steps
from CNCStepper.workbench.features.base import proxy_type
from CNCStepper.workbench.panels.fields import NAME
from CNCStepper.workbench.panels.object_form import Editor
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.standard_buttons import PanelButtons
from CNCStepper.workbench.services.translation import tr

LOOK_MS, LOOKS = 20, 100  # how often it is looked whether FreeCAD shows the panel, and how many times
TITLE_LETTERS = 20  # of a title in a panel that is as wide as FreeCAD makes it on a small screen


class _UndoObserver:
    """Calls `undone` after each undo and redo in a document: FreeCAD ends the transaction that is open."""

    def __init__(self, document: str, undone: Callable[[], None]):
        import FreeCAD

        self._document, self._undone, self._watches = document, undone, True
        FreeCAD.addDocumentObserver(self)

    def end(self) -> None:
        """Watch no longer."""
        import FreeCAD

        if self._watches:
            self._watches = False
            FreeCAD.removeDocumentObserver(self)

    def slotUndoDocument(self, document: Any) -> None:
        """FreeCAD calls this after an undo."""
        if document.Name == self._document:
            QtCore.QTimer.singleShot(0, self._undone)

    def slotRedoDocument(self, document: Any) -> None:
        """FreeCAD calls this after a redo."""
        self.slotUndoDocument(document)


class Panel(PanelButtons):
    """The interface for FreeCAD's task view; the transaction is open already.

    An undo or redo while the panel is open ends that transaction: what follows belongs to a new one. An object that is
    gone then takes its panel along.
    """

    def __init__(self, obj: Any, editor: Editor):
        self.document, self._name, self._closed = obj.Document.Name, obj.Name, False
        self._undos = _UndoObserver(self.document, guarded(self._begin_again))
        editor.destroyed.connect(self._undos.end)  # FreeCAD may close the panel without OK or Cancel
        self.editors = [editor]
        self.form = editor
        editor.setWindowTitle(_title(editor, obj.Label))
        editor.setWindowIcon(QtGui.QIcon(_icon(obj)))
        editor.setObjectName(f"{NAME}_{proxy_type(obj)}")

    @guarded
    def accept(self) -> bool:
        """Keep all as one undo step, or stay open where something is wrong; FreeCAD calls this for OK."""
        good = [editor.flush() for editor in self.editors]
        if not all(good):
            self._accept_later(good)
            return False
        document = self._document()
        if document is not None:
            document.recompute()  # what of the user's own stands on it
            document.commitTransaction()
        for editor in self.editors:
            editor.stop()
        self._close()
        return True

    def _accept_later(self, good: list[bool]) -> None:
        """Close as with OK as soon as what is being cut is good, where nothing else is in the way."""
        waiting = [editor for editor in self.editors if editor.waiting]
        if len(waiting) == good.count(False):
            for editor in waiting:
                editor.then = self.accept

    @guarded
    def reject(self) -> bool:
        """Leave the document as it was before; FreeCAD calls this for Cancel and Esc."""
        for editor in self.editors:
            editor.stop()
        document = self._document()
        if document is not None:
            document.abortTransaction()
            document.recompute()
        self._close()
        return True

    def focus_first(self) -> None:
        """Take the keyboard into the panel as soon as FreeCAD has shown it, so that Esc and typing go there."""
        self._looks = LOOKS
        self._shown = QtCore.QTimer(self.form)
        self._shown.setInterval(LOOK_MS)
        self._shown.timeout.connect(guarded(self._look_for_focus))
        self._shown.start()

    def _look_for_focus(self) -> None:
        self._looks -= 1
        editor = self.editors[0]
        if editor.isVisible() or not self._looks:
            self._shown.stop()
            if not editor.isAncestorOf(QtGui.QApplication.focusWidget()):  # where a person was quicker, it stays
                editor.form.focus_first()

    def _begin_again(self) -> None:
        document = self._document()
        if self._closed or document is None:
            return
        obj = document.getObject(self._name)
        if obj is None:
            for editor in self.editors:
                editor.stop()
            self._close()
            return
        undo_steps.begin(document, tr("Edit {0}").format(obj.Label))
        for editor in self.editors:
            editor.refresh()
            editor.remake()

    def _document(self) -> Any:
        """Return the object's document, or None when it was closed meanwhile."""
        import FreeCAD

        return FreeCAD.listDocuments().get(self.document)

    def _close(self) -> None:
        import FreeCADGui

        self._closed = True
        self._undos.end()
        if self._document() is not None:
            FreeCADGui.getDocument(self.document).resetEdit()
        FreeCADGui.Control.closeDialog()


def _title(form: Any, label: str) -> str:
    """Return an object's label as a title: FreeCAD makes a panel as wide as its title is."""
    metrics = form.fontMetrics()
    return str(
        metrics.elidedText(label, QtCore.Qt.TextElideMode.ElideRight, TITLE_LETTERS * metrics.averageCharWidth())
    )


def _icon(obj: Any) -> str:
    from CNCStepper.workbench import packages

    return str(packages.ROOT / "resources" / "icons" / f"{proxy_type(obj)}.svg")
