# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jogging by keys: the arrow keys are the pad's arrows while a button that was switched on has the keyboard.

off ──► a click or Space ──► on: an arrow is down as long as its key is ──► the focus goes anywhere else ──► off
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from PySide import QtCore

from CNCStepper.workbench.dock.views import widgets
from CNCStepper.workbench.dock.views.keyboard import REPEATS, KeyButton
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr

KEY = QtCore.Qt.Key
ARROWS = {  # each key with the name of its arrow in the pad
    KEY.Key_Left: "XMinus",
    KEY.Key_Right: "XPlus",
    KEY.Key_Down: "YMinus",
    KEY.Key_Up: "YPlus",
    KEY.Key_PageDown: "ZMinus",
    KEY.Key_PageUp: "ZPlus",
}
RELEASED_MS = 30  # after a release: X may send one in each repetition of a key that is held, with a press behind it


class JogKeys(KeyButton):
    """The button; `arrows` are those of the pad, by their names."""

    def __init__(self, arrows: Mapping[str, Any]):
        super().__init__(tr("Jog by keys"))
        widgets.named(self, "JogKeys")
        self.setCheckable(True)
        self.setToolTip(
            tr(
                "While this is pressed in and has the keyboard, the arrow keys move X and Y, and Page up and Page down "
                "move Z. A click or Tab to anything else switches it off and stops the motion."
            )
        )
        self._arrows, self._down = arrows, KEY.Key_unknown
        self._released = QtCore.QTimer(self)
        self._released.setSingleShot(True)
        self._released.setInterval(RELEASED_MS)
        self._released.timeout.connect(guarded(self._let_go))
        self.toggled.connect(guarded(self._let_go))

    def keyPressEvent(self, event: Any) -> None:
        """Press the arrow of a key; a key that is held presses it once."""
        key = event.key()
        if not self.isChecked() or key not in ARROWS:
            super().keyPressEvent(event)
        elif key == self._down:
            self._released.stop()
        elif not REPEATS.is_repeat(event):
            self._let_go()
            self._press(key)

    def keyReleaseEvent(self, event: Any) -> None:
        """Let go of the arrow of a key, unless its repetition presses it again."""
        super().keyReleaseEvent(event)
        if event.key() == self._down and not event.isAutoRepeat():
            self._released.start()

    def focusOutEvent(self, event: Any) -> None:
        """Let go and switch off: keys are another widget's now."""
        self.setChecked(False)
        super().focusOutEvent(event)

    def _press(self, key: Any) -> None:
        arrow = self._arrows[ARROWS[key]]
        if arrow.isEnabled():
            self._down = key
            arrow.setDown(True)
            arrow.pressed.emit()

    def _let_go(self) -> None:
        """Let go of the arrow that is down."""
        self._released.stop()
        key, self._down = self._down, KEY.Key_unknown
        if key in ARROWS:
            arrow = self._arrows[ARROWS[key]]
            arrow.setDown(False)
            arrow.released.emit()
