# SPDX-License-Identifier: LGPL-2.1-or-later
"""The state in large letters on its colour, and below it where the machine stands."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.dock.model.button_states import RULES, ControllerSnapshot, Face, why_not
from CNCStepper.workbench.dock.views import widgets
from CNCStepper.workbench.services.number_format import NOTHING, Lengths
from CNCStepper.workbench.services.translation import tr

LARGE, SMALLEST_PT = 2.4, 9.0  # of the usual letters; in points
LINES_KEPT = 2  # free for the sentence, so that the buttons below do not move under the pointer
AXES = "XYZ"
WIDEST = "-000.000"  # a position on the tables that there are


class Headline(QtGui.QLabel):
    """One word or two in letters as large as the width allows."""

    def fit(self) -> None:
        """Choose the size of the letters for the present text and width."""
        font = QtGui.QFont(QtGui.QApplication.font())
        font.setBold(True)
        size_pt = QtGui.QApplication.font().pointSizeF() * LARGE
        font.setPointSizeF(size_pt)
        text_width = QtGui.QFontMetrics(font).boundingRect(self.text()).width()
        if text_width > self.width() > 0:
            font.setPointSizeF(max(size_pt * self.width() / (text_width + 4), SMALLEST_PT))
        self.setFont(font)

    def resizeEvent(self, event: Any) -> None:
        """Keep the whole text visible."""
        super().resizeEvent(event)
        self.fit()


class StateView(QtGui.QFrame):
    """The coloured band with the state and one sentence, and below it the way on after a lost link."""

    def __init__(self, go_on: Callable[[], object]) -> None:
        super().__init__()
        widgets.named(self, "StateBand")
        self.headline = widgets.named(Headline(), "State")
        self.headline.setMinimumWidth(1)
        self.sentence = widgets.wrapped("StateSentence")
        self.sentence.setMinimumHeight(LINES_KEPT * self.sentence.fontMetrics().lineSpacing())
        self.sentence.setAlignment(QtCore.Qt.AlignmentFlag.AlignTop | QtCore.Qt.AlignmentFlag.AlignLeft)
        layout = widgets.column(self)
        layout.setContentsMargins(10, 8, 10, 8)
        layout.setSpacing(2)
        layout.addWidget(self.headline)
        layout.addWidget(self.sentence)
        self.way_on = widgets.button("GoOn", tr("Go on from here…"), go_on)
        self.way_on.setToolTip(tr("Show how far the job came when the link broke, and restart it there"))
        self.way_on.hide()
        layout.addWidget(self.way_on)
        self._tone = ""

    def show_way_on(self, is_open: bool) -> None:
        """Show the button that goes on with the job that a lost link has cut off, or hide it."""
        self.way_on.setVisible(is_open)

    def show_face(self, face: Face, sentence: str) -> None:
        """Show a state; the sentence is in people's language already."""
        headline = tr(face.headline)
        if headline != self.headline.text():
            self.headline.setText(headline)
            self.headline.fit()
        self.sentence.setText(widgets.breakable(sentence))
        if face.tone != self._tone:
            self._tone = face.tone
            ground, letters = widgets.TONES[face.tone]
            self.setStyleSheet(
                f"#{self.objectName()} {{ background: {ground}; border-radius: 6px; }}"
                f"#{self.objectName()} QLabel {{ color: {letters}; background: transparent; }}"
            )


class PositionView(QtGui.QWidget):
    """Work and machine position of each axis with its zero button, then feed and speed."""

    def __init__(self, lengths: Lengths, point: str, set_zero: Callable[[str], None]):
        super().__init__()
        self._lengths, self._point = lengths, point
        layout = widgets.grid(self)
        layout.setVerticalSpacing(3)
        for place, text in ((0, lengths.name), (1, tr("Work")), (2, tr("Machine"))):
            heading = QtGui.QLabel(text)
            heading.setAlignment(QtCore.Qt.AlignmentFlag.AlignRight)
            layout.addWidget(heading, 0, place)
        self.work = {axis: widgets.figure(f"Work{axis}", 1.4, widest=WIDEST) for axis in AXES}
        self.machine = {axis: widgets.figure(f"Machine{axis}", widest=WIDEST) for axis in AXES}
        self.zeros = {
            axis: widgets.button(f"Zero{axis}", tr("{0} = 0").format(axis), partial(set_zero, axis)) for axis in AXES
        }
        for line, axis in enumerate(AXES, 1):
            self.zeros[axis].setAccessibleName(f"{tr('Work zero')} {axis}")
            name = widgets.caption(axis)
            for place, widget in enumerate((name, self.work[axis], self.machine[axis], self.zeros[axis])):
                layout.addWidget(widget, line, place)
        self.zeros["XYZ"] = widgets.button("ZeroAll", tr("All = 0"), lambda: set_zero("XYZ"))
        layout.addWidget(self.zeros["XYZ"], 0, 3)
        layout.setColumnStretch(1, 3)
        layout.setColumnStretch(2, 2)
        self.feed = widgets.figure("Feed", widest=f"0000 {lengths.speed_name}")
        self.speed = widgets.figure("Spindle", widest=tr("{0} rpm").format("00000"))
        layout.addLayout(self._speeds(), len(AXES) + 1, 0, 1, 4)

    def show_status(self, status: Any) -> None:
        """Show positions, feed and speed of a status; None shows dashes."""
        for index, axis in enumerate(AXES):
            self.work[axis].setText(self._at(status and status.wpos_mm, index))
            self.machine[axis].setText(self._at(status and status.mpos_mm, index))
        feed, speed = (status.feed_mm_min, status.spindle_rpm) if status else (None, None)
        self.feed.setText(f"{self._lengths.speed_text(feed, self._point)} {self._lengths.speed_name}")
        self.speed.setText(tr("{0} rpm").format(NOTHING if speed is None else f"{speed:.0f}"))

    def lock(self, moment: ControllerSnapshot) -> None:
        """Enable the zero buttons when they can work."""
        for button in self.zeros.values():
            widgets.lock(button, why_not("zero", moment), RULES["zero"].does)

    def _at(self, position_mm: Any, index: int) -> str:
        known = position_mm is not None and index < len(position_mm)
        return self._lengths.text(position_mm[index] if known else None, self._point)

    def _speeds(self) -> Any:
        speeds = widgets.row(QtGui.QLabel(tr("Feed")), self.feed, QtGui.QLabel(tr("Spindle")), self.speed)
        speeds.insertSpacing(2, 2 * widgets.SPACE)
        speeds.setStretch(1, 1)
        speeds.setStretch(4, 1)
        return speeds
