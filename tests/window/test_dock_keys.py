# SPDX-License-Identifier: LGPL-2.1-or-later
"""Real keys in the controller's dock act on what it shows or on nothing: never on Stop, nor on the tree."""

from __future__ import annotations

import time
from typing import Any

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtCore, QtGui
from test_dock import D, connected, dock, own_sessions, pocket, says, start_button, work_mm, zeroed  # noqa: F401

from CNCStepper.workbench.dock.connection import Link
from CNCStepper.workbench.dock.model.button_states import ControllerSnapshot
from window_helpers.hand import Hand

DOCKS_OWN = ("space", "Return", "Escape", "Delete", "v", "0")  # with which FreeCAD hides, deletes, turns the view …
LET_GO_S = 1.5  # so long a key is held: X repeats it some 25 times a second after half a second


def begun(hand: Hand) -> Any:
    """Send a pocket to the virtual machine, and select a box that Space would hide; return it."""
    pocket(hand)
    connected(hand, "1× speed")
    hand.command("CNCStepper_Send")
    hand.wait(lambda: hand.exists(f"{D}Start") and "Work zero" in hand.text(f"{D}FlowTitle"), 180, "the proof")

    def select() -> Any:
        box = FreeCAD.ActiveDocument.addObject("Part::Box", "Seen")
        FreeCAD.ActiveDocument.recompute()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(box)
        return box

    box = hand.main(select)
    hand.settle()  # FreeCAD 1.1 gives the keyboard to the 3D view; the clicks take it back
    zeroed(hand)
    hand.click(f"{D}Start")
    says(hand, "Running", 60)
    return box


def focus(hand: Hand) -> str:
    """Return the name of what has the keyboard, without the dock's own."""
    return str(hand.main(lambda: QtGui.QApplication.focusWidget().objectName())).removeprefix(D)


def tree(hand: Hand) -> Any:
    """Return what keys could have changed outside of the dock."""

    def look() -> Any:
        view = FreeCADGui.ActiveDocument.ActiveView
        seen = [(obj.Name, obj.ViewObject.Visibility) for obj in FreeCAD.ActiveDocument.Objects]
        return seen, [obj.Name for obj in FreeCADGui.Selection.getSelection()], str(view.getCameraOrientation())

    return hand.main(look)


def test_the_focus_waits_where_hold_was_and_goes_to_resume_and_back_to_hold(hand: Hand, dock: Any) -> None:  # noqa: F811
    box = begun(hand)
    before = tree(hand)
    assert focus(hand) not in ("Stop", "Hold")  # Start has gone, and what it leaves is no control
    for key in DOCKS_OWN:
        hand.key(key)
    says(hand, "Running", 1)
    hand.click(f"{D}Hold")
    says(hand, "Held")
    assert focus(hand) == "Halt"
    for key in DOCKS_OWN:
        hand.key(key)
    time.sleep(0.5)
    says(hand, "Held", 1)
    hand.shot("keys-held")
    hand.key("Tab")
    assert focus(hand) == "Resume"
    hand.shot("keys-resume")
    hand.key("space")
    says(hand, "Running")
    hand.wait(lambda: focus(hand) == "Hold", 5, "Hold in the place of Resume")
    assert tree(hand) == before and hand.main(lambda: box.ViewObject.Visibility)


def test_a_key_that_is_held_acts_once(hand: Hand, dock: Any, monkeypatch: pytest.MonkeyPatch) -> None:  # noqa: F811
    begun(hand)
    before = tree(hand)
    asked: list[str] = []
    command = dock.link.command
    monkeypatch.setattr(dock.link, "command", lambda name, *rest, **named: (asked.append(name), command(name, *rest)))
    for name, state in (("Hold", "Held"), ("Resume", "Running")):
        hand.main(hand.find(f"{D}{name}").setFocus)
        hand.keyboard.down("space")
        time.sleep(LET_GO_S)
        hand.keyboard.up("space")
        says(hand, state)
        time.sleep(LET_GO_S)
        says(hand, state, 1)
    assert asked == ["hold", "resume"] and tree(hand) == before


