# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of one's own tools, materials and charts by real keys: searched, edited, refused, saved, used by a job."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtCore, QtGui

from CNCStepper.machine.files.profile_files import config_folder
from CNCStepper.machine.libraries.chart_library import CHARTED
from CNCStepper.machine.libraries.tool_library import library_path, library_tools
from CNCStepper.workbench import api, panels
from CNCStepper.workbench.libraries.library_page import WIDEST_PX
from window_helpers import screen_places as places
from window_helpers.file_dialogs import choose_file
from window_helpers.hand import Hand
from window_helpers.tables import click_cell, click_tab, put, rows_by_buttons

L = "CNCStepper_Library"
TOOLS, MATERIALS, CHARTS = range(3)
MENU = "CNCStepper_Panel_tools_library_menu"


def widget(name: str) -> Any:
    return FreeCADGui.getMainWindow().findChild(QtGui.QWidget, name)


@pytest.fixture
def library(hand: Hand) -> Iterator[Any]:
    shutil.rmtree(config_folder() / "tools", ignore_errors=True)
    document = hand.main(FreeCAD.newDocument, "Library")
    hand.main(api.new_job, document)
    hand.command(L)
    hand.wait(lambda: widget(L) and widget(L).isVisible(), what="the dialog")
    hand.settle()
    yield widget(L)

    def close() -> None:
        for page in widget(L).pages:
            page.revert()
        widget(L).close()
        widget(L).deleteLater()
        FreeCADGui.Control.closeDialog()
        FreeCAD.closeDocument("Library")

    hand.main(close)
    hand.settle()
    shutil.rmtree(config_folder() / "tools", ignore_errors=True)


@pytest.mark.window("plain", "portuguese")
def test_nothing_is_cut_off(hand: Hand, library: Any) -> None:
    for tab in (MATERIALS, CHARTS, TOOLS):
        click_tab(hand, library.tabs, tab)
        hand.shot(f"library-{tab}")
        assert hand.main(places.narrower_than_their_text, library) == []


def test_columns_are_as_wide_as_qt_makes_them(hand: Hand, library: Any) -> None:
    def widths(table: Any) -> list[int]:
        return [min(table.columnWidth(column), WIDEST_PX) for column in range(table.model().columnCount())]

    for page in hand.main(lambda: list(library.pages)):
        ours = hand.main(widths, page.table)
        hand.main(page.table.resizeColumnsToContents)
        assert ours == hand.main(widths, page.table)


def test_a_tool_is_typed_saved_searched_and_put_into_the_job(hand: Hand, library: Any) -> None:
    page = library.tools
    hand.click(f"{L}_tools_add")
    put(hand, page, 0, "name", "Sign cutter")
    put(hand, page, 0, "diameter_mm", "six")
    hand.wait(lambda: "six" in page.note.text() and not page.save_button.isEnabled(), 5, "the refusal")
    put(hand, page, 0, "diameter_mm", "3,175")
    hand.click(f"{L}_tools_duplicate")
    hand.click(f"{L}_tools_save")
    hand.wait(lambda: library_path().exists(), 5, "the file")
    assert [(each.number, each.tool.diameter_mm) for each in library_tools() if each.tool] == [(1, 3.175), (2, 3.175)]
    hand.fill(f"{L}_tools_search", "cutter 2")
    hand.wait(lambda: page.model.rowCount() == 1, 5, "the row that was found")
    assert {f"{L}_tools_{name}" for name in ("add", "search", "table")} <= hand.touches.touched
    hand.main(page.table.selectRow, 0)
    hand.click(f"{L}_tools_to_job")
    job = FreeCAD.getDocument("Library").Objects[0]
    hand.wait(lambda: [tool.Label for tool in job.Tools] == ["Sign cutter"], 5, "the tool")
    hand.main(library.close)
    hand.main(panels.edit, job)
    hand.wait(lambda: widget("CNCStepper_Panel_tools_library"), 10, "the panel")
    hand.settle()
    hand.click("CNCStepper_Panel_tools_library")
    hand.wait(lambda: widget(MENU) and widget(MENU).isVisible(), 5, "the menu")
    hand.shot("library-menu")
    hand.entry("T2  Sign cutter")
    hand.wait(lambda: len(job.Tools) == 2 and job.Tools[1].Diameter.Value == 3.175, 5, "the tool of the menu")
    hand.click("CNCStepper_Panel_tools_library")
    hand.entry("Keep the marked tool")
    hand.wait(lambda: len(library_tools()) == 3, 5, "a third tool in the library")


