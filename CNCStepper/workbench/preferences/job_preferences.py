# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preferences page: with what new jobs begin, where programs are saved, and the card of the first steps."""

from __future__ import annotations

from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.document import preferred_values as preferred
from CNCStepper.workbench.features.base import JOB
from CNCStepper.workbench.first_run import card_setting
from CNCStepper.workbench.help import f1_key
from CNCStepper.workbench.help.topics import object_address
from CNCStepper.workbench.services import missing_packages
from CNCStepper.workbench.services.choice_labels import words_of
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr

PREFIX = "CNCStepper_Preferences"
LEAST_MM, MOST_MM, DECIMALS = 0.01, 10_000.0, 2


class JobPreferences:
    """FreeCAD's interface of a page: `form`, `loadSettings` when the dialog opens, `saveSettings` for OK and Apply."""

    def __init__(self, parent: Any = None):
        self.form = QtGui.QWidget()
        self.form.setObjectName(PREFIX)
        self.form.setWindowTitle(tr("Jobs and programs"))
        f1_key.attach(self.form, object_address(JOB))
        self.choices = {
            preferred.MACHINE: self._box("machine", tr("Machine")),
            preferred.MATERIAL: self._box("material", tr("Material")),
            preferred.UNITS: self._box("units", tr("Units")),
        }
        self.thickness = QtGui.QDoubleSpinBox(self.form)
        self.thickness.setRange(LEAST_MM, MOST_MM)
        self.thickness.setDecimals(DECIMALS)
        self.thickness.setSuffix(" mm")
        self.thickness.setAccessibleName(tr("Stock under a drawing"))
        self.folder = QtGui.QLineEdit(self.form)
        self.folder.setPlaceholderText(tr("beside the document"))
        self.folder.setAccessibleName(tr("Folder of programs"))
        self.card = QtGui.QCheckBox(tr("Show the first steps when the workbench opens"), self.form)
        names = {"thickness": self.thickness, "folder": self.folder, "card": self.card}
        for name, widget in names.items():
            widget.setObjectName(f"{PREFIX}_{name}")
        self._lay_out()

    @guarded
    def loadSettings(self) -> None:
        """Show what is preferred now."""
        self._fill(preferred.UNITS, [(name, words_of(name)) for name in ("mm", "inch")])
        if not missing_packages.why_not():
            self._fill_profiles()
        self.thickness.setValue(preferred.thickness_mm())
        self.folder.setText(preferred.text(preferred.FOLDER))
        self.card.setChecked(not card_setting.was_closed())

    @guarded
    def saveSettings(self) -> None:
        """Keep what stands here."""
        texts = {name: box.itemData(box.currentIndex()) for name, box in self.choices.items() if box.count()}
        preferred.prefer({**texts, preferred.FOLDER: self.folder.text().strip()}, self.thickness.value())
        card_setting.remember_closed(not self.card.isChecked())

    # --- inside ------------------------------------------------------------------------------------

    def _fill_profiles(self) -> None:
        from CNCStepper.machine.materials import material_names
        from CNCStepper.machine.own_profiles import label_of

        machines = preferred.milling_machines()
        self._fill(preferred.MACHINE, [(name, label_of(name, words_of)) for name in machines])
        materials = [("", tr("not given")), *((name, words_of(name)) for name in material_names())]
        self._fill(preferred.MATERIAL, materials)

    def _fill(self, name: str, choices: list[tuple[str, str]]) -> None:
        box = self.choices[name]
        box.clear()
        for value, words in choices:
            box.addItem(words, value)
        box.setCurrentIndex(max(box.findData(preferred.text(name)), 0))

    def _box(self, name: str, label: str) -> Any:
        box = QtGui.QComboBox(self.form)
        box.setObjectName(f"{PREFIX}_{name}")
        box.setAccessibleName(label)
        return box

    def _lay_out(self) -> None:
        jobs = QtGui.QGroupBox(tr("New jobs begin with"), self.form)
        rows = QtGui.QFormLayout(jobs)
        for box in self.choices.values():
            rows.addRow(box.accessibleName(), box)
        rows.addRow(self.thickness.accessibleName(), self.thickness)
        programs = QtGui.QGroupBox(tr("Programs"), self.form)
        browse = QtGui.QPushButton(tr("Choose…"), programs)
        browse.setObjectName(f"{PREFIX}_browse")
        browse.clicked.connect(guarded(self._choose_folder))
        line = QtGui.QHBoxLayout()
        line.addWidget(self.folder, 1)
        line.addWidget(browse)
        folders = QtGui.QFormLayout(programs)
        folders.addRow(tr("Folder"), line)
        note = QtGui.QLabel(tr("Units of fields, the decimal sign and colours of paths are FreeCAD's own preferences."))
        note.setWordWrap(True)
        column = QtGui.QVBoxLayout(self.form)
        for widget in (jobs, programs, self.card, note):
            column.addWidget(widget)
        column.addStretch(1)

    def _choose_folder(self) -> None:
        """Ask for the folder."""
        dialog = QtGui.QFileDialog(self.form, tr("Folder of programs"), self.folder.text())
        dialog.setObjectName(f"{PREFIX}_folder_dialog")
        dialog.setFileMode(dialog.FileMode.Directory)
        dialog.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.fileSelected.connect(guarded(self.folder.setText))
        dialog.open()
