# SPDX-License-Identifier: LGPL-2.1-or-later
"""The measuring test by real keys: parts typed and pasted, figures and plots at once, a file saved and opened."""

from __future__ import annotations

import statistics
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import FreeCADGui
import pytest
from PySide import QtCore, QtGui

from CNCStepper.machine.part_record_table import MOST_PARTS, read_csv
from window_helpers import screen_places as places
from window_helpers.file_dialogs import choose_file
from window_helpers.hand import Hand

R = "CNCStepper_PartRecords"
PASTED = "Height\td1\td2\td3\n149.97\t50.03\t50.02\t49.99\n150.00\t49.99\t50.00\t50.02\n"
CONE_BASES_MM = (49.98, 50.01, 50.00)


def widget(name: str) -> Any:
    return FreeCADGui.getMainWindow().findChild(QtGui.QWidget, name)


@pytest.fixture
def window(hand: Hand) -> Iterator[Any]:
    hand.command(R)
    hand.wait(lambda: widget(R) and widget(R).isVisible(), what="the window")
    hand.settle()
    yield widget(R)

    def close() -> None:
        widget(R).show_table([], (150.0, 50.0), "")
        widget(R).close()
        widget(R).deleteLater()

    hand.main(close)


def shown(window: Any, row: int) -> list[str]:
    """The texts of a row as they are seen, with decimal points."""
    model = window.model
    return [str(model.index(row, column).data()).replace(",", ".") for column in range(model.columnCount())]


def typed(hand: Hand, window: Any, row: int, *texts: str) -> None:
    """Type a row as a person does: the cell, its text, Tab."""
    hand.main(lambda: (window.table.setFocus(), window.table.setCurrentIndex(window.model.index(row, 0))))
    for text in texts:
        hand.type(text)
        hand.key("Tab")


def colours(view: Any) -> int:
    image = view.grab().toImage()
    return len({image.pixel(x, y) for x in range(image.width()) for y in range(0, image.height(), 4)})


@pytest.mark.window("plain", "portuguese")
def test_parts_are_typed_pasted_worked_out_saved_and_opened(hand: Hand, window: Any, tmp_path: Path) -> None:
    assert not hand.main(lambda: widget(f"{R}_save").isEnabled())
    empty = hand.main(lambda: colours(window.views[1]))
    typed(hand, window, 0, "150,02", "49,98", "5", "50.00")
    hand.wait(lambda: window.note.isVisible() and window.note.text().startswith("1, d2: "), 5, "the refusal")
    hand.shot("part-records-refused")
    hand.main(lambda: window.table.setCurrentIndex(window.model.index(0, 2)))
    hand.type("50.01")
    hand.key("Return")
    mean, deviation = statistics.mean(CONE_BASES_MM), statistics.stdev(CONE_BASES_MM)
    figures = [f"{mean:.4f}", f"{deviation:.4f}", f"{mean / 50:.5f}", f"{150.02 / 150:.5f}"]
    hand.wait(lambda: shown(window, 0)[4:] == figures, 5, "the figures")
    hand.main(QtGui.QApplication.clipboard().setText, PASTED)
    hand.main(lambda: (window.table.setFocus(), window.table.setCurrentIndex(window.model.index(1, 0))))
    hand.click(f"{R}_paste")
    hand.wait(lambda: len(window.model.judged.whole) == 3, 5, "the pasted rows")
    assert "3" in hand.text(f"{R}_summary") and not hand.main(window.note.isVisible)
    assert hand.main(lambda: colours(window.views[1])) > empty
    hand.shot("part-records")
    assert hand.main(places.narrower_than_their_text, window) == []
    file, picture = tmp_path / "parts.csv", tmp_path / "parts.png"
    hand.click(f"{R}_save")
    choose_file(hand, f"{R}_file", file)
    hand.wait(file.exists, 5, "the file")
    assert [float(row[0].replace(",", ".")) for row in read_csv(file)[0]] == [150.02, 149.97, 150.0]
    too_much_is_refused(hand, window)
    hand.click(f"{R}_plots")
    choose_file(hand, f"{R}_file", picture)
    hand.wait(picture.exists, 5, "the picture")
    hand.fill(f"{R}_diameter", "60")
    hand.wait(lambda: window.isWindowModified(), 5, "the change")
    hand.fill(f"{R}_height", "149")
    hand.wait(lambda: shown(window, 0)[6:] == [f"{mean / 60:.5f}", f"{150.02 / 149:.5f}"], 5, "both ratios")
    answers_what_would_be_lost(hand, window)
    hand.click(f"{R}_open")
    choose_file(hand, f"{R}_file", file)
    hand.wait(lambda: window.nominal_mm == (150.0, 50.0) and len(window.model.judged.whole) == 3, 5, "the file")
    assert file.name in hand.main(window.windowTitle)


def too_much_is_refused(hand: Hand, window: Any) -> None:
    """A column of a whole spreadsheet is refused in words, and the rows stay."""
    hand.main(QtGui.QApplication.clipboard().setText, "150\n" * MOST_PARTS)
    hand.main(lambda: (window.table.setFocus(), window.table.setCurrentIndex(window.model.index(1, 0))))
    hand.key("Ctrl+V")
    hand.wait(lambda: places.visible("CNCStepper_Tell_ok"), 5, "the refusal")
    hand.click("CNCStepper_Tell_ok")
    assert len(window.model.filled()) == 3


def answers_what_would_be_lost(hand: Hand, window: Any) -> None:
    """Esc asks; no keeps the rows, yes discards them."""
    for answer, is_open in (("no", True), ("yes", False)):
        hand.main(QtCore.QTimer.singleShot, 0, window.close)
        hand.wait(lambda answer=answer: places.visible(f"CNCStepper_Tell_{answer}"), 5, "the question")
        hand.click(f"CNCStepper_Tell_{answer}")
        hand.wait(lambda is_open=is_open: window.isVisible() == is_open, 5, "the answer")
    assert window.model.filled() == []
    hand.command(R)
    hand.wait(window.isVisible, 5, "the window")
