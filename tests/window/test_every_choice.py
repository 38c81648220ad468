# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every group, box and choice of every panel by real clicks: what is clicked is what the object holds, or is refused.

`test_typing.py` clicks and types into every line of the panels of milling and cutting.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui
from test_drawn_objects import SHEET
from test_lathe import every_operation
from test_typing import KINDS, draw, hidden_view

from CNCStepper.workbench import api, panels
from CNCStepper.workbench.features.base import edit, proxy_type, value_of
from CNCStepper.workbench.panels.fields import CheckField, ChoiceField, NumberField, TextField, VectorField
from CNCStepper.workbench.panels.text import FontField
from window_helpers.hand import Hand
from window_helpers.task_panels import PANEL

OLDEST = FreeCAD.Version()[1] == "20"  # newer ones take the first objects only: all that is clicked is clicked once
DOWN = QtCore.Qt.ArrowType.DownArrow  # of a group that is not folded


def test_every_group_box_and_choice_of_milling_and_cutting_answers(hand: Hand) -> None:
    plate, done = hand.main(draw, limit_s=120), set[str]()
    with hidden_view(hand):
        for kind in KINDS if OLDEST else KINDS[:1]:
            work_through(hand, plate[kind], done)


def test_every_group_box_and_choice_of_turning_answers(hand: Hand) -> None:
    job, done = hand.main(every_operation, limit_s=120), set[str]()
    with hidden_view(hand):
        objects = (job, *hand.main(lambda: [job.Tools[0], *job.Operations, *job.Operations[1].OutList[1:2]]))
        for obj in objects if OLDEST else objects[:3]:
            work_through(hand, obj, done, (CheckField, ChoiceField, NumberField, VectorField))
        (thread,) = [each for each in job.Operations if proxy_type(each) == "CNCStepper_TurnThread"]
        work_through(hand, thread, but(thread, "thread"), (TextField,))
        for keys, tool in hand.main(other_tools, job).items():
            work_through(hand, tool, but(tool, *keys), (NumberField, TextField))


def other_tools(job: Any) -> dict[tuple[str, ...], Any]:
    """Make tools by the lines that only they have."""
    boring = {"kind": "boring", "insert": "CCMT 060204", "bar_mm": 8.0, "smallest_bore_mm": 10.0}
    return {
        ("insert",): api.add_tool(job, kind="turning"),
        ("bar_mm", "smallest_bore_mm"): api.add_tool(job, **boring),
        ("point_angle_deg",): api.add_tool(job, kind="drill"),
        ("tip_angle_deg",): api.add_tool(job, kind="threading", insert="", tip_angle_deg=60.0),
    }


def test_points_and_tips_of_tools_answer(hand: Hand) -> None:
    job = hand.main(lambda: api.new_job(FreeCAD.newDocument("Tips")))
    with hidden_view(hand):
        for shape, keys in (("v", ("tip_angle_deg", "tip_diameter_mm")), ("drill", ("point_angle_deg",))):
            tool = hand.main(lambda shape=shape: api.add_tool(job, shape=shape, diameter_mm=6))
            hand.main(job.Document.recompute)
            work_through(hand, tool, but(tool, *keys), (NumberField,))


def test_every_field_of_drawings_texts_and_sheets_answers(hand: Hand, tmp_path: Path) -> None:
    file, done = tmp_path / "plate.svg", set[str]()
    file.write_text(SHEET.format(radius=8), "utf-8")
    kinds = (CheckField, ChoiceField, FontField, NumberField, TextField, VectorField)
    drawn = hand.main(drawn_objects, file, limit_s=120)
    with hidden_view(hand):  # of the document, which FreeCAD 1.1 shows its tasks over
        for obj in drawn:
            work_through(hand, obj, done, kinds)


def drawn_objects(file: Path) -> list[Any]:
    """Make a drawing, a text, a shape, slices of a box, a nest and an arrangement."""
    document = FreeCAD.newDocument("Drawn")
    document.UndoMode = 1
    job = api.new_job(document)
    drawing = api.import_drawing(document, file)
    box = document.addObject("Part::Box", "Box")
    document.addObject("Part::Box", "Other")  # so that another solid and another job can be chosen
    api.new_job(document)
    text, shape = api.add_text(document, "ABC"), api.add_shape(document, "flange")
    document.recompute()
    slices, nest = api.add_slices(document, box), api.add_nest(document, [text])
    return [drawing, text, shape, slices, nest, api.add_arrangement(job, [])]


