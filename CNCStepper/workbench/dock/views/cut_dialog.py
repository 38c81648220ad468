# SPDX-License-Identifier: LGPL-2.1-or-later
"""Asks how a G-code file is cut: process, material, thickness and consumable of the cut chart, whose feed it shows.

A program without F takes that feed. Without a job it also asks for the size of the sheet.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import FreeCADGui
from PySide import QtGui

from CNCStepper.errors import CNCStepperError
from CNCStepper.machine.cut_charts import cut_data_for, known_chart, material_key
from CNCStepper.machine.cut_data import CutData
from CNCStepper.machine.processes import PROCESSES
from CNCStepper.workbench.dock.model.settings import decimal_point
from CNCStepper.workbench.help import f1_key
from CNCStepper.workbench.panels.fields import ERROR_COLOUR, note_label
from CNCStepper.workbench.services.choice_labels import words_of
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr

NAME = "CNCStepper_Cut"
MOST_MM, MOST_THICKNESS_MM = 100_000.0, 1000.0


@dataclass(frozen=True)
class CutChoice:
    """How a file is cut; size_mm: of the sheet, X and Y, None where a job has it. chart: rows of the shop's own."""

    process: str
    material: str
    thickness_mm: float
    consumable: str = ""
    size_mm: tuple[float, float] | None = None
    chart: Sequence[CutData] | None = None

    def row(self) -> CutData:
        """Return the chart's row; raises JobError for what it does not cover."""
        return cut_data_for(self.process, self.material, self.thickness_mm, self.consumable, self.chart)


class CutDialog(QtGui.QDialog):
    """See the module; processes: those with a chart that can be chosen, begin: what is chosen at first."""

    def __init__(self, file: str, processes: Sequence[str], begin: CutChoice):
        super().__init__(FreeCADGui.getMainWindow())
        self.setObjectName(NAME)
        self.setWindowTitle(tr("How is {0} cut?").format(file))
        f1_key.attach(self, "sending/send-file.md")
        self._begin = begin
        self.process, self.material, self.consumable = (
            _named(QtGui.QComboBox(), name) for name in ("process", "material", "consumable")
        )
        self.thickness = _length("thickness", begin.thickness_mm, MOST_THICKNESS_MM)
        self.sheet = [_length(name, value, MOST_MM) for name, value in zip("xy", begin.size_mm or (), strict=False)]
        self.feed = _named(QtGui.QLabel(), "feed")
        self.feed.setWordWrap(True)
        self.note = note_label(f"{NAME}_error", ERROR_COLOUR, self)
        for name in processes:
            self.process.addItem(tr(PROCESSES[name].title), name)
        self.process.setCurrentIndex(max(self.process.findData(begin.process), 0))
        self._arrange()
        self._process_chosen()
        self.process.activated.connect(guarded(self._process_chosen))
        self.material.activated.connect(guarded(self._material_chosen))
        self.consumable.activated.connect(guarded(self._show))
        self.thickness.valueChanged.connect(guarded(self._show))

    @property
    def choice(self) -> CutChoice:
        """What is chosen now."""
        x_y = [field.value() for field in self.sheet]
        return CutChoice(
            self.process.currentData(),
            self.material.currentData() or "",
            self.thickness.value(),
            self.consumable.currentData() or "",
            (x_y[0], x_y[1]) if x_y else None,
            self._begin.chart,
        )

    def _arrange(self) -> None:
        form = QtGui.QFormLayout(self)
        form.addRow(tr("Process"), self.process)
        form.addRow(tr("Material"), self.material)
        form.addRow(tr("Thickness"), self.thickness)
        form.addRow(tr("Consumable"), self.consumable)
        for label, field in zip((tr("Sheet, X"), tr("Sheet, Y")), self.sheet, strict=False):
            form.addRow(label, field)
        form.addRow(self.feed)
        form.addRow(self.note)
        buttons = QtGui.QDialogButtonBox()
        self.ok = _named(buttons.addButton(tr("Check and send"), QtGui.QDialogButtonBox.ButtonRole.AcceptRole), "ok")
        _named(buttons.addButton(tr("Cancel"), QtGui.QDialogButtonBox.ButtonRole.RejectRole), "cancel")
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        form.addRow(buttons)

    def _rows(self) -> Sequence[CutData]:
        process = self.process.currentData()
        rows = known_chart(process) if self._begin.chart is None else self._begin.chart
        return [row for row in rows if row.process == process]

    def _process_chosen(self) -> None:
        """Offer the materials of the process; the one that was chosen stays where the chart has it."""
        wanted = self.material.currentData() or self._begin.material
        _offer(self.material, dict.fromkeys(row.material for row in self._rows()), wanted)
        self._material_chosen()

    def _material_chosen(self) -> None:
        chosen = material_key(self.material.currentData() or "")
        rows = [row for row in self._rows() if material_key(row.material) == chosen]
        wanted = self.consumable.currentData() or self._begin.consumable
        names = dict.fromkeys(row.consumable for row in rows if row.consumable)
        _offer(self.consumable, ["", *names], wanted, tr("first of the chart"))
        self._show()

    def _show(self) -> None:
        """Show the feed of the row, or why there is none."""
        try:
            row, why = self.choice.row(), ""
        except CNCStepperError as error:
            row, why = None, translated(error.sentence)
        self.feed.setText(_feed_words(row) if row else "")
        self.note.setText(why)
        self.note.setVisible(bool(why))
        self.ok.setEnabled(row is not None)


def _feed_words(row: CutData) -> str:
    """Return in words which feed and kerf the row gives."""
    whose = ", ".join(words_of(name) for name in (row.material, row.consumable) if name)
    told = tr("A program without F runs at {0} mm/min ({1}; kerf {2} mm).")
    return told.format(_number(row.feed_mm_min), whose, _number(row.kerf_mm))


def _number(value: float) -> str:
    return f"{value:.6g}".replace(".", decimal_point())


def ask(file: str, processes: Sequence[str], begin: CutChoice) -> CutChoice | None:
    """Ask, wait, and return the choice; None when a person cancels."""
    dialog: Any = CutDialog(file, processes, begin)
    agreed = getattr(dialog, "exec", dialog.exec_)()
    choice = dialog.choice if agreed else None
    dialog.deleteLater()
    return choice


def _named(widget: Any, name: str) -> Any:
    widget.setObjectName(f"{NAME}_{name}")
    return widget


def _length(name: str, value_mm: float, most_mm: float) -> Any:
    field = _named(QtGui.QDoubleSpinBox(), name)
    field.setRange(0.01, most_mm)
    field.setDecimals(2)
    field.setSuffix(" mm")
    field.setValue(value_mm)
    return field


def _offer(box: Any, values: Any, wanted: str, words_of_none: str = "") -> None:
    """Fill a box with values; the wanted one is chosen, else the first."""
    box.clear()
    for value in values:
        box.addItem(words_of(value) if value else words_of_none, value)
    box.setCurrentIndex(max(box.findData(wanted), 0))
