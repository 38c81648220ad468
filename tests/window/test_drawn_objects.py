# SPDX-License-Identifier: LGPL-2.1-or-later
"""Imported drawings, texts and shapes by real clicks, in both languages: what a person sees, undoes and reloads."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtGui

from CNCStepper.workbench.features.base import problem_of, proxy_type
from window_helpers.file_dialogs import choose_file
from window_helpers.hand import Hand

ROOT = Path(__file__).parents[2]
IMPORT = "CNCStepper_Import_drawing"
LANGUAGES = {"en": "English", "pt": "pt-BR"}
SHEET = """<svg xmlns="http://www.w3.org/2000/svg" width="80mm" height="50mm" viewBox="0 0 80 50">
<g id="cut" fill="none" stroke="#ff0000"><path id="edge" d="M5 5 H75 V45 H5 V5.3"/></g>
<g id="holes" fill="none" stroke="#0000ff"><circle id="hole" cx="20" cy="25" r="{radius}"/></g></svg>"""


@pytest.fixture(params=LANGUAGES)
def language(hand: Hand, request: pytest.FixtureRequest) -> Iterator[str]:
    hand.main(FreeCADGui.setLocale, LANGUAGES[request.param])
    hand.settle()
    yield request.param
    hand.main(FreeCADGui.setLocale, "English")
    hand.settle()


@pytest.fixture
def document(hand: Hand) -> Any:
    def make() -> Any:
        made = FreeCAD.newDocument("Drawn")
        made.UndoMode = 1
        return made

    return hand.main(make)


def of_type(document: Any, type_: str) -> Any:
    return next((obj for obj in document.Objects if proxy_type(obj) == type_), None)


def cut_texts() -> list[str]:
    """Return the texts of labels and buttons of the task panel that are wider than their widget."""
    kinds = (QtGui.QAbstractButton,)
    found = [part for kind in kinds for part in FreeCADGui.getMainWindow().findChildren(kind)]
    ours = [part for part in found if part.isVisible() and part.objectName().startswith("CNCStepper_Panel")]
    return [part.text() for part in ours if part.width() < part.minimumSizeHint().width()]


def gap_row() -> str:
    """Return the text of the first row of the findings."""
    return str(FreeCADGui.getMainWindow().findChild(QtGui.QListWidget, "CNCStepper_Panel_findings").item(0).text())


def near_centre(x_mm: float, y_mm: float) -> bool:
    """Return whether the middle of the 3D view lies within 2 mm of a place."""
    view = FreeCADGui.activeDocument().activeView()
    width, height = view.getSize()
    seen = view.getPoint(width // 2, height // 2)
    return math.hypot(seen.x - x_mm, seen.y - y_mm) < 2.0


def wires(document: Any) -> dict[str, Any]:
    return {each.ChainName: each for each in of_type(document, "CNCStepper_Drawing").Group}


def test_a_drawing_is_imported_mended_and_reloaded(hand: Hand, document: Any, language: str, tmp_path: Path) -> None:
    path = tmp_path / "peça.svg"
    path.write_text(SHEET.format(radius=5), "utf-8")
    with hand.watchdog() as watch:
        hand.command("CNCStepper_ImportDrawing")
        choose_file(hand, IMPORT, path)
        hand.wait(lambda: of_type(document, "CNCStepper_Drawing") and len(wires(document)) == 2, 40, "the contours")
        hand.wait(lambda: hand.exists("CNCStepper_Panel_findings"), 5)
    print(f"import: at most {watch.max_ms:.0f} ms")
    assert not wires(document)["edge"].Closed
    hand.shot(f"import-drawing-{language}")
    assert hand.main(cut_texts) == []
    hand.item("CNCStepper_Panel_findings", gap_row())
    hand.wait(lambda: near_centre(5.0, 45.2), 10, "the view to go to the gap")
    hand.shot(f"import-drawing-place-{language}")
    hand.click("CNCStepper_Panel_mend")
    hand.wait(lambda: wires(document)["edge"].Closed, 20, "the gap to be closed")
    hand.shot(f"import-drawing-mended-{language}")
    hand.button("OK")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 10, "the panel to close")
    names = {key: each.Name for key, each in hand.main(lambda: wires(document)).items()}
    path.write_text(SHEET.format(radius=4), "utf-8")
    group = of_type(document, "CNCStepper_Drawing")
    hand.wait(lambda: problem_of(group), 10, "the change to be told")
    hand.shot(f"import-drawing-changed-{language}")
    hand.tree("peça", double=True)
    hand.wait(lambda: FreeCADGui.Control.activeDialog(), 10)
    hand.click("CNCStepper_Panel_reload")
    hand.wait(lambda: math.isclose(wires(document)["hole"].Shape.Length, 8 * math.pi), 20, "the new hole")
    other = tmp_path / "outra.svg"
    for file, radius in ((other, 3), (path, 4)):
        file.write_text(SHEET.format(radius=radius), "utf-8")
        hand.click("CNCStepper_Panel_file_choose")
        choose_file(hand, IMPORT, file)
        length = 2 * math.pi * radius
        hand.wait(lambda length=length: math.isclose(wires(document)["hole"].Shape.Length, length), 20, file.name)
    hand.button("OK")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 10, "the panel to close")
    assert {key: each.Name for key, each in hand.main(lambda: wires(document)).items()} == names
    hand.wait(lambda: not problem_of(group), 5, "the change to be taken in")
    hand.undo()
    hand.wait(lambda: math.isclose(wires(document)["hole"].Shape.Length, 10 * math.pi), 10, "the old hole")
    hand.undo()
    hand.wait(lambda: not document.Objects, 10, "the import to be undone")


def test_a_text_is_typed_and_seen_at_once(hand: Hand, document: Any, language: str) -> None:
    hand.command("CNCStepper_Text")
    hand.wait(lambda: hand.exists("CNCStepper_Panel_text"), 10)
    hand.wait(lambda: of_type(document, "CNCStepper_Text").CurveCount, 40, "the first letters")
    hand.click("CNCStepper_Panel_text")
    hand.key("Ctrl+A")
    hand.type("mao")
    hand.wait(lambda: of_type(document, "CNCStepper_Text").Text == "mao", 10, "the text")
    hand.main(lambda: hand_text(hand, "ação"))
    hand.wait(lambda: of_type(document, "CNCStepper_Text").Text == "ação", 10, "ç and ã")
    hand.shot(f"text-{language}")
    assert hand.main(cut_texts) == []
    hand.main(lambda: hand_text(hand, "a\u3042"))
    hand.wait(lambda: hand.exists("CNCStepper_Panel_text_error"), 20, "the missing letter to be told")
    hand.shot(f"text-missing-{language}")
    assert "\u3042" in hand.text("CNCStepper_Panel_text_error")
    hand.main(lambda: hand_text(hand, "ação"))
    hand.wait(lambda: not hand.exists("CNCStepper_Panel_text_error"), 20)
    hand.button("OK")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 20, "the panel to close")
    assert hand.main(lambda: problem_of(of_type(document, "CNCStepper_Text"))) == ""
    hand.undo()
    hand.wait(lambda: not document.Objects, 10, "the text to be undone")


def hand_text(hand: Hand, text: str) -> None:
    """Put letters that no key of the test's keyboard has into the box."""
    box = FreeCADGui.getMainWindow().findChild(QtGui.QPlainTextEdit, "CNCStepper_Panel_text")
    box.setPlainText(text)


