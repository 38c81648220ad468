# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panels with real keys and clicks: live values, errors beside the field, OK, Cancel, one undo step."""

from __future__ import annotations

import re
import statistics
import time
from collections.abc import Iterator
from functools import partial
from importlib import resources
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import Part
import pytest
from FreeCAD import Vector
from PySide import QtCore, QtGui

from CNCStepper.machine.libraries.operation_presets import presets_of
from CNCStepper.workbench import api, panels
from CNCStepper.workbench.commands.create_object import create
from CNCStepper.workbench.document import program_file
from CNCStepper.workbench.features.base import problem_of, proxy_type, value_of
from CNCStepper.workbench.features.operation import Operation
from CNCStepper.workbench.panels.fields import NoteLabel
from CNCStepper.workbench.panels.operations.preset_row import fitting, preset_entries
from window_helpers import screen_places as places
from window_helpers.file_dialogs import choose_file
from window_helpers.hand import Hand

DEPTH, STEPOVER, TIME, OK, CANCEL = (
    f"CNCStepper_Panel_{name}" for name in ("depth_mm", "stepover_mm", "time", "ok", "cancel")
)
PRESET, STEPDOWN = "CNCStepper_Panel_preset", "CNCStepper_Panel_stepdown_mm"
NEVER_A_NUMBER = ["", "abc", "nan", "inf", "mm", "-", "("]  # nor is any of their beginnings
NO_NUMBERS = [*NEVER_A_NUMBER, "1.234,5", "1,2,3", "5 kg", "1e400", "1/0"]
NOT_POSITIVE = ["0", "-1", "-0,5 mm"]
QUICK_MS = 100.0
CUT_S = 20.0  # so long may a program take that is computed beside the window
RIGHT = QtCore.Qt.ArrowType.RightArrow  # of a group that is folded
SHOWING_ALL: dict[str, dict[str, Any]] = {"pocket": {"method": "dda"}}  # values with which no line is hidden


class Bench:
    """A document with the demo's pocket, an engraving and their job, and what a person may do with its panels."""

    def __init__(self, hand: Hand) -> None:
        self.hand = hand
        hand.main(self._draw)

    def _draw(self) -> None:
        self.document = FreeCAD.newDocument("Panels")
        self.document.UndoMode = 1
        sketch = self.document.addObject("Sketcher::SketchObject", "Sketch")
        sketch.exposeInternalGeometry(sketch.addGeometry(Part.Ellipse(Vector(30, 0), Vector(0, 20), Vector())))
        self.sketch = sketch
        self.job = api.new_job(self.document)
        self.tool = api.add_tool(self.job, diameter_mm=6)
        self.pocket = api.add_elliptical_pocket(self.job)
        self.line = api.add_freehand(self.document, [(x, (x % 7) - 3) for x in range(-20, 20)], 0.01)
        self.engraving = api.add_engrave(self.job, self.line, depth_mm=1)
        self.document.recompute()
        self.document.clearUndos()
        FreeCADGui.SendMsgToActiveView("ViewFit")

    def open(self, obj: Any) -> None:
        self.hand.main(panels.edit, obj)
        self.opened()

    def opened(self) -> None:
        """Wait until the panel is there and has taken the keyboard, which it does a moment later."""
        self.hand.wait(lambda: self.panel() is not None and keyboard_in_panel(), what="the panel")
        self.hand.settle()

    def panel(self) -> Any:
        types = ("Job", "Tool", "EllipticalPocket", "Engrave", "Freehand")
        found = [hand_box(f"CNCStepper_Panel_CNCStepper_{name}") for name in types]
        return next((widget for widget in found if widget is not None and widget.isVisible()), None)

    def closed(self) -> bool:
        return FreeCADGui.Control.activeDialog() is False or not FreeCADGui.Control.activeDialog()

    def values(self) -> dict[str, Any]:
        """Return what all our objects hold, and the program."""
        ours = [obj for obj in self.document.Objects if proxy_type(obj) and hasattr(obj.Proxy, "PROPERTIES")]
        held = {
            f"{obj.Name}.{entry.key}": value_of(obj, entry)
            for obj in ours
            for entry in obj.Proxy.PROPERTIES
            if entry.key != "program"
        }
        problems = {f"{obj.Name}.problem": problem_of(obj) for obj in ours}
        return {**held, **problems, "text": program_file.load(self.job)}

    def sound(self, text: str, before: dict[str, Any]) -> bool:
        """Tell whether the last good values and their program stand, while `text` is refused.

        The beginning of a bad text may be good ("5" of "5 kg"), and is then the last good value: its program comes
        when it is computed.
        """
        held = self.values()
        if text in NEVER_A_NUMBER:
            return held == before
        return held["text"] != "" and not any(value for key, value in held.items() if key.endswith(".problem"))

    def note(self, key: str) -> str:
        label = FreeCADGui.getMainWindow().findChild(QtGui.QLabel, f"CNCStepper_Panel_{key}_error")
        return label.text() if label is not None and label.isVisible() else ""

    def panel_problem(self) -> str:
        return str(self.panel().problem.text())

    def fields(self) -> list[str]:
        """Return the names of the fields of the open panel that are seen and can be typed into, its groups unfolded.

        The line of the presets takes any name, and is no field.
        """
        for box in self.panel().findChildren(QtGui.QToolButton):
            if box.objectName().startswith("CNCStepper_Panel_group_") and box.arrowType() == RIGHT:
                box.click()
        lines = self.panel().findChildren(QtGui.QLineEdit)
        named = [line for line in lines if line.objectName()]
        return [line.objectName() for line in named if line.isVisible() and line.isEnabled()]


