# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window of part records: the measuring test of turned parts, typed or pasted, worked out and plotted at once."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.atomic_file import write_whole
from CNCStepper.errors import JobError
from CNCStepper.machine.axis_tests import Readings
from CNCStepper.machine.part_record_table import DECIMALS, NOMINAL_MM, csv_text, read_csv
from CNCStepper.machine.part_records import over_parts
from CNCStepper.workbench.help import f1_key
from CNCStepper.workbench.panels.fields import ERROR_COLOUR, named_button, note_label
from CNCStepper.workbench.part_records.readings_view import ReadingsView
from CNCStepper.workbench.part_records.records_table import RecordsModel, RecordsTable, local
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr

NAME = "CNCStepper_PartRecords"
SIZE = (860, 620)
GUIDE = "turning.md"
CYLINDER_MM = (150.0, 50.0)  # height and diameter of the first part of a lathe's acceptance
RECORDS_SUFFIX, PLOTS_SUFFIX = "csv", "png"


class PartRecords(QtGui.QDialog):
    """See the module."""

    def __init__(self, parent: Any):
        super().__init__(parent)
        self.setObjectName(NAME)
        f1_key.attach(self, GUIDE)
        self.resize(*SIZE)
        self.height_mm, self.diameter_mm = (self._nominal(name) for name in ("height", "diameter"))
        self.model = RecordsModel(self)
        self.table = RecordsTable(f"{NAME}_table", self.model, self)
        self.table.setAccessibleName(tr("Part records"))
        self.note = note_label(f"{NAME}_error", ERROR_COLOUR, self)
        self.summary = QtGui.QLabel(self)
        self.summary.setObjectName(f"{NAME}_summary")
        self.summary.setWordWrap(True)
        self.summary.setTextInteractionFlags(QtCore.Qt.TextInteractionFlag.TextSelectableByMouse)
        self.plots = QtGui.QWidget(self)
        titles = (tr("Heights less the nominal, mm"), tr("Mean diameters less the nominal, mm"))
        self.views = [
            ReadingsView(f"{NAME}_{name}_plot", title, self.plots)
            for name, title in zip(("height", "diameter"), titles, strict=True)
        ]
        self._arrange()
        self.model.typed.connect(guarded(self.look))
        self.show_table([], CYLINDER_MM, tr("Part records"))

    @property
    def nominal_mm(self) -> tuple[float, float]:
        """The nominal height and diameter that are typed."""
        return self.height_mm.value(), self.diameter_mm.value()

    def show_table(self, rows: list[list[str]], nominal_mm: tuple[float, float], title: str) -> None:
        """Show other rows, as they are saved, under a title."""
        for box, value_mm in zip((self.height_mm, self.diameter_mm), nominal_mm, strict=True):
            box.blockSignals(True)
            box.setValue(value_mm)
            box.blockSignals(False)
        self._saved = [list(row) for row in rows], self.nominal_mm
        self.setWindowTitle(f"{title}[*]")
        self.model.show_rows(rows, self.nominal_mm)

    def look(self) -> None:
        """Show what the rows come to, what is wrong, and what can be saved."""
        problem, records = self.model.first_problem(), self.model.judged.whole
        self.note.setText(problem)
        self.note.setVisible(bool(problem))
        self.save_button.setEnabled(bool(records) and not problem)
        self.plots_button.setEnabled(bool(records))
        self.setWindowModified(self.is_changed)
        found: list[Readings | None] = [*over_parts(records)] if records else [None, None]
        for view, readings, nominal_mm in zip(self.views, found, self.nominal_mm, strict=True):
            view.show_readings(readings, nominal_mm)
        names = (tr("Height"), tr("Diameter"))
        together = zip(names, found, self.nominal_mm, strict=True)
        self.summary.setText("\n".join(_words(name, one, nominal) for name, one, nominal in together if one))

    @property
    def is_changed(self) -> bool:
        """Whether the rows are others than those of the file."""
        return (self.model.filled(), self.nominal_mm) != self._saved

    def open_file(self, path: Path) -> None:
        """Show the records of a CSV file; raises JobError for what is none."""
        rows, nominal_mm = read_csv(path)
        self.show_table(rows, nominal_mm, tr("Part records: {0}").format(path.name))

    def save_file(self, path: Path) -> None:
        """Write the records as a CSV file, figures and all."""
        write_whole(path, csv_text(self.model.judged.whole, *self.nominal_mm).encode("utf-8"))
        self.open_file(path)
        messages.note(tr("{0} was written").format(path))

    def save_plots(self, path: Path) -> None:
        """Write both plots as one picture."""
        if not self.plots.grab().save(str(path)):
            advice = "choose a folder that exists and that you may write to"
            raise JobError("picture-file", tr("{0} cannot be written").format(path), advice=advice)
        messages.note(tr("{0} was written").format(path))

    def closeEvent(self, event: Any) -> None:
        """Close, unless somebody thinks better of losing what was typed; FreeCAD's Esc comes here too."""
        if not self._may_lose():
            event.ignore()
            return
        if self.is_changed:
            self.show_table([], self.nominal_mm, tr("Part records"))
        event.accept()

    def reject(self) -> None:
        """Close, as Esc does."""
        self.close()

    # --- inside ------------------------------------------------------------------------------------

    def _may_lose(self) -> bool:
        question = tr("These records have changes that are not saved. Discard them?")
        return not self.is_changed or messages.ask(question, tr("Discard"), tr("Cancel"))

    def _nominal(self, name: str) -> Any:
        box = QtGui.QDoubleSpinBox(self)
        box.setObjectName(f"{NAME}_{name}")
        box.setDecimals(3)
        box.setRange(NOMINAL_MM.low, NOMINAL_MM.high)
        box.setSuffix(" mm")
        box.valueChanged.connect(guarded(lambda _: self.model.measure_by(self.nominal_mm)))
        return box

    def _arrange(self) -> None:
        head = QtGui.QHBoxLayout()
        for words, box in ((tr("Nominal height"), self.height_mm), (tr("Nominal diameter"), self.diameter_mm)):
            label = QtGui.QLabel(words, self)
            label.setBuddy(box)
            head.addWidget(label)
            head.addWidget(box)
        head.addStretch(1)
        row = QtGui.QHBoxLayout(self.plots)
        row.setContentsMargins(0, 0, 0, 0)
        for view in self.views:
            row.addWidget(view, 1)
        column = QtGui.QVBoxLayout(self)
        column.addLayout(head)
        column.addWidget(self.table, 3)
        for widget in (self.note, self.summary):
            column.addWidget(widget)
        column.addWidget(self.plots, 2)
        column.addLayout(self._buttons())

    def _buttons(self) -> Any:
        row = QtGui.QHBoxLayout()
        tip = tr("Put the cells of a spreadsheet from the chosen cell on: height and three diameters in each row")
        self._button(row, "paste", tr("Paste"), tip, self.table.paste)
        row.addStretch(1)
        self._button(row, "open", tr("Open…"), tr("Shows the records of a CSV file"), self._ask_to_open)
        tip = tr("Writes all as a CSV file, which spreadsheets open")
        self.save_button = self._button(
            row, "save", tr("Save…"), tip, lambda: self._ask_to_save(self.save_file, RECORDS_SUFFIX)
        )
        tip = tr("Writes both plots as a picture")
        self.plots_button = self._button(
            row, "plots", tr("Save plots…"), tip, lambda: self._ask_to_save(self.save_plots, PLOTS_SUFFIX)
        )
        return row

    def _button(self, row: Any, name: str, text: str, tip: str, act: Any) -> Any:
        button = named_button(f"{NAME}_{name}", text, tip, act, self)
        row.addWidget(button)
        return button

    def _ask_to_open(self) -> None:
        if self._may_lose():
            dialog = self._file_dialog(self.open_file, RECORDS_SUFFIX)
            dialog.setFileMode(dialog.FileMode.ExistingFile)
            dialog.open()

    def _ask_to_save(self, write: Callable[[Path], None], suffix: str) -> None:
        dialog = self._file_dialog(write, suffix)
        dialog.setAcceptMode(dialog.AcceptMode.AcceptSave)
        dialog.setDefaultSuffix(suffix)
        dialog.open()

    def _file_dialog(self, take: Callable[[Path], None], suffix: str) -> Any:
        """Return a dialog for a file, not opened yet; `take` is called with the file."""
        dialog = QtGui.QFileDialog(self, self.windowTitle().removesuffix("[*]"), str(Path.home()), f"*.{suffix}")
        dialog.setObjectName(f"{NAME}_file")
        dialog.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.fileSelected.connect(guarded(lambda path: take(Path(path))))
        return dialog


def _words(name: str, readings: Readings, nominal_mm: float) -> str:
    """Return what the readings of all parts come to, as one line."""
    figures = (readings.mean_mm, readings.deviation_mm, readings.range_mm)
    shown = (local(value_mm, DECIMALS["mean_mm"]) for value_mm in figures)
    ratio = local(readings.mean_mm / nominal_mm, DECIMALS["diameter_ratio"])
    line = tr("{0} of {1} parts: mean {2} mm, standard deviation {3} mm, range {4} mm, ratio {5}")
    return line.format(name, len(readings.values_mm), *shown, ratio)
