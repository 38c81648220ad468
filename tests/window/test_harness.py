# SPDX-License-Identifier: LGPL-2.1-or-later
"""The hand itself: real clicks and keys arrive, the report view is read, a blocked window is noticed."""

from __future__ import annotations

import time
from collections.abc import Iterator
from typing import Any

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtCore, QtGui

from window_helpers.hand import Hand

pytestmark = pytest.mark.window("plain", "scaled")


class Dialog(QtGui.QDialog):
    """A field and two buttons in a modal dialog that runs its own event loop."""

    def __init__(self) -> None:
        super().__init__(FreeCADGui.getMainWindow())
        self.setObjectName("Harness_dialog")
        layout = QtGui.QVBoxLayout(self)
        self.field = QtGui.QLineEdit()
        self.field.setObjectName("Harness_field")
        self.combo = QtGui.QComboBox()
        self.combo.setObjectName("Harness_combo")
        self.combo.addItems(["one", "two", "three"])
        box = QtGui.QDialogButtonBox(
            QtGui.QDialogButtonBox.StandardButton.Ok | QtGui.QDialogButtonBox.StandardButton.Cancel
        )
        box.accepted.connect(self.accept)
        box.rejected.connect(self.reject)
        for widget in (self.field, self.combo, box):
            layout.addWidget(widget)


@pytest.fixture
def dialog(hand: Hand) -> Iterator[Any]:
    shown = hand.main(Dialog)
    opened = getattr(shown, "exec", None) or shown.exec_
    hand.main(lambda: QtCore.QTimer.singleShot(0, opened))
    hand.wait(shown.isVisible)
    yield shown
    hand.main(shown.deleteLater)


def test_keys_and_clicks_reach_a_modal_dialog(hand: Hand, dialog: Any) -> None:
    hand.click("Harness_field")
    hand.type('Peça nº 1, "12,5 mm" (ÃÕ€→)')
    assert hand.text("Harness_field") == 'Peça nº 1, "12,5 mm" (ÃÕ€→)'
    hand.fill("Harness_field", "-3.5")
    assert hand.text("Harness_field") == "-3.5"
    hand.choose("Harness_combo", "three")
    assert hand.text("Harness_combo") == "three"
    hand.shot("harness-dialog", "Harness_dialog")
    hand.button("OK")
    hand.wait(lambda: not dialog.isVisible())
    assert hand.main(dialog.result) == 1


def test_escape_closes_a_dialog(hand: Hand, dialog: Any) -> None:
    hand.key("Esc")
    hand.wait(lambda: not dialog.isVisible())
    assert hand.main(dialog.result) == 0


def test_a_menu_and_a_toolbar_button_are_clicked(hand: Hand) -> None:
    new = hand.main(lambda: FreeCADGui.Command.get("Std_New").getAction()[0].text())
    hand.menu("File", new)
    hand.wait(lambda: len(FreeCAD.listDocuments()) == 1)
    hand.command("Std_New")
    hand.wait(lambda: len(FreeCAD.listDocuments()) == 2)
    hand.shot("harness-window")


def test_undo_by_key_and_the_tree(hand: Hand) -> None:
    def box() -> None:
        document = FreeCAD.newDocument("Harness")
        document.UndoMode = 1
        document.openTransaction("box")
        document.addObject("Part::Box", "Box").Label = "A box"
        document.commitTransaction()
        document.recompute()

    hand.main(box)
    hand.tree("A box")
    assert hand.main(lambda: [chosen.Label for chosen in FreeCADGui.Selection.getSelection()]) == ["A box"]
    hand.key("Ctrl+Z")
    hand.wait(lambda: not FreeCAD.ActiveDocument.Objects)


