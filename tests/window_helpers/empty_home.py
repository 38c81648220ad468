# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs in the window of a FreeCAD that has no packages of ours: `empty_home.py`, started by install_and_work.py.

CNCSTEPPER_STEP "ask" writes what the workbench says is missing into the file CNCSTEPPER_ANSWER. "work" installs from
CNCSTEPPER_ZIP by the button of that message, makes a job and connects to the virtual controller, as the dock does, and
writes what it has then: as JSON, or the error's text.
"""

import json
import os
import traceback
from pathlib import Path

LIMIT_S = 120.0
INSTALL_S = 200.0
LOOK_MS = 50


def notice():
    """Return the message that the workbench shows when it is opened."""
    import FreeCADGui
    from PySide import QtGui

    box = FreeCADGui.getMainWindow().findChild(QtGui.QMessageBox, "CNCStepper_Tell_notice")
    assert box is not None and box.isVisible(), "the workbench says nothing of what is missing"
    return box


def ask():
    """Return what the workbench says when it is opened, and FreeCAD's Python."""
    from CNCStepper.control.processes.bootstrap import python_version

    return {"text": notice().text(), "advice": notice().informativeText(), "python": python_version()}


class Installing:
    """The dialog of the message's button, which is looked at until it has installed; then `connecting` begins."""

    def __init__(self):
        import time

        import FreeCADGui
        from PySide import QtCore, QtGui

        self.now = time.monotonic
        notice().findChild(QtGui.QPushButton, "CNCStepper_Tell_remedy").click()
        self.dialog = FreeCADGui.getMainWindow().findChild(QtGui.QDialog, "CNCStepper_Install")
        self.dialog.install(Path(os.environ["CNCSTEPPER_ZIP"]))
        self.begun_s = self.now()
        self.timer = QtCore.QTimer()
        self.timer.timeout.connect(self.look)
        self.timer.start(LOOK_MS)

    def look(self):
        """Go on when all is installed, or end with what the dialog says."""
        global connecting
        if self.dialog.run is not None and self.now() < self.begun_s + INSTALL_S:
            return
        self.timer.stop()
        try:
            assert not self.dialog.error.isVisible(), self.dialog.error.text() + self.dialog.details.toPlainText()
            assert self.dialog.run is None, self.dialog.details.toPlainText()
            connecting = Connecting(draw_job(), self.now() - self.begun_s)
        except BaseException:
            answer({"error": traceback.format_exc()})


def draw_job():
    """Return a small job, whose program may have to wait until FreeCAD has prepared itself."""
    import FreeCAD

    from CNCStepper.workbench import api
    from CNCStepper.workbench.services import missing_packages

    assert not missing_packages.lacking_packages(), missing_packages.lacking_packages()
    document = FreeCAD.newDocument("Empty")
    job = api.new_job(document)
    api.add_tool(job)
    api.add_operation(job, "circular_pocket", radius_mm=8, depth_mm=1)
    document.recompute()
    return job


class Connecting:
    """The dock's link to the virtual controller, looked at until it is there and the job has its program."""

    def __init__(self, job, installed_s):
        import time

        from PySide import QtCore

        from CNCStepper.workbench.dock.connection import Link
        from CNCStepper.workbench.dock.model.port_choices import VIRTUAL

        self.job, self.now, self.installed_s = job, time.monotonic, installed_s
        self.link = Link()
        self.link.open(VIRTUAL, 115200, 10.0)
        self.until_s = self.now() + LIMIT_S
        self.timer = QtCore.QTimer()
        self.timer.timeout.connect(self.look)
        self.timer.start(LOOK_MS)

    def look(self):
        """End when the controller answers, or with the reason why it does not."""
        self.link.poll()
        moment, program = self.link.moment, self.program()
        connected = self.link.status is not None and moment.phase not in ("connecting", "starting")
        if connected and program:
            self.end({"program": len(program), "phase": moment.phase, "installed_s": round(self.installed_s)})
        elif moment.phase in ("unreached", "gone") or self.now() > self.until_s:
            self.end({"error": f"{moment.phase}: {moment.message}; {self.job.Operations[0].Problem}"})

    def program(self):
        """Return the program, "" while there is none."""
        from CNCStepper.errors import CNCStepperError
        from CNCStepper.workbench import api

        try:
            return api.program_text(self.job)
        except CNCStepperError:
            return ""

    def end(self, result):
        """Let the controller go and tell."""
        self.timer.stop()
        self.link.leave()
        answer(result)


def answer(result):
    """Write what was found, and close FreeCAD."""
    import FreeCAD
    import FreeCADGui

    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)  # else FreeCAD asks whether it is to be saved
    Path(os.environ["CNCSTEPPER_ANSWER"]).write_text(json.dumps(result), "utf-8")
    FreeCADGui.getMainWindow().close()


def begin():
    """Open the workbench and do what is asked; FreeCAD is up now."""
    import FreeCADGui

    global installing
    try:
        FreeCADGui.activateWorkbench("CNCStepperWorkbench")
        if os.environ["CNCSTEPPER_STEP"] == "ask":
            answer(ask())
        else:
            installing = Installing()
    except BaseException:
        answer({"error": traceback.format_exc()})


def start():
    """Wait for FreeCAD's event loop."""
    from PySide import QtCore

    QtCore.QTimer.singleShot(500, begin)


start()