@pytest.fixture
def bench(hand: Hand) -> Iterator[Bench]:
    yield Bench(hand)
    hand.main(FreeCADGui.Control.closeDialog)
    hand.main(FreeCAD.closeDocument, "Panels")


def key_of(field: str) -> str:
    """Return the key by whose note a line says what is wrong; the axis sheet has one for all its lines."""
    key = field.removeprefix("CNCStepper_Panel_").removesuffix("_x").removesuffix("_y").removesuffix("_z")
    return "axis" if key.startswith("axis_") else key


def test_ok_is_one_undo_step(hand: Hand, bench: Bench) -> None:
    before = hand.main(bench.values)
    hand.tree(bench.pocket.Label, double=True)
    bench.opened()
    hand.fill(DEPTH, "12,5")
    hand.wait(lambda: bench.pocket.Depth.Value == 12.5)
    hand.wait(lambda: ":" in hand_box(TIME).text(), CUT_S, "the time")
    slow = hand.text(TIME)
    hand.fill(STEPOVER, "1 mm + 1 mm")
    hand.wait(lambda: bench.pocket.Stepover.Value == 2)
    assert hand.text(DEPTH) == "12.50 mm"
    hand.wait(lambda: ":" in hand_box(TIME).text() != slow, CUT_S, "another time")
    assert hand.text("CNCStepper_Panel_levels") == str(hand.main(lambda: bench.pocket.Levels))
    assert hand.main(bench.values)["text"] not in ("", before["text"])
    hand.shot("panel-pocket")
    hand.click(OK)
    hand.wait(bench.closed)
    changed = hand.main(bench.values)
    assert hand.main(lambda: bench.document.UndoCount) == 1
    hand.undo()
    hand.wait(lambda: bench.pocket.Depth.Value == 10)
    assert hand.main(bench.values) == before
    assert hand.main(api.program_text, bench.job) == before["text"]
    hand.redo()
    hand.wait(lambda: bench.pocket.Depth.Value == 12.5)
    assert hand.main(bench.values) == changed


@pytest.mark.parametrize("leave", ["Esc", "button"])
def test_cancel_leaves_all_as_it_was(hand: Hand, bench: Bench, leave: str) -> None:
    before = hand.main(bench.values)
    bench.open(bench.pocket)
    hand.fill(DEPTH, "7")
    hand.wait(lambda: bench.pocket.Depth.Value == 7)
    hand.fill(STEPOVER, "abc")
    hand.key("Esc") if leave == "Esc" else hand.click(CANCEL)
    hand.wait(bench.closed)
    assert hand.main(bench.values) == before
    assert hand.main(api.program_text, bench.job) == before["text"]
    assert hand.main(lambda: bench.document.UndoCount) == 0


