# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run by FreeCAD: connect the dock to the virtual grbl, begin a long cut, then end the window in one of four ways.

CNCSTEPPER_END: "killed" (somebody outside does it), "keep" or "stop" (the answer to FreeCAD's question at closing), or
"idle" (close it without a job). CNCSTEPPER_FOLDER: where the file "cutting" appears when it can be ended.
"""

import os
import sys
import traceback
from pathlib import Path

import FreeCADGui
from PySide import QtCore, QtGui

END, FOLDER = os.environ["CNCSTEPPER_END"], Path(os.environ["CNCSTEPPER_FOLDER"])


def write_job():
    """Return the file of a job of some minutes."""
    from CNCStepper.control.program.send_job import SendJob, write_job

    file = FOLDER / "send.zip"
    lines = ["G21", "G90", "G94", *(f"G1X{index % 2 * 5}Y{index % 3}F300" for index in range(400))]
    write_job(file, SendJob(port="", lines=lines, file="alone.nc"))
    return file


def steps():
    """Yield until what was begun is done."""
    from CNCStepper.workbench import dock

    panel = dock.show().widget()
    panel.connect_chosen()
    while panel.link.moment.phase != "idle":
        yield
    if END != "idle":
        panel.link.command("set_zero", "XYZ")
        panel.link.command("run", write_job(), zero_confirmed=True)
        while not (panel.link.moment.job_runs and panel.link.status.acknowledged > 5):
            yield
    (FOLDER / "cutting").touch()
    if END == "killed":
        return
    QtCore.QTimer.singleShot(0, FreeCADGui.getMainWindow().close)
    while END != "idle":
        for button in QtGui.QApplication.allWidgets():
            if button.objectName() == f"CNCStepper_Dock_Closing_{END}" and button.isVisible():
                button.click()
                return
        yield


def go_on():
    """Take one step; FreeCAD ends at once where one goes wrong."""
    try:
        next(road)
    except StopIteration:
        timer.stop()
    except BaseException:
        traceback.print_exc(file=sys.__stderr__)
        os._exit(3)


road = steps()
timer = QtCore.QTimer()
timer.timeout.connect(go_on)
timer.start(50)