def test_the_mouse_draws_in_the_3d_view(hand: Hand) -> None:
    seen: list[tuple[str, str, tuple[int, int]]] = []

    def watch() -> Any:
        FreeCAD.newDocument("Harness")
        view = FreeCADGui.ActiveDocument.ActiveView
        view.viewTop()
        view.fitAll()

        def note(event: dict[str, Any]) -> None:
            seen.append((event["Type"], event.get("State", ""), event["Position"]))

        return view, view.addEventCallback("SoEvent", note)

    view, watching = hand.main(watch)
    hand.drag([(100, 100), (150, 120), (200, 180)])
    hand.main(view.removeEventCallback, "SoEvent", watching)
    kinds = [(kind, state) for kind, state, _ in seen]
    down, up = kinds.index(("SoMouseButtonEvent", "DOWN")), kinds.index(("SoMouseButtonEvent", "UP"))
    assert kinds[down + 1 : up].count(("SoLocation2Event", "")) >= 2
    (x0, y0), (x1, y1) = seen[down][2], seen[up][2]
    scale = hand.main(lambda: QtGui.QApplication.primaryScreen().devicePixelRatio())
    rounded = 2 / scale  # each end is a whole pixel of the screen
    assert ((x1 - x0) / scale, (y1 - y0) / scale) == pytest.approx((100, -80), abs=rounded)


def test_a_point_of_the_drawing_is_found_on_the_screen(hand: Hand) -> None:
    def show() -> None:
        document = FreeCAD.newDocument("Harness")
        document.addObject("Part::Box", "Box")
        document.recompute()
        FreeCADGui.ActiveDocument.ActiveView.viewTop()
        FreeCADGui.ActiveDocument.ActiveView.fitAll()

    hand.main(show)
    hand.settle()
    hand.click_view(hand.view_point(5, 5, 10))
    assert hand.main(lambda: [chosen.Name for chosen in FreeCADGui.Selection.getSelection()]) == ["Box"]


def test_the_report_view_is_read_with_its_colours(hand: Hand) -> None:
    hand.expect_report("^Harness: ")
    hand.main(FreeCAD.Console.PrintMessage, "Harness: hello\n")
    hand.main(FreeCAD.Console.PrintWarning, "Harness: careful\n")
    hand.main(FreeCAD.Console.PrintError, "Harness: no\n")
    hand.wait(lambda: True)
    assert [tuple(line) for line in hand.report() if "Harness" in line.text] == [
        ("message", "Harness: hello"),
        ("warning", "Harness: careful"),
        ("error", "Harness: no"),
    ]
    assert hand.unexpected() == []
    hand._allowed.clear()
    assert len(hand.unexpected()) == 2
    hand.expect_report("^Harness: ")


def test_an_exception_in_a_slot_is_seen_in_the_report_view(hand: Hand) -> None:
    hand.expect_report("Traceback|Harness|File|ZeroDivision|1 // 0|\\^|~")
    hand.main(lambda: QtCore.QTimer.singleShot(0, lambda: 1 // 0))
    hand.wait(lambda: True)
    hand.settle()
    assert any("ZeroDivisionError" in line.text and line.bad for line in hand.report())


def test_the_watchdog_sees_a_blocked_window(hand: Hand) -> None:
    with hand.watchdog() as watch:
        time.sleep(0.3)
    assert watch.max_cpu_ms < 50, watch
    with hand.watchdog() as watch:
        hand.main(time.sleep, 0.12)
    assert 110 < watch.max_ms < 400
    assert watch.max_cpu_ms < 60
    assert "sleep" in watch.where or "task()" in watch.where


def test_the_watchdog_counts_work_as_a_processor_of_usual_speed_does(hand: Hand) -> None:
    with hand.watchdog() as watch:
        used_ms = hand.main(work_for_ms, 120.0)
    assert watch.slowness >= 1.0
    assert 0.9 * used_ms < watch.max_cpu_ms * watch.slowness < 1.5 * used_ms, watch


def work_for_ms(wanted_ms: float) -> float:
    """Work until so much processor time has passed, and return how much it was."""
    begun_s = time.thread_time()
    while (used_ms := 1000 * (time.thread_time() - begun_s)) < wanted_ms:
        sum(range(1000))
    return used_ms