def work_through(hand: Hand, obj: Any, done: set[str], kinds: tuple[Any, ...] = (CheckField, ChoiceField)) -> None:
    """Click in the panel of an object what was clicked in none of those before, and leave it with Cancel."""
    hand.main(panels.edit, obj)
    hand.wait(lambda: panel_of(obj) is not None, 20, "the panel")
    hand.settle()
    for head in hand.main(lambda: [one for one in shown(obj, QtGui.QToolButton) if "_group_" in one.objectName()]):
        fold(hand, head, done)
    while (found := hand.main(next_field, obj, done, kinds)) is not None:
        change(hand, *found)
    hand.click(f"{PANEL}cancel")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 20, "the panel to close")


def but(obj: Any, *keys: str) -> set[str]:
    """Return the names of all lines of an object's panel but those of some keys, as if they were clicked already."""
    return {f"{PANEL}{entry.key}" for entry in obj.Proxy.PROPERTIES if entry.key not in keys}


def panel_of(obj: Any) -> Any:
    found = FreeCADGui.getMainWindow().findChild(QtGui.QWidget, f"{PANEL}{proxy_type(obj)}")
    return found if found is not None and found.isVisible() else None


def shown(obj: Any, kind: Any) -> list[Any]:
    return [widget for widget in panel_of(obj).findChildren(kind) if widget.isVisible() and widget.isEnabled()]


def fold(hand: Hand, head: Any, done: set[str]) -> None:
    """Click a group open, and one that is clicked for the first time closed before."""
    name = hand.main(head.objectName)
    if name not in done:
        for _ in range(2 if hand.main(head.arrowType) == DOWN else 1):
            before = hand.main(head.arrowType)
            hand.click(head)
            hand.wait(lambda before=before: head.arrowType() != before, 5, f"{name} to fold")
        done.add(name)
    elif hand.main(head.arrowType) != DOWN:
        hand.main(head.click)
    assert hand.main(head.arrowType) == DOWN


def editors_of(obj: Any) -> list[Any]:
    found = [panel_of(obj), *panel_of(obj).findChildren(QtGui.QWidget)]
    return [widget for widget in found if hasattr(widget, "form") and hasattr(widget, "waiting")]


def next_field(obj: Any, done: set[str], kinds: tuple[Any, ...]) -> Any:
    """Return an editor, a field of it and a widget of that which was not clicked yet, None when all were."""
    for editor in editors_of(obj):
        for field in editor.form.field_order():
            if not isinstance(field, kinds) or (
                isinstance(field, ChoiceField | FontField) and not others(field.editors[0])
            ):
                continue
            for box in field.editors:
                if box.isVisible() and box.isEnabled() and box.objectName() not in done:
                    done.add(box.objectName())
                    return editor, field, box
    return None


def others(box: Any) -> list[int]:
    """Return the rows of a box that can be chosen instead of the present one."""
    rows = [row for row in range(box.count()) if row != box.currentIndex()]
    return [row for row in rows if box.model().item(row).isEnabled()]


def change(hand: Hand, editor: Any, field: Any, box: Any) -> None:
    """Check, choose or type: the object holds it, or words say why not. Then let it be as it was."""
    entry = field.entry
    before = hand.main(value_of, field.obj, entry)
    if isinstance(field, CheckField):
        hand.click(box)
    elif isinstance(field, FontField):
        hand.fill(box, "DejaVu Sans")
    elif isinstance(field, ChoiceField):
        number = hand.main(others, box)[0]
        hand.choose(box, hand.main(box.itemText, number))
    else:
        hand.fill(box, "7" if hand.main(box.text).startswith("5") else "5")
    wanted = hand.main(field.read)
    assert wanted != before, entry.key

    def answers() -> bool:
        if editor.waiting or editor.timer.isActive():
            return False
        said = [editor.problem.text(), *(each.said for each in editor.form.field_order())]
        return value_of(field.obj, entry) == wanted or any(said)

    hand.wait(answers, 60, f"{entry.key} to be {wanted}")

    def take_back() -> None:
        edit(field.obj, **{entry.key: before})
        field.edited = False
        editor.refresh()
        editor.remake()

    hand.main(take_back, limit_s=60)
    hand.wait(lambda: not (editor.waiting or editor.timer.isActive()), 60, f"{entry.key} to be {before} again")
