# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts are nested and programs arranged by real clicks and drags, in both languages: counts, overlap, undo, saving."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import Part
import pytest
from PySide import QtGui

from CNCStepper.workbench import api
from CNCStepper.workbench.features.base import problem_of, proxy_type
from CNCStepper.workbench.features.drawings.nest import part_values
from window_helpers.file_dialogs import choose_file
from window_helpers.hand import Hand

P = "CNCStepper_Panel_"
LANGUAGES = {"en": "English", "pt": "pt-BR"}
SQUARE = "G21 G90 G17\nM3 S1000\nG0 Z5\nG0 X0 Y0\nG1 Z-1 F200\nG1 X20 F600\nG1 Y10\nG1 X0\nG1 Y0\nG0 Z5\nM5\nM2\n"
MOST_MS = 50.0  # of one call on the window's thread, beside what FreeCAD itself takes


@pytest.fixture(params=LANGUAGES)
def language(hand: Hand, request: pytest.FixtureRequest) -> Iterator[str]:
    hand.main(FreeCADGui.setLocale, LANGUAGES[request.param])
    hand.settle()
    yield request.param
    hand.main(FreeCADGui.setLocale, "English")
    hand.settle()


def new_document() -> Any:
    """Return a document that is seen from above, with its view shown."""
    import pivy.coin  # noqa: F401  the camera's type comes from it

    made = FreeCAD.newDocument("Placing")
    made.UndoMode = 1
    view = FreeCADGui.ActiveDocument.ActiveView
    view.setAnimationEnabled(False)
    view.viewTop()
    return made


def wire(document: Any, name: str, corners: list[tuple[float, float]]) -> Any:
    shape = document.addObject("Part::Feature", name)
    shape.Shape = Part.makePolygon([FreeCAD.Vector(x, y, 0) for x, y in (*corners, corners[0])])
    return shape


def of_type(document: Any, type_: str) -> Any:
    return next((each for each in document.Objects if proxy_type(each) == type_), None)


def placed(panel: Any) -> list[list[Any]]:
    return panel.rows()


def panel_of() -> Any:
    """Return the panel whose mode is on, by the dialog's form."""
    import gc

    from CNCStepper.workbench.panels.placing.placing_panel import PlacingPanel

    found = [each for each in gc.get_objects() if isinstance(each, PlacingPanel) and each.mode is not None]
    return found[-1]


def select(*objects: Any) -> None:
    FreeCADGui.Selection.clearSelection()
    for each in objects:
        FreeCADGui.Selection.addSelection(each)


def cut_texts() -> list[str]:
    """Return the texts of buttons of the task panel that are wider than their widget."""
    found = FreeCADGui.getMainWindow().findChildren(QtGui.QAbstractButton)
    ours = [part for part in found if part.isVisible() and part.objectName().startswith("CNCStepper_Panel")]
    return [part.text() for part in ours if part.width() < part.minimumSizeHint().width()]


def drag_part(hand: Hand, begin: tuple[float, float], end: tuple[float, float], **more: Any) -> None:
    (x, y), (to_x, to_y) = hand.view_point(*begin), hand.view_point(*end)
    steps = [(x + (to_x - x) * step / 8, y + (to_y - y) * step / 8) for step in range(9)]
    hand.drag(steps, **more)


def pixel_mm(hand: Hand) -> float:
    """Return how much of the drawing a pixel of the view shows: above 1 mm where docks leave it little room."""
    return 100.0 / abs(hand.view_point(100, 0)[0] - hand.view_point(0, 0)[0])


