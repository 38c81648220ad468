# SPDX-License-Identifier: LGPL-2.1-or-later
"""The editors in FreeCAD's window: one dock for each text, one behind the other; none goes with something unsaved.

An editor stays in front while a person works at the machine or in the 3D view. A click in the tree, or another
selection than when they turned to the editor, puts the job in front again; another tab before it, the editor of that
tab.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import FreeCADGui
from PySide import QtCore, QtGui

from CNCStepper.workbench.editor import active_program
from CNCStepper.workbench.editor.panel import EditorPanel
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.command import look_again
from CNCStepper.workbench.services.translation import tr

TREE = "Gui::TreeWidget"
NAME = "CNCStepper_Editor_dock"
WIDTH = 430
TAKE_THE_FRONT = ("CNCStepper_Simulate", "CNCStepper_Send")  # the commands whose tooltips name the program in front


class ActiveEditor:
    """Follows the keyboard's focus; changed: called when another editor, or the tree, is in front."""

    def __init__(self, changed: Callable[[], None]) -> None:
        self._changed = changed
        self._dock: Any = None
        self._selected: list[str] = []  # when a person turned to that editor
        self._focus_moves = messages.guarded(self._focus_moved)
        QtGui.QApplication.instance().focusChanged.connect(self._focus_moves)

    def end(self) -> None:
        """Follow no more: FreeCAD quits."""
        QtGui.QApplication.instance().focusChanged.disconnect(self._focus_moves)

    def turn_to(self, dock: Any) -> None:
        """Put an editor's dock in front; None: the tree."""
        is_new, self._dock = dock is not self._dock, dock
        self._selected = selected() if dock is not None else []
        if is_new:
            self._changed()

    def leave(self, dock: Any) -> None:
        """Let go of a dock that closes."""
        if dock is self._dock:
            self.turn_to(None)

    def dock(self, shown: list[Any]) -> Any:
        """Return the dock in front, of those that there are; None where the tree counts."""
        if self._dock is None or self._dock not in shown or selected() != self._selected:
            return None
        return self._dock if is_seen(self._dock) else next(filter(is_seen, shown), None)

    def _focus_moved(self, _: Any, now: Any) -> None:
        """Follow the focus; runs for every change of it in FreeCAD.

        No widget is asked for its parents: PySide2 keeps those that FreeCAD has made beyond their deletion, and takes
        what comes to lie at their place in memory for them.
        """
        if now is None:
            return
        dock = next((dock for dock in _docks if dock.isAncestorOf(now)), None)
        if dock is not None or class_in_qt(now) == TREE:
            self.turn_to(dock)


def class_in_qt(widget: Any) -> str:
    """Return the name of a widget's class in Qt, "" for one that PySide2 takes for a dead one."""
    try:
        return str(widget.metaObject().className())
    except RuntimeError:
        return ""


def selected() -> list[str]:
    """Return the names of the objects that are selected in all documents."""
    return sorted(f"{part.DocumentName}#{part.ObjectName}" for part in FreeCADGui.Selection.getSelectionEx("*"))


def is_seen(dock: Any) -> bool:
    """Return whether a dock is shown, and not behind another tab."""
    return bool(dock.isVisible() and not dock.visibleRegion().isEmpty())


class EditorDock(QtGui.QDockWidget):
    """The dock of one text."""

    def __init__(self, source: Any, window: Any):
        panel = EditorPanel(source)
        super().__init__(window)
        self.setObjectName(NAME)
        self.panel = panel
        self.setWidget(self.panel)
        self.panel.title_changed.connect(messages.guarded(self._name))
        self._name()

    def closeEvent(self, event: Any) -> None:
        """Close, unless the user cancels because of unsaved text."""
        if not messages.guarded(self.panel.may_close)():
            event.ignore()
            return
        self.panel.end()
        if self in _docks:
            _docks.remove(self)
        for front in _front:
            front.leave(self)
        super().closeEvent(event)
        self.deleteLater()

    def sizeHint(self) -> Any:
        """Return a comfortable size."""
        return QtCore.QSize(WIDTH, 600)

    def _name(self) -> None:
        self.setWindowTitle(tr("Program: {0}").format(self.panel.title))


class ClosingGuard(QtCore.QObject):
    """Asks about every unsaved text before FreeCAD's window closes."""

    def __init__(self, window: Any):
        super().__init__(window)
        self._window = window
        window.installEventFilter(self)
        QtCore.QCoreApplication.instance().aboutToQuit.connect(self._quit)

    def eventFilter(self, watched: Any, event: Any) -> bool:
        """Keep the window open when the user cancels the closing."""
        if not isinstance(event, QtCore.QEvent) or event.type() != QtCore.QEvent.Type.Close:
            return False  # PySide2 may take an event for a deleted object that lay at its address
        for dock in docks():
            if not messages.guarded(dock.panel.may_close)():
                event.ignore()
                return True
        return False

    def _quit(self) -> None:
        self._window.removeEventFilter(self)
        _front.pop().end()
        for dock in docks():
            dock.panel.end()


_guard: list[ClosingGuard] = []
_front: list[ActiveEditor] = []
_docks: list[EditorDock] = []


def docks() -> list[EditorDock]:
    """Return the docks of all texts that are being edited."""
    return list(_docks)


def dock_in_front() -> EditorDock | None:
    """Return the dock of the editor in front, None where a person has turned to the tree since, or there is none."""
    return _front[0].dock(docks()) if _front else None


active_program.dock_in_front = dock_in_front


def open_source(source: Any) -> EditorDock:
    """Show the editor of a source in front; one that is open already is shown as it is."""
    window = FreeCADGui.getMainWindow()
    if not _guard:
        _guard.append(ClosingGuard(window))
        _front.append(ActiveEditor(lambda: look_again(*TAKE_THE_FRONT)))
    others = docks()
    dock = next((dock for dock in others if dock.panel.source.key == source.key), None)
    if dock is None:
        dock = EditorDock(source, window)
        _docks.append(dock)
        window.addDockWidget(QtCore.Qt.DockWidgetArea.RightDockWidgetArea, dock)
        if others:
            window.tabifyDockWidget(others[-1], dock)
        else:  # Qt would forget the width at the next change of anything else in the window
            window.resizeDocks([dock], [WIDTH], QtCore.Qt.Orientation.Horizontal)
    dock.show()
    dock.raise_()
    dock.panel.edit.setFocus()
    _front[0].turn_to(dock)
    return dock