def test_every_change_of_state_leaves_the_focus_where_no_key_acts(
    hand: Hand,
    dock: Any,  # noqa: F811
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    shown = [ControllerSnapshot("running")]  # of no job of ours, which would have a process to ask
    monkeypatch.setattr(Link, "moment", property(lambda link: shown[0]))
    asked: list[str] = []
    monkeypatch.setattr(dock.link, "command", lambda name, *rest, **named: asked.append(name))

    def show(phase: str) -> None:
        shown[0] = ControllerSnapshot(phase)
        hand.main(dock.refresh)
        hand.settle()

    def press() -> None:
        for key in DOCKS_OWN:
            hand.key(key)

    show("running")
    hand.main(hand.find(f"{D}Hold").setFocus)
    for phase in ("holding", "held"):
        show(phase)
        assert focus(hand) == "Halt"
        press()
    hand.key("Tab")
    assert focus(hand) == "Resume"
    show("running")
    assert focus(hand) == "Hold"
    show("idle")
    assert focus(hand) == "Halt"
    press()
    hand.main(hand.find(f"{D}ZeroX").setFocus)
    show("alarm")
    assert focus(hand) == ""  # what holds the figures, which is no control
    press()
    assert asked == []


def test_a_repetition_that_qt_takes_for_another_press_acts_once(hand: Hand, dock: Any) -> None:  # noqa: F811
    kind, space, none = QtCore.QEvent.Type, QtCore.Qt.Key.Key_Space, QtCore.Qt.KeyboardModifier.NoModifier
    home = hand.main(lambda: dock.home)
    pressed: list[str] = []

    def press_and_repeat() -> None:
        home.setEnabled(True)
        home.clicked.connect(lambda: pressed.append("home"))
        for what, at_ms in [(kind.KeyPress, 0)] + [(each, at) for at in (660, 700, 740) for each in (RELEASE, PRESS)]:
            event = QtGui.QKeyEvent(what, space, none)
            event.setTimestamp(5000 + at_ms)
            QtGui.QApplication.sendEvent(home, event)

    RELEASE, PRESS = kind.KeyRelease, kind.KeyPress
    hand.main(press_and_repeat)
    assert pressed == ["home"]


def test_arrow_keys_jog_while_their_button_has_the_keyboard(hand: Hand, dock: Any) -> None:  # noqa: F811
    connected(hand, "1× speed")
    keys = hand.main(hand.find, f"{D}JogKeys")
    hand.click(f"{D}JogKeys")
    assert hand.main(keys.isChecked)
    for key, axis, place_mm in (
        ("Right", "X", 1),
        ("Up", "Y", 1),
        ("Prior", "Z", 1),
        ("Left", "X", 0),
        ("Down", "Y", 0),
    ):
        hand.key(key)
        hand.wait(lambda axis=axis, at=place_mm: abs(work_mm(hand, axis) - at) < 0.01, 20, f"{axis} at {place_mm} mm")
        says(hand, "Idle", 5)
    hand.key("Tab")  # away, and off
    assert not hand.main(keys.isChecked) and focus(hand) != "JogKeys"
    for key in ("Right", "Up", "Prior"):
        hand.key(key)
    time.sleep(0.5)
    assert [round(work_mm(hand, axis), 2) for axis in "XYZ"] == [0, 0, 1]


def test_a_key_that_is_held_jogs_until_it_is_let_go_or_the_keyboard_goes(hand: Hand, dock: Any) -> None:  # noqa: F811
    connected(hand, "1× speed")
    hand.click(f"{D}Step4")
    for end in ("release", "leave"):
        hand.click(f"{D}JogKeys")
        stood = work_mm(hand, "Y")
        hand.keyboard.down("Up")
        says(hand, "Jogging")
        hand.wait(lambda stood=stood: work_mm(hand, "Y") > stood + 25, 20, "more than a repetition's way")
        if end == "leave":
            hand.click(f"{D}JogFeed")
        else:
            hand.keyboard.up("Up")
        says(hand, "Idle", 3)
        if end == "leave":
            hand.keyboard.up("Up")
        time.sleep(0.5)  # it may stand a moment between two renewals of the jog
        stood = work_mm(hand, "Y")
        time.sleep(0.5)
        assert work_mm(hand, "Y") == stood
        hand.click(f"{D}ConsoleLine")
        assert not hand.main(hand.find(f"{D}JogKeys").isChecked)


def test_what_stop_leaves_is_no_control(hand: Hand, dock: Any) -> None:  # noqa: F811
    begun(hand)
    before = tree(hand)
    hand.click(f"{D}Stop")
    hand.wait(lambda: "Stopped" in hand.text(f"{D}FlowTitle"), 20)
    assert focus(hand) == "Halt"
    at_mm = [work_mm(hand, axis) for axis in "XYZ"]
    for key in DOCKS_OWN:
        hand.key(key)
    assert "Stopped" in hand.text(f"{D}FlowTitle") and tree(hand) == before
    assert [work_mm(hand, axis) for axis in "XYZ"] == at_mm


def test_the_console_takes_its_keys(hand: Hand, dock: Any) -> None:  # noqa: F811
    connected(hand)
    hand.click(f"{D}ConsoleLine")
    hand.type("G4 P0.1")
    hand.key("Escape")
    assert hand.text(f"{D}ConsoleLine") == "G4 P0.1"
    hand.key("Return")
    hand.wait(lambda: "G4 P0.1" in dock.console.said.toPlainText(), 10, "the line that was typed")
    assert hand.text(f"{D}ConsoleLine") == "" and hand.exists(f"{D}State")
