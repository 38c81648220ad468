# SPDX-License-Identifier: LGPL-2.1-or-later
"""F1 with a real key: in a field, in the dock, in the editor; the menu's help, its links, and both languages."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtGui
from test_language import PORTUGUESE, STARTED_IN

from CNCStepper.workbench import api
from CNCStepper.workbench.editor import open_file
from CNCStepper.workbench.help.topics import CONTENTS, PROFILE
from window_helpers.hand import Hand

HELP = "CNCStepper_Help"
DEPTH = "CNCStepper_Panel_depth_mm"
BUSY_MS = 50.0  # the window may be busy with one page so long at most


@pytest.fixture(autouse=True)
def in_english_and_closed_afterwards(hand: Hand) -> Iterator[None]:
    hand.main(FreeCADGui.setLocale, "English")
    yield

    def end() -> None:
        for shown in FreeCADGui.getMainWindow().findChildren(QtGui.QDialog):
            if shown.objectName() in (HELP, "CNCStepper_Machines"):
                shown.close()
                shown.deleteLater()
        FreeCADGui.setLocale(STARTED_IN)

    hand.main(end)
    hand.settle()


def window() -> Any:
    return FreeCADGui.getMainWindow().findChild(QtGui.QDialog, HELP)


def shown(hand: Hand, address: str) -> None:
    hand.wait(lambda: window() is not None and window().isVisible() and window().address == address, 10, address)
    hand.settle()


def marked(hand: Hand) -> str:
    return str(hand.main(lambda: window().browser.textCursor().selectedText()))


def top_line(hand: Hand) -> str:
    """Return the text of the first block that can be read in the window."""
    place = lambda: window().browser.cursorForPosition(window().browser.viewport().rect().topLeft())  # noqa: E731
    return str(hand.main(lambda: place().block().text()))


def middle_of_mark() -> tuple[int, int]:
    """Return where in the browser the marked text ends, a little to the left."""
    place = window().browser.cursorRect().center()
    return place.x() - 20, place.y()


def pocket_panel(hand: Hand) -> None:
    def make() -> None:
        job = api.new_job(FreeCAD.newDocument("Help"))
        api.add_tool(job, diameter_mm=6)
        job.Document.recompute()

    hand.main(make)
    hand.command("CNCStepper_EllipticalPocket")
    hand.wait(FreeCADGui.Control.activeDialog, 10, "the panel")
    hand.settle()


@pytest.mark.parametrize(
    ("language", "title", "depth", "explained"),
    [
        ("English", "Elliptical pocket", "Depth", "The depth below the top of the stock"),
        (PORTUGUESE, "Bolsão elíptico", "Profundidade", "A profundidade abaixo do topo do bruto"),
    ],
)
def test_f1_at_a_field_opens_its_page_at_the_field(
    hand: Hand, language: str, title: str, depth: str, explained: str
) -> None:
    hand.main(FreeCADGui.setLocale, language)
    pocket_panel(hand)
    hand.click(DEPTH)
    with hand.watchdog() as watch:
        hand.key("F1")
        shown(hand, "objects/CNCStepper_EllipticalPocket")
    assert marked(hand) == depth
    text = hand.main(lambda: window().browser.toPlainText())
    assert text.startswith(title)
    assert explained in text
    hand.shot(f"help-field-{language}", HELP)
    assert hand.main(lambda: FreeCADGui.getMainWindow().findChild(QtGui.QLineEdit, DEPTH).whatsThis())
    assert watch.max_python_ms < BUSY_MS, watch.where_cpu
    hand.main(lambda: window().close())
    cancel = QtGui.QDialogButtonBox.StandardButton.Cancel
    hand.click(hand.main(lambda: FreeCADGui.getMainWindow().findChild(QtGui.QDialogButtonBox).button(cancel)))
    hand.wait(lambda: not FreeCADGui.Control.activeDialog())


def test_f1_in_the_dock_and_in_its_parts_opens_the_guide_to_sending(hand: Hand) -> None:
    hand.command("CNCStepper_Controller")
    hand.wait(lambda: hand.exists("CNCStepper_Dock_Port"))
    hand.main(lambda: hand.find("CNCStepper_Dock_Port").setFocus())
    hand.key("F1")
    shown(hand, "sending/link.md")
    hand.main(lambda: window().close())
    hand.main(lambda: hand.find("CNCStepper_Dock_Panel").setFocus())
    hand.key("F1")
    shown(hand, "sending/README.md")


def test_f1_in_the_editor_and_in_the_machines_opens_their_pages(hand: Hand, tmp_path: Path) -> None:
    program = tmp_path / "short.ngc"
    program.write_text("G0 X1\n", "utf-8")
    dock = hand.main(open_file, program)
    hand.main(lambda: dock.panel.edit.setFocus())
    hand.key("F1")
    shown(hand, "editing.md")
    hand.main(lambda: window().close())
    hand.command("CNCStepper_Machines")
    hand.wait(lambda: hand.exists("CNCStepper_Machine_feed_mm_min"), 20, "the machines")
    hand.click("CNCStepper_Machine_feed_mm_min")
    hand.key("F1")
    shown(hand, PROFILE)
    assert marked(hand) == "Feed without F"


def test_the_menu_opens_the_contents_and_links_lead_on_and_back(hand: Hand) -> None:
    hand.main(FreeCAD.newDocument)
    hand.menu("CNCStepper", "Help")
    shown(hand, CONTENTS)
    hand.shot("help-contents", HELP)
    hand.main(lambda: window().browser.find("FreeCAD, step by step"))
    hand.click(hand.main(lambda: window().browser.viewport()), at=hand.main(middle_of_mark))
    shown(hand, "freecad.md")
    hand.main(lambda: window().open("freecad.md", "#imported-drawings"))
    assert marked(hand) == "Imported drawings"
    assert top_line(hand) == "Imported drawings"
    hand.shot("help-guide", HELP)
    hand.click(f"{HELP}_back")
    hand.click(f"{HELP}_back")
    shown(hand, CONTENTS)
    hand.click(f"{HELP}_forward")
    shown(hand, "freecad.md")
    hand.click(f"{HELP}_contents")
    shown(hand, CONTENTS)
    hand.click(f"{HELP}_search")
    hand.type("Bore")
    hand.key("Return")
    hand.wait(lambda: window().browser.textCursor().selectedText() == "Bore")
