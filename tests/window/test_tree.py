# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's tree: what stands below a job, badges and tooltips, double click, context menu, deleting, reopening."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import Part
import pytest
from FreeCAD import Vector
from PySide import QtCore, QtGui

from CNCStepper.workbench import api
from CNCStepper.workbench.features.base import problem_of, proxy_type
from CNCStepper.workbench.services.icons import icon
from CNCStepper.workbench.viewproviders import tree_tooltips
from window_helpers import screen_places as places
from window_helpers.hand import Hand

RIGHT = 3
TOOL = "T1 flat end mill 6 mm"  # as it is called until a person names it


@pytest.fixture
def job(hand: Hand) -> Any:
    """A job with a tool, a pocket from a sketch and one from numbers; each was one undo step."""
    return hand.main(make_job)


def make_job() -> Any:
    document = FreeCAD.newDocument("Part")
    document.openTransaction("Drawing")
    sketch = document.addObject("Sketcher::SketchObject", "Sketch")
    sketch.addGeometry(Part.Ellipse(Vector(30, 0), Vector(0, 20), Vector()))
    document.commitTransaction()
    document.openTransaction("Job")
    made = api.new_job(document)
    api.add_tool(made)
    api.add_elliptical_pocket(made, sketch, depth_mm=4)
    api.add_elliptical_pocket(made, depth_mm=2)
    document.recompute()
    document.commitTransaction()
    return made


def tree() -> Any:
    """Return FreeCAD's tree, all rows open."""
    shown = [view for view in FreeCADGui.getMainWindow().findChildren(QtGui.QTreeWidget) if view.isVisible()]
    found = next(view for view in shown if view.metaObject().className() == "Gui::TreeWidget")
    found.expandAll()
    return found


def row(label: str) -> Any:
    exactly = QtCore.Qt.MatchFlag.MatchRecursive | QtCore.Qt.MatchFlag.MatchExactly
    rows = tree().findItems(label, exactly)
    return rows[0] if rows else None


def children(label: str) -> list[str]:
    parent = row(label)
    return [parent.child(index).text(0) for index in range(parent.childCount())] if parent is not None else []


def names(document: Any) -> set[str]:
    return {obj.Name for obj in document.Objects}


def badge(obj: Any) -> str:
    return obj.ViewObject.Proxy.badge()


def test_a_job_holds_what_is_its_own(hand: Hand, job: Any) -> None:
    wanted = [TOOL, "EllipticalPocket", "EllipticalPocket001", "Preview"]
    hand.wait(lambda: children("Job") == wanted, 5, "the job's rows")
    assert hand.main(children, "Part")[:2] == ["Sketch", "Job"]
    assert hand.main(lambda: all(obj.ViewObject.isVisible() for obj in job.Document.Objects))
    hand.shot("tree", hand.main(tree))


def test_a_problem_has_a_badge_and_a_tooltip(hand: Hand, job: Any) -> None:
    pocket = hand.main(lambda: job.Operations[1])
    hand.wait(lambda: children("Job"))
    assert hand.main(badge, pocket) == ""
    hand.main(lambda: (api.edit(pocket, radius_x_mm=2), job.Document.recompute()))
    assert (hand.main(badge, pocket), hand.main(badge, job), hand.main(badge, job.Operations[0])) == (
        "Problem", "Problem", "",
    )  # fmt: skip
    assert hand.main(lambda: tree_tooltips.problem_at(row(pocket.Label))) == hand.main(problem_of, pocket) != ""
    assert "wider than the pocket" in hand.tooltip_in_tree(pocket.Label)
    hand.shot("tree-problem")
    hand.main(lambda: (api.edit(pocket, radius_x_mm=40), job.Document.recompute()))
    assert hand.main(badge, pocket) == ""
    assert hand.main(lambda: tree_tooltips.problem_at(row(pocket.Label))) == ""


def test_a_badge_changes_the_picture(hand: Hand) -> None:
    def picture(badge: str) -> Any:
        return icon("CNCStepper_Engrave", badge).pixmap(16, 16).toImage()

    plain, problem, inactive = (hand.main(picture, badge) for badge in ("", "Problem", "Inactive"))
    assert plain != problem != inactive != plain


