# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dock in FreeCAD's window: one for each, where it was the last time."""

from __future__ import annotations

from typing import Any

import FreeCADGui
from PySide import QtCore, QtGui

from CNCStepper.control.service.connection_client import running_services
from CNCStepper.state import Start
from CNCStepper.workbench import packages
from CNCStepper.workbench.dock.close_guard import ClosingGuard
from CNCStepper.workbench.dock.connection import Link
from CNCStepper.workbench.dock.panel import Panel
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.translation import tr

NAME = "CNCStepper_Dock"


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


def open_unless_connected() -> None:
    """Show the dock, unless this window has a controller already, whose dock may have been closed on purpose."""
    found = FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, NAME)
    if not (found and (found.widget().link.moment.connected or found.widget().link.moment.busy)):
        open_dock()


def start_here() -> Start | None:
    """Return the start state of the machine that this window's dock is connected to, None where it is not known."""
    found = FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, NAME)
    return found.widget().link.start if found else None


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
    dock.setWidget(Panel(link))
