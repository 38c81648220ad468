# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD expects of a workbench: a recorded macro makes the same document, and its test framework runs ours."""

from __future__ import annotations

import io
import unittest
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtGui

from CNCStepper.workbench import api
from CNCStepper.workbench.document import macro_recorder
from window_helpers import macros, monkey_documents
from window_helpers.hand import Hand

DRAWING = """<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="30mm" viewBox="0 0 40 30">
<circle cx="9" cy="9" r="5"/></svg>"""


@pytest.fixture
def document(hand: Hand) -> Iterator[Any]:
    """An empty document that keeps undo steps."""

    def make() -> Any:
        made = FreeCAD.newDocument("Macro")
        made.UndoMode = 1
        return made

    yield hand.main(make)


def close_panel(hand: Hand) -> None:
    """Press OK and wait until the panel is gone."""
    hand.button("OK")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 30, "the panel to close")


def open_panel(hand: Hand, command: str) -> None:
    """Choose a command and wait for its panel."""
    hand.command(command)
    hand.wait(FreeCADGui.Control.activeDialog, 20, "the panel")


def work(hand: Hand, document: Any, drawing: Path) -> None:
    """Make, edit, order and delete as a person does."""
    open_panel(hand, "CNCStepper_NewJob")
    hand.choose("CNCStepper_Panel_begin_with", "sign (example)")
    hand.wait(lambda: document.getObject("CNCStepper_Job").Material == "plywood", 10, "the template's material")
    close_panel(hand)
    for command in ("CNCStepper_RectangularPocket", "CNCStepper_CircularPocket"):
        hand.tree("Job")
        open_panel(hand, command)
        close_panel(hand)
    hand.tree("Rectangular pocket", double=True)
    hand.wait(FreeCADGui.Control.activeDialog, 20, "the pocket's panel")
    hand.fill("CNCStepper_Panel_depth_mm", "2.5")
    close_panel(hand)
    open_panel(hand, "CNCStepper_Shapes")
    hand.item("CNCStepper_Panel_shapes", "Ring", double=True)
    hand.wait(lambda: hand.exists("CNCStepper_Panel_outer_diameter_mm"), 10)
    hand.fill("CNCStepper_Panel_outer_diameter_mm", "60")
    close_panel(hand)
    hand.main(lambda: api.add_text(document, "não gravado"))  # by a script: of no concern to the macro
    hand.command("CNCStepper_ImportDrawing")
    hand.wait(lambda: hand.exists("fileNameEdit"), 20, "the question which file")
    hand.main(lambda: FreeCADGui.getMainWindow().findChild(QtGui.QLineEdit, "fileNameEdit").setText(str(drawing)))
    hand.click("fileNameEdit")
    hand.key("Return")
    hand.wait(lambda: [obj for obj in document.Objects if obj.Name.startswith("Contour")], 30, "the drawing")
    close_panel(hand)


def test_a_recorded_macro_makes_the_same_document(hand: Hand, document: Any, tmp_path: Path) -> None:
    drawing = tmp_path / "furo ç.svg"
    drawing.write_text(DRAWING, "utf-8")
    path = macros.begin_recording(hand)
    work(hand, document, drawing)
    text = macros.end_recording(hand, path)
    assert "Gui.runCommand('CNCStepper" not in text
    wanted = without_texts(hand.main(macros.state, document))
    again = hand.main(lambda: FreeCAD.newDocument("Again"))
    macros.run(hand, text)
    hand.wait(lambda: macros.state(again) == wanted, 60, "the same document")


def test_a_macro_deletes_duplicates_moves_and_undoes(hand: Hand, tmp_path: Path) -> None:
    document = hand.main(monkey_documents.draw, "milling", tmp_path, limit_s=120)
    copy = tmp_path / "Monkey.FCStd"
    hand.main(document.saveCopy, str(copy))
    path = macros.begin_recording(hand)
    for label, command in (("Pocket", "Duplicate"), ("Drill", "MoveUp"), ("Bore", "MoveDown")):
        hand.tree(label)
        hand.main(FreeCADGui.runCommand, f"CNCStepper_{command}")
    delete(hand, "Thread")
    hand.tree("Face", double=True)
    hand.wait(FreeCADGui.Control.activeDialog, 20, "the panel")
    hand.key("Esc")  # a step that is taken back before it changed anything
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 20, "the panel to close")
    delete(hand, "Engrave")
    hand.undo()
    hand.wait(lambda: document.getObject("CNCStepper_Engrave"), 10, "what was deleted last")
    hand.tree("Contour", double=True)
    hand.wait(FreeCADGui.Control.activeDialog, 20, "the panel")
    hand.fill("CNCStepper_Panel_depth_mm", "2.5")
    hand.wait(lambda: document.getObject("CNCStepper_Contour").Depth == 2.5, 20, "the depth")
    hand.undo()
    hand.key("Esc")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 20, "the panel to close")
    text = macros.end_recording(hand, path)
    wanted = hand.main(macros.state, document)
    assert "CNCStepper_Thread.type" not in wanted and wanted["CNCStepper_Contour.Depth"] != "2.5"
    macros.run_on_copy(hand, text, copy, wanted)


def test_an_undo_where_nothing_is_ours_is_written_by_freecad(hand: Hand, document: Any) -> None:
    hand.main(macro_recorder.follow, document, "Ours")

    def make_box() -> None:
        other = FreeCAD.newDocument("Other")
        other.UndoMode = 1
        other.openTransaction("Box")
        other.addObject("Part::Box", "Box")
        other.commitTransaction()

    hand.main(make_box)
    path = macros.begin_recording(hand)
    hand.undo()
    text = macros.end_recording(hand, path)
    assert "Std_Undo" in text and "CNCStepper" not in text


def test_a_macro_deletes_a_job_with_all_that_is_its_own(hand: Hand, tmp_path: Path) -> None:
    document = hand.main(monkey_documents.draw, "cutting", tmp_path, limit_s=120)
    copy = tmp_path / "Monkey.FCStd"
    hand.main(document.saveCopy, str(copy))
    path = macros.begin_recording(hand)
    delete(hand, "Job001")
    text = macros.end_recording(hand, path)
    wanted = hand.main(macros.state, document)
    assert "CNCStepper_SheetCut001.type" not in wanted and "CNCStepper_SheetCut.type" in wanted
    macros.run_on_copy(hand, text, copy, wanted)


def delete(hand: Hand, label: str) -> None:
    """Delete an object of the tree by its key; FreeCAD's question what depends on it is answered with Yes."""
    hand.tree(label)
    hand.shortcut("Std_Delete", "Delete")
    if hand.is_soon(lambda: QtGui.QApplication.activeModalWidget() is not None):
        hand.key("Alt+Y")
    hand.wait(lambda: label not in [obj.Label for obj in FreeCAD.ActiveDocument.Objects], 10, f"{label} to go")


def without_texts(held: dict[str, Any]) -> dict[str, Any]:
    """Return the state of a document without the text that a script has made."""
    return {key: value for key, value in held.items() if not key.startswith("CNCStepper_Text.")}


def test_freecads_test_framework_runs_our_tests_of_the_window(hand: Hand) -> None:
    name = "CNCStepper.workbench.unit_tests.test_gui"
    said = io.StringIO()
    assert name in FreeCAD.__unit_test__
    tests = hand.main(lambda: unittest.defaultTestLoader.loadTestsFromName(name))
    result = hand.main(lambda: unittest.TextTestRunner(stream=said).run(tests))
    assert result.testsRun >= 2
    assert result.wasSuccessful(), said.getvalue()
