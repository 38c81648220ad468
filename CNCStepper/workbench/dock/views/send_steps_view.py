# SPDX-License-Identifier: LGPL-2.1-or-later
"""The way of a job to the machine, step by step, with its questions and their answers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.dock.model.send_steps import LAST_NUMBER, STARTS, Flow
from CNCStepper.workbench.dock.views import widgets
from CNCStepper.workbench.dock.views.keyboard import KeyButton
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr

FINDINGS_HEIGHT = 160
HIDDEN_AT = ("", "cutting")  # the job's own section says it then


class FlowView(QtGui.QFrame):
    """A frame in the colour of the step; `findings` is the list widget of the checks."""

    def __init__(self, findings: Any, confirm_step: Callable[[], None], away: Callable[[], None]):
        super().__init__()
        widgets.named(self, "Flow")
        self.findings = findings
        self.number, self.title = QtGui.QLabel(), widgets.wrapped("FlowTitle")  # a job's name may be long
        self.title.setFont(widgets.caption("").font())
        self.text, self.detail = widgets.wrapped("FlowText"), widgets.wrapped("FlowDetail")
        self.away = widgets.named(KeyButton(), "Cancel")
        self.confirm_step = widgets.named(KeyButton(), "Start")
        self.away.clicked.connect(guarded(away))
        self.confirm_step.clicked.connect(guarded(confirm_step))
        layout = widgets.column(self)
        layout.setContentsMargins(10, 8, 10, 8)
        head = widgets.row(self.title, self.number)
        head.setStretch(0, 1)
        head.setAlignment(self.number, QtCore.Qt.AlignmentFlag.AlignTop)
        layout.addLayout(head)
        for widget in (self.text, self.detail, findings):
            layout.addWidget(widget)
        layout.addLayout(widgets.row(self.away, self.confirm_step))
        findings.setMaximumHeight(FINDINGS_HEIGHT)
        self._tone = ""
        self.hide()

    def show_flow(self, flow: Flow, why_not: str) -> None:
        """Show the flow's state; `why_not`: why its question cannot be answered with yes."""
        shown = flow.step not in HIDDEN_AT
        self.setVisible(shown)
        if not shown:
            return
        step = flow.shown
        self.title.setText(tr("{0}: {1}").format(flow.label, tr(step.title)))
        self.title.setToolTip(flow.label)
        self.number.setText(tr("Step {0} of {1}").format(step.number, LAST_NUMBER) if step.number else "")
        self._say(self.text, tr(step.text))
        self._say(self.detail, flow.detail or (tr(why_not) if flow.step in STARTS else ""))
        self.findings.setVisible(flow.step in ("refused", "warned"))
        for button, text in ((self.confirm_step, step.confirm_step), (self.away, step.away)):
            button.setVisible(bool(text))
            button.setText(tr(text))
        widgets.lock(self.confirm_step, why_not, "")
        self._colour(step.tone)

    def _say(self, label: Any, text: str) -> None:
        label.setText(text)
        label.setVisible(bool(text))

    def _colour(self, tone: str) -> None:
        if tone != self._tone:
            self._tone = tone
            self.setStyleSheet(
                f"#{self.objectName()} {{ border: 2px solid {widgets.TONES[tone][0]}; border-radius: 6px; }}"
            )