@pytest.mark.parametrize("leave", [OK, CANCEL])
def test_what_follows_an_undo_in_the_panel_is_undone_too(hand: Hand, bench: Bench, leave: str) -> None:
    before = hand.main(bench.values)
    bench.open(bench.pocket)
    hand.fill(DEPTH, "7")
    hand.wait(lambda: bench.pocket.Depth.Value == 7)
    hand.click("CNCStepper_Panel_group_operation")  # the keyboard is in no line, whose own undo that would be
    hand.undo()
    hand.wait(lambda: bench.pocket.Depth.Value == 10)
    hand.click("CNCStepper_Panel_group_operation")
    hand.wait(lambda: hand_box(DEPTH).isVisible() and hand_box(DEPTH).text() == "10.00 mm", what="the depth as it was")
    hand.fill(DEPTH, "8")
    hand.wait(lambda: bench.pocket.Depth.Value == 8)
    hand.click(leave)
    hand.wait(bench.closed)
    if leave == OK:
        hand.undo()
        hand.wait(lambda: bench.pocket.Depth.Value == 10)
    assert hand.main(bench.values) == before


def test_an_undo_that_takes_the_object_closes_its_panel(hand: Hand, bench: Bench) -> None:
    def new() -> None:
        create(bench.document, "New pocket", lambda: api.add_elliptical_pocket(bench.job, radius_x_mm=20))

    count = hand.main(lambda: len(bench.document.Objects))
    hand.main(new)
    bench.opened()
    hand.click("CNCStepper_Panel_group_operation")
    hand.undo()
    hand.wait(lambda: len(bench.document.Objects) == count)
    hand.wait(bench.closed)


def test_a_cancelled_new_operation_is_gone_and_a_kept_one_is_undone_at_once(hand: Hand, bench: Bench) -> None:
    def new() -> None:
        create(bench.document, "New pocket", lambda: api.add_elliptical_pocket(bench.job, radius_x_mm=20))

    count, before = hand.main(lambda: len(bench.document.Objects)), hand.main(bench.values)
    hand.main(new)
    hand.wait(lambda: len(bench.document.Objects) == count + 1, 5, "the new object")
    bench.opened()
    hand.key("Esc")
    hand.wait(bench.closed)
    assert hand.main(lambda: len(bench.document.Objects)) == count
    assert hand.main(bench.values) == before
    hand.main(new)
    bench.opened()
    hand.fill(DEPTH, "3")
    hand.click(OK)
    hand.wait(bench.closed)
    assert hand.main(lambda: bench.document.UndoNames) == ["New pocket"]
    hand.undo()
    hand.wait(lambda: len(bench.document.Objects) == count)
    assert hand.main(bench.values) == before


@pytest.mark.parametrize("text", [*NO_NUMBERS, *NOT_POSITIVE])
def test_a_bad_depth_is_said_beside_it_and_goes_nowhere(hand: Hand, bench: Bench, text: str) -> None:
    before = hand.main(bench.values)
    bench.open(bench.pocket)
    hand.click(DEPTH)
    hand.key("Ctrl+A")
    hand.key("BackSpace")
    hand.type(text)
    hand.wait(lambda: bench.note("depth_mm"), 5, "the note")
    hand.wait(partial(bench.sound, text, before), CUT_S, f"what was good before {text!r}")
    hand.click(STEPOVER)
    hand.click(OK)
    hand.settle()
    assert not hand.main(bench.closed)
    assert hand.main(lambda: QtGui.QApplication.focusWidget().objectName()) == DEPTH
    hand.fill(DEPTH, "8")
    hand.wait(lambda: not bench.note("depth_mm"))
    hand.click(OK)
    hand.wait(bench.closed)
    assert hand.main(lambda: bench.pocket.Depth.Value) == 8