def shapes() -> list[str]:
    """Return the names below the pictures."""
    pictures = FreeCADGui.getMainWindow().findChild(QtGui.QListWidget, "CNCStepper_Panel_shapes")
    return [pictures.item(row).text() for row in range(pictures.count())]


def test_a_shape_is_chosen_by_its_picture(hand: Hand, document: Any, language: str) -> None:
    hand.command("CNCStepper_Shapes")
    hand.wait(lambda: hand.exists("CNCStepper_Panel_shapes"), 10)
    hand.shot(f"shapes-{language}")
    first, *others = hand.main(lambda: [hand.find("CNCStepper_Panel_family").itemText(row) for row in range(2)])
    for family in (*others, first):
        before = hand.main(shapes)
        hand.choose("CNCStepper_Panel_family", family)
        hand.wait(lambda before=before: shapes() != before, 5, family)
    hand.item("CNCStepper_Panel_shapes", "Ring" if language == "en" else "Anel", double=True)
    hand.wait(lambda: hand.exists("CNCStepper_Panel_outer_diameter_mm"), 10)
    hand.fill("CNCStepper_Panel_outer_diameter_mm", "60")
    hand.wait(lambda: math.isclose(of_type(document, "CNCStepper_Shape").Shape.BoundBox.XLength, 60), 10, "the ring")
    hand.shot(f"shape-{language}")
    hand.fill("CNCStepper_Panel_inner_diameter_mm", "70")
    hand.wait(lambda: hand.exists("CNCStepper_Panel_problem"), 10, "the refusal")
    hand.shot(f"shape-refused-{language}")
    hand.click("CNCStepper_Panel_cancel")
    hand.wait(lambda: not document.Objects, 10, "nothing to be left")


