# SPDX-License-Identifier: LGPL-2.1-or-later
"""The left mouse button and a few keys of one 3D view, taken before FreeCAD's navigation sees them.

Some navigation styles turn or pan the view with the left button before the scene gets any event; what a
filter of Qt takes reaches none of them. Events that its listener does not use are passed on to FreeCAD.
"""

from __future__ import annotations

from typing import Any, Protocol

from PySide import QtCore

from CNCStepper.workbench.freehand.stroke import Point
from CNCStepper.workbench.services.messages import guarded

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


class Listener(Protocol):
    """A receiver of the left button and of the keys, in pixels of the view; see `Mode`, which is one."""

    def pressed(self, pixel: Point, shift: bool) -> bool:
        """The left button went down; return whether that was meant for the listener, as the next two do."""

    def moved(self, pixel: Point, shift: bool) -> bool:
        """The pointer moved."""

    def released(self, pixel: Point) -> bool:
        """The button that `pressed` took went up."""

    def wants(self, key: str) -> bool:
        """Return whether one of the KEYS would do something now."""

    def key(self, key: str) -> None:
        """Do what a wanted key means."""


class Pointer(QtCore.QObject):
    """Hands a view's left button and keys to a listener, from `take` to `give_back`."""

    def __init__(self, view: Any, listener: Listener):
        super().__init__()
        self._listener = listener
        self._view = view
        self._holds = False  # the press was taken, so the release belongs to us as well

    def _widgets(self) -> list[Any]:
        """Return the view's widgets: the one with the keys and the one with the mouse; [] when the view was closed.

        They are never kept: PySide would hand out a kept one of a closed view for a new one at the same address.
        """
        try:
            keys = self._view.graphicsView()
        except (RuntimeError, ReferenceError):  # as the versions of FreeCAD say that a view is gone
            return []
        return [keys, keys.viewport()]

    def take(self) -> None:
        """Begin: the view gets the keyboard and a cross for its pointer."""
        keys, mouse = self._widgets()
        for widget in (keys, mouse):
            widget.installEventFilter(self)
        mouse.setCursor(QtCore.Qt.CursorShape.CrossCursor)
        keys.setFocus()

    def give_back(self) -> None:
        """End; a view that was closed meanwhile has nothing to be given back."""
        for widget in self._widgets():
            widget.removeEventFilter(self)
            widget.unsetCursor()

    def eventFilter(self, widget: Any, event: QtCore.QEvent) -> bool:
        """Return whether the event ends here; Qt calls this."""
        return bool(self._taken(widget, event))

    @guarded
    def _taken(self, widget: Any, event: QtCore.QEvent) -> bool:
        kind = event.type()
        if kind in (TYPE.ShortcutOverride, TYPE.KeyPress):
            return self._key(event, kind)
        if kind in PRESSES and event.button() == LEFT and event.buttons() == LEFT and not event.modifiers() & OTHERS:
            self._holds = self._listener.pressed(_pixel(widget, event), bool(event.modifiers() & SHIFT))
            return self._holds
        if kind == TYPE.MouseMove and (self._holds or not event.buttons()):
            return self._listener.moved(_pixel(widget, event), bool(event.modifiers() & SHIFT)) and self._holds
        if kind == TYPE.MouseButtonRelease and event.button() == LEFT and self._holds:
            self._holds = False
            return self._listener.released(_pixel(widget, event))
        return False

    def _key(self, event: QtCore.QEvent, kind: QtCore.QEvent.Type) -> bool:
        """Take a key that the listener wants; first of all from the shortcuts, where Delete would delete the object."""
        key = KEYS.get(event.key(), "")
        if not key or not self._listener.wants(key):
            return False
        if kind == TYPE.KeyPress:
            self._listener.key(key)
        event.accept()
        return True


def _pixel(viewport: Any, event: Any) -> Point:
    """Return where a mouse event is, in OpenGL's pixels from the lower left corner."""
    place = event.position() if hasattr(event, "position") else event.localPos()
    scale = viewport.devicePixelRatioF()
    return (place.x() * scale, (viewport.height() - 1 - place.y()) * scale)
