# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dock in FreeCAD's window: one for each, where it was the last time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import FreeCADGui
from PySide import QtCore, QtGui

from CNCStepper.control.service.connection_client import running_services
from CNCStepper.state import Start
from CNCStepper.workbench import packages
from CNCStepper.workbench.dock.connection import Link
from CNCStepper.workbench.dock.controller_panel import Panel
from CNCStepper.workbench.proving import latest_proof
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.translation import tr

if TYPE_CHECKING:
    from CNCStepper.recovery.restart.restart_proof_folder import RestartPlace

NAME = "CNCStepper_Dock"


class ClosingGuard(QtCore.QObject):
    """Watches one window; `link` is asked whether a job runs, told to stop it, and left when FreeCAD ends."""

    def __init__(self, window: Any, link: Any):
        super().__init__(window)
        self.setObjectName(f"{NAME}_ClosingGuard")
        self._window, self._link = window, link
        self._asking = False
        window.installEventFilter(self)
        QtCore.QCoreApplication.instance().aboutToQuit.connect(self._quit)

    def eventFilter(self, watched: Any, event: Any) -> bool:
        """Keep the window open when a job runs and somebody thinks better of closing it."""
        if not isinstance(event, QtCore.QEvent) or event.type() != QtCore.QEvent.Type.Close:
            return False  # PySide2 may take an event for a deleted object that lay at its address
        if not self._link.moment.job_runs:
            return False
        if self._asking or not self.may_close():
            event.ignore()
            return True
        return False

    def may_close(self) -> bool:
        """Ask what becomes of the job, stop it where that is wanted, and return whether the window may close."""
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
        answers = {
            "keep": (tr("Keep cutting and close"), "Accept"),
            "stop": (tr("Stop the cut and close"), "Destructive"),
            "cancel": (tr("Cancel"), "Reject"),
        }
        text = tr("The machine is cutting a job.")
        more = tr("The job continues without FreeCAD; the controller's panel shows it when it is opened again.")
        title = tr("A job is being cut")
        return messages.choose("CNCStepper_Dock_Closing", "Warning", title, text, answers, "cancel", more)

    def _quit(self) -> None:
        """Let go: a job goes on alone, without one the controller's process ends."""
        self._window.removeEventFilter(self)
        if self._link.moment.job_runs:
            self._link.detach()
        else:
            self._link.leave()


def dock() -> Any:
    """Return the dock of this window, made at its last place when it is not there yet, in FreeCAD's language."""
    window = FreeCADGui.getMainWindow()
    found = window.findChild(QtGui.QDockWidget, NAME)
    if found is None:
        return _made(window)
    shown = found.widget()
    if shown.language != FreeCADGui.getLocale() and not shown.sending.flow.active:
        _fill(found, shown.link)
        shown.backing.end()
        shown.deleteLater()
    return found


def panel() -> Panel:
    """Return the dock's content."""
    return dock().widget()


def open_dock() -> Any:
    """Show the dock in front, attached to a controller's process that runs already, and return it.

    Raises MissingPackage when no place for such processes can be named.
    """
    packages.require("platformdirs")
    shown = dock()
    shown.show()
    shown.raise_()
    attach_running(shown.widget())
    return shown


def send(job: Any, place: RestartPlace | None = None) -> None:
    """Show the dock in front and begin to send a job object, or its restart at a place."""
    open_dock().widget().send(job, place)


def open_unless_connected() -> None:
    """Show the dock, unless this window has a controller already, whose dock may have been closed on purpose."""
    found = FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, NAME)
    if not (found and (found.widget().link.moment.connected or found.widget().link.moment.busy)):
        open_dock()


def link_here() -> Link | None:
    """Return this window's controller, None while the dock was never opened."""
    found = FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, NAME)
    return found.widget().link if found else None


def start_here() -> Start | None:
    """Return the start state of the machine that this window's dock is connected to, None where it is not known."""
    found = FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, NAME)
    return found.widget().link.start if found else None


latest_proof.start_here = start_here


def attach_running(shown: Panel) -> None:
    """Take up the newest process that still has a controller, when this window has none."""
    if shown.link.moment.connected or shown.link.moment.busy:
        return
    for session_file in reversed(running_services()):
        shown.attach(session_file)
        messages.note(tr("The controller's panel is attached again to a machine that was left connected."))
        return


def _made(window: Any) -> Any:
    made, link = QtGui.QDockWidget(window), Link()
    made.setObjectName(NAME)
    area = QtCore.Qt.DockWidgetArea
    made.setAllowedAreas(area.LeftDockWidgetArea | area.RightDockWidgetArea)
    _fill(made, link)
    if not window.restoreDockWidget(made):
        window.addDockWidget(area.RightDockWidgetArea, made)
    ClosingGuard(window, link)
    return made


def _fill(dock: Any, link: Link) -> None:
    """Give a dock its title and its panel."""
    dock.setWindowTitle(tr("Controller"))
    dock.setWidget(Panel(link, send))
