# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine assistant by real clicks: from nothing to a saved profile, with which the virtual machine cuts a job."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtGui
from test_language import PORTUGUESE, STARTED_IN
from test_road import DOCK, own_sessions, step  # noqa: F401

from CNCStepper.workbench.services.translation import tr
from window_helpers import screen_places as places
from window_helpers.hand import Hand

A, FIELD, PANEL, PLAYER = "CNCStepper_Assistant", "CNCStepper_Machine", "CNCStepper_Panel_", "CNCStepper_Simulation_"
MILL = "Genmitsu 3018-PRO – 300 × 180 × 45 mm"


def dialog() -> Any:
    return FreeCADGui.getMainWindow().findChild(QtGui.QDialog, A)


@pytest.fixture(params=["English", PORTUGUESE])
def assistant(hand: Hand, request: pytest.FixtureRequest) -> Iterator[Any]:
    """The assistant in a language, opened by its command; afterwards nothing is connected and no profile is left."""
    from CNCStepper.machine.files.profile_files import own_folder
    from CNCStepper.workbench.dock.model import settings

    shutil.rmtree(own_folder(), ignore_errors=True)
    hand.main(FreeCADGui.setLocale, request.param)
    hand.settle()
    hand.main(settings.remember_port, "virtual", 115200)
    hand.menu("CNCStepper", hand.main(FreeCAD.Qt.translate, A, "Machine assistant…").rstrip("…"))
    hand.wait(lambda: dialog() and dialog().isVisible(), what="the assistant")
    hand.settle()
    yield dialog()

    def end() -> None:
        for window in FreeCADGui.getMainWindow().findChildren(QtGui.QDialog, A):
            window.close()
            window.deleteLater()
        dock = FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, "CNCStepper_Dock")
        if dock:
            dock.widget().link.leave()
            dock.widget().refresh()
            dock.close()
        settings.remember_machine(settings.MACHINE)
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)
        FreeCADGui.setLocale(STARTED_IN)

    hand.main(end)
    hand.settle()
    shutil.rmtree(own_folder(), ignore_errors=True)


def cut_off() -> list[str]:
    """Return the texts of the page in front that are narrower than what stands on them."""
    return places.narrower_than_their_text(dialog())


def go_on(hand: Hand, number: int) -> None:
    """Look at the page, and go to the next one."""
    hand.settle()
    hand.shot(f"assistant-{number}-{hand.main(FreeCADGui.getLocale)}", A)
    assert hand.main(cut_off) == []
    hand.click(f"{A}_next")
    hand.wait(lambda: dialog().steps.currentRow() == number, what=f"step {number + 1}")
    hand.settle()


def test_from_nothing_to_a_saved_machine_that_cuts_a_job(hand: Hand, assistant: Any) -> None:
    connect(hand)
    go_on(hand, 1)
    hand.item(f"{A}_starts", MILL)
    hand.wait(lambda: dialog().setup.base == "genmitsu-3018-pro", what="the mill")
    go_on(hand, 2)
    values(hand)
    go_on(hand, 3)
    write_to_the_controller(hand)
    measure(hand)
    hand.click(f"{A}_next")
    hand.wait(lambda: dialog().steps.currentRow() == 4, what="the settings")
    hand.click(f"{A}_next")
    hand.wait(lambda: dialog().steps.currentRow() == 5, what="the name")
    save(hand)
    cut_a_job(hand)


def connect(hand: Hand) -> None:
    hand.click(f"{A}_connect")
    hand.wait(lambda: dialog().setup.identity is not None, 90, "what answers")
    assert "1.1" in hand.text(f"{A}_found")


def values(hand: Hand) -> None:
    assert hand.text(f"{FIELD}_axis_x_steps_per_mm") == "800"
    hand.fill(f"{FIELD}_axis_x_steps_per_mm", "many")
    hand.wait(lambda: dialog().page.why_not())
    hand.click(f"{A}_next")
    hand.settle()
    assert hand.main(lambda: dialog().steps.currentRow()) == 2, "a bad value keeps the step"
    hand.fill(f"{FIELD}_axis_x_steps_per_mm", "800")
    hand.fill(f"{FIELD}_name", "My 3018")
    hand.fill(f"{FIELD}_axis_x_acceleration_mm_s2", "200")
    hand.fill(f"{FIELD}_axis_y_acceleration_mm_s2", "200")
    hand.wait(lambda: not dialog().page.why_not())


def write_to_the_controller(hand: Hand) -> None:
    """Go over the measuring to the settings, write them, and come back."""
    hand.click(f"{A}_next")
    hand.wait(lambda: dialog().steps.currentRow() == 4, what="the settings")
    hand.click(f"{A}_write")
    hand.wait(lambda: places.visible("CNCStepper_Tell_yes"), what="the question")
    hand.shot(f"assistant-question-{hand.main(FreeCADGui.getLocale)}")
    hand.click("CNCStepper_Tell_yes")
    hand.wait(lambda: not any(row.differs for row in dialog().page._rows), 20, "all is written")
    assert hand.main(lambda: dialog().setup.identity.settings[100]) == 800
    hand.shot(f"assistant-settings-{hand.main(FreeCADGui.getLocale)}", A)
    assert hand.main(cut_off) == []
    hand.click(f"{A}_back")
    hand.wait(lambda: dialog().steps.currentRow() == 3, what="the measuring")


