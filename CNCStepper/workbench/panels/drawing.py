# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of an imported drawing: how it is read, what was found in it, *Reload* and *Mend*.

typed ──► Editor ──► the object's options ──► other than those it was read with? ──► Reading ──► report
                                                                            (beside the window)
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper import text_json
from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.document.drawing_files import Reading, ask_file, look_now
from CNCStepper.workbench.features.drawings.drawing import FOUND, is_stale
from CNCStepper.workbench.panels.background_panel import BackgroundPanel, button_row
from CNCStepper.workbench.panels.fields import NAME, TextField, WorkNote
from CNCStepper.workbench.panels.object_form import Editor
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import later, tr
from CNCStepper.workbench.services.view_fit import show_place

ROWS_SEEN = 6
PLACE = QtCore.Qt.ItemDataRole.UserRole  # of a row: X and Y in mm, None for one without
Row = tuple[str, list[float] | None]
FOUND_WORDS = {
    "open": later("Open contour"),
    "gap": later("Gap"),
    "double": later("Drawn twice"),
    "tiny": later("Tiny contour"),
    "crossing": later("Contour that crosses itself"),
    "overlap": later("Contours that cross"),
}
MENDED_WORDS = {
    "double": later("Taken out, drawn twice"),
    "tiny": later("Taken out, tiny"),
    "joined": later("Ends joined"),
    "closed": later("Gap closed"),
    "fitted": later("Simplified"),
}


class FileField(TextField):
    """The file of a drawing, with a button that asks for another one."""

    def make(self) -> list[Any]:
        """Add the line and the button."""
        row = QtGui.QHBoxLayout()
        row.setSpacing(3)
        self._column.addLayout(row)
        line = self.line("", row)
        button = QtGui.QToolButton(self.widget)
        button.setText("…")
        button.setObjectName(f"{NAME}_file_choose")
        button.setAccessibleName(tr("Choose another file"))
        button.setToolTip(tr("Choose another file"))
        button.clicked.connect(guarded(lambda: ask_file(str(Path(self.obj.File).parent), self._take)))
        row.addWidget(button)
        return [line]

    def _take(self, path: str) -> None:
        self.editors[0].setText(path)
        self.touched()


class Report(QtGui.QWidget):
    """What was found in a drawing: a sentence, and a list of what is wrong, was mended or left out."""

    def __init__(self, obj: Any, parent: Any):
        super().__init__(parent)
        self._obj = obj
        self.summary = QtGui.QLabel(self)
        self.summary.setObjectName(f"{NAME}_report")
        self.summary.setWordWrap(True)
        self.rows = QtGui.QListWidget(self)
        self.rows.setObjectName(f"{NAME}_findings")
        self.rows.setAccessibleName(tr("What was found in it"))
        self.rows.setWordWrap(True)
        self.rows.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.rows.setToolTip(tr("A click on a row with a place moves the view there"))
        self.rows.itemClicked.connect(guarded(self._show_place))
        self.work = WorkNote(f"{NAME}_reading", self)
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        for widget in (self.work, self.summary, self.rows):
            column.addWidget(widget)
        self.refresh()

    def refresh(self) -> None:
        """Show what the object knows of its drawing."""
        told = text_json.loads(self._obj.Report) if self._obj.Report else None
        lines = _lines(told) if told else []
        self.summary.setText(_summary(told) if told else "")
        self.summary.setVisible(bool(told))
        self.rows.clear()
        for text, place in lines:
            self.rows.addItem(text)
            self.rows.item(self.rows.count() - 1).setData(PLACE, place)
        seen = min(len(lines), ROWS_SEEN)
        self.rows.setFixedHeight((2 * seen + 1) * self.fontMetrics().lineSpacing())
        self.rows.setVisible(bool(lines))

    def _show_place(self, item: Any) -> None:
        """Move the view to the place of a fault."""
        if (place := item.data(PLACE)) is not None:
            show_place(*place)


def _summary(told: dict[str, Any]) -> str:
    left, front, right, back = told["box_mm"]
    return tr("{0} × {1} mm, layers: {2}, open contours: {3}, the file's unit: {4} mm").format(
        f"{right - left:.5g}", f"{back - front:.5g}", told["layers"], told["open"], f"{told['unit_mm']:.6g}"
    )


def _lines(told: dict[str, Any]) -> list[Row]:
    """Return the rows of the list: warnings, faults, changes, what was left out; each kind with the rest's count."""
    rows: list[Row] = [(translated(each), None) for each in told["warnings"]]
    for (count, found), words in ((told["problems"], FOUND_WORDS), (told["changes"], MENDED_WORDS)):
        rows += [(_placed(words[kind], kind, layer, place, size), place) for kind, layer, place, size in found]
        rows += _rest(count - len(found))
    count, entries = told["skipped"]
    for kind, layer, why in entries:
        rows.append((tr("{0} on layer '{1}' was left out: {2}").format(kind, layer, translated(why)), None))
    return rows + _rest(count - len(entries))


def _placed(words: str, kind: str, layer: str, place_mm: list[float], size: float) -> str:
    """Return a fault or a change with its layer, its place and its length; a fit counts segments."""
    x, y = place_mm
    said = tr("{0} on layer '{1}' at X {2} Y {3}").format(tr(words), layer, f"{x:.3f}", f"{y:.3f}")
    return f"{said}, {size:.4g} mm" if size and kind != "fitted" else said


def _rest(count: int) -> list[Row]:
    return [(tr("… and {0} more").format(count), None)] if count > 0 else []


class DrawingPanel(BackgroundPanel):
    """Edits how a drawing is read; all readings while it is open belong to its one undo step."""

    def __init__(self, obj: Any, editor: Editor):
        self.report = Report(obj, editor)
        super().__init__(obj, editor, self.report.work, not obj.ReadWith)
        editor.form.add_widget(FOUND, self.report)
        editor.form.add_widget(FOUND, self._buttons())
        editor.applied.connect(guarded(self.follow))
        self.follow()

    def follow(self) -> None:
        """Read the file where options are not those that it was read with."""
        if not self.editor.refused and is_stale(self.obj):
            self.read()

    def read(self) -> None:
        """Read the file now, in place of a reading that is under way."""
        reading = Reading(self.obj, guarded(self.done), guarded(self.failed), self._share)
        self.begin(reading, tr("Reading the drawing…"))

    def mend(self) -> None:
        """Repair the drawing within the limits of the fields."""
        self.editor.take({"mending": True})

    def failed(self, error: CNCStepperError) -> None:
        """Say why the file could not be read, and whether it is still as it was."""
        look_now(self.obj)
        super().failed(error)

    def refresh_report(self) -> None:
        """Show what was found."""
        self.report.refresh()

    def _buttons(self) -> Any:
        texts = (
            ("reload", tr("Reload"), tr("Read the file again; operations keep their contours"), self._reload),
            ("mend", tr("Mend"), tr("Repair what is wrong, as far as the values under Repair allow"), self.mend),
        )
        return button_row(texts, self.editor)

    def _reload(self) -> None:
        self.editor.apply()
        if self.work is None:
            self.read()

    def _share(self, share: float) -> None:
        self.note.say(tr("Reading the drawing: {0} %").format(f"{100 * share:.0f}"))
