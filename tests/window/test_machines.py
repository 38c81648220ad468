# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine profiles in the window: chosen, copied, changed, refused at the field, saved; nothing is lost."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import FreeCADGui
import pytest
from PySide import QtGui

from CNCStepper.machine.files.profile_files import own_folder, own_names
from CNCStepper.machine.profile import load_machine
from window_helpers import screen_places as places
from window_helpers.hand import Hand
from window_helpers.tables import click_cell, click_tab

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
    hand.fill(f"{M}_question_name", "shop")
    hand.click(f"{M}_question_ok")
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


def test_every_field_takes_what_a_hand_gives_and_revert_takes_all_back(hand: Hand, machines: Any) -> None:
    hand.item(f"{M}_list", "thesis-table")
    hand.wait(lambda: machines.name == "thesis-table", what="the profile")
    hand.keyboard.learn("7")
    for tab, section in enumerate(machines.sections.values()):
        click_tab(hand, machines.tabs, tab)
        for path, field in section.fields.items():
            give(hand, field.editor, partial(lambda path: machines.draft.texts[path], path))
        for name, field in list(getattr(section, "pins", {}).items()):
            give(hand, field.editor, partial(lambda name: machines.draft.pins.get(name, ""), name))
        for key, editor in section.lists.items():
            add_and_remove(hand, key, editor)
    hand.click(f"{M}_revert")
    hand.wait(lambda: not machines.draft.is_changed, what="the values of the file")
    for button, title in (("new", "New machine"), ("copy", "Copy of thesis-table")):
        hand.click(f"{M}_{button}")
        hand.wait(lambda title=title: places.find(f"{M}_question").windowTitle() == title, what="the question")
        hand.click(f"{M}_question_cancel")
        hand.wait(lambda: not places.visible(f"{M}_question"), what="its end")
    assert own_names() == []


def give(hand: Hand, editor: Any, text: Callable[[], str]) -> None:
    """Type, check or choose something in a field, and see that the draft holds it."""
    before = hand.main(text)
    if isinstance(editor, QtGui.QComboBox):
        other = hand.main(lambda: next(n for n in range(editor.count()) if n != editor.currentIndex()))
        hand.choose(editor, hand.main(editor.itemText, other))
        hand.wait(lambda: text() == editor.itemData(other) != before, 5, editor.objectName())
    elif isinstance(editor, QtGui.QLineEdit):
        hand.tap(editor)
        if not hand.is_soon(editor.hasFocus):  # a note of the last field has moved it
            hand.click(editor)
        hand.keyboard.write("7")
        hand.wait(lambda: text() == editor.text() != before and "7" in text(), 5, editor.objectName())
    else:
        boxes = [editor] if isinstance(editor, QtGui.QCheckBox) else list(editor.boxes.values())
        for box in boxes:
            before = hand.main(text)
            hand.tap(box)
            hand.wait(lambda before=before: text() != before, 5, box.objectName())


def add_and_remove(hand: Hand, key: str, editor: Any) -> None:
    """Add a line to a list, give each of its cells something, and remove it."""
    lines = hand.main(lambda: len(editor.entries))
    hand.click(f"{FIELD}_{key}_add")
    hand.wait(lambda: len(editor.entries) == lines + 1, 5, "the new line")
    entry = editor.entries[-1]
    for place, row in enumerate(editor.table.columns):
        text = partial(entry.__getitem__, row.path[-1])
        box = hand.main(editor.grid.cellWidget, lines, place)
        if box is not None:
            give(hand, box, text)
            continue
        click_cell(hand, editor.grid, lines, place)
        hand.type("7")
        hand.key("Return")
        hand.wait(lambda text=text: text() == "7", 5, row.path[-1])
    click_cell(hand, editor.grid, lines, 0)
    hand.click(f"{FIELD}_{key}_remove")
    hand.wait(lambda: len(editor.entries) == lines, 5, "the line to go")


def note_text(key: str) -> str:
    return str(dialog().findChild(QtGui.QLabel, f"{FIELD}_{key}_error").text())
