# SPDX-License-Identifier: LGPL-2.1-or-later
"""Buttons side by side, in as many lines as the width needs: a theme or a language may make them wider than a dock."""

from __future__ import annotations

from typing import Any

from PySide import QtCore, QtGui

BETWEEN_PX = 3


class ButtonRow(QtGui.QWidget):
    """The row; buttons are added from left to right."""

    def __init__(self, parent: Any):
        super().__init__(parent)
        self._buttons: list[Any] = []
        policy = QtGui.QSizePolicy(QtGui.QSizePolicy.Policy.Preferred, QtGui.QSizePolicy.Policy.Minimum)
        policy.setHeightForWidth(True)
        self.setSizePolicy(policy)

    def add(self, button: Any) -> Any:
        """Add a button at the end, and return it."""
        button.setParent(self)
        self._buttons.append(button)
        self.updateGeometry()
        return button

    def sizeHint(self) -> Any:
        """Return the room of all buttons in one line; Qt asks."""
        widths_px = [_width_px(button) for button in self._buttons]
        return QtCore.QSize(sum(widths_px) + BETWEEN_PX * max(len(widths_px) - 1, 0), self._line_px())

    def minimumSizeHint(self) -> Any:
        """Return the room of the widest button; Qt asks."""
        return QtCore.QSize(max(map(_width_px, self._buttons), default=0), self._line_px())

    def heightForWidth(self, width_px: int) -> int:
        """Return how high its lines are together at a width; Qt asks."""
        count = len(self._lines(width_px))
        return count * self._line_px() + max(count - 1, 0) * BETWEEN_PX

    def resizeEvent(self, event: Any) -> None:
        """Divide the buttons into lines anew; Qt calls this."""
        super().resizeEvent(event)
        self._place()

    def event(self, event: Any) -> bool:
        """Follow a button that has become wider, as with other letters; Qt calls this."""
        if event.type() == QtCore.QEvent.Type.LayoutRequest:
            self.updateGeometry()
            self._place()
        return bool(super().event(event))

    def _line_px(self) -> int:
        return max((int(button.sizeHint().height()) for button in self._buttons), default=0)

    def _lines(self, width_px: int) -> list[list[Any]]:
        """Return the buttons line by line, each line as full as it can be."""
        lines: list[list[Any]] = []
        left_px = 0
        for button in self._buttons:
            left_px -= BETWEEN_PX + _width_px(button)
            if not lines or left_px < 0:
                lines.append([])
                left_px = width_px - _width_px(button)
            lines[-1].append(button)
        return lines

    def _place(self) -> None:
        """Let the buttons of each line share its width."""
        height_px = self._line_px()
        for number, line in enumerate(self._lines(self.width())):
            x_px, spare_px = 0, self.width() - sum(map(_width_px, line)) - BETWEEN_PX * (len(line) - 1)
            for after, button in zip(range(len(line), 0, -1), line, strict=True):
                width_px = _width_px(button) + spare_px // after
                spare_px -= spare_px // after
                button.setGeometry(x_px, number * (height_px + BETWEEN_PX), width_px, height_px)
                x_px += width_px + BETWEEN_PX


def _width_px(button: Any) -> int:
    return int(button.sizeHint().width())
