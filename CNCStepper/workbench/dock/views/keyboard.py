# SPDX-License-Identifier: LGPL-2.1-or-later
"""The keyboard in the dock: keys act only on the dock's controls, and only a person moves the focus.

key ──► the control with the focus ──► what it leaves, the dock takes: no shortcut of FreeCAD acts on the tree
a control that is disabled or hidden ──► the focus goes to what contains it: no other control gets it by itself

Qt alone would give the focus to the next control that is enabled: to Stop, once Hold was pressed. And on X11 it takes a
key that is held for one that is pressed again and again, when it reads a repetition's release before its press.
"""

from __future__ import annotations

from typing import Any

from PySide import QtCore, QtGui

KEY, MODIFIER = QtCore.Qt.Key, QtCore.Qt.KeyboardModifier
OF_SHORTCUTS = (MODIFIER.ControlModifier, MODIFIER.AltModifier, MODIFIER.MetaModifier)
SAME_MS = 5  # between a release and a press, of one repetition; no finger is that quick
KEYS_OF_THE_WINDOW = (*(getattr(KEY, f"Key_F{number}") for number in range(1, 13)),)  # such as F1 for help


class Repeats:
    """Tells the presses of a key that is held from those of a finger, also where the focus moves meanwhile."""

    def __init__(self) -> None:
        self._released_ms: dict[int, int] = {}  # when each key was released last, by the clock of its events

    def note_release(self, event: Any) -> None:
        """Note when a key was released."""
        self._released_ms[event.key()] = event.timestamp()

    def is_repeat(self, event: Any) -> bool:
        """Return whether a press is the repetition of a key that is held."""
        before_ms = self._released_ms.get(event.key())
        after_ms = -1 if before_ms is None else event.timestamp() - before_ms
        return bool(event.isAutoRepeat()) or 0 <= after_ms <= SAME_MS


REPEATS = Repeats()  # of the one keyboard


class KeyButton(QtGui.QPushButton):
    """A button that a key presses once, however long it is held."""

    def keyPressEvent(self, event: Any) -> None:
        """Take a press, unless it is a repetition."""
        if not REPEATS.is_repeat(event):
            super().keyPressEvent(event)

    def keyReleaseEvent(self, event: Any) -> None:
        """Take a release."""
        REPEATS.note_release(event)
        super().keyReleaseEvent(event)


class KeyboardArea(QtGui.QWidget):
    """A widget that keeps the keys that are pressed in it, and its focus where a person has put it."""

    def event(self, event: Any) -> bool:
        """Take a key before a shortcut of the window does."""
        if event.type() == QtCore.QEvent.Type.ShortcutOverride and stays_here(event):
            event.accept()
            return True
        return bool(super().event(event))

    def keyPressEvent(self, event: Any) -> None:
        """Take a key that no control in here wanted."""
        if not stays_here(event):
            super().keyPressEvent(event)

    def keyReleaseEvent(self, event: Any) -> None:
        """Take its release, too."""
        REPEATS.note_release(event)
        if not stays_here(event):
            super().keyReleaseEvent(event)

    def focusNextPrevChild(self, forward: bool) -> bool:
        """Move the focus for Tab; Qt asks for this as well when the control with the focus is disabled or hidden."""
        left = self.window().focusWidget()
        if left is None or left is self or not self.isAncestorOf(left) or can_be_used(left):
            return bool(super().focusNextPrevChild(forward))
        self._container_of(left).setFocus()
        return True

    def _container_of(self, left: Any) -> Any:
        """Return the nearest widget around one that can still have the focus."""
        place = left.parentWidget()
        while place is not self and not can_be_used(place):
            place = place.parentWidget()
        return place


def can_be_used(widget: Any) -> bool:
    """Return whether a widget is enabled and shown."""
    return bool(widget.isEnabled() and widget.isVisible())


def stays_here(event: Any) -> bool:
    """Return whether a key is for what has the focus: one without Ctrl, Alt or Meta, and no function key."""
    modified = any(bool(event.modifiers() & modifier) for modifier in OF_SHORTCUTS)
    return not modified and event.key() not in KEYS_OF_THE_WINDOW