@pytest.mark.parametrize("kind", ["job", "tool", "pocket", "engraving", "line"])
def test_every_field_of_every_panel_takes_bad_values(hand: Hand, bench: Bench, kind: str) -> None:
    hand.main(lambda: api.edit(getattr(bench, kind), **SHOWING_ALL.get(kind, {})))
    hand.main(bench.document.recompute)
    hand.wait(lambda: not problem_of(bench.job), CUT_S, "the program")
    before = hand.main(bench.values)
    bench.open(getattr(bench, kind))
    fields = hand.main(bench.fields)
    assert fields
    for number, field in enumerate(fields):
        for text in (NO_NUMBERS[number % len(NO_NUMBERS)], NO_NUMBERS[(number + 5) % len(NO_NUMBERS)]):
            hand.main(partial(keyboard_into, field))
            held = hand.main(bench.values)  # the "5" of an earlier "5 kg" may stand in another field by now
            hand.key("Ctrl+A")
            hand.key("BackSpace")
            hand.type(text)
            hand.wait(partial(bench.note, key_of(field)), 5, f"the note at {field} for {text!r}")
            hand.wait(partial(bench.sound, text, held), CUT_S, f"what was good before {text!r} in {field}")
    hand.shot(f"panel-{kind}-bad")
    assert (
        hand.main(lambda: [note.objectName() for note in notes() if note.height() < note.heightForWidth(note.width())])
        == []
    )
    hand.click(OK)
    hand.settle()
    assert not hand.main(bench.closed)
    hand.key("Esc")
    hand.wait(bench.closed)
    assert hand.main(bench.values) == before


def notes() -> list[Any]:
    """Return the notes that are shown below fields."""
    return [note for note in FreeCADGui.getMainWindow().findChildren(NoteLabel) if note.isVisible()]


def keyboard_in_panel() -> bool:
    """Tell whether the keyboard is in a panel of ours."""
    focus = QtGui.QApplication.focusWidget()
    return focus is not None and focus.objectName().startswith("CNCStepper_Panel")


def keyboard_into(name: str) -> None:
    """Give a field the keyboard; clicks into a panel that has grown fall through FreeCAD 1.1's overlay for a while."""
    hand_into(name)
    hand_box(name).setFocus()


def hand_into(name: str) -> None:
    """Scroll the task panel until a widget can be seen."""
    places.scroll_to(places.find(name))


def test_what_the_cut_refuses_is_said_and_the_last_good_program_stays(hand: Hand, bench: Bench) -> None:
    before = hand.main(bench.values)
    bench.open(bench.pocket)
    hand.fill(STEPOVER, "7")
    hand.wait(lambda: "larger than the tool" in bench.note("stepover_mm"))
    assert hand.main(bench.values) == before
    hand.fill(DEPTH, "9")
    hand.wait(lambda: bench.note("stepover_mm") and not bench.note("depth_mm"))
    hand.shot("panel-pocket-refused")
    hand.fill(STEPOVER, "3")
    hand.wait(lambda: (bench.pocket.Stepover.Value, bench.pocket.Depth.Value) == (3, 9), CUT_S, "what is typed")
    assert not hand.main(bench.note, "stepover_mm")


@pytest.fixture
def inches(hand: Hand) -> Iterator[None]:
    before = hand.main(FreeCAD.Units.getSchema)
    hand.main(FreeCAD.Units.setSchema, 3)
    yield
    hand.main(FreeCAD.Units.setSchema, before)


@pytest.mark.parametrize(("typed", "depth_mm"), [("0.25", 6.35), ('1/4"', 6.35), ("0,25 in", 6.35), ("5 mm", 5)])
def test_imperial_units(hand: Hand, bench: Bench, inches: None, typed: str, depth_mm: float) -> None:
    bench.open(bench.pocket)
    assert hand.text(DEPTH) == "0.3937 in"
    hand.fill(DEPTH, typed)
    hand.wait(lambda: bench.pocket.Depth.Value == pytest.approx(depth_mm))
    if depth_mm == 6.35:
        hand.wait(lambda: hand.text(DEPTH) == "0.25 in", 5, "the depth in inches")


