# SPDX-License-Identifier: LGPL-2.1-or-later
"""The left mouse button and a few keys of one 3D view, taken before FreeCAD's navigation sees them.

Some navigation styles turn or pan the view with the left button before the scene gets any event; what a
filter of Qt takes reaches none of them. Everything that a mode does not want goes on to FreeCAD.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from PySide import QtCore

from CNCStepper.workbench.freehand.stroke import Point
from CNCStepper.workbench.tell import guarded

if TYPE_CHECKING:
    from CNCStepper.workbench.freehand.mode import Mode

TYPE = QtCore.QEvent.Type
PRESSES = (TYPE.MouseButtonPress, TYPE.MouseButtonDblClick)
LEFT = QtCore.Qt.MouseButton.LeftButton
SHIFT = QtCore.Qt.KeyboardModifier.ShiftModifier
OTHERS = QtCore.Qt.KeyboardModifier.ControlModifier | QtCore.Qt.KeyboardModifier.AltModifier
KEYS = {
    QtCore.Qt.Key.Key_Escape: "escape",
    QtCore.Qt.Key.Key_Return: "enter",
    QtCore.Qt.Key.Key_Enter: "enter",
    QtCore.Qt.Key.Key_Delete: "delete",
    QtCore.Qt.Key.Key_Backspace: "delete",
}


class Pointer(QtCore.QObject):
    """Hands a view's left button and keys to a mode, from `take` to `give_back`."""

    def __init__(self, view: Any, mode: Mode):
        super().__init__()
        self._mode = mode
        self._widget = view.graphicsView()
        self._holds = False  # the press was taken, so the release belongs to us as well

    def take(self) -> None:
        """Begin: the view gets the keyboard and a cross for its pointer."""
        for widget in (self._widget, self._widget.viewport()):
            widget.installEventFilter(self)
        self._widget.viewport().setCursor(QtCore.Qt.CursorShape.CrossCursor)
        self._widget.setFocus()
        self._widget.destroyed.connect(self._gone)

    def give_back(self) -> None:
        """End; a view that was closed meanwhile has nothing to be given back."""
        widget, self._widget = self._widget, None
        if widget is not None:
            widget.destroyed.disconnect(self._gone)
            widget.viewport().unsetCursor()
            for filtered in (widget, widget.viewport()):
                filtered.removeEventFilter(self)

    def _gone(self) -> None:
        self._widget = None
        self._mode.leave()

    def eventFilter(self, _widget: QtCore.QObject, event: QtCore.QEvent) -> bool:
        """Return whether the event ends here; Qt calls this."""
        return bool(self._taken(event))

    @guarded
    def _taken(self, event: QtCore.QEvent) -> bool:
        kind = event.type()
        if self._widget is None:
            return False
        if kind in (TYPE.ShortcutOverride, TYPE.KeyPress):
            return self._key(event, kind)
        if kind in PRESSES and event.button() == LEFT and event.buttons() == LEFT and not event.modifiers() & OTHERS:
            self._holds = self._mode.pressed(self._pixel(event), bool(event.modifiers() & SHIFT))
            return self._holds
        if kind == TYPE.MouseMove and (self._holds or not event.buttons()):
            return self._mode.moved(self._pixel(event), bool(event.modifiers() & SHIFT)) and self._holds
        if kind == TYPE.MouseButtonRelease and event.button() == LEFT and self._holds:
            self._holds = False
            return self._mode.released(self._pixel(event))
        return False

    def _key(self, event: QtCore.QEvent, kind: QtCore.QEvent.Type) -> bool:
        """Take a key that the mode wants; first of all from the shortcuts, where Delete would delete the object."""
        key = KEYS.get(event.key(), "")
        if not key or not self._mode.wants(key):
            return False
        if kind == TYPE.KeyPress:
            self._mode.key(key)
        event.accept()
        return True

    def _pixel(self, event: QtCore.QEvent) -> Point:
        place = event.position() if hasattr(event, "position") else event.localPos()
        viewport = self._widget.viewport()
        scale = viewport.devicePixelRatioF()
        return (place.x() * scale, (viewport.height() - 1 - place.y()) * scale)