def test_a_double_click_opens_the_panel(hand: Hand, job: Any) -> None:
    hand.wait(lambda: children("Job"))
    for label in ("EllipticalPocket", "Job", "Preview"):
        hand.tree(label)
        hand.wait(lambda label=label: FreeCADGui.Selection.getSelection()[0].Label == label, 5, f"{label} selected")
        hand.tree(label, double=True)
        hand.wait(FreeCADGui.Control.activeDialog, 5, f"the panel of {label}")
        assert not hand.main(lambda: QtGui.QApplication.activeModalWidget())
        hand.button("Cancel")
        hand.wait(lambda: not FreeCADGui.Control.activeDialog())
        hand.wait(lambda: FreeCADGui.Command.get("CNCStepper_NewJob").getAction()[0].isEnabled())
    assert hand.main(lambda: list(job.Document.UndoNames)) == ["Job", "Drawing"]


def test_a_second_double_click_keeps_the_open_panel(hand: Hand, job: Any) -> None:
    hand.wait(lambda: children("Job"))
    hand.main(lambda: job.Operations[0].ViewObject.Proxy.edit())
    hand.wait(FreeCADGui.Control.activeDialog)
    hand.main(lambda: job.Operations[1].ViewObject.Proxy.edit())
    assert hand.main(lambda: FreeCADGui.getMainWindow().statusBar().currentMessage()) == (
        "Close the open task panel first"
    )
    assert hand.main(lambda: bool(FreeCADGui.Control.activeDialog()))


def context_menu(hand: Hand, label: str) -> dict[str, bool]:
    """Open the context menu of a row and return its texts and what is enabled."""
    hand.wait(lambda: row(label) is not None)
    hand.tree(label)
    hand._click_place(hand.main(places.of_tree_item, label), RIGHT)
    hand.wait(QtGui.QApplication.activePopupWidget, 5, "the context menu")
    return hand.main(
        lambda: {entry.text(): entry.isEnabled() for entry in QtGui.QApplication.activePopupWidget().actions()}
    )


def test_the_context_menu_of_a_job(hand: Hand, job: Any) -> None:
    entries = context_menu(hand, "Job")
    assert list(entries)[:5] == ["Edit", "Check and simulate", "Send", "Edit program", "Save program as…"]
    assert all(list(entries.values())[:5])
    hand.shot("context-menu-job")
    hand.key("Escape")


def test_an_operation_is_left_out_by_its_context_menu(hand: Hand, job: Any) -> None:
    pocket = hand.main(lambda: job.Operations[0])
    before = hand.main(api.program_text, job)
    assert "Leave out of the program" in context_menu(hand, pocket.Label)
    hand._click_place(hand.main(places.popup_entry, "Leave out of the program"))
    hand.wait(lambda: not pocket.Active)
    assert hand.main(badge, pocket) == "Inactive"
    assert len(hand.main(api.program_text, job)) < len(before)
    hand.shot("tree-inactive", hand.main(tree))
    hand.main(lambda: (job.Document.undo(), job.Document.recompute()))
    assert hand.main(lambda: pocket.Active)
    assert hand.main(badge, pocket) == ""


def test_a_program_is_saved_where_the_person_says(hand: Hand, job: Any, tmp_path: Path) -> None:
    context_menu(hand, "Job")
    hand._click_place(hand.main(places.popup_entry, "Save program as…"))
    hand.wait(lambda: places.visible("CNCStepper_Save_file"), 5, "the file dialog")
    hand.key("Ctrl+A")
    hand.type(str(tmp_path / "peça 1.nc"))
    for _ in range(3):  # the first may go to the list that completes the name
        if hand.main(places.visible, "CNCStepper_Save_file"):
            hand.key("Return")
            hand.settle()
    hand.wait((tmp_path / "peça 1.nc").exists)
    assert (tmp_path / "peça 1.nc").read_text("ascii") == hand.main(api.program_text, job)


def delete(hand: Hand, label: str, question: bool = False) -> None:
    """Delete a row as a person does, with the key; answer FreeCAD's question with Yes."""
    hand.wait(lambda: row(label) is not None)
    hand.tree(label)
    hand.shortcut("Std_Delete", "Delete")
    if question:
        hand.wait(
            lambda: isinstance(QtGui.QApplication.activeModalWidget(), QtGui.QMessageBox), 5, "FreeCAD's question"
        )
        hand.shot("tree-question")
        box = hand.main(QtGui.QApplication.activeModalWidget)
        hand.click(hand.main(box.button, QtGui.QMessageBox.StandardButton.Yes))
    hand.settle()
    assert not hand.main(QtGui.QApplication.activeModalWidget)


