# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tooltip of an object in the tree that has a problem: FreeCAD itself has none for it."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.features.base import problem_of
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import polled
from CNCStepper.workbench.viewproviders import tree_drag_and_drop


def install() -> None:
    """Let FreeCAD's trees say what is wrong with an object of ours under the pointer, and drags keep jobs whole."""
    import FreeCADGui
    from PySide import QtGui

    window = FreeCADGui.getMainWindow()
    tips = _make_filter(window)
    for tree in window.findChildren(QtGui.QTreeWidget):
        if tree.metaObject().className() == "Gui::TreeWidget":
            tree.viewport().installEventFilter(tips)
            tree_drag_and_drop.install(tree.viewport())


def problem_at(item: Any) -> str:
    """Return the problem of the object that a row of the tree shows, "" when there is none.

    A row knows only the labels; where two objects share one, the first that has a problem speaks.
    """
    import FreeCAD

    lineage = []
    while item is not None:
        lineage.append(item.text(0))
        item = item.parent()
    documents = [document for document in FreeCAD.listDocuments().values() if document.Label in lineage[1:]]
    found = (problem_of(obj) for document in documents for obj in document.getObjectsByLabel(lineage[0]))
    return translated(next(filter(None, found), "")) if lineage else ""


def _make_filter(parent: Any) -> Any:
    """Return the filter; its class is made here because Qt is loaded only with a window."""
    from PySide import QtCore, QtGui

    class Tips(QtCore.QObject):
        """Shows the problem when Qt asks the tree for a tooltip."""

        def eventFilter(self, viewport: Any, event: Any) -> bool:
            """Return whether the tooltip is shown here."""
            if not isinstance(event, QtCore.QEvent) or event.type() != QtCore.QEvent.Type.ToolTip:
                return False  # PySide2 may take an event for a deleted object that lay at its address
            return bool(self.show(viewport, event))

        @polled
        def show(self, viewport: Any, event: Any) -> bool:
            """Show the problem of the object under the pointer, and return whether it has one."""
            problem = problem_at(viewport.parent().itemAt(event.pos()))
            if problem:
                QtGui.QToolTip.showText(event.globalPos(), problem, viewport)
            return bool(problem)

    return Tips(parent)