def test_shapes_are_shown_where_no_document_is_open(hand: Hand) -> None:
    hand.command("CNCStepper_Shapes")
    hand.wait(lambda: hand.exists("CNCStepper_Panel_shapes"), 20, "the pictures")
    hand.click("CNCStepper_Panel_cancel")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 10, "the panel to close")


def test_a_job_file_is_opened_and_exported(hand: Hand, document: Any, tmp_path: Path) -> None:
    hand.menu("CNCStepper", "Open job")
    choose_file(hand, "CNCStepper_Job_file", ROOT / "examples" / "jobs" / "cycles" / "contour.toml")
    hand.wait(lambda: of_type(document, "CNCStepper_Job"), 30, "the job")
    hand.wait(lambda: not problem_of(of_type(document, "CNCStepper_Job")), 30, "its program")
    hand.shot("job-opened")
    hand.tree("contour")
    hand.menu("CNCStepper", "Export job")
    choose_file(hand, "CNCStepper_Job_file", tmp_path / "saída.toml")
    hand.wait(lambda: (tmp_path / "saída.toml").exists(), 20, "the file")
    hand.undo()
    hand.wait(lambda: not document.Objects, 10, "the job to be undone")


def box() -> None:
    """Put a block of 40 x 30 x 12 mm into the document."""
    import Part

    block = FreeCAD.ActiveDocument.addObject("Part::Feature", "Block")
    block.Shape = Part.makeBox(40, 30, 12)
    FreeCAD.ActiveDocument.recompute()


def test_a_body_is_sliced_beside_the_window(hand: Hand, document: Any, language: str, tmp_path: Path) -> None:
    hand.main(box)
    with hand.watchdog() as watch:
        hand.command("CNCStepper_Slices")
        hand.wait(lambda: hand.exists("CNCStepper_Panel_thickness_mm"), 10)
        hand.fill("CNCStepper_Panel_thickness_mm", "4")
        hand.fill("CNCStepper_Panel_time_s", "1")
        hand.click("CNCStepper_Panel_slice")
        hand.wait(lambda: hand.exists("CNCStepper_Panel_problem"), 10, "the missing folder to be told")
        hand.fill("CNCStepper_Panel_folder", str(tmp_path / "fatias"))
        hand.click("CNCStepper_Panel_slice")
        hand.wait(lambda: of_type(document, "CNCStepper_Slices").SheetCount, 60, "the sheets")
        hand.wait(lambda: hand.exists("CNCStepper_Panel_slices_report"), 20)
    print(f"slices: at most {watch.max_ms:.0f} ms")
    hand.shot(f"slices-{language}")
    assert hand.main(cut_texts) == [] and "3" in hand.text("CNCStepper_Panel_slices_report")
    hand.fill("CNCStepper_Panel_thickness_mm", "3")
    hand.button("OK")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 60, "the panel to close when it is sliced anew")
    slices = of_type(document, "CNCStepper_Slices")
    assert hand.main(lambda: (problem_of(slices), slices.SliceCount, len(slices.Group))) == ("", 4, 1)
    hand.undo()
    hand.wait(lambda: [each.Name for each in document.Objects] == ["Block"], 10, "the slices to be undone")