def test_a_deleted_job_takes_along_what_is_its_own(hand: Hand, job: Any) -> None:
    document = hand.main(lambda: job.Document)
    before = hand.main(names, document)
    delete(hand, "Job")
    hand.wait(lambda: names(document) == {"Sketch"}, 5, "only the drawing to be left")
    hand.undo()
    hand.wait(lambda: names(document) == before)
    hand.wait(lambda: len(children("Job")) == 4)
    restored = hand.main(lambda: document.getObject("CNCStepper_Job"))
    hand.main(document.recompute)
    assert hand.main(api.program_text, restored)


def test_a_tool_that_another_job_uses_stays(hand: Hand, job: Any) -> None:
    document = hand.main(lambda: job.Document)
    tool = hand.main(lambda: job.Tools[0])
    other = hand.main(lambda: api.new_job(document))
    hand.main(lambda: setattr(other, "Tools", [tool]))
    hand.wait(lambda: children("Job001") == [TOOL, "Preview001"], 5, "the other job's rows")
    delete(hand, "Job")
    hand.wait(lambda: "CNCStepper_Job" not in names(document))
    assert tool.Name in hand.main(names, document)
    assert hand.main(lambda: [each.Name for each in other.Tools]) == [tool.Name]


def test_a_deleted_operation_leaves_the_program(hand: Hand, job: Any) -> None:
    before = hand.main(api.program_text, job)
    delete(hand, "EllipticalPocket001")
    hand.wait(lambda: len(job.Operations) == 1)
    hand.main(job.Document.recompute)
    assert len(hand.main(api.program_text, job)) < len(before)


def test_a_deleted_tool_leaves_a_problem_that_undo_mends(hand: Hand, job: Any) -> None:
    delete(hand, TOOL, question=True)
    hand.wait(lambda: not job.Tools)
    hand.main(job.Document.recompute)
    assert "has no tool" in hand.main(problem_of, job)
    assert hand.main(lambda: all(badge(obj) == "Problem" for obj in [job, *job.Operations]))
    hand.undo()
    hand.wait(lambda: job.Tools)
    hand.main(job.Document.recompute)
    assert hand.main(problem_of, job) == ""


def test_hiding_the_job_hides_its_preview(hand: Hand, job: Any) -> None:
    preview = hand.main(lambda: job.Document.getObject("CNCStepper_Preview"))
    hand.wait(lambda: row("Job") is not None)
    hand.tree("Job")
    hand.shortcut("Std_ToggleVisibility", "space")
    hand.wait(lambda: not preview.ViewObject.Visibility)
    hand.shortcut("Std_ToggleVisibility", "space")
    hand.wait(lambda: preview.ViewObject.Visibility)


@pytest.mark.parametrize("old", [False, True], ids=["as saved", "as older versions saved it"])
def test_a_reopened_document_has_its_views(hand: Hand, job: Any, tmp_path: Path, old: bool) -> None:
    def reopened() -> Any:
        document = job.Document
        for obj in document.Objects if old else ():
            if proxy_type(obj):
                obj.ViewObject.Proxy = 0
        path = str(tmp_path / "peça nº 1.FCStd")
        document.saveAs(path)
        FreeCAD.closeDocument(document.Name)
        return FreeCAD.openDocument(path)

    document = hand.main(reopened)
    ours = hand.main(lambda: [obj for obj in document.Objects if proxy_type(obj)])
    assert len(ours) == 5
    assert hand.main(lambda: [type(obj.ViewObject.Proxy).__name__ for obj in ours]) == [
        "Job", "Preview", "Tool", "Operation", "Operation",
    ]  # fmt: skip
    hand.wait(lambda: len(children("Job")) == 4)
    assert hand.main(lambda: all(not obj.ViewObject.Icon.isNull() for obj in ours))
    assert not hand.main(lambda: "Touched" in document.getObject("CNCStepper_Job").State)


def test_a_document_made_without_a_window_gets_its_views(hand: Hand, job: Any, tmp_path: Path) -> None:
    """Such a document has no GuiDocument.xml: it is taken out of one that has."""
    import zipfile

    def saved() -> str:
        job.Document.saveAs(str(tmp_path / "whole.FCStd"))
        FreeCAD.closeDocument(job.Document.Name)
        return str(tmp_path / "whole.FCStd")

    bare = tmp_path / "bare.FCStd"
    with zipfile.ZipFile(hand.main(saved)) as whole, zipfile.ZipFile(bare, "w") as archive:
        for name in whole.namelist():
            if name != "GuiDocument.xml" and "ShapeAppearance" not in name:
                archive.writestr(name, whole.read(name))
    document = hand.main(FreeCAD.openDocument, str(bare))
    hand.wait(lambda: len(children("Job")) == 4)
    ours = hand.main(lambda: [obj for obj in document.Objects if proxy_type(obj)])
    assert hand.main(lambda: all(obj.ViewObject.Proxy.obj is obj for obj in ours))
    assert hand.main(lambda: document.getObject("CNCStepper_Preview").ViewObject.isVisible())