def test_a_drawing_is_chosen_taken_and_let_go(hand: Hand, bench: Bench) -> None:
    bench.open(bench.pocket)
    box = "CNCStepper_Panel_drawings"
    offered = hand.main(lambda: [hand_box(box).itemText(i) for i in range(hand_box(box).count())])
    assert offered == ["by numbers", "Sketch"]
    hand.choose(box, "Sketch")
    hand.wait(lambda: bench.pocket.RadiusX.Value == pytest.approx(30))
    hand.wait(lambda: hand.text("CNCStepper_Panel_radius_x_mm") == "30.00 mm", 10, "the drawing's radius")
    assert not hand.main(lambda: hand_box("CNCStepper_Panel_radius_x_mm").isEnabled())
    hand.shot("panel-pocket-drawing")
    hand.choose(box, "by numbers")
    hand.wait(lambda: not bench.pocket.Drawings)
    assert hand.main(lambda: hand_box("CNCStepper_Panel_radius_x_mm").isEnabled())
    for _ in range(3):  # a click that falls through FreeCAD 1.1's panel goes into the 3D view, which selects nothing
        hand.main(FreeCADGui.Selection.clearSelection)
        hand.main(FreeCADGui.Selection.addSelection, bench.line)
        hand.click("CNCStepper_Panel_drawings_take")
        if hand.main(lambda: "no ellipse" in bench.note("drawings") or bench.panel_problem()):
            break
    hand.wait(lambda: "no ellipse" in bench.note("drawings") or bench.panel_problem(), 5, "why it cannot be taken")
    assert hand.main(lambda: bench.pocket.Drawings) == []


def _rows(name: str) -> list[Any]:
    entries = hand_box(name)
    return [entries.item(row) for row in range(entries.count())]


def hand_box(name: str) -> Any:
    return FreeCADGui.getMainWindow().findChild(QtGui.QWidget, name)


def test_a_preset_is_saved_and_chosen_in_another_operation(hand: Hand, bench: Bench) -> None:
    other = hand.main(api.add_elliptical_pocket, bench.job)
    hand.main(lambda: (bench.document.recompute(), bench.document.clearUndos()))
    bench.open(bench.pocket)
    hand.fill(STEPDOWN, "0.7 mm")
    hand.fill(DEPTH, "3 mm")
    assert not hand.main(hand.find(f"{PRESET}_save").isEnabled)
    hand.fill(PRESET, "Oak")
    hand.click(f"{PRESET}_save")
    hand.wait(lambda: "Oak" in presets_of(bench.pocket.Proxy.CYCLE), CUT_S, "the preset")
    hand.shot("preset-saved")
    hand.click(OK)
    hand.wait(bench.closed, CUT_S, "the panel to close")
    bench.open(other)
    hand.click(PRESET, at=hand.main(arrow_of, hand.find(PRESET)))
    hand.item(hand.main(places.combo_list, PRESET), "Oak")
    hand.wait(lambda: (other.Stepdown.Value, other.Depth.Value) == pytest.approx((0.7, 3)), CUT_S, "its values")
    hand.wait(lambda: hand_box(STEPDOWN).text().startswith("0.7"), CUT_S, "them in the fields")
    assert other.Tool == bench.tool
    by_hand = {"stepdown_mm": "deep", "depth_mm": True, "stepover_mm": float("inf"), "not_known": 3}
    assert hand.main(lambda: fitting(preset_entries(other), {**by_hand, "stepover_mm": 2})) == {"stepover_mm": 2}
    assert hand.main(lambda: fitting(preset_entries(other), by_hand)) == {}
    hand.click(f"{PRESET}_delete")
    hand.wait(lambda: not presets_of(bench.pocket.Proxy.CYCLE), 5, "the preset to go")
    assert hand.text(PRESET) == "" and not hand.main(hand.find(f"{PRESET}_delete").isEnabled)
    hand.click(OK)
    hand.wait(bench.closed, CUT_S, "the panel to close")
    hand.undo()
    hand.wait(lambda: other.Stepdown.Value != pytest.approx(0.7), 5, "the undo")


def arrow_of(combo: Any) -> tuple[float, float]:
    """Return the place of the arrow of a list that can be typed into."""
    return combo.width() - 10, combo.height() / 2


