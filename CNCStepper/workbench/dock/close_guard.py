# SPDX-License-Identifier: LGPL-2.1-or-later
"""Asks before FreeCAD's window closes over a job that is being cut, and lets the controller go at the end."""

from __future__ import annotations

from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.services.translation import tr


class ClosingGuard(QtCore.QObject):
    """Guards one window; `link` is asked for a running job, stopped, and left when FreeCAD ends."""

    def __init__(self, window: Any, link: Any):
        super().__init__(window)
        self._window, self._link = window, link
        self._asking = False
        window.installEventFilter(self)
        QtCore.QCoreApplication.instance().aboutToQuit.connect(self._quit)

    def eventFilter(self, watched: Any, event: Any) -> bool:
        """Keep the window open when a job runs and the user cancels the closing."""
        if not isinstance(event, QtCore.QEvent) or event.type() != QtCore.QEvent.Type.Close:
            return False  # PySide2 may take an event for a deleted object that lay at its address
        if not self._link.moment.job_runs:
            return False
        if self._asking or not self._may_close():
            event.ignore()
            return True
        return False

    def _may_close(self) -> bool:
        self._asking = True
        try:
            answer = self._ask()
        finally:
            self._asking = False
        if answer == "stop":
            self._link.command("stop")
        return answer != "cancel"

    def _ask(self) -> str:
        """Ask, and return "keep", "stop" or "cancel"; Esc and the box's own closing mean cancel."""
        box = QtGui.QMessageBox(self._window)
        box.setObjectName("CNCStepper_Dock_Closing")
        box.setIcon(QtGui.QMessageBox.Icon.Warning)
        box.setWindowTitle(tr("A job is being cut"))
        box.setText(tr("The machine is cutting a job."))
        box.setInformativeText(
            tr("The cut goes on without FreeCAD; the controller's panel finds it again the next time it is opened.")
        )
        role = QtGui.QMessageBox.ButtonRole
        answers = {
            "keep": box.addButton(tr("Keep cutting and close"), role.AcceptRole),
            "stop": box.addButton(tr("Stop the cut and close"), role.DestructiveRole),
            "cancel": box.addButton(tr("Cancel"), role.RejectRole),
        }
        for name, button in answers.items():
            button.setObjectName(f"CNCStepper_Dock_Closing_{name}")
        box.setDefaultButton(answers["cancel"])
        box.setEscapeButton(answers["cancel"])
        getattr(box, "exec", box.exec_)()
        clicked = box.clickedButton()
        box.deleteLater()
        return next((name for name, button in answers.items() if button is clicked), "cancel")

    def _quit(self) -> None:
        """Let go: a job goes on alone, without one the controller's process ends."""
        self._window.removeEventFilter(self)
        if self._link.moment.job_runs:
            self._link.detach()
        else:
            self._link.leave()