def test_a_duplicated_job_stands_on_its_own(hand: Hand, job: Any) -> None:
    document = hand.main(lambda: job.Document)
    copies = hand.main(lambda: document.copyObject([job], True))
    hand.main(document.recompute)
    copy = hand.main(lambda: next(obj for obj in copies if proxy_type(obj) == "CNCStepper_Job"))
    assert copy.Name != job.Name
    assert hand.main(lambda: type(copy.ViewObject.Proxy).__name__) == "Job"
    assert hand.main(api.program_text, copy)


# ---- the order of operations ----

ORDER = ("a", "b", "c", "d")


@pytest.fixture
def ordered(hand: Hand) -> Any:
    """A job of four pockets, and a circle that is in no job; each was one undo step."""
    job = hand.main(make_ordered)
    hand.wait(lambda: children("Job") == [TOOL, *ORDER, "Preview"], 5, "the job's rows")
    return job


def make_ordered() -> Any:
    document = FreeCAD.newDocument("Part")
    document.openTransaction("Job")
    made = api.new_job(document)
    api.add_tool(made)
    for number, label in enumerate(ORDER):
        api.add_operation(made, "circular_pocket", depth_mm=1 + number, radius_mm=10).Label = label
    circle = document.addObject("Part::Feature", "Circle")
    circle.Shape = Part.makeCircle(5)
    document.recompute()
    document.commitTransaction()
    return made


def order(job: Any) -> list[str]:
    return [operation.Label for operation in job.Operations]


def drag(hand: Hand, labels: list[str], onto: str, *, lower: bool = True, modifiers: tuple[str, ...] = ()) -> None:
    hand.drag_in_tree(labels, onto, lower=lower, modifiers=modifiers)
    hand.shot(f"drag-{'-'.join(labels)}-{onto}-{'lower' if lower else 'upper'}")
    hand.drop(modifiers)


@pytest.mark.parametrize(
    ("labels", "onto", "lower", "wanted"),
    [
        (["a"], "c", True, "bcad"),
        (["a"], "c", False, "bacd"),
        (["d"], "a", False, "dabc"),
        (["a", "c"], "d", True, "bdac"),
        (["b"], "Job", True, "acdb"),
    ],
)
def test_dragging_orders_operations(
    hand: Hand, ordered: Any, labels: list[str], onto: str, lower: bool, wanted: str
) -> None:
    before = hand.main(api.program_text, ordered)
    drag(hand, labels, onto, lower=lower)
    hand.wait(lambda: order(ordered) == list(wanted), 5, f"the order {wanted}")
    hand.wait(lambda: children("Job") == [TOOL, *wanted, "Preview"], 5, "the rows in that order")
    assert hand.main(problem_of, ordered) == ""
    assert hand.main(lambda: ordered.Document.UndoNames) == ["Move operations", "Job"]
    hand.undo()
    hand.wait(lambda: order(ordered) == list(ORDER))
    assert hand.main(api.program_text, ordered) == before


@pytest.mark.parametrize(
    ("labels", "onto", "modifiers"),
    [
        (["a"], TOOL, ()),
        (["a"], "Preview", ()),
        (["a"], "Part", ()),
        (["a", "b"], "Part", ()),
        (["a"], "Circle", ()),
        (["Circle"], "b", ()),
        (["Circle"], "b", ("Alt",)),
        (["Circle"], "Job", ()),
        ([TOOL], "b", ()),
        (["Preview"], "b", ()),
        (["a"], "Part", ("Alt",)),
        ([TOOL], "Part", ()),
    ],
)
def test_no_drag_takes_anything_out_of_its_job(
    hand: Hand, ordered: Any, labels: list[str], onto: str, modifiers: tuple[str, ...]
) -> None:
    document = hand.main(lambda: ordered.Document)
    before = hand.main(lambda: (names(document), order(ordered), list(document.UndoNames), api.program_text(ordered)))
    drag(hand, labels, onto, modifiers=modifiers)
    hand.settle()
    after = hand.main(lambda: (names(document), order(ordered), list(document.UndoNames), api.program_text(ordered)))
    assert after == before
    assert hand.main(lambda: FreeCADGui.getMainWindow().statusBar().currentMessage())


