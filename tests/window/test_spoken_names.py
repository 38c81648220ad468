# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a person clicks or types into has a name that a screen reader says, not only the kind of a widget."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
from PySide import QtGui

from CNCStepper.workbench import api, editor, panels
from CNCStepper.workbench.help.window import open_help
from CNCStepper.workbench.preferences.job_preferences import JobPreferences
from window_helpers import screen_places as places
from window_helpers.docks import opened_dock
from window_helpers.hand import Hand
from window_helpers.task_panels import PANEL
from window_helpers.touches import KINDS, OURS

WORD = re.compile(r"[^\W\d_]{2,}")  # "+10", "▶" and "X" are none


def spoken(widget: Any) -> str:
    """Return what is said of a widget, which may be what its label says; a tab widget has a name on each page."""
    own = widget.text() if isinstance(widget, QtGui.QAbstractButton) else ""
    labels = [label.text() for label in widget.window().findChildren(QtGui.QLabel) if label.buddy() is widget]
    return "pages" if isinstance(widget, QtGui.QTabWidget) else widget.accessibleName() or own or "".join(labels)


def nameless() -> list[str]:
    """Return the shown widgets of ours that have no name with a word in it."""
    ours = [widget for widget in places.all_widgets() if widget.objectName().startswith(OURS) and widget.isVisible()]
    used = [widget for widget in ours if any(widget.inherits(kind) for kind in KINDS)]
    assert used, "nothing is shown"
    return sorted({widget.objectName() for widget in used if not WORD.search(spoken(widget))})


def unfold() -> None:
    for head in FreeCADGui.getMainWindow().findChildren(QtGui.QToolButton):
        if head.objectName().startswith(f"{PANEL}group_") and head.isVisible() and not head.isChecked():
            head.click()


def test_panels_have_names(hand: Hand) -> None:
    def make() -> list[Any]:
        job = api.new_job(FreeCAD.newDocument("Names"))
        tool, pocket = api.add_tool(job, diameter_mm=6), api.add_elliptical_pocket(job)
        return [job, tool, pocket, api.add_nest(job.Document, [api.add_shape(job.Document, "flange")])]

    found = []
    for obj in hand.main(make):
        hand.main(panels.edit, obj)
        hand.wait(lambda: hand.exists(f"{PANEL}ok"), 20, "the panel")
        hand.main(unfold)
        hand.settle()
        found += hand.main(nameless)
        hand.main(FreeCADGui.Control.closeDialog)
    assert not found


def test_dock_editor_help_and_preferences_have_names(hand: Hand, tmp_path: Path) -> None:
    with opened_dock(hand, lambda panel: None):
        found = hand.main(nameless)
        hand.command("CNCStepper_Letters")
        hand.wait(lambda: hand.exists("CNCStepper_Letters_slider"), 20, "the letters")
        found += hand.main(nameless)
    path = tmp_path / "names.nc"
    path.write_text("G0 X1\nM2\n", "utf-8")
    dock = hand.main(editor.open_file, path)
    hand.main(dock.panel.find.begin)
    hand.main(open_help)
    page = hand.main(JobPreferences)
    hand.main(page.loadSettings)
    hand.main(page.form.show)
    hand.settle()
    found += hand.main(nameless)
    hand.main(page.form.close)
    hand.main(dock.close)
    assert not found
