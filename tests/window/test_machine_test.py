# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine test in the window, at the virtual grbl that the dock is connected to."""

from __future__ import annotations

import dataclasses
import shutil
from collections.abc import Iterator
from typing import Any

import FreeCADGui
import pytest
from PySide import QtGui

from CNCStepper.machine.files.profile_files import own_folder
from CNCStepper.machine.profile import load_machine
from CNCStepper.workbench.dock.model.port_choices import VIRTUAL
from CNCStepper.workbench.machines.port_levels import levels_of
from window_helpers import screen_places as places
from window_helpers.docks import one_run
from window_helpers.hand import Hand

M, T, D = "CNCStepper_Machines", "CNCStepper_MachineTest", "CNCStepper_Dock_"


@pytest.fixture
def bench(hand: Hand, tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> Iterator[Any]:
    """The machine test of table-a, the dock connected to the virtual grbl."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path_factory.mktemp("state")))
    hand.command("CNCStepper_Controller")
    hand.wait(lambda: FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, "CNCStepper_Dock"))
    dock = hand.main(FreeCADGui.getMainWindow().findChild, QtGui.QDockWidget, "CNCStepper_Dock")
    panel = hand.main(dock.widget)
    hand.main(panel.connection.look, VIRTUAL)
    hand.command(M)
    hand.wait(lambda: FreeCADGui.getMainWindow().findChild(QtGui.QDialog, M), what="the dialog")
    machines = hand.main(FreeCADGui.getMainWindow().findChild, QtGui.QDialog, M)

    def begin() -> Any:
        machines.look("table-a")
        machines.tabs.setCurrentIndex(machines.tabs.count() - 1)
        return machines.test

    test = hand.main(begin)
    assert "Connect to the machine first" in hand.text(f"{T}_state")
    hand.main(panel.connection.speed.setCurrentIndex, 1)
    hand.main(panel.connect_chosen)
    hand.wait(lambda: not test.bench.why_not(), 60, "the machine")
    hand.main(panel.link.command, "set_zero", "XYZ")
    hand.wait(lambda: test.bench.status.position_known, 20, "a known position")
    yield machines

    def end() -> None:
        machines.drafts = {}
        machines.close()
        machines.deleteLater()
        panel.link.leave()
        panel.refresh()
        dock.close()

    hand.main(end)
    hand.settle()
    shutil.rmtree(own_folder(), ignore_errors=True)


def press(hand: Hand, name: str) -> None:
    hand.main(lambda: places.scroll_to(places.find(f"{T}_{name}")))
    hand.settle()
    hand.click(f"{T}_{name}")


def put(hand: Hand, **values: str) -> None:
    """Type into fields, and choose in boxes."""
    for name, text in values.items():
        hand.main(lambda name=name: places.scroll_to(places.find(f"{T}_{name}")))
        hand.settle()
        is_box = isinstance(hand.find(f"{T}_{name}"), QtGui.QComboBox)
        hand.choose(f"{T}_{name}", text) if is_box else hand.fill(f"{T}_{name}", text)


def mpos(test: Any) -> tuple[float, ...]:
    return tuple(round(value, 2) for value in test.bench.status.mpos_mm)


def rests(hand: Hand, test: Any) -> None:
    hand.wait(lambda: not test.bench.why_not() or test.bench.trouble, 30, "the end of the test")
    assert hand.main(lambda: test.bench.trouble) == ""


def test_pulses_a_square_and_a_circle(hand: Hand, bench: Any) -> None:
    test = bench.test
    hand.shot("machine-test", M)
    assert not hand.main(lambda: bench.tabs.currentWidget().horizontalScrollBar().isVisible())
    began = hand.main(mpos, test)
    press(hand, "forward")
    hand.wait(lambda: mpos(test)[0] == began[0] + 5.0, 20, "400 pulses of 80 a mm")
    rests(hand, test)
    press(hand, "back")
    hand.wait(lambda: mpos(test) == began, 20, "back again")
    rests(hand, test)
    put(hand, axis="Y", pulses="80", size="10", feed="3000", height="2")
    for name, place in (("forward", (began[0], began[1] + 1.0, began[2])), ("back", began)):
        press(hand, name)
        hand.wait(lambda place=place: mpos(test) == place, 20, "80 pulses of 80 a mm")
        rests(hand, test)
    for name in ("square", "circle"):
        press(hand, name)
        hand.wait(lambda: mpos(test)[2] == began[2] + 2.0, 5, "it lifts")
        rests(hand, test)
        hand.wait(lambda: mpos(test) == began, 20, f"the {name} closes")
    put(hand, feed="100", height="0")
    press(hand, "square")
    hand.wait(lambda: mpos(test)[0] > began[0] + 0.2, 10, "it moves")
    press(hand, "stop")
    hand.wait(lambda: test.bench.status.phase in ("idle", "alarm"), 20, "it stands")
    assert began[0] < hand.main(mpos, test)[0] < began[0] + 9.0


def test_relays_switch_and_show_what_is_on(hand: Hand, bench: Any) -> None:
    test = bench.test
    press(hand, "relay_flood")
    hand.wait(lambda: "F" in (test.bench.status.outputs or ""), 20, "flood is on")
    rests(hand, test)
    assert hand.main(test._relays["flood"].isChecked)
    press(hand, "relay_flood")
    hand.wait(lambda: "F" not in (test.bench.status.outputs or ""), 20, "flood is off")
    rests(hand, test)
    press(hand, "relay_spindle_cw")
    hand.wait(lambda: "S" in (test.bench.status.outputs or ""), 20, "the spindle is on")


def test_a_measured_travel_corrects_the_profile(hand: Hand, bench: Any) -> None:
    test = bench.test
    put(hand, travel_axis="Y", length="10", feed="3000")
    for measured in ("9.9", "9.91", "9.89"):
        for button in ("start", "along"):
            with one_run(hand, test.bench):
                press(hand, button)
        put(hand, measured=measured)
        press(hand, "reading")
        hand.settle()
        rests(hand, test)
    assert "steps per mm 80 becomes 80.8081" in hand.text(f"{T}_travel_words")
    hand.shot("machine-test-travel", M)
    press(hand, "correct")
    hand.wait(lambda: bench.draft.is_changed, what="the draft")
    assert hand.main(lambda: bench.draft.texts[("axis", "y", "steps_per_mm")]) == "80.8081"


def test_backlash_and_squareness(hand: Hand, bench: Any) -> None:
    test = bench.test
    put(hand, feed="3000", play_axis="Y", distance="2")
    began = hand.main(mpos, test)
    for side, value in (("below", "0.02"), ("above", "0.12")):
        with one_run(hand, test.bench):
            press(hand, side)
        put(hand, dial=value)
        press(hand, f"dial_{side}")
    assert "backlash 0.1 mm" in hand.text(f"{T}_play_words")
    press(hand, "play_correct")
    hand.wait(lambda: bench.draft.texts[("axis", "y", "backlash_mm")] == "0.1", 5, "the draft")
    assert hand.main(mpos, test)[0] == began[0], "only the axis that was chosen"
    put(hand, side_x="3", side_y="4")
    begins, goes = hand.main(mpos, test), ((3.0, 0.0), (3.0, 4.0), (0.0, 4.0), (0.0, 0.0))
    for corner, (x, y) in enumerate(goes):
        press(hand, f"corner_{corner}")
        place = (round(begins[0] + x, 2), round(begins[1] + y, 2), begins[2])
        hand.wait(lambda place=place: mpos(test) == place, 20, f"corner {corner}")
        rests(hand, test)
    put(hand, side_x="300", side_y="400", falling="501")
    press(hand, "angle")
    assert "90.2390°: 4.171 mm" in hand.text(f"{T}_square_words")
    put(hand, rising="499")
    press(hand, "angle")
    assert "90.2390°" not in hand.text(f"{T}_square_words")
    hand.shot("machine-test-square", M)


def test_the_ports_pins_show_what_the_status_says(hand: Hand, bench: Any) -> None:
    hand.main(bench.look, "thesis-table")
    hand.wait(bench.test.port.isVisible, what="the port of a profile with one")
    hand.main(lambda: places.scroll_to(bench.test.port))
    hand.settle()
    hand.shot("machine-test-port", M)
    assert hand.main(bench.test.port.words, 2).startswith("Pin 2: output, X step")
    table = load_machine("thesis-table")
    status = dataclasses.replace(hand.main(lambda: bench.test.bench.status), outputs="SF", port_inputs=(11,))
    levels = levels_of(table, status)
    assert levels[abs(table.signals.wired["spindle_cw"])] is True and levels[11] is True and levels[10] is False
    assert levels_of(table, None) == {}