def test_the_job_s_operations_and_tools(hand: Hand, bench: Bench, tmp_path: Path) -> None:
    bench.open(bench.job)
    hand.shot("panel-job")
    first, second = hand.main(lambda: [operation.Label for operation in bench.job.Operations])
    total = "CNCStepper_Panel_operations_total"
    hand.wait(lambda: ":" in hand_box(total).text(), CUT_S, "the times")
    rows = hand.main(lambda: [row.text().split("\n") for row in _rows("CNCStepper_Panel_operations")])
    assert [row[0] for row in rows] == [first, second]
    assert all(re.fullmatch(r"T1 · \d+:\d\d(\.\d)?", row[1]) for row in rows)
    hand.main(lambda: hand_into("CNCStepper_Panel_operations_up"))
    hand.item("CNCStepper_Panel_operations", second)
    hand.click("CNCStepper_Panel_operations_up")
    hand.wait(lambda: [operation.Label for operation in bench.job.Operations] == [second, first])
    hand.wait(lambda: "Touched" not in bench.job.State, 20, "the program in the new order")
    assert hand.main(api.program_text, bench.job).index("engrave") < hand.main(api.program_text, bench.job).index("ell")
    hand.click("CNCStepper_Panel_operations_down")
    hand.wait(lambda: [operation.Label for operation in bench.job.Operations] == [first, second], 5, "the old order")
    hand.click("CNCStepper_Panel_operations_up")
    hand.wait(lambda: [operation.Label for operation in bench.job.Operations] == [second, first], 5, "the new order")
    hand.main(lambda: hand_into("CNCStepper_Panel_stock_fit"))
    hand.main(FreeCADGui.Selection.addSelection, bench.sketch)
    hand.click("CNCStepper_Panel_stock_fit")
    hand.wait(lambda: tuple(bench.job.StockSize)[:2] == pytest.approx((80, 60), abs=1e-3), 10, "10 mm around it")
    hand.main(lambda: hand_into("CNCStepper_Panel_tools_add"))
    hand.click("CNCStepper_Panel_tools_remove")
    assert "is cut with it" in hand.text("CNCStepper_Panel_tools_error")
    hand.click("CNCStepper_Panel_tools_add")
    hand.wait(lambda: len(bench.job.Tools) == 2)
    hand.main(lambda: hand_into("CNCStepper_Panel_diameter_mm"))
    hand.fill("CNCStepper_Panel_diameter_mm", "3,175")
    hand.wait(lambda: bench.job.Tools[1].Diameter.Value == 3.175)
    hand.main(lambda: hand_into("CNCStepper_Panel_tools_remove"))
    hand.shot("panel-job-tools")
    hand.click("CNCStepper_Panel_tools_remove")
    hand.wait(lambda: len(bench.job.Tools) == 1)
    table = tmp_path / "tool.tbl"
    table.write_text("T7 P7 D4.5 ;end mill\n", "utf-8")
    hand.click("CNCStepper_Panel_tools_import")
    choose_file(hand, "CNCStepper_Import_file", table)
    hand.wait(lambda: [tool.Diameter.Value for tool in bench.job.Tools] == [6, 4.5], 10, "the tool of the table")
    hand.item("CNCStepper_Panel_tools", hand.main(lambda: _rows("CNCStepper_Panel_tools")[0].text()))
    hand.wait(lambda: hand_box("CNCStepper_Panel_diameter_mm").text().startswith("6"), 10, "the first tool's diameter")
    hand.click(OK)
    hand.wait(bench.closed)
    assert hand.main(lambda: bench.document.UndoCount) == 1
    hand.undo()
    hand.wait(lambda: [operation.Label for operation in bench.job.Operations] == [first, second])
    assert hand.main(lambda: problem_of(bench.job)) == ""


def test_what_the_cut_warns_of_is_shown(hand: Hand, bench: Bench) -> None:
    bench.open(bench.pocket)
    assert not hand.exists("CNCStepper_Panel_warnings")
    hand.main(bench.fields)  # unfolds the groups
    hand.main(lambda: hand_into("CNCStepper_Panel_method"))
    hand.choose("CNCStepper_Panel_method", "published points (DDA)")
    hand.wait(lambda: bench.pocket.Method == "dda")
    hand.wait(lambda: bench.panel().warnings.isVisible() and bench.panel().warnings.text())
    hand.main(lambda: hand_into("CNCStepper_Panel_warnings"))
    hand.shot("panel-pocket-warned")