def measure(hand: Hand) -> None:
    hand.fill(f"{A}_length", "10")
    hand.fill(f"{A}_feed", "800")
    for button in ("to_start", "move"):
        hand.wait(lambda: not dialog().bench.why_not(), 20, "the machine")
        hand.click(f"{A}_{button}")
        hand.wait(lambda: dialog().bench.is_busy, 5, "it moves")
        hand.wait(lambda: not dialog().bench.why_not() or dialog().bench.trouble, 30, "it is there")
        assert hand.main(lambda: dialog().bench.trouble) == ""
    hand.fill(f"{A}_measured", "9.9")
    hand.click(f"{A}_correct")
    hand.wait(lambda: places.visible("CNCStepper_Tell_yes"), what="the question")
    hand.click("CNCStepper_Tell_yes")
    hand.wait(lambda: dialog().setup.identity.settings[100] != 800, 20, "it is read back")
    assert hand.main(lambda: dialog().setup.identity.settings[100]) == pytest.approx(808.081, abs=0.001)
    assert hand.main(lambda: dialog().setup.draft.texts[("axis", "x", "steps_per_mm")]) == "808.0808"
    hand.shot(f"assistant-measured-{hand.main(FreeCADGui.getLocale)}", A)
    hand.wait(lambda: not dialog().bench.why_not(), 20, "the machine")
    hand.click(f"{A}_return")
    hand.wait(lambda: dialog().bench.status.mpos_mm[0] == pytest.approx(0.0, abs=0.01), 30, "it is back")
    hand.wait(lambda: not dialog().bench.why_not(), 20, "it rests")


def save(hand: Hand) -> None:
    from CNCStepper.machine.profile import load_machine

    hand.fill(f"{A}_name", "meu-3018")
    hand.click(f"{A}_save")
    hand.wait(lambda: dialog().setup.saved == "meu-3018", what="it is saved")
    assert load_machine("meu-3018").axis["x"].steps_per_mm == 808.0808
    hand.shot(f"assistant-6-{hand.main(FreeCADGui.getLocale)}", A)
    assert hand.main(cut_off) == []
    hand.click(f"{A}_close")
    hand.wait(lambda: not dialog().isVisible(), what="its end")


def cut_a_job(hand: Hand) -> None:
    """Make a small job for the new machine, and cut it on the virtual one, which has its settings now."""
    from CNCStepper.workbench import api

    def made() -> None:
        document = FreeCAD.newDocument("Assistant")
        job = api.new_job(document, machine="meu-3018")
        api.add_tool(job, diameter_mm=3, feed_mm_min=700, plunge_mm_min=200, spindle_rpm=8000)
        api.add_operation(job, "circular_pocket", radius_mm=4, depth_mm=0.5)
        document.recompute()

    hand.main(made)
    hand.settle()
    hand.command("CNCStepper_Send")
    step(hand, hand.main(tr, "Work zero"))
    hand.click(f"{DOCK}ZeroAll")
    hand.wait(lambda: hand.find(f"{DOCK}Start").isEnabled(), 20, "Start")
    hand.click(f"{DOCK}Start")
    step(hand, hand.main(tr, "Done"), 240)


def test_settings_are_backed_up_and_restored_after_a_refusal(hand: Hand, assistant: Any, tmp_path: Path) -> None:
    connect(hand)
    backup = tmp_path / "backup.txt"
    hand.main(lambda: dialog().steps.setCurrentRow(4))
    hand.click(f"{A}_backup")
    hand.wait(lambda: dialog().findChild(QtGui.QFileDialog), what="the file's dialog")
    hand.settle()
    hand.type(str(backup))
    hand.wait(lambda: places.find("fileNameEdit").text() == str(backup), 10, "the name is typed")
    hand.key("Return")
    if not hand._is_soon(backup.is_file):
        hand.key("Return")  # the first one closed the list of names that Qt proposes
    hand.wait(backup.is_file, 10, "the backup")
    hand.settle()
    text = backup.read_text("utf-8")
    assert "$110=5000" in text
    backup.write_text(text.replace("$110=5000", "$110=0").replace("$111=5000", "$111=4000"), "utf-8")
    hand.main(lambda: dialog().page._take_backup(backup))
    hand.main(lambda: dialog().page.other.setCurrentIndex(1))
    hand.main(lambda: (dialog().page._fill(), dialog().page.refresh()))
    hand.click(f"{A}_only")
    hand.wait(lambda: dialog().page.table.rowCount() == 2, what="the differences")
    hand.shot(f"assistant-compared-{hand.main(FreeCADGui.getLocale)}", A)
    hand.click(f"{A}_write")
    hand.wait(lambda: places.visible("CNCStepper_Tell_yes"), what="the question")
    hand.click("CNCStepper_Tell_yes")
    hand.wait(lambda: "error:4" in dialog().page.note.text(), 20, "the refusal")
    hand.wait(lambda: not dialog().bench.is_busy, 20, "it is read again")
    assert hand.main(lambda: dialog().setup.identity.settings[111]) == 5000
    assert "error:4" in hand.main(lambda: dialog().page.note.text()), "the refusal stays to be read"
    hand.shot(f"assistant-refused-{hand.main(FreeCADGui.getLocale)}", A)
