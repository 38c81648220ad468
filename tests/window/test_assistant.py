# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine assistant by real clicks: from nothing to a saved profile, with which the virtual machine cuts a job."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtCore, QtGui
from test_language import PORTUGUESE, STARTED_IN
from test_road import DOCK, own_sessions, step  # noqa: F401

from CNCStepper.workbench.services.translation import tr
from window_helpers import screen_places as places
from window_helpers.docks import one_run
from window_helpers.file_dialogs import choose_file
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
            dock.widget().connection.look_for_machines(settings.MACHINE)
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
    hand.click(f"{A}_take")
    held = hand.main(lambda: dialog().setup.identity.settings[100])
    hand.wait(lambda: dialog().setup.draft.texts[("axis", "x", "steps_per_mm")] == f"{held:g}", what="its values")
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
        with one_run(hand, hand.main(lambda: dialog().bench)):
            hand.click(f"{A}_{button}")
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


@pytest.mark.parametrize("assistant", ["English"], indirect=True)
def test_settings_are_backed_up_and_restored_after_a_refusal(hand: Hand, assistant: Any, tmp_path: Path) -> None:
    connect(hand)
    hand.main(lambda: setattr(dialog().setup, "identity", None))
    hand.click(f"{A}_ask")
    hand.wait(lambda: dialog().setup.identity is not None, 20, "what answers once more")
    backup = tmp_path / "backup.txt"
    go_to(hand, 5, "Settings")
    hand.click(f"{A}_backup")
    choose_file(hand, f"{A}_file", backup)
    hand.wait(backup.is_file, 10, "the backup")
    text = backup.read_text("utf-8")
    assert "$110=5000" in text
    backup.write_text(text.replace("$110=5000", "$110=0").replace("$111=5000", "$111=4000"), "utf-8")
    hand.choose(f"{A}_other", "a backup…")
    choose_file(hand, f"{A}_file", backup)
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
    hand.item(f"{A}_settings", "$111")
    assert hand.main(lambda: dialog().page.table.currentRow()) == 1
    stops_on_the_way(hand)


def stops_on_the_way(hand: Hand) -> None:
    """Move the second axis, and stop it before it is there."""
    go_to(hand, 4, "Measure")
    hand.choose(f"{A}_axis", "Y")
    hand.wait(lambda: hand.text(f"{A}_steps_per_mm").startswith("Y: "), 10, "the axis")
    hand.wait(lambda: not dialog().bench.why_not(), 20, "the machine")
    hand.click(f"{A}_move")
    hand.wait(lambda: dialog().bench.status.mpos_mm[1] > 0.5, 10, "it moves")
    hand.click(f"{A}_stop")
    hand.wait(lambda: dialog().bench.status.phase in ("idle", "alarm"), 20, "it stands")
    assert 0.5 < hand.main(lambda: dialog().bench.status.mpos_mm[1]) < 90.0


def go_to(hand: Hand, number: int, title: str) -> None:
    """Click a step in the list."""
    hand.item(hand.main(lambda: dialog().steps), f"{number}. {title}")
    hand.wait(lambda: dialog().steps.currentRow() == number - 1, what=title)
    hand.settle()


@pytest.mark.parametrize("assistant", ["English"], indirect=True)
def test_ports_machines_and_files_are_chosen_without_a_machine(
    hand: Hand, assistant: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from CNCStepper.control.transport import link

    monkeypatch.setattr(link, "port_list", lambda: [SimpleNamespace(name="/dev/ttyNEW0", text="New board")])
    hand.click(f"{A}_look")
    hand.wait(lambda: hand.text(f"{A}_found").startswith("New board is new"), what="the port that has come")
    hand.choose(f"{A}_baud", "57600")
    assert hand.main(lambda: (dialog().page._port(), dialog().page.baud.currentText())) == ("/dev/ttyNEW0", "57600")
    hand.fill(f"{A}_port", "socket://127.0.0.1:2300")
    hand.wait(lambda: not places.visible(f"{A}_baud"), what="a baud rate that an address does not have")
    go_to(hand, 2, "Machine")
    for box, entry, every in (("process", "turning", "table-a"), ("controller", "thesis-a", "genmitsu-3018-pro")):
        hand.choose(f"{A}_{box}", entry)
        assert hand.main(listed) and every not in hand.main(listed)
        hand.choose(f"{A}_{box}", "all")
        assert every in hand.main(listed)
    go_to(hand, 3, "Values")
    hand.fill(f"{FIELD}_name", "Shop mill")
    go_to(hand, 6, "Save")
    assert hand.text(f"{A}_name") == "shop-mill"
    hand.click(f"{A}_save")
    hand.click(f"{A}_export")
    file = tmp_path / "oficina.fcm"
    choose_file(hand, f"{A}_file", file)
    hand.wait(file.is_file, 10, "the machine's file for FreeCAD")
    go_to(hand, 2, "Machine")
    hand.item(f"{A}_starts", MILL)
    hand.click(f"{A}_fcm")
    choose_file(hand, f"{A}_file", file)
    hand.wait(lambda: hand.text(f"{A}_about").startswith("Shop mill is read."), 10, "the file to be read")


def listed() -> list[str]:
    """Return the profiles that can be begun from."""
    entries = dialog().page.list
    return [entries.item(row).data(QtCore.Qt.ItemDataRole.UserRole) for row in range(entries.count())]