def test_what_does_not_fit_into_the_stock_is_said_while_typing_and_before_it_is_computed(
    hand: Hand, bench: Bench, monkeypatch: pytest.MonkeyPatch
) -> None:
    said: list[str] = []
    make = Operation.make
    label = "CNCStepper_Panel_of_stock"

    def spy(self: Any, obj: Any) -> None:
        said.append(places.find(label).text() if places.visible(label) else "")
        make(self, obj)

    monkeypatch.setattr(Operation, "make", spy)
    hand.main(setattr, bench.job, "StockSize", Vector(100, 70, 20))
    hand.main(bench.document.recompute)
    bench.open(bench.pocket)
    assert not hand.exists(label)
    said.clear()
    hand.fill(DEPTH, "23")
    hand.wait(lambda: hand.exists(label) and "the depth goes below the stock" in hand.text(label), 10, "the warning")
    assert "limit 20 mm" in hand.text(label)
    hand.wait(lambda: said, 10, "the cut")
    assert "below the stock" in said[-1]
    hand.shot("panel-below-stock")
    hand.fill(DEPTH, "2")
    hand.wait(lambda: not hand.exists(label), 10, "no warning")
    hand.fill("CNCStepper_Panel_centre_mm_x", "45")
    hand.wait(lambda: hand.exists(label) and "beside the stock" in hand.text(label), 10, "the warning")
    hand.fill(DEPTH, "40")
    hand.wait(lambda: "below the stock" in hand.text(label), 10, "both warnings")
    first, second = hand.text(label).splitlines()[:2]
    assert first.startswith("Error: the depth goes below") and "beside the stock" in second
    hand.shot("panel-beside-stock")


def test_a_look_without_a_change_is_no_undo_step(hand: Hand, bench: Bench) -> None:
    for obj in (bench.pocket, bench.tool, bench.job):
        bench.open(obj)
        hand.click(OK)
        hand.wait(bench.closed)
    assert hand.main(lambda: bench.document.UndoCount) == 0


def test_a_deleted_drawing_is_named_in_the_panel_until_it_is_let_go(hand: Hand, bench: Bench) -> None:
    hand.main(lambda: api.edit(bench.pocket, drawing=bench.sketch))
    hand.main(bench.document.recompute)
    hand.main(bench.document.removeObject, "Sketch")
    hand.main(bench.document.recompute)
    bench.open(bench.pocket)
    assert "Sketch" in hand.main(bench.panel_problem) + hand.main(bench.note, "drawings")
    hand.click(OK)
    hand.settle()
    assert not hand.main(bench.closed)
    hand.choose("CNCStepper_Panel_drawings", "by numbers")
    hand.click(OK)
    hand.wait(bench.closed)
    assert hand.main(problem_of, bench.pocket) == ""
    assert hand.main(lambda: bench.pocket.RadiusX.Value) == pytest.approx(30)


def test_a_machine_is_chosen_from_a_file(hand: Hand, bench: Bench, tmp_path: Path) -> None:
    shipped = resources.files("CNCStepper.machine") / "profiles" / "table-b.toml"
    profile = tmp_path / "mesa própria.toml"
    profile.write_text(shipped.read_text("utf-8"), "utf-8")
    bench.open(bench.job)
    hand.choose("CNCStepper_Panel_machine", "A profile's file…")
    hand.wait(lambda: hand_box("CNCStepper_Panel_machine_file") is not None)
    for _ in range(3):  # the list that completes names may take the folder, and show it
        hand.fill("fileNameEdit", str(profile))
        hand.key("Return")
        if not hand.exists("CNCStepper_Panel_machine_file"):
            break
    hand.wait(lambda: bench.job.Machine == str(profile))
    hand.click(OK)
    hand.wait(bench.closed)
    assert hand.main(problem_of, bench.job) == ""


def test_each_edit_is_quick_and_memory_stays_flat_over_500(hand: Hand, bench: Bench) -> None:
    bench.open(bench.pocket)
    times_ms: list[float] = []

    def edit(number: int) -> None:
        line = hand_box(DEPTH)
        line.setText(f"{10 + number % 5 / 10}")
        line.textEdited.emit(line.text())
        begun_s = time.thread_time()
        bench.panel().apply()
        times_ms.append((time.thread_time() - begun_s) * 1000)

    for number in range(60):
        hand.main(edit, number)
    before_mb = hand.memory_mb()
    times_ms.clear()
    for number in range(500):
        hand.main(edit, number)
    print(f"an edit takes {statistics.median(times_ms):.0f} ms, at most {max(times_ms):.0f} ms")
    assert statistics.median(times_ms) < QUICK_MS
    assert hand.memory_mb() - before_mb < 8