def test_parts_are_nested_dragged_turned_locked_and_filled(hand: Hand, language: str, tmp_path: Path) -> None:
    document = hand.main(new_document)

    def make() -> None:
        plate = wire(document, "Plate", [(0, 0), (60, 0), (60, 20), (20, 20), (20, 40), (0, 40)])
        bar = wire(document, "Bar", [(100, 0), (140, 0), (140, 15), (100, 15)])
        document.recompute()
        select(plate, bar)

    hand.main(make)
    with hand.watchdog() as watch:
        hand.command("CNCStepper_Nest")
        hand.wait(lambda: hand.exists("CNCStepper_Panel_count_1"), 10)
        hand.fill("CNCStepper_Panel_count_0", "2")
        hand.fill("CNCStepper_Panel_sheet_x_mm", "300")
        hand.fill("CNCStepper_Panel_sheet_y_mm", "200")
        hand.fill("CNCStepper_Panel_time_s", "300")
        hand.fill("CNCStepper_Panel_folder", str(tmp_path / "chapas"))
        hand.click("CNCStepper_Panel_nest")
        hand.wait(lambda: hand.exists("CNCStepper_Panel_nesting"), 30, "the progress")
        hand.wait(lambda: "%" in hand.find("CNCStepper_Panel_nesting").findChild(QtGui.QLabel).text(), 60)
        hand.click("CNCStepper_Panel_stop")
        nest = hand.main(of_type, document, "CNCStepper_Nest")
        hand.wait(lambda: nest.Placed == 3, 60, "the best so far after Stop")
        hand.wait(lambda: len(nest.Group) == 1 and nest.Group[0].Group, 30)
        hand.settle()
        print(f"nest: at most {watch.max_ms:.0f} ms")
    panel = hand.main(panel_of)
    before = hand.main(placed, panel)
    number = next(n for n, row in enumerate(before) if row[1] == 1)
    middle = hand.main(lambda: panel.nest.polygon(number).centroid.coords[0])
    hand.shot(f"nest-{language}")
    with hand.watchdog() as watch:
        drag_part(hand, middle, (250, 170))
    print(f"drag: at most {watch.max_ms:.0f} ms")
    after = hand.main(placed, panel)
    assert [row for n, row in enumerate(after) if n != number] == [row for n, row in enumerate(before) if n != number]
    middle = hand.main(lambda: panel.nest.polygon(number).centroid.coords[0])
    assert middle == pytest.approx((250, 170), abs=3 * pixel_mm(hand))

    other = next(n for n, row in enumerate(before) if row[1] == 0)
    target = hand.main(lambda: panel.nest.polygon(other).centroid.coords[0])
    x, y = hand.view_point(*middle)
    hand.press_at((x, y))
    hand.move_to(hand.view_point(target[0] + 1, target[1]))
    hand.wait(lambda: hand.exists("CNCStepper_Panel_why_not"), 5, "the overlap to be told at once")
    hand.shot(f"nest-overlap-{language}")
    hand.release()
    assert hand.main(lambda: panel.nest.overlapping()) == [], "a part never comes to lie on another"

    middle = hand.main(lambda: panel.nest.polygon(number).centroid.coords[0])
    drag_part(hand, middle, (240, 150))
    hand.click("CNCStepper_Panel_turn_part")
    turned = hand.main(placed, panel)[number][4]
    assert turned != after[number][4]
    hand.click("CNCStepper_Panel_lock_part")
    locked = hand.main(placed, panel)[number]
    assert locked[5] is True
    middle = hand.main(lambda: panel.nest.polygon(number).centroid.coords[0])
    drag_part(hand, middle, (200, 100))
    assert hand.main(placed, panel)[number] == locked

    hand.click("CNCStepper_Panel_fill")
    hand.wait(lambda: len(panel.rows()) > 10, 60, "the sheet to be filled")
    hand.settle()
    count = hand.main(lambda: panel.rows() and len(panel.rows()))
    hand.shot(f"nest-filled-{language}")
    assert hand.main(cut_texts) == []
    hand.button("OK")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 60, "the panel to close when the sheets are written")
    assert hand.main(lambda: (problem_of(nest), nest.Placed, len(nest.Group))) == ("", count, 1)
    assert locked in hand.main(lambda: json.loads(nest.Placements))
    hand.undo()
    hand.wait(lambda: sorted(each.Name for each in document.Objects) == ["Bar", "Plate"], 10, "all to be undone")
    hand.redo()
    hand.wait(lambda: of_type(document, "CNCStepper_Nest") is not None, 10)


def test_parts_and_remnants_are_chosen_in_menus_and_cells_typed(hand: Hand, tmp_path: Path) -> None:
    document = hand.main(new_document)

    def make() -> Any:
        plate = wire(document, "Plate", [(0, 0), (60, 0), (60, 20), (0, 20)])
        wire(document, "Bar", [(100, 0), (140, 0), (140, 15), (100, 15)])
        wire(document, "Rest", [(200, 0), (300, 0), (300, 100), (200, 100)])
        document.recompute()
        select(plate)

    hand.main(make)
    hand.command("CNCStepper_Nest")
    hand.wait(lambda: hand.exists(f"{P}count_0"), 10)
    nest = hand.main(of_type, document, "CNCStepper_Nest")
    for button, entry, labels in (
        ("add_part", "Bar", ["Plate", "Bar"]),
        ("add_part", "Rest", ["Plate", "Bar", "Rest"]),
    ):
        hand.click(f"{P}{button}")
        hand.entry(entry)
        hand.wait(lambda labels=labels: [part.Label for part in nest.Parts] == labels, 5, entry)
    hand.item(f"{P}parts", "Rest")
    hand.click(f"{P}drop_part")
    hand.wait(lambda: len(nest.Parts) == 2, 5, "the part to be left out")
    for entry, count in (("All of them", 3), ("", 0), ("Rest", 1)):
        hand.click(f"{P}add_rest" if entry else f"{P}drop_rests")
        if entry:
            hand.entry(entry)
        hand.wait(lambda count=count: len(nest.Remnants) == count, 5, f"{count} remnants")
    for column, (key, value) in enumerate({"count": "2", "turn": "any", "grain": "", "priority": "3"}.items(), 2):
        set_cell(hand, nest, column, key, value)
    set_cell(hand, nest, 6, "thickness_mm", "1.5")
    set_cell(hand, nest, 6, "thickness_mm", "0")
    hand.fill(f"{P}time_s", "1")
    hand.fill(f"{P}folder", str(tmp_path))
    hand.click(f"{P}nest")
    hand.wait(lambda: nest.Placed == 3 and panel_or_none() is not None, 60, "the parts to be placed")
    panel = hand.main(panel_of)
    hand.settle()
    hand.click_view(hand.view_point(*hand.main(lambda: panel.nest.polygon(0).centroid.coords[0])))
    hand.click(f"{P}remove_part")
    hand.wait(lambda: len(panel.rows()) == 2, 10, "the part to be taken away")
    hand.click(f"{P}cancel")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 60)


