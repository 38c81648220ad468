# SPDX-License-Identifier: LGPL-2.1-or-later
"""The margin of the editor: line numbers, and a mark at every line that is refused."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.editor.model.error_marks import Marks

LEAST_DIGITS = 3
GAP = 0.6  # of a digit's width: free on both sides of the numbers
MARK = 1.2  # of a digit's width: the mark

SeenLines = Callable[[], Iterable[tuple[int, int, int]]]


class Margin(QtGui.QWidget):
    """The margin at the left of the text of `edit`, which scrolls with it.

    seen_lines: returns number (from 0), top and height in pixels of the lines that are seen.
    """

    def __init__(self, edit: QtGui.QPlainTextEdit, seen_lines: SeenLines, marks: Marks, colours: dict[str, str]):
        super().__init__(edit)
        self.setObjectName("CNCStepper_Editor_margin")
        self._edit = edit
        self._seen_lines = seen_lines
        self._marks = marks
        self.colours = colours

    def wanted_px(self) -> int:
        """Return how wide it must be for the numbers of all lines."""
        digits = max(len(str(self._edit.blockCount())), LEAST_DIGITS)
        return round(self._digit_px() * (digits + 2 * GAP + MARK))

    def paintEvent(self, event: Any) -> None:
        """Draw the numbers that are seen."""
        painter = QtGui.QPainter(self)
        painter.fillRect(event.rect(), QtGui.QColor(self.colours["margin"]))
        painter.setFont(self._edit.font())
        digit_px = self._digit_px()
        width = self.width() - round(GAP * digit_px)
        for number, top, height in self._seen_lines():
            if self._marks.at(number + 1):
                self._mark(painter, digit_px, top, height)
            colour = "wrong" if self._marks.at(number + 1) else "digits"
            painter.setPen(QtGui.QColor(self.colours[colour]))
            painter.drawText(0, top, width, height, QtCore.Qt.AlignmentFlag.AlignRight, str(number + 1))
        painter.end()

    def mousePressEvent(self, event: Any) -> None:
        """Go to the line whose number is clicked."""
        self._edit.setTextCursor(
            self._edit.cursorForPosition(
                QtCore.QPoint(0, round(event.position().y() if hasattr(event, "position") else event.pos().y()))
            )
        )

    def _mark(self, painter: Any, digit_px: float, top: int, height: int) -> None:
        painter.save()
        painter.setRenderHint(QtGui.QPainter.RenderHint.Antialiasing)
        painter.setPen(QtCore.Qt.PenStyle.NoPen)
        painter.setBrush(QtGui.QColor(self.colours["wrong"]))
        side = min(MARK * digit_px, 0.5 * height)
        painter.drawEllipse(QtCore.QRectF(0.4 * digit_px, top + (height - side) / 2, side, side))
        painter.restore()

    def _digit_px(self) -> float:
        return self._edit.fontMetrics().boundingRect("0" * 100).width() / 100
