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
    hand.main(test.size.setValue, 10.0)
    hand.main(test.feed.setValue, 3000.0)
    for name in ("square", "circle"):
        press(hand, name)
        hand.wait(lambda: test.bench.is_busy, 5, "it begins")
        rests(hand, test)
        hand.wait(lambda: mpos(test) == began, 20, f"the {name} closes")


def test_relays_switch_and_show_what_is_on(hand: Hand, bench: Any) -> None:
    test = bench.test
    press(hand, "relay_flood")
    hand.wait(lambda: "F" in (test.bench.status.outputs or ""), 20, "flood is on")
    rests(hand, test)
    assert hand.main(test._relays["flood"].isChecked)
    press(hand, "relay_flood")
    hand.wait(lambda: "F" not in (test.bench.status.outputs or ""), 20, "flood is off")


def test_a_measured_travel_corrects_the_profile(hand: Hand, bench: Any) -> None:
    test = bench.test
    hand.main(test.travel_length.setValue, 10.0)
    hand.main(test.feed.setValue, 3000.0)
    for measured in (9.9, 9.91, 9.89):
        press(hand, "start")
        rests(hand, test)
        press(hand, "along")
        hand.wait(lambda: test.bench.is_busy, 5, "it begins")
        rests(hand, test)
        hand.main(test.measured.setValue, measured)
        press(hand, "reading")
        hand.settle()
        rests(hand, test)
    assert "steps per mm 80 becomes 80.8081" in hand.text(f"{T}_travel_words")
    hand.shot("machine-test-travel", M)
    press(hand, "correct")
    hand.wait(lambda: bench.draft.is_changed, what="the draft")
    assert hand.main(lambda: bench.draft.texts[("axis", "x", "steps_per_mm")]) == "80.8081"


def test_backlash_and_squareness(hand: Hand, bench: Any) -> None:
    test = bench.test
    hand.main(test.feed.setValue, 3000.0)
    for side, value in (("below", 0.02), ("above", 0.12)):
        press(hand, side)
        hand.wait(lambda: test.bench.is_busy, 5, "it begins")
        rests(hand, test)
        hand.main(test.dial.setValue, value)
        press(hand, f"dial_{side}")
    assert "backlash 0.1 mm" in hand.text(f"{T}_play_words")
    hand.main(test.falling.setValue, 501.0)
    press(hand, "angle")
    assert "90.2390°: 4.171 mm" in hand.text(f"{T}_square_words")
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
