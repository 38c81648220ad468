# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole road, clicked and typed: a job, a drawn line, a pocket, edit and undo, the simulation, the cut, done.

Its pictures are the ones that `make pictures` keeps in docs/pictures.
"""

from __future__ import annotations

import math
from typing import Any

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtGui

from CNCStepper.workbench import api
from CNCStepper.workbench.features.base import proxy_type
from CNCStepper.workbench.services.translation import tr
from window_helpers.hand import PICTURES, Hand
from window_helpers.task_panels import PANEL, accept

DOCK, PLAYER = "CNCStepper_Dock_", "CNCStepper_Simulation_"
FLAT_PASS = "1.4"  # mm: 3 mm less the last pass of 0.2 mm, in two
LEAF_MM = [(-18 + 36 * k / 40, 9 * math.sin(k / 40 * 2 * math.pi)) for k in range(41)]


@pytest.fixture(autouse=True)
def own_sessions(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    """Machines that other windows on this computer are connected to are none of ours."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path_factory.mktemp("state")))


def ours(kind: str) -> list[Any]:
    document = FreeCAD.ActiveDocument
    return [obj for obj in document.Objects if proxy_type(obj) == f"CNCStepper_{kind}"] if document else []


def undo_count() -> int:
    return int(FreeCAD.ActiveDocument.UndoCount)


def state(hand: Hand, words: str, seconds: float = 60.0) -> None:
    hand.wait(lambda: hand.find(f"{DOCK}State").text() == tr(words), seconds, f"the state {words}")


def step(hand: Hand, title: str, seconds: float = 120.0) -> None:
    """Wait for a step of the dock; where it does not come, what was to be sent is kept beside the pictures."""
    words = hand.main(tr, title)
    try:
        hand.wait(lambda: hand.exists(f"{DOCK}FlowTitle") and words in hand.text(f"{DOCK}FlowTitle"), seconds, words)
    except AssertionError as error:
        hand.main(keep_what_is_sent)
        raise AssertionError(f"{error}; the dock says: {hand.text(f'{DOCK}FlowTitle')}") from None


def keep_what_is_sent() -> None:
    """Write the job's program, and the job with which it is proven, as road-failed.nc and .json."""
    from CNCStepper.job.model import save_job  # a FreeCAD without packages collects this module too
    from CNCStepper.workbench.document.core_job import proven_with

    (job,) = ours("Job")
    (PICTURES / "road-failed.nc").write_text(api.program_text(job), "utf-8")
    save_job(proven_with(job), PICTURES / "road-failed.json")


@pytest.mark.window("plain", "scaled", "portuguese")
def test_from_an_empty_window_to_a_cut_part(hand: Hand) -> None:
    new_job(hand)
    draw_a_line(hand)
    cut_a_pocket(hand)
    edit_and_undo(hand)
    engrave_the_line(hand)
    simulate(hand)
    send(hand)


def look_from_above(height_mm: float) -> None:
    import pivy.coin  # noqa: F401  the camera's type comes from it

    view = FreeCADGui.ActiveDocument.ActiveView
    view.setAnimationEnabled(False)
    view.viewTop()
    view.getCameraNode().height.setValue(height_mm)


def new_job(hand: Hand) -> None:
    hand.command("CNCStepper_NewJob")
    hand.wait(lambda: hand.exists(f"{PANEL}ok"), 20, "the job's panel")
    assert hand.text(f"{PANEL}cancel") == hand.main(tr, "Cancel")
    hand.shot("road-1-job")
    accept(hand)
    assert len(hand.main(ours, "Job")) == 1
    assert hand.main(undo_count) == 1


def draw_a_line(hand: Hand) -> None:
    hand.main(look_from_above, 130.0)  # newer FreeCADs lay the task panel over the right of the view
    hand.command("CNCStepper_Freehand")
    places = [hand.view_point(x, y) for x, y in LEAF_MM]
    hand.press_at(places[0])
    for place in places[1:]:
        hand.move_to(place)
    hand.shot("road-2-drawing")
    hand.release()
    hand.key("Escape")
    (line,) = hand.main(ours, "Freehand")
    assert hand.main(lambda: line.Label == tr("Freehand"))