def test_no_drag_takes_an_operation_into_another_document(hand: Hand, ordered: Any) -> None:
    other = hand.main(FreeCAD.newDocument, "Other")
    into = hand.main(api.new_job, other)
    hand.main(lambda: (setattr(into, "Label", "Other job"), setattr(other, "Label", "Second")))
    for onto in ("Second", "Other job"):
        hand.wait(lambda onto=onto: row("a") is not None and row(onto) is not None)
        drag(hand, ["a"], onto)
        hand.settle()
        assert hand.main(order, ordered) == list(ORDER)
        assert hand.main(lambda: [len(into.Operations), len(other.Objects)]) == [0, 2]


def test_a_drag_with_ctrl_copies(hand: Hand, ordered: Any) -> None:
    drag(hand, ["a"], "c", modifiers=("Ctrl",))
    hand.wait(lambda: len(ordered.Operations) == 5, 5, "the copy")
    labels = hand.main(order, ordered)
    assert labels[:3] + labels[4:] == list(ORDER) and labels[3].startswith("a")
    assert hand.main(problem_of, ordered) == ""
    hand.undo()
    hand.wait(lambda: order(ordered) == list(ORDER))


def test_the_menu_moves_and_duplicates(hand: Hand, ordered: Any) -> None:
    entries = context_menu(hand, "a")
    assert list(entries)[:5] == ["Edit", "Leave out of the program", "Duplicate", "Move up", "Move down"]
    assert [entries["Move up"], entries["Move down"]] == [False, True]
    hand.shot("context-menu-operation")
    hand._click_place(hand.main(places.popup_entry, "Move down"))
    hand.wait(lambda: order(ordered) == list("bacd"))
    context_menu(hand, "c")
    hand._click_place(hand.main(places.popup_entry, "Duplicate"))
    hand.wait(lambda: len(ordered.Operations) == 5)
    assert hand.main(lambda: ordered.Operations[3].Label).startswith("c")
    assert hand.main(problem_of, ordered) == ""
    assert hand.main(lambda: list(ordered.Document.UndoNames)) == ["Duplicate", "Move down", "Job"]
    hand.tree("d")
    hand.menu("CNCStepper", "Move up")
    hand.wait(lambda: order(ordered)[3] == "d")
    hand.menu("CNCStepper", "Move down")
    hand.wait(lambda: order(ordered)[4] == "d")
    hand.menu("CNCStepper", "Duplicate")
    hand.wait(lambda: len(ordered.Operations) == 6 and ordered.Operations[5].Label.startswith("d"))
    for _ in range(5):
        hand.undo()
    hand.wait(lambda: order(ordered) == list(ORDER) and len(ordered.Document.Objects) == 8)


def test_copy_and_paste_land_behind_the_original(hand: Hand, ordered: Any) -> None:
    objects = hand.main(lambda: names(ordered.Document))
    hand.tree("b")
    hand.shortcut("Std_Copy", "Ctrl+C")
    hand.wait(QtGui.QApplication.activeModalWidget, 5, "FreeCAD's question what to copy along")
    hand.key("Return")
    hand.wait(lambda: not QtGui.QApplication.activeModalWidget())
    hand.shortcut("Std_Paste", "Ctrl+V")
    hand.wait(lambda: len(ordered.Operations) == 5, 5, "the copy in the job")
    copy = hand.main(lambda: ordered.Operations[2])
    assert hand.main(lambda: (copy.Label[0], copy.Tool is ordered.Operations[1].Tool)) == ("b", True)
    hand.wait(lambda: len(children("Job")) >= 7)
    assert hand.main(lambda: [obj.Name for obj in ordered.Document.Objects if proxy_type(obj) and not obj.InList]) == (
        ["CNCStepper_Preview"]
    )
    hand.wait(lambda: len(ordered.Tools) == 1, 5, "the tool that was pasted along to go")
    hand.main(ordered.Document.recompute)
    assert hand.main(problem_of, ordered) == ""
    hand.shot("pasted", hand.main(tree))
    hand.undo()
    hand.wait(lambda: names(ordered.Document) == objects, 5, "one undo to take the copies away")
    assert hand.main(order, ordered) == list(ORDER)
    hand.redo()
    hand.wait(lambda: len(ordered.Operations) == 5 and len(ordered.Tools) == 1, 5, "one redo to bring the copy back")


def test_a_deleted_operation_comes_back_in_its_place(hand: Hand, ordered: Any) -> None:
    delete(hand, "b")
    hand.wait(lambda: order(ordered) == list("acd"))
    hand.undo()
    hand.wait(lambda: order(ordered) == list(ORDER))
