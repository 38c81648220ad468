# SPDX-License-Identifier: LGPL-2.1-or-later
"""The step with the controller's settings: backed up, compared side by side, and written after a question.

controller ──$$──► left   the machine's values, or a backup ──► right   written: what differs, then read back
"""

from __future__ import annotations

from pathlib import Path

from PySide import QtGui

from CNCStepper.control.settings.controller_identity import identity_of
from CNCStepper.control.settings.settings_comparison import ComparedSetting, compare_settings
from CNCStepper.control.settings.settings_file import read_settings, write_settings
from CNCStepper.control.settings.settings_profile import settings_of_profile
from CNCStepper.control.settings.settings_restore import (
    ASK_SETTINGS,
    check_restored,
    check_takes_settings,
    restore_lines,
)
from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.assistant.machine_setup import MachineSetup
from CNCStepper.workbench.assistant.widgets import NAME, Page, choose_file, combo, label, row
from CNCStepper.workbench.dock.connection import error_text
from CNCStepper.workbench.machines.machine_test_connection import Bench
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.translation import later, tr

TITLE = later("Settings")
PROFILE, BACKUP = "profile", "backup"
DIFFERS = "≠"
COLUMNS, NAME_COLUMN = 6, 2
MARK = QtGui.QColor(255, 193, 7, 90)  # reads on light and on dark; the sign says it without colour


