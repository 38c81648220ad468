# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two lines below the text: position and modal state after the cursor's line, and its error."""

from __future__ import annotations

from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.editor.model import line_status
from CNCStepper.workbench.editor.model.error_marks import Mark
from CNCStepper.workbench.editor.model.word_meanings import meaning_of
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.theme_colours import ERROR, letters
from CNCStepper.workbench.services.translation import tr

NAME = "CNCStepper_Editor_"
LEAST_WIDTH = 260
WRONG = "QLabel {{ color: {} }}"


class StatusLine(QtGui.QWidget):
    """Labels below the text."""

    def __init__(self, parent: Any = None):
        super().__init__(parent)
        self._place, self._time, self._cursor = _label("place"), _label("time"), _label("cursor")
        self._modes, self._word = _label("modes"), _label("word")
        self._word.setWordWrap(True)
        self._word.setAlignment(QtCore.Qt.AlignmentFlag.AlignTop)
        self._word.setMinimumHeight(2 * self._word.fontMetrics().lineSpacing())
        layout = QtGui.QGridLayout(self)
        layout.setContentsMargins(4, 2, 4, 2)
        layout.setVerticalSpacing(1)
        layout.addWidget(self._place, 0, 0)
        layout.addWidget(self._time, 0, 1)
        layout.addWidget(self._cursor, 0, 2, QtCore.Qt.AlignmentFlag.AlignRight)
        layout.addWidget(self._modes, 1, 0, 1, 3)
        layout.addWidget(self._word, 2, 0, 1, 3)
        layout.setColumnStretch(0, 1)
        self.setMinimumWidth(LEAST_WIDTH)  # and no more: the dock must not follow what the labels say

    def show_cursor(self, line: int, column: int, word: str, mark: Mark | None) -> None:
        """Show where the cursor is, and why its line is refused or else what its word means."""
        self._cursor.setText(tr("line {0}, column {1}").format(line, column))
        self._word.setText(translated(mark.error.sentence) if mark else meaning_of(word))
        self._word.setStyleSheet(WRONG.format(letters(ERROR)) if mark else "")

    def show_answer(self, answer: dict[str, Any] | None, duration_s: float | None) -> None:
        """Show what holds after the line, nothing while that is not known."""
        if answer is None:
            return
        if answer["state"] is None:
            self._place.setText(tr("this line is not run"))
            self._modes.clear()
            self._time.clear()
            return
        self._place.setText(line_status.place_text(answer))
        self._modes.setText(line_status.modes_text(answer))
        self._time.setText(line_status.time_text(answer, duration_s))


def _label(name: str) -> Any:
    label = QtGui.QLabel()
    label.setObjectName(NAME + name)
    label.setSizePolicy(
        QtGui.QSizePolicy.Policy.Ignored if name in ("modes", "word") else QtGui.QSizePolicy.Policy.Preferred,
        QtGui.QSizePolicy.Policy.Fixed,
    )
    label.setTextInteractionFlags(QtCore.Qt.TextInteractionFlag.TextSelectableByMouse)
    return label
