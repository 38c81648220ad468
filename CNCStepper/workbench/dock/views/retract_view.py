# SPDX-License-Identifier: LGPL-2.1-or-later
"""Back along the cut, and forward again: by a length, to a line, to the last entry; shown while a job is cut."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.dock.model.button_states import ControllerSnapshot
from CNCStepper.workbench.dock.model.retract_state import (
    ASIDE,
    BACK,
    DOES,
    ENTRY,
    FORWARD,
    LINE,
    RetractFlow,
    state_text,
    why_not_back,
)
from CNCStepper.workbench.dock.views import widgets
from CNCStepper.workbench.services.number_format import Lengths
from CNCStepper.workbench.services.translation import tr

FIRST_MM, LEAST_MM, LONGEST_MM = 5.0, 0.01, 100_000.0
LAST_LINE = 99_999_999
USUAL, ARROWS_PX = "0000.000 mm", 32  # what a box must have room for at least
LINES_KEPT = 2  # free for the sentence, so that the buttons below do not move under the pointer


class RetractView(QtGui.QWidget):
    """`go` is called with the request, as `back` names it, and its value."""

    def __init__(self, lengths: Lengths, point: str, go: Callable[[str, float | bool], None]):
        super().__init__()
        self._lengths, self._point = lengths, point
        self.length, self.line = self._length_box(), self._line_box()
        self.state = widgets.wrapped("BackState")
        self.state.setMinimumHeight(LINES_KEPT * self.state.fontMetrics().lineSpacing())
        self.state.setAlignment(QtCore.Qt.AlignmentFlag.AlignTop | QtCore.Qt.AlignmentFlag.AlignLeft)
        self.buttons = {
            BACK: widgets.button("Back", tr("Back"), lambda: go(BACK, self.length_mm)),
            FORWARD: widgets.button("Forward", tr("Forward"), lambda: go(FORWARD, self.length_mm)),
            LINE: widgets.button("BackToLine", tr("To the line"), lambda: go(LINE, self.line.value())),
            ENTRY: widgets.button("BackToEntry", tr("To the entry"), lambda: go(ENTRY, True)),
            ASIDE: widgets.button("Aside", tr("Free to jog"), lambda: go(ASIDE, True)),
        }
        for button in self.buttons.values():
            button.setFocusPolicy(QtCore.Qt.FocusPolicy.TabFocus)  # no click leaves the keys to what moves the machine
        rows = widgets.grid()
        rows.setColumnStretch(0, 1)
        for place, widget in enumerate((self.length, self.buttons[BACK], self.buttons[FORWARD])):
            rows.addWidget(widget, 0, place)
        for place, widget in enumerate((self.line, self.buttons[LINE], self.buttons[ENTRY])):
            rows.addWidget(widget, 1, place)
        layout = widgets.column(self)
        layout.addLayout(self._head())
        layout.addLayout(rows)
        layout.addWidget(self.state)
        self.hide()

    @property
    def length_mm(self) -> float:
        """How far one click goes."""
        return self.length.value() * self._lengths.mm

    def show_back(self, flow: RetractFlow, moment: ControllerSnapshot) -> None:
        """Show the tool's place on its cut, and enable the possible requests."""
        self.setVisible(moment.job_runs)
        for kind, button in self.buttons.items():
            widgets.lock(button, why_not_back(kind, flow, moment), DOES[kind])
        behind = f"{self._lengths.text(flow.behind_mm, self._point)} {self._lengths.name}"
        text = state_text(flow, moment)
        self.state.setText(flow.trouble or tr(text).format(flow.line, behind))

    def _head(self) -> Any:
        head = widgets.row(widgets.caption(tr("Back along the cut")), self.buttons[ASIDE])
        head.setStretch(0, 1)
        self.buttons[ASIDE].setSizePolicy(QtGui.QSizePolicy.Policy.Fixed, QtGui.QSizePolicy.Policy.Fixed)
        return head

    def _length_box(self) -> Any:
        box = _narrow(widgets.named(QtGui.QDoubleSpinBox(), "BackLength"))
        box.setDecimals(self._lengths.decimals)
        box.setRange(LEAST_MM / self._lengths.mm, LONGEST_MM / self._lengths.mm)
        box.setValue(FIRST_MM / self._lengths.mm)
        box.setSuffix(f" {self._lengths.name}")
        box.setToolTip(tr("How far one click goes along the cut."))
        box.setAccessibleName(tr("How far one click goes along the cut."))
        return box

    def _line_box(self) -> Any:
        box = _narrow(widgets.named(QtGui.QSpinBox(), "BackLine"))
        box.setRange(1, LAST_LINE)
        box.setPrefix(tr("Line") + " ")
        box.setToolTip(tr("A line of the program that was cut already."))
        box.setAccessibleName(tr("A line of the program that was cut already."))
        return box


def _narrow(box: Any) -> Any:
    """Return a box that may be narrower than its largest number wants it."""
    box.setMinimumWidth(box.fontMetrics().boundingRect(USUAL).width() + ARROWS_PX)
    return box
