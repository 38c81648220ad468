# SPDX-License-Identifier: LGPL-2.1-or-later
"""F1 in our panels, before FreeCAD's own shortcut gets it: the page of the panel opens, at the field with the focus.

    F1 ──► the widget with the focus ──► its parents ──► the first panel with a page ──► the help window
                      └── the first that is the field of a key: the page scrolls to it

A panel gets a page with `attach`; a part of it may have another one with `set_page`, a field its key with `set_key`.
"""

from __future__ import annotations

from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.services.messages import guarded

PAGE, KEY = "CNCStepper_help_page", "CNCStepper_help_key"  # Qt's dynamic properties of a widget


class _F1Filter(QtCore.QObject):
    """Takes F1 that the widgets in a panel have left."""

    def eventFilter(self, watched: Any, event: Any) -> bool:
        """Accept the key before it becomes a shortcut, and open the page when it arrives."""
        kinds = (QtCore.QEvent.Type.ShortcutOverride, QtCore.QEvent.Type.KeyPress)
        if not isinstance(event, QtCore.QEvent) or event.type() not in kinds:
            return False  # PySide2 may take an event for a deleted object that lay at its address
        if event.key() != QtCore.Qt.Key.Key_F1 or event.modifiers() != QtCore.Qt.KeyboardModifier.NoModifier:
            return False
        event.accept()
        if event.type() == QtCore.QEvent.Type.KeyPress:
            guarded(_open)(watched)
        return True


def attach(panel: Any, address: str) -> None:
    """Let F1 in a panel open a page."""
    set_page(panel, address)
    panel.installEventFilter(_F1Filter(panel))


def set_page(widget: Any, address: str) -> None:
    """Give a part of a panel a page of its own."""
    widget.setProperty(PAGE, address)


def set_key(widget: Any, key: str) -> None:
    """Name the field that a widget shows."""
    widget.setProperty(KEY, key)


def _open(panel: Any) -> None:
    """Open the page of what has the focus in a panel; its own where nothing in there has one."""
    from CNCStepper.workbench.help.window import open_help

    address, key = "", ""
    widget = QtGui.QApplication.focusWidget() or panel
    while widget is not None and not address:
        address, key = str(widget.property(PAGE) or ""), key or str(widget.property(KEY) or "")
        widget = None if widget is panel else widget.parentWidget()
    open_help(address or str(panel.property(PAGE)), key)
