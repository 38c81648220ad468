# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tour: a dock below the toolbars with seven steps, which follows what a person does."""

from __future__ import annotations

from typing import Any

import FreeCADGui
from PySide import QtCore, QtGui

from CNCStepper.workbench.document import targets
from CNCStepper.workbench.features.base import proxy_type
from CNCStepper.workbench.first_run.tour_steps import (
    CONNECTION,
    CUT,
    DONE,
    DRAWING,
    END,
    JOB,
    OPERATION,
    SIMULATION,
    STEPS,
    Tour,
)
from CNCStepper.workbench.help import f1_key
from CNCStepper.workbench.services.messages import guarded, polled
from CNCStepper.workbench.services.translation import tr

NAME = "CNCStepper_Tour"
LOOK_EVERY_MS = 400
DOCK, PLAYER = "CNCStepper_Dock", "CNCStepper_Simulation_panel"
STYLES = {  # of a step's label: done, next, to come; read on light and on dark
    "done": "color: #2e9e63;",
    "next": "font-weight: bold; border-bottom: 3px solid #3f74b0;",
    "later": "color: #808890;",
}


class TourDock(QtGui.QDockWidget):
    """See the module. Nothing happens while it is closed."""

    def __init__(self, parent: Any):
        super().__init__(tr("First part"), parent)
        self.setObjectName(NAME)
        f1_key.attach(self, "freecad.md")
        self.tour = Tour()
        self._make()
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(LOOK_EVERY_MS)
        self._timer.timeout.connect(polled(self.look))
        self.visibilityChanged.connect(guarded(self._shown))
        self.show_step()

    def look(self) -> None:
        """Go on where the next step, or a later one, is seen to be done."""
        if self.tour.look(seen(self.tour.place)):
            self.show_step()

    def show_step(self) -> None:
        """Show how far the tour is, and what is to be done next."""
        step = self.tour.step
        for number, label in enumerate(self.labels):
            state = "done" if number < self.tour.place else "next" if number == self.tour.place else "later"
            label.setStyleSheet(STYLES[state])
            mark = "✓" if state == "done" else str(number + 1)
            label.setText(f"{mark} {tr(STEPS[number].title)}")
        self.text.setText(tr(step.text) if step else tr(END))
        self.button.setVisible(bool(step and step.command))
        if step and step.command:
            self.button.setText(_command_text(step.command))

    def press(self) -> None:
        """Run the command of the step, as its tool button does."""
        if self.tour.step and self.tour.step.command:
            FreeCADGui.runCommand(self.tour.step.command)

    def _shown(self, visible: bool) -> None:
        self._timer.start() if visible else self._timer.stop()

    def _make(self) -> None:
        content = QtGui.QWidget(self)
        column = QtGui.QVBoxLayout(content)
        row = QtGui.QHBoxLayout()
        self.labels = [QtGui.QLabel(content) for _ in STEPS]
        for number, label in enumerate(self.labels):
            label.setObjectName(f"{NAME}_step{number + 1}")
            row.addWidget(label)
            row.addStretch()
        column.addLayout(row)
        line = QtGui.QHBoxLayout()
        self.text = QtGui.QLabel(content)
        self.text.setObjectName(f"{NAME}_text")
        self.text.setWordWrap(True)
        self.button = QtGui.QPushButton(content)
        self.button.setObjectName(f"{NAME}_do")
        self.button.clicked.connect(guarded(self.press))
        line.addWidget(self.text, 1)
        line.addWidget(self.button)
        column.addLayout(line)
        self.setWidget(content)


def begin_tour() -> Any:
    """Begin the tour at its first step, below the toolbars, and return its dock."""
    window = FreeCADGui.getMainWindow()
    for former in window.findChildren(QtGui.QDockWidget, NAME):
        window.removeDockWidget(former)
        former.deleteLater()
    dock = TourDock(window)
    window.addDockWidget(QtCore.Qt.DockWidgetArea.TopDockWidgetArea, dock)
    dock.show()
    return dock


def seen(place: int) -> set[str]:
    """Return the keys of the steps that are done by what is in the window now. place: how many were done before.

    It runs several times a second, so it only looks.
    """
    jobs = targets.jobs()
    found = {JOB} if jobs else set()
    if jobs and any(_is_drawing(obj) for obj in targets.document().Objects):
        found.add(DRAWING)
    if any(job.Operations for job in jobs):
        found.add(OPERATION)
    window = FreeCADGui.getMainWindow()
    if any(shown.isVisible() for shown in window.findChildren(QtGui.QWidget, PLAYER)):
        found.add(SIMULATION)
    dock = window.findChild(QtGui.QDockWidget, DOCK)
    return found | _at_machine(dock.widget().link.moment, place) if dock is not None else found


def _at_machine(moment: Any, place: int) -> set[str]:
    """Return what a controller shows; that a job is over counts only where it was seen to run."""
    if not moment.connected:
        return set()
    if moment.job_runs:
        return {CONNECTION, CUT}
    return {CONNECTION, DONE} if place == len(STEPS) - 1 else {CONNECTION}


def _command_text(name: str) -> str:
    """Return the text that a command's tool button has, in FreeCAD's language."""
    return str(FreeCADGui.Command.get(name).getAction()[0].text())


def _is_drawing(obj: Any) -> bool:
    return bool(obj.isDerivedFrom("Part::Feature") and proxy_type(obj) != targets.PREVIEW)
