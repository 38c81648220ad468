# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arithmetic of an axis in a job's panel: worked out while it is typed, with the published problems."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtGui

from CNCStepper.workbench import api, panels
from window_helpers import screen_places as places
from window_helpers.hand import Hand

P = "CNCStepper_Panel"
A = f"{P}_axis"
SHIPPED = Path(__file__).parents[2] / "CNCStepper" / "machine" / "profiles" / "table-a.toml"


@pytest.fixture
def job(hand: Hand) -> Iterator[Any]:
    def make() -> Any:
        document = FreeCAD.newDocument("Axis")
        document.UndoMode = 1
        made = api.new_job(document)
        document.recompute()
        return made

    yield hand.main(make)
    hand.main(FreeCADGui.Control.closeDialog)
    hand.main(FreeCAD.closeDocument, "Axis")


def open_sheet(hand: Hand, job: Any) -> None:
    hand.main(panels.edit, job)
    hand.wait(lambda: places.visible(f"{P}_group_axis"), what="the panel")
    hand.settle()
    hand.main(lambda: places.scroll_to(places.find(f"{P}_group_axis")))
    hand.settle()
    hand.click(f"{P}_group_axis")
    hand.wait(lambda: places.visible(f"{A}_screw_pitch_mm"), what="the sheet")


def reached_by_tab(hand: Hand, presses: int, end: str = "") -> list[str]:
    """Return the names of what Tab reaches behind the sheet's head, up to `end`.

    Not by `nextInFocusChain`: PySide then takes FreeCAD's window for a child of the widget that was asked.
    """
    hand.main(lambda: places.find(f"{P}_group_axis").setFocus())
    names: list[str] = []
    while len(names) < presses and end not in names:
        hand.key("Tab")
        names.append(hand.main(lambda: QtGui.QApplication.focusWidget().objectName()))
    return names


def test_the_sheet_is_made_when_it_is_opened_and_tab_goes_through_it_next(hand: Hand, job: Any) -> None:
    hand.main(panels.edit, job)
    hand.wait(lambda: places.visible(f"{P}_group_axis"), what="the panel")
    assert not hand.main(lambda: [each for each in places.all_widgets() if each.objectName().startswith(f"{A}_")])
    [behind] = reached_by_tab(hand, 1)
    hand.main(FreeCADGui.Control.closeDialog)
    hand.settle()
    open_sheet(hand, job)
    *lines, last = reached_by_tab(hand, 30, behind)
    assert last == behind and all(name.startswith(f"{A}_") for name in lines), lines
    assert lines[:2] == [f"{A}_axis", f"{A}_moved_by"] and lines[-1] == f"{A}_rate_hz", lines


def fill(hand: Hand, **values: str) -> None:
    for key, text in values.items():
        hand.main(lambda name: places.scroll_to(places.find(name)), f"{A}_{key}")
        hand.settle()
        hand.fill(f"{A}_{key}", text)


def choose(hand: Hand, key: str, text: str) -> None:
    hand.main(lambda: places.scroll_to(places.find(f"{A}_{key}")))
    hand.settle()
    hand.choose(f"{A}_{key}", text)


def shown(hand: Hand, *quantities: str) -> list[str]:
    return [hand.text(f"{A}_{quantity}") for quantity in quantities]