def test_rows_of_every_table_come_and_go_by_buttons(
    hand: Hand, library: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    hand.click(f"{L}_tools_add")
    keys = {library.tools: "name", library.materials: "title", library.charts: "consumable"}
    for tab, (page, key) in enumerate(keys.items()):
        click_tab(hand, library.tabs, tab)
        rows_by_buttons(hand, page, tmp_path)
        hand.click(f"{page.name}_revert")
        hand.wait(lambda page=page: not page.draft.is_changed, 5, "the rows as they are saved")
        if tab == TOOLS:
            continue
        put(hand, page, 0, key, "A")
        hand.click(f"{page.name}_save")
        hand.wait(lambda page=page: not page.draft.is_changed, 5, "the change to be saved")
        assert hand.main(lambda page=page, key=key: page.draft.table[0].texts[key]) == "A"
    hand.choose(f"{L}_charts_process", hand.main(lambda: library.process.itemText(1)))
    hand.wait(lambda: library.charts.draft.library.process == CHARTED[1], 5, "another chart")
    put(hand, library.charts, 0, "consumable", "B")
    for answer, is_open in (("cancel", True), ("discard", False)):
        hand.main(QtCore.QTimer.singleShot, 0, library.close)
        hand.click(f"{L}_closing_{answer}")
        hand.wait(lambda is_open=is_open: library.isVisible() == is_open, 5, answer)


def test_a_material_goes_to_freecad_s_form_and_comes_back(
    hand: Hand, library: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    page, count = library.materials, len(library.materials.draft.table)
    click_tab(hand, library.tabs, MATERIALS)
    click_cell(hand, page.table, 0, 0)
    hand.click(f"{L}_materials_export")
    choose_file(hand, f"{L}_materials_file", tmp_path / "Alu", "*.FCMat")
    hand.wait((tmp_path / "Alu.FCMat").is_file, 5, "the file with the ending that is chosen")
    text = (tmp_path / "Alu.FCMat").read_text("utf-8")
    (tmp_path / "Alu.FCMat").write_text(text[: text.index("CNCStepper:")], encoding="utf-8")  # as FreeCAD saves it
    hand.click(f"{L}_materials_import")
    choose_file(hand, f"{L}_materials_file", tmp_path / "Alu.FCMat")
    hand.wait(lambda: len(page.draft.table) == count + 1, 5, "the material of the file")
    row = hand.main(lambda: page.table.visualRect(page.model.index(count, 0)).center())
    assert hand.main(lambda: page.table.viewport().rect().contains(row)), "the new row is seen"
    hand.shot("library-material-of-freecad")
    first, last = page.draft.table[0].texts, page.draft.table[-1].texts
    assert (last["key"], last["carbide_speed_m_min"]) == ("material-1", "180 180")
    assert last["source"] == "FreeCAD: Alu.FCMat; chip load of aluminium-6061"
    same = ("title", "carbide_chip_load_mm", "turning_force_n_mm2", "turning_elasticity_n_mm2", "stepdown")
    assert {key: last[key] for key in same} == {key: first[key] for key in same} and not page.model.problems


def test_a_material_file_of_freecad_0_20_is_refused(hand: Hand, library: Any, tmp_path: Path) -> None:
    page, count = library.materials, len(library.materials.draft.table)
    (tmp_path / "Steel.FCMat").write_text("; Steel\n[General]\nName = Steel\n", encoding="utf-8")
    click_tab(hand, library.tabs, MATERIALS)
    hand.click(f"{L}_materials_import")
    choose_file(hand, f"{L}_materials_file", tmp_path / "Steel.FCMat")
    hand.wait(lambda: places.visible("CNCStepper_Tell_error"), 10, "the refusal")
    hand.shot("library-material-refused")
    hand.click("CNCStepper_Tell_ok")
    hand.wait(lambda: not places.visible("CNCStepper_Tell_error"), 10, "the message to close")
    assert len(page.draft.table) == count