def cut_a_pocket(hand: Hand) -> None:
    hand.main(FreeCADGui.Selection.clearSelection)
    hand.command("CNCStepper_EllipticalPocket")
    hand.wait(lambda: hand.exists(f"{PANEL}depth_mm"), 20, "the pocket's panel")
    hand.fill(f"{PANEL}radius_x_mm", "26")
    hand.fill(f"{PANEL}radius_y_mm", "17,5")
    hand.fill(f"{PANEL}depth_mm", "3")
    hand.wait(lambda: FLAT_PASS in hand.text(f"{PANEL}ap_mm").replace(",", "."), 20, "the passes of that depth")
    hand.wait(lambda: hand.text(f"{PANEL}time")[:1].isdigit(), 20, "the time of the pocket")
    hand.shot("road-3-pocket")
    accept(hand)
    (pocket,) = hand.main(ours, "EllipticalPocket")
    assert hand.main(lambda: (float(pocket.RadiusX), float(pocket.RadiusY), float(pocket.Depth))) == (26, 17.5, 3)


def edit_and_undo(hand: Hand) -> None:
    (job,), (pocket,) = hand.main(ours, "Job"), hand.main(ours, "EllipticalPocket")
    before, count = hand.main(api.program_text, job), hand.main(undo_count)
    hand.tree(hand.main(lambda: pocket.Label), double=True)
    hand.wait(lambda: hand.exists(f"{PANEL}depth_mm"), 20, "the pocket's panel")
    hand.fill(f"{PANEL}depth_mm", "5 mm")
    accept(hand)
    assert "Z-5" in hand.main(api.program_text, job)
    assert hand.main(undo_count) == count + 1
    hand.undo()
    hand.wait(lambda: float(pocket.Depth) == 3, 10, "the undo")
    assert hand.wait(lambda: api.program_text(job), 10) == before


def engrave_the_line(hand: Hand) -> None:
    (line,) = hand.main(ours, "Freehand")
    hand.tree(hand.main(lambda: line.Label))
    hand.command("CNCStepper_Engrave")
    hand.wait(lambda: hand.exists(f"{PANEL}depth_mm"), 20, "the engraving's panel")
    hand.fill(f"{PANEL}depth_mm", "4")
    accept(hand)
    (engraving,) = hand.main(ours, "Engrave")
    assert hand.main(lambda: engraving.Drawings[0][0]) == line


def simulate(hand: Hand) -> None:
    hand.main(lambda: FreeCADGui.ActiveDocument.ActiveView.viewIsometric())
    hand.main(FreeCADGui.SendMsgToActiveView, "ViewFit")
    hand.command("CNCStepper_Simulate")
    hand.wait(lambda: hand.exists(f"{PLAYER}play") and hand.find(f"{PLAYER}play").isEnabled(), 180, "the simulation")
    hand.click(f"{PLAYER}play")
    hand.wait(lambda: hand.find(f"{PLAYER}time").value() > 2000, 60, "the tool to run")
    hand.click(f"{PLAYER}play")
    hand.shot("road-4-simulation")
    hand.click(hand.main(close_button))
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 10)


def close_button() -> Any:
    """Return the button of the task panel that Qt names in FreeCAD's language."""
    boxes = FreeCADGui.getMainWindow().findChildren(QtGui.QDialogButtonBox)
    close = QtGui.QDialogButtonBox.StandardButton.Close
    return next(box.button(close) for box in boxes if box.isVisible() and box.button(close))


def send(hand: Hand) -> None:
    (job,) = hand.main(ours, "Job")
    hand.tree(hand.main(lambda: job.Label))
    hand.command("CNCStepper_Send")
    step(hand, "Connect")
    virtual = hand.main(tr, "Virtual grbl (no machine)")
    if hand.text(f"{DOCK}Port") != virtual:  # a test before has connected to another one
        hand.choose(f"{DOCK}Port", virtual)
    hand.choose(f"{DOCK}Speed", hand.main(tr, "{0}× speed").format(10))
    hand.click(f"{DOCK}Start")
    step(hand, "Work zero")
    hand.shot("road-5-zero")
    hand.click(f"{DOCK}ZeroAll")
    hand.wait(lambda: hand.find(f"{DOCK}Start").isEnabled(), 10, "Start")
    hand.click(f"{DOCK}Start")
    state(hand, "Running")
    hand.wait(lambda: hand.find(f"{DOCK}Progress").value() > 100, 60)
    hand.shot("road-6-running")
    hand.click(f"{DOCK}Hold")
    state(hand, "Held")
    hand.shot("road-7-held")
    hand.click(f"{DOCK}Resume")
    state(hand, "Running")
    step(hand, "Done")
    state(hand, "Idle")
    hand.shot("road-8-done")
    hand.click(f"{DOCK}Cancel")
    hand.click(f"{DOCK}Connect")
    state(hand, "Not connected")
