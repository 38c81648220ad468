# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs in the window of a FreeCAD that has no packages of ours: `empty_home.py`, started by install_and_work.py.

CNCSTEPPER_STEP "ask" writes what the workbench says is missing into the file CNCSTEPPER_ANSWER. "install" chooses the
workbench and installs from CNCSTEPPER_ZIP by the button of that message; then, as "work" does from the choice of the
workbench on, it goes the tour of the first steps to a part that is cut on the virtual machine. All of it is done by a
hand at the mouse and the keys. The answer has the clicks and the seconds, as JSON, or the error's text.

The hand needs python-xlib, which CNCSTEPPER_HAND has in a folder that holds nothing of ours.
"""

import json
import os
import sys
import threading
import time
import traceback
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]
sys.path += [str(TESTS), os.environ["CNCSTEPPER_HAND"]]
INSTALL, CARD, TOUR = "CNCStepper_Install", "CNCStepper_FirstSteps", "CNCStepper_Tour"
DOCK, PLAYER = "CNCStepper_Dock_", "CNCStepper_Simulation_"
INSTALL_S = 300.0
FIRST_S = 400.0  # so long may kernels take that were never compiled
STEP_S = 60.0


def ask():
    """Return what the workbench says when it is opened, and FreeCAD's Python."""
    import FreeCADGui
    from PySide import QtGui

    from CNCStepper.control.processes.bootstrap import python_version

    FreeCADGui.activateWorkbench("CNCStepperWorkbench")
    box = FreeCADGui.getMainWindow().findChild(QtGui.QMessageBox, "CNCStepper_Tell_notice")
    assert box is not None and box.isVisible(), "the workbench says nothing of what is missing"
    return {"text": box.text(), "advice": box.informativeText(), "python": python_version()}


def work(hand, step):
    """Return how many clicks, typed texts and seconds it takes to the first cut part, and those of the installation."""
    begun_s = time.monotonic()
    choose_workbench(hand)
    opened, opened_s = hand.clicks, time.monotonic()
    if step == "install":
        install(hand)
    installed = {"install_clicks": hand.clicks - opened, "installed_s": round(time.monotonic() - opened_s)}
    hand.wait(lambda: hand.exists(CARD), STEP_S, "the card")
    hand.click(f"{CARD}_try")
    if step == "install":
        hand.click(f"{INSTALL}_close")
    make_a_job(hand)
    result = cut(hand)
    took = {"clicks": hand.clicks, "typed": hand.typed, "seconds": round(time.monotonic() - begun_s)}
    return {**installed, **took, **result}


def choose_workbench(hand):
    """Choose the workbench in the list of FreeCAD's toolbar."""
    import FreeCADGui
    from PySide import QtGui

    def box():
        boxes = FreeCADGui.getMainWindow().findChildren(QtGui.QComboBox)
        return next((each for each in boxes if each.isVisible() and each.findText("CNCStepper") >= 0), None)

    hand.choose(hand.wait(box, STEP_S, "the list of workbenches"), "CNCStepper")
    hand.wait(hand.workbench_is_open, STEP_S, "the workbench")


def install(hand):
    """Press the button of the message, choose the zip, and wait until all is there."""
    from CNCStepper.workbench.services import missing_packages
    from CNCStepper.workbench.services.translation import tr
    from window_helpers import screen_places as places

    hand.wait(lambda: hand.exists("CNCStepper_Tell_notice"), STEP_S, "the message of what is missing")
    hand.click("CNCStepper_Tell_remedy")
    dialog = hand.wait(lambda: places.visible(INSTALL), STEP_S, "the dialog that installs")[0]
    hand.wait(lambda: hand.exists(f"{INSTALL}_files"), STEP_S)
    hand.settle()
    hand.tap(f"{INSTALL}_files")  # its menu opens before it tells of a click
    hand.entry(hand.main(tr, "From a zip…"))
    hand.wait(lambda: hand.exists(f"{INSTALL}_file"), STEP_S, "the question which file")
    hand.type(os.environ["CNCSTEPPER_ZIP"])
    hand.key("Return")
    hand.wait(lambda: dialog.run is not None, STEP_S, "the installation to begin")
    hand.wait(lambda: dialog.run is None, INSTALL_S, "the installation")
    said = hand.main(lambda: dialog.error.isVisible() and dialog.error.text() + dialog.details.toPlainText())
    assert not said, said
    assert not hand.main(missing_packages.lacking_packages), hand.main(missing_packages.lacking_packages)