def test_both_published_problems_while_they_are_typed(hand: Hand, job: Any) -> None:
    open_sheet(hand, job)
    fill(hand, screw_pitch_mm="6", gear_ratio="5", steps_per_turn="48", distance_mm="250", feed_mm_min="500")
    hand.wait(lambda: places.find(f"{A}_pulse_rate").text() == "333.333 Hz")
    assert shown(hand, "pulses", "motor_speed") == ["10000", "416.667 rpm"]
    assert shown(hand, "steps_per_mm", "resolution") == ["40  (profile: 80)", "0.025 mm"]
    hand.main(lambda: places.scroll_to(places.find(f"{A}_highest_feed")))
    hand.settle()
    hand.shot("panel-axis-open-loop")
    assert hand.main(cut_off) == []
    choose(hand, "loop", "Encoder (closed loop)")
    assert hand.text(f"{A}_screw_pitch_mm") == "6.00 mm"  # as it stands once it is left
    fill(hand, encoder_pulses_per_turn="48", encoder_gear_ratio="4")
    hand.wait(lambda: places.find(f"{A}_pulse_rate").text() == "266.667 Hz")
    assert shown(hand, "pulses", "motor_speed") == ["8000", "416.667 rpm"]
    assert not hand.main(places.visible, f"{A}_microsteps")
    choose(hand, "loop", "Stepper motor (open loop)")
    choose(hand, "moved_by", "Toothed belt")
    fill(hand, belt_pitch_mm="2", pulley_teeth="20", gear_ratio="1", steps_per_turn="200", microsteps="16")
    hand.wait(lambda: places.find(f"{A}_steps_per_mm").text().startswith("80 "))
    hand.shot("panel-axis-belt")


def test_what_is_no_drive_is_said_and_the_profile_s_drive_stands_first(hand: Hand, job: Any, tmp_path: Path) -> None:
    path = tmp_path / "table.toml"
    drive = "\n[axis.x.drive]\nscrew_pitch_mm = 5\nmicrosteps = 2\n"
    told = SHIPPED.read_text("utf-8").replace("backlash_mm = 0.0", "backlash_mm = 0.05", 1)
    path.write_text(told + drive, "utf-8")
    hand.main(setattr, job, "Machine", str(path))
    open_sheet(hand, job)
    assert shown(hand, "steps_per_mm", "highest_feed") == ["80  (profile: 80)", "18750.00 mm/min"]
    assert shown(hand, "backlash_mm") == ["0.05 mm"]
    for axis, is_of_x in (("Y", False), ("X", True)):
        choose(hand, "axis", axis)
        hand.wait(lambda is_of_x=is_of_x: (hand.text(f"{A}_backlash_mm") == "0.05 mm") is is_of_x, 10, axis)
    for text, told in (("0", "must be at least"), ("x", "no number"), ("3 deg", "no value in")):
        fill(hand, screw_pitch_mm=text)
        hand.wait(lambda told=told: told in places.find(f"{A}_error").text())
        assert shown(hand, "steps_per_mm", "pulses", "backlash_mm") == ["", "", "0.05 mm"]
    hand.shot("panel-axis-refused")


def cut_off() -> list[str]:
    """Return what of the sheet is too narrow for its words, and the scroll areas that are too narrow for theirs."""
    sheet = places.find(f"{A}_pulses").window().findChild(QtGui.QWidget, f"{P}_group_axis").parentWidget()
    labels = [label for label in sheet.findChildren(QtGui.QLabel) if label.isVisible() and not label.wordWrap()]
    areas = FreeCADGui.getMainWindow().findChildren(QtGui.QScrollArea)
    holding = [area for area in areas if area.isVisible() and area.isAncestorOf(sheet)]
    wide = [str(area) for area in holding if area.widget().width() > area.viewport().width()]
    return wide + [label.text() for label in labels if label.width() < label.minimumSizeHint().width()]


@pytest.fixture
def portuguese(hand: Hand) -> Iterator[None]:
    hand.main(FreeCADGui.setLocale, "pt-BR")
    hand.settle()
    yield
    hand.main(FreeCADGui.setLocale, "English")
    hand.settle()


def test_the_sheet_is_seen_whole_in_portuguese(hand: Hand, portuguese: None, job: Any) -> None:
    open_sheet(hand, job)
    hand.main(lambda: places.scroll_to(places.find(f"{A}_backlash_mm")))
    hand.settle()
    hand.shot("panel-axis-pt-screw")
    assert hand.main(cut_off) == []
    choose(hand, "moved_by", "Correia dentada")
    choose(hand, "loop", "Encoder (malha fechada)")
    hand.wait(lambda: places.find(f"{A}_loop").toolTip() == "Encoder (malha fechada)")
    fill(hand, pulley_teeth="2,5")
    hand.wait(lambda: "Dentes da polia" in places.find(f"{A}_error").text())
    hand.shot("panel-axis-pt-belt")
    assert hand.main(cut_off) == []