class SettingsPage(Page):
    """See the module."""

    title = TITLE

    def __init__(self, setup: MachineSetup, bench: Bench):
        super().__init__(setup, bench, tr("Compare what the controller holds with your machine's values or a backup."))
        self._backup: dict[int, float] = {}
        self._rows: list[ComparedSetting] = []
        self._lines: list[str] = []  # that are being written
        others = [(tr("the machine's values"), PROFILE), (tr("a backup…"), BACKUP)]
        self.other = combo("other", tr("Compare with"), others, self._chosen)
        self.only = QtGui.QCheckBox(tr("Only differences"))
        self.only.setObjectName(f"{NAME}_only")
        self.only.clicked.connect(messages.guarded(self._fill))
        self.saving = self.button("backup", tr("Back up…"), self._back_up)
        self.writing = self.button("write", tr("Write the differences…"), self._write)
        self.table = QtGui.QTableWidget(0, COLUMNS)
        self.table.setObjectName(f"{NAME}_settings")
        self.table.setAccessibleName(tr(TITLE))
        self.table.setHorizontalHeaderLabels(["$", "", tr("Name"), tr("Unit"), tr("Controller"), tr("Wanted")])
        self.table.verticalHeader().setVisible(False)
        self.table.horizontalHeader().setSectionResizeMode(NAME_COLUMN, QtGui.QHeaderView.ResizeMode.Stretch)
        self.table.setEditTriggers(QtGui.QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.setSelectionBehavior(QtGui.QAbstractItemView.SelectionBehavior.SelectRows)
        self.said = label("settings_said")
        self.column.addLayout(row(QtGui.QLabel(tr("Compare with")), self.other, self.only))
        self.column.addWidget(self.table, 1)
        self.column.addWidget(self.said)
        self.column.addWidget(self.note)
        self.column.addLayout(row(self.saving, self.writing))

    def entered(self) -> None:
        """Compare anew."""
        self._fill()
        self.refresh()

    def refresh(self) -> None:
        """Show what can be done now; a write that was refused is told with what was written."""
        has = bool(self.setup.identity and self.setup.identity.settings)
        why = self.bench.why_not(locked=True)
        self.saving.setEnabled(has)
        self.writing.setEnabled(has and not why and any(one.differs for one in self._rows))
        self.writing.setToolTip(tr(why))
        if self._lines and self.bench.trouble and not self.bench.is_busy:
            done, count = len(self.bench.answered), len(self._lines)
            self._lines = []
            self.said.setText(tr("{0} of {1} settings are written.").format(min(done, count), count))
            self.say_wrong(self.bench.trouble)
            self._read_again()

    def _wanted(self) -> dict[int, float]:
        if self.other.currentData() == BACKUP:
            return self._backup
        machine = self.setup.machine
        return settings_of_profile(machine) if machine else {}

    def _fill(self) -> None:
        """Show both sides, line by line."""
        found = self.setup.identity
        self._rows = list(compare_settings(found.settings if found else {}, self._wanted()))
        shown = [one for one in self._rows if one.differs or not self.only.isChecked()]
        self.table.setRowCount(len(shown))
        for line, one in enumerate(shown):
            texts = (f"${one.number}", DIFFERS if one.differs else "", translated(one.name.name), one.name.unit,
                     _value(one.left), _value(one.right))  # fmt: skip
            for column, text in enumerate(texts):
                item = QtGui.QTableWidgetItem(text)
                if one.differs:
                    item.setBackground(QtGui.QBrush(MARK))
                self.table.setItem(line, column, item)
        self.table.resizeColumnsToContents()
        count = sum(one.differs for one in self._rows)
        none = tr("No controller with settings has answered.")
        self.said.setText(tr("{0} settings differ.").format(count) if found and found.settings else none)

    def _chosen(self) -> None:
        if self.other.currentData() == BACKUP:
            path = choose_file(self, tr("Backup of settings"), tr("Settings (*.txt *.nc *.gcode)"))
            if path is None:
                self.other.setCurrentIndex(self.other.findData(PROFILE))
            else:
                self._take_backup(path)
        self._fill()
        self.refresh()

    def _take_backup(self, path: Path) -> None:
        try:
            self._backup = read_settings(path)
        except (CNCStepperError, OSError) as error:
            self.other.setCurrentIndex(self.other.findData(PROFILE))
            messages.error(error)

    def _back_up(self) -> None:
        found = self.setup.identity
        assert found
        proposed = f"{self.setup.proposed_name()}-settings.txt"
        path = choose_file(self, tr("Back up the settings"), tr("Settings (*.txt)"), "txt", proposed)
        if path:
            write_settings(path, found.settings, str(found.text))
            self.said.setText(tr("{0} is written.").format(path))

    def _write(self) -> None:
        """Ask, and write what differs, line by line."""
        found, wanted = self.setup.identity, self._wanted()
        if found is None:
            return
        check_takes_settings(found.firmware)
        lines = restore_lines(found.settings, wanted)
        question = tr("Write {0} settings to the controller?").format(len(lines))
        if messages.ask(question, tr("Write"), tr("Not now"), " ".join(lines[:12]) + (" …" if len(lines) > 12 else "")):
            self._lines = lines
            self.say_wrong("")
            self.bench.run([*lines, ASK_SETTINGS], lambda _: self._written(lines, wanted), locked=True)

    def _written(self, lines: list[str], wanted: dict[int, float]) -> None:
        self._lines = []
        self._take_answer()
        try:
            check_restored(self.setup.identity.settings if self.setup.identity else {}, lines, wanted)
        except CNCStepperError as error:
            self.say_wrong(error_text(error))
            return
        self.said.setText(tr("{0} settings are written and read back.").format(len(lines)))

    def _read_again(self) -> None:
        """Show what the controller holds after a refusal, which stays to be read."""
        trouble = self.bench.trouble

        def answered() -> None:
            self._take_answer()
            self.say_wrong(trouble)

        self.bench.run([ASK_SETTINGS], lambda _: answered(), locked=True)

    def _take_answer(self) -> None:
        found = identity_of(word for _, words in self.bench.answered for word in words)
        if self.setup.identity:
            self.setup.identity = self.setup.identity.with_settings(found.settings)
        said = self.said.text()
        self._fill()
        self.said.setText(said)
        self.refresh()


def _value(value: float | None) -> str:
    return "–" if value is None else f"{value:.10g}"
