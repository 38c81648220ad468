# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of one's own tools, materials and charts by real keys: searched, edited, refused, saved, used by a job."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from typing import Any

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtGui

from CNCStepper.machine.files.profile_files import config_folder
from CNCStepper.machine.libraries.tool_library import library_path, library_tools
from CNCStepper.workbench import api, panels
from window_helpers import screen_places as places
from window_helpers.hand import Hand
from window_helpers.tables import put

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
    for tab in (TOOLS, MATERIALS, CHARTS):
        hand.main(library.tabs.setCurrentIndex, tab)
        hand.settle()
        hand.shot(f"library-{tab}")
        assert hand.main(places.narrower_than_their_text, library) == []


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
    hand.key("Down")
    hand.key("Return")
    hand.wait(lambda: len(job.Tools) == 2 and job.Tools[1].Diameter.Value == 3.175, 5, "the tool of the menu")
