# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine profiles in the window: chosen, copied, changed, refused at the field, saved; nothing is lost."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from typing import Any

import FreeCADGui
import pytest
from PySide import QtGui

from CNCStepper.machine.files.profile_files import own_folder, own_names
from CNCStepper.machine.profile import load_machine
from window_helpers import screen_places as places
from window_helpers.hand import Hand

M, FIELD = "CNCStepper_Machines", "CNCStepper_Machine"


def dialog() -> Any:
    return FreeCADGui.getMainWindow().findChild(QtGui.QDialog, M)


@pytest.fixture
def machines(hand: Hand) -> Iterator[Any]:
    shutil.rmtree(own_folder(), ignore_errors=True)
    hand.command(M)
    hand.wait(lambda: dialog() and dialog().isVisible(), what="the dialog")
    hand.settle()
    yield dialog()

    def close() -> None:
        dialog().drafts = {}
        dialog().close()
        dialog().deleteLater()

    hand.main(close)
    hand.settle()
    shutil.rmtree(own_folder(), ignore_errors=True)


def show(hand: Hand, tab: int, field: str) -> None:
    hand.main(lambda: dialog().tabs.setCurrentIndex(tab))
    hand.settle()
    hand.main(lambda: places.scroll_to(places.find(f"{FIELD}_{field}")))
    hand.settle()


def cut_off() -> list[str]:
    """Return the labels, buttons and lines of the tab in front that are narrower than what stands on them."""
    return places.narrower_than_their_text(dialog())


@pytest.mark.window("plain", "portuguese")
def test_all_tabs_show_every_value_and_nothing_is_cut_off(hand: Hand, machines: Any) -> None:
    for tab in range(hand.main(machines.tabs.count)):
        hand.main(machines.tabs.setCurrentIndex, tab)
        hand.settle()
        hand.shot(f"machines-{tab}", M)
        assert not hand.main(lambda: machines.tabs.currentWidget().horizontalScrollBar().isVisible())
        assert hand.main(cut_off) == []


def test_a_copy_is_changed_and_saved_and_a_bad_value_is_told_at_its_field(hand: Hand, machines: Any) -> None:
    hand.main(machines.look, "table-a")
    hand.click(f"{M}_copy")
    hand.wait(lambda: places.visible("qt_msgbox_buttonbox") or FreeCADGui.getMainWindow().findChild(
        QtGui.QInputDialog) or dialog().findChild(QtGui.QInputDialog), what="the question")  # fmt: skip
    hand.settle()
    hand.type("shop")
    hand.key("Return")
    hand.wait(lambda: dialog().name == "shop", what="the copy")
    show(hand, 1, "axis_x_steps_per_mm")
    hand.fill(f"{FIELD}_axis_x_steps_per_mm", "many")
    hand.wait(lambda: "no number" in note_text("axis_x_steps_per_mm"))
    hand.shot("machines-bad-value", M)
    assert not hand.main(machines.save_button.isEnabled)
    hand.main(machines.look, "table-b")
    hand.main(machines.look, "shop")
    assert hand.text(f"{FIELD}_axis_x_steps_per_mm") == "many", "nothing is lost on a bad value"
    hand.fill(f"{FIELD}_axis_x_steps_per_mm", "81,5")
    hand.fill(f"{FIELD}_axis_y_travel_max_mm", "-500")
    hand.wait(lambda: "must be below" in note_text("axis_y_travel_max_mm") + note_text("axis_y_travel_min_mm"))
    hand.fill(f"{FIELD}_axis_y_travel_max_mm", "0")
    hand.wait(lambda: machines.save_button.isEnabled(), what="a whole machine")
    hand.click(f"{M}_save")
    hand.wait(lambda: not machines.draft.is_changed, what="it is saved")
    assert load_machine("shop").axis["x"].steps_per_mm == 81.5
    assert "# machine coordinates" in (own_folder() / "shop.toml").read_text("utf-8")
    assert own_names() == ["shop"]


def test_pins_are_drawn_and_a_pin_that_is_an_input_is_refused(hand: Hand, machines: Any) -> None:
    hand.main(machines.look, "thesis-table")
    show(hand, 4, "signals_pins_x_step")
    hand.fill(f"{FIELD}_signals_pins_x_step", "11")
    hand.wait(lambda: "input of the parallel port" in machines.sections[machines.tabs.tabText(4)].note.text()
              or any("input of the parallel port" in one.note.text()
                     for one in machines.sections[machines.tabs.tabText(4)].pins.values()))  # fmt: skip
    hand.fill(f"{FIELD}_signals_pins_x_step", "-2")
    hand.fill(f"{FIELD}_signals_pins_x_direction", "3")
    hand.wait(lambda: not machines.draft.judged()[1])
    picture = machines.sections[machines.tabs.tabText(4)].picture
    assert hand.main(picture.words, 2) == "Pin 2: output, X step, active low"
    hand.main(picture.show_levels, {2: True, 3: False})
    hand.settle()
    hand.shot("machines-pins", M)


def test_relays_and_inputs_are_added_line_by_line(hand: Hand, machines: Any) -> None:
    hand.main(machines.look, "torch-table")
    hand.main(machines.tabs.setCurrentIndex, 3)
    hand.settle()
    hand.click(f"{FIELD}_relay_add")
    hand.wait(lambda: "Line 1, Device" in note_text("relay"), what="what is missing")

    def name_it() -> None:
        machines.sections[machines.tabs.tabText(3)].lists["relay"].grid.item(0, 0).setText("oxygen")

    hand.main(name_it)
    hand.choose(f"{FIELD}_relay_0_device", "flood (M8)")
    hand.wait(lambda: not machines.draft.judged()[1])
    hand.shot("machines-relays", M)
    assert hand.main(machines.save)
    assert [(one.name, one.device) for one in load_machine("torch-table").relay] == [("oxygen", "flood")]
    assert "your copy" in hand.main(machines.about.text)


def note_text(key: str) -> str:
    return str(dialog().findChild(QtGui.QLabel, f"{FIELD}_{key}_error").text())