def make_a_job(hand):
    """Go the tour's way from the job to the simulation, with all that is proposed."""
    import FreeCADGui

    from window_helpers.task_panels import PANEL, accept

    for number in (1, 2):  # a job, a text
        go_on(hand)
        hand.wait(lambda: hand.exists(f"{PANEL}ok"), STEP_S, "the panel")
        accept(hand)
        reached(hand, number)
    hand.tree(hand.main(text_label))
    go_on(hand)
    hand.wait(lambda: hand.exists(f"{PANEL}depth_mm"), STEP_S, "the engraving's panel")
    accept(hand)
    reached(hand, 3)
    go_on(hand)
    hand.wait(lambda: hand.exists(f"{PLAYER}play") and hand.find(f"{PLAYER}play").isEnabled(), FIRST_S, "the cut part")
    reached(hand, 4)
    hand.click(f"{PANEL}close")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), STEP_S, "the simulation to close")


def cut(hand):
    """Send the part to the virtual machine until it is cut; return how many lines were sent."""
    import FreeCADGui
    from PySide import QtGui

    from CNCStepper.workbench.services.translation import tr

    go_on(hand)
    panel = hand.wait(lambda: FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, "CNCStepper_Dock"), STEP_S)
    panel = hand.main(panel.widget)
    at(hand, panel, "connect")
    hand.choose(f"{DOCK}Speed", hand.main(tr, "{0}× speed").format(10))
    hand.click(f"{DOCK}Start")
    at(hand, panel, "zero")
    hand.click(f"{DOCK}ZeroAll")
    hand.wait(lambda: hand.find(f"{DOCK}Start").isEnabled(), STEP_S, "Start")
    hand.click(f"{DOCK}Start")
    acknowledged = []

    def is_cut():
        acknowledged.append(panel.link.status.acknowledged)
        return panel.sending.flow.step == "ended"

    hand.wait(is_cut, STEP_S, "the end of the cut")
    reached(hand, 7)
    assert hand.main(tr, "Done") in hand.text(f"{DOCK}FlowTitle"), hand.text(f"{DOCK}FlowTitle")
    findings = hand.main(lambda: [each.text for each in panel.sending._result.findings if each.severity != "info"])
    assert not findings, findings
    hand.shot("cut")
    hand.main(panel.link.leave)
    return {"lines": max(acknowledged)}


def at(hand, panel, step):
    """Wait for a step of the sending."""
    hand.wait(lambda: panel.sending.flow.step == step, FIRST_S, f"the step {step}")


def go_on(hand):
    """Press the tour's button."""
    hand.wait(lambda: hand.exists(f"{TOUR}_do"), STEP_S, "the tour")
    hand.click(f"{TOUR}_do")


def reached(hand, number):
    """Wait until the tour has seen so many steps done."""
    import FreeCADGui
    from PySide import QtGui

    def place():
        return FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, TOUR).tour.place

    hand.wait(lambda: place() >= number, STEP_S, f"step {number} of the tour")


def text_label():
    """Return the label of the text in FreeCAD's tree."""
    import FreeCAD

    from CNCStepper.workbench.features.base import proxy_type

    return next(obj.Label for obj in FreeCAD.ActiveDocument.Objects if proxy_type(obj) == "CNCStepper_Text")


def in_a_thread(link, keeper, step):
    """Do a step beside the interface, and answer."""
    from window_helpers.hand import Hand

    try:
        hand = Hand(link, keeper)
        with keeper.watching():
            try:
                found = work(hand, step)
            except BaseException:
                hand.shot(f"failed-{step}")
                raise
    except BaseException:
        found = {"error": traceback.format_exc()}
    link.call(answer, found)


def answer(result):
    """Write what was found, and close FreeCAD a moment later."""
    from PySide import QtCore

    Path(os.environ["CNCSTEPPER_ANSWER"]).write_text(json.dumps(result), "utf-8")
    QtCore.QTimer.singleShot(0, close)


def close():
    """Close the documents, else FreeCAD asks whether they are to be saved, and the window."""
    import FreeCAD
    import FreeCADGui

    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)
    FreeCADGui.getMainWindow().close()


def begin():
    """Do what is asked; FreeCAD is up now."""
    import FreeCADGui

    from window_helpers import interface

    global link, keeper
    step = os.environ["CNCSTEPPER_STEP"]
    FreeCADGui.getMainWindow().showMaximized()
    if step == "ask":
        try:
            answer(ask())
        except BaseException:
            answer({"error": traceback.format_exc()})
        return
    link = interface.Interface()
    keeper = interface.Keeper((str(TESTS / "window_helpers"),), link)
    threading.Thread(target=in_a_thread, args=(link, keeper, step), daemon=True).start()


def start():
    """Wait for FreeCAD's event loop."""
    from PySide import QtCore

    QtCore.QTimer.singleShot(500, begin)


start()
