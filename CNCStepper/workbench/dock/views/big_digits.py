# SPDX-License-Identifier: LGPL-2.1-or-later
"""State, positions, remaining time and line in a window of their own, in digits as large as it allows."""

from __future__ import annotations

from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.dock.model.button_states import ControllerSnapshot, face
from CNCStepper.workbench.dock.views import widgets
from CNCStepper.workbench.help import f1_key
from CNCStepper.workbench.services.number_format import Lengths, duration
from CNCStepper.workbench.services.translation import tr

AXES = "XYZ"
WIDEST = "-000.000"  # a position on the tables that there are
SMALLEST_PX, BEGIN_PX = 8, (720, 520)
FILLED = 0.8  # of a label's height by its letters
SHARES = {"State": 2, **dict.fromkeys(AXES, 4), "Line": 2}  # of the window's height


class Fitted(QtGui.QLabel):
    """A label whose letters are as large as its size allows; widest: for which text there is always room."""

    def __init__(self, name: str, widest: str = ""):
        super().__init__()
        self.setObjectName(f"CNCStepper_Digits_{name}")
        self.setTextFormat(QtCore.Qt.TextFormat.PlainText)
        self.setMinimumSize(1, 1)
        policy = QtGui.QSizePolicy.Policy.Ignored
        self.setSizePolicy(policy, policy)
        self._widest = widest

    def put(self, text: str) -> None:
        """Show a text."""
        if text != self.text():
            self.setText(text)
            self.fit()

    def fit(self) -> None:
        """Choose the size of the letters for the present size and text."""
        font = QtGui.QFont(self.font())
        height_px = max(round(FILLED * self.height()), SMALLEST_PX)
        font.setPixelSize(height_px)
        longest = max(self._widest, self.text(), key=len)
        width_px = QtGui.QFontMetrics(font).boundingRect(longest).width()
        if width_px > self.width() > 0:
            font.setPixelSize(max(int(height_px * self.width() / (width_px + 4)), SMALLEST_PX))
        self.setFont(font)

    def resizeEvent(self, event: Any) -> None:
        """Keep the whole text visible."""
        super().resizeEvent(event)
        self.fit()


class BigDigits(QtGui.QWidget):
    """The window; it belongs to the dock's panel and is filled with it."""

    def __init__(self, parent: Any, lengths: Lengths, point: str) -> None:
        super().__init__(parent, QtCore.Qt.WindowType.Window)
        self.setObjectName("CNCStepper_Digits")
        self.setWindowTitle(tr("Big digits"))
        self.resize(*BEGIN_PX)
        f1_key.attach(self, "sending/README.md")
        self._lengths, self._point, self._tone = lengths, point, ""
        self.state = Fitted("State")
        self.axes = {axis: Fitted(f"Work{axis}", WIDEST) for axis in AXES}
        self.remaining, self.line = Fitted("Remaining", tr("Remaining {0}").format("0:00:00")), Fitted("Line")
        self._lay_out()

    def _lay_out(self) -> None:
        layout = widgets.grid(self)
        layout.setContentsMargins(10, 10, 10, 10)
        self.state.setAlignment(QtCore.Qt.AlignmentFlag.AlignCenter)
        layout.addWidget(self.state, 0, 0, 1, 2)
        for row, (axis, digits) in enumerate(self.axes.items(), start=1):
            name = Fitted(axis)
            name.put(axis)
            digits.setAlignment(QtCore.Qt.AlignmentFlag.AlignRight | QtCore.Qt.AlignmentFlag.AlignVCenter)
            digits.setFont(QtGui.QFontDatabase.systemFont(QtGui.QFontDatabase.SystemFont.FixedFont))
            layout.addWidget(name, row, 0)
            layout.addWidget(digits, row, 1)
        foot = widgets.row(self.remaining, self.line)
        layout.addLayout(foot, len(AXES) + 1, 0, 1, 2)
        for row, share in enumerate(SHARES.values()):
            layout.setRowStretch(row, share)
        layout.setColumnStretch(0, 1)
        layout.setColumnStretch(1, 6)

    def show_moment(self, moment: ControllerSnapshot, status: Any) -> None:
        """Show a moment; status: the controller's last, None for dashes."""
        if not self.isVisible():
            return
        shown = face(moment)
        self.state.put(tr(shown.headline))
        if shown.tone != self._tone:
            self._tone = shown.tone
            ground, letters = widgets.TONES[shown.tone]
            self.state.setStyleSheet(f"background: {ground}; color: {letters}; border-radius: 8px;")
        position_mm = (status and status.wpos_mm) or ()
        for index, digits in enumerate(self.axes.values()):
            known = index < len(position_mm)
            digits.put(self._lengths.text(position_mm[index] if known else None, self._point))
        runs = moment.job_runs and status is not None
        self.remaining.put(tr("Remaining {0}").format(duration(status.remaining_s)) if runs else "")
        self.line.put(tr("Line {0}").format(status.file_line) if runs else "")