def set_cell(hand: Hand, nest: Any, column: int, key: str, text: str) -> None:
    """Type or choose in a cell of the first row, "" for another choice; the object holds it."""
    table, cell = hand.find(f"{P}parts"), f"{P}{key}_0"
    hand.main(lambda: table.scrollTo(table.model().index(0, column)))
    before = hand.main(lambda: part_values(nest)[0])
    if isinstance(hand.find(cell), QtGui.QComboBox):
        choices = hand.main(lambda: [hand.find(cell).itemText(row) for row in range(hand.find(cell).count())])
        hand.choose(cell, text or next(one for one in choices if one != hand.text(cell)))
    else:
        hand.fill(cell, text)
    hand.wait(lambda: part_values(nest)[0] != before, 5, f"{key} of the object")


def test_programs_are_arranged_by_the_mouse(hand: Hand, language: str, tmp_path: Path) -> None:
    document = hand.main(new_document)
    file, out = tmp_path / "square.nc", tmp_path / "tudo.nc"
    file.write_text(SQUARE, encoding="utf-8")

    def make() -> Any:
        job = api.new_job(document)
        program = api.load_program(job, file)
        document.recompute()
        select(program)
        return job

    hand.main(make)
    hand.command("CNCStepper_Arrangement")
    hand.wait(lambda: hand.exists("CNCStepper_Panel_count_0"), 10)
    hand.fill("CNCStepper_Panel_count_0", "2")
    hand.fill("CNCStepper_Panel_file", str(out))
    hand.click("CNCStepper_Panel_place")
    arrangement = hand.main(of_type, document, "CNCStepper_Arrangement")
    hand.wait(lambda: [each for each in [panel_or_none()] if each and len(each.rows()) == 2], 60, "the copies")
    panel = hand.main(panel_of)
    hand.settle()
    middle = hand.main(lambda: panel.nest.polygon(1).centroid.coords[0])
    drag_part(hand, middle, (90, 60))
    hand.click("CNCStepper_Panel_turn_part")
    hand.shot(f"arrangement-{language}")
    rows = hand.main(placed, panel)
    assert rows[1][4] == 90.0 and hand.main(cut_texts) == []
    hand.button("OK")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 60, "the panel to close when the program is written")
    assert hand.main(lambda: (problem_of(arrangement), arrangement.Placed)) == ("", 2)
    text = out.read_text("utf-8")
    assert text.count("(begin operation") == 2 and "90 deg" in text


def test_a_file_is_added_turned_with_shift_and_taken_away(hand: Hand, tmp_path: Path) -> None:
    document = hand.main(new_document)
    files = [tmp_path / "a.nc", tmp_path / "peça b.nc"]
    for file in files:
        file.write_text(SQUARE, encoding="utf-8")
    job = hand.main(api.new_job, document)
    program = hand.main(api.load_program, job, files[0])
    hand.main(lambda: (document.recompute(), select(program)))
    hand.command("CNCStepper_Arrangement")
    hand.wait(lambda: hand.exists("CNCStepper_Panel_count_0"), 10)
    hand.click("CNCStepper_Panel_add_file")
    choose_file(hand, "CNCStepper_Editor_file", files[1])
    hand.wait(lambda: hand.exists("CNCStepper_Panel_count_1"), 10, "the row of the file")
    hand.fill("CNCStepper_Panel_file", str(tmp_path / "tudo.nc"))
    hand.click("CNCStepper_Panel_place")
    hand.wait(lambda: [each for each in [panel_or_none()] if each and len(each.rows()) == 2], 60, "the copies")
    panel = hand.main(panel_of)
    hand.settle()
    drag_part(hand, hand.main(lambda: panel.nest.polygon(1).centroid.coords[0]), (90, 60))
    hand.settle()
    x, y = hand.main(lambda: panel.nest.polygon(1).centroid.coords[0])
    drag_part(hand, (x + 9, y), (x, y + 9), modifiers=("Shift",))
    two_pixels_deg = math.degrees(2 * pixel_mm(hand) / 9)
    assert hand.main(placed, panel)[1][4] == pytest.approx(90.0, abs=two_pixels_deg)
    hand.shot("arrangement-turned-with-shift")
    hand.key("Delete")
    hand.wait(lambda: len(panel.rows()) == 1, 10, "the copy to be taken away")
    hand.click(f"{P}write")
    hand.wait((tmp_path / "tudo.nc").is_file, 60, "the program of the one that is left")
    hand.wait(lambda: panel.work is None, 60, "the panel to rest")
    hand.button("Cancel")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 60)
    assert hand.main(of_type, document, "CNCStepper_Arrangement") is None


def panel_or_none() -> Any:
    try:
        return panel_of()
    except IndexError:
        return None
