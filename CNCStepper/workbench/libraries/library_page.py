# SPDX-License-Identifier: LGPL-2.1-or-later
"""A table of rows with its search, buttons, and what is wrong in it; and a page of the dialog, which saves them."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.errors import CNCStepperError
from CNCStepper.machine.libraries.table_draft import Library, TableDraft
from CNCStepper.workbench.libraries.table_model import ChoiceDelegate, TableModel
from CNCStepper.workbench.panels.fields import ERROR_COLOUR, named_button, note_label
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr

WIDEST_PX = 220  # of a column at first
LONGEST = 8  # so many texts of a column are measured: the one of most letters need not be the widest
GRID_PX = 1


class TablePage(QtGui.QWidget):
    """The table of a library while it is edited; `name` is the beginning of its widgets' names."""

    def __init__(self, library: Library, name: str, parent: Any):
        super().__init__(parent)
        self.name = name
        self.model = TableModel(TableDraft(library), self)
        self.model.typed.connect(guarded(self.look))
        self.search = QtGui.QLineEdit(self)
        self.search.setObjectName(f"{name}_search")
        self.search.setPlaceholderText(tr("Search"))
        self.search.setAccessibleName(tr("Search"))
        self.search.textChanged.connect(guarded(self.model.search))
        self.table = QtGui.QTableView(self)
        self.table.setObjectName(f"{name}_table")
        self.table.setModel(self.model)
        self.table.setItemDelegate(ChoiceDelegate(self.table))
        self.table.setSelectionBehavior(QtGui.QAbstractItemView.SelectionBehavior.SelectRows)
        self.table.setAlternatingRowColors(True)
        self.note = note_label(f"{name}_error", ERROR_COLOUR, self)
        self.head = QtGui.QHBoxLayout()
        self.head.addWidget(self.search, 1)
        self.buttons = QtGui.QHBoxLayout()
        column = QtGui.QVBoxLayout(self)
        column.addLayout(self.head)
        column.addWidget(self.table, 1)
        column.addWidget(self.note)
        column.addLayout(self.buttons)
        self._add_buttons()
        self._fit_columns()
        self.look()

    @property
    def draft(self) -> TableDraft:
        """The rows as they are typed."""
        return self.model.draft

    def show_library(self, library: Library) -> None:
        """Show another library's rows."""
        self.model.draft = TableDraft(library)
        self._show_rows()
        self._fit_columns()

    def look(self) -> None:
        """Show what is wrong, and what can be done."""
        problem = self.model.first_problem()
        self.note.setText(problem)
        self.note.setVisible(bool(problem))
        self.export_button.setEnabled(bool(self.draft.table) and not problem)

    def rows(self) -> list[int]:
        """Return the numbers of the marked rows."""
        places = sorted({index.row() for index in self.table.selectionModel().selectedIndexes()})
        return [self.model.shown[place] for place in places]

    # --- what the buttons do ------------------------------------------------------------------------

    def add(self) -> None:
        """Add a row behind the marked one, and edit it."""
        self.search.clear()
        self._mark(self.draft.add(max(self.rows(), default=len(self.draft.table) - 1)))

    def duplicate(self) -> None:
        """Add a copy of the marked row."""
        if rows := self.rows():
            self.search.clear()
            self._mark(self.draft.duplicate(rows[-1]))

    def delete(self) -> None:
        """Delete the marked rows."""
        self.draft.delete(self.rows())
        self._show_rows()

    def import_file(self, path: str) -> None:
        """Add the rows of a file."""
        try:
            notes = self.draft.import_file(Path(path))
        except (CNCStepperError, OSError) as error:
            messages.error(error)
            return
        self.search.clear()
        self._show_rows()
        self.table.scrollToBottom()
        if notes:
            messages.notice(tr("Not all of the file was taken"), "\n".join(map(translated, notes)))

    def export_file(self, path: str) -> None:
        """Write the marked rows, or all where none is marked, into a file."""
        try:
            notes = self.draft.export_file(Path(path), self.rows() or range(len(self.draft.table)))
        except (CNCStepperError, OSError) as error:
            messages.error(error)
            return
        messages.note(tr("{0} was written").format(path))
        if notes:
            messages.notice(tr("Not all was written"), "\n".join(map(translated, notes)))

    def button(self, name: str, text: str, tip: str, act: Callable[[], None]) -> Any:
        """Add a button below the table."""
        button = named_button(f"{self.name}_{name}", text, tip, act, self)
        self.buttons.addWidget(button)
        return button

    # --- inside ------------------------------------------------------------------------------------

    def _add_buttons(self) -> None:
        self.button("add", tr("Add"), tr("Add a row behind the marked one"), self.add)
        self.button("duplicate", tr("Duplicate"), tr("Add a copy of the marked row"), self.duplicate)
        self.button("delete", tr("Delete"), tr("Delete the marked rows"), self.delete)
        endings = ", ".join(self.draft.library.ENDINGS)
        tip = tr("Add the rows of a file: {0}").format(endings)
        self.button("import", tr("Import…"), tip, lambda: self._ask_file(False))
        tip = tr("Write the marked rows, or all, into a file: {0}").format(endings)
        self.export_button = self.button("export", tr("Export…"), tip, lambda: self._ask_file(True))
        self.buttons.addStretch(1)

    def _show_rows(self) -> None:
        self.model.look()
        self.look()

    def _mark(self, row: int) -> None:
        self._show_rows()
        self.table.setCurrentIndex(self.model.index(self.model.shown.index(row), 0))
        self.table.setFocus()

    def _fit_columns(self) -> None:
        """Make each column as wide as its heading and texts; Qt itself would ask the model for every cell."""
        header, style = self.table.horizontalHeader(), self.table.style()
        metrics = QtGui.QFontMetricsF(self.table.font())
        margin_px = 1 + style.pixelMetric(QtGui.QStyle.PixelMetric.PM_FocusFrameHMargin, None, self.table)
        for column in range(self.model.columnCount()):
            longest = sorted(self.model.texts_of(column), key=len)[-LONGEST:]
            text_px = math.ceil(max(map(metrics.horizontalAdvance, longest), default=0.0))
            wanted_px = max(header.sectionSizeHint(column), text_px + 2 * margin_px + GRID_PX)
            self.table.setColumnWidth(column, min(wanted_px, WIDEST_PX))

    def _ask_file(self, writing: bool) -> None:
        """Ask for a file to write or to read."""
        dialog = QtGui.QFileDialog(self, tr("Export") if writing else tr("Import"), str(Path.home()))
        dialog.setObjectName(f"{self.name}_file")
        dialog.setNameFilters([f"*{ending}" for ending in self.draft.library.ENDINGS])
        dialog.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
        if writing:
            dialog.setAcceptMode(dialog.AcceptMode.AcceptSave)
            dialog.setDefaultSuffix(self.draft.library.ENDINGS[0][1:])
            dialog.filterSelected.connect(guarded(lambda chosen: dialog.setDefaultSuffix(chosen.removeprefix("*."))))
        else:
            dialog.setNameFilter(" ".join(f"*{ending}" for ending in self.draft.library.ENDINGS))
            dialog.setFileMode(dialog.FileMode.ExistingFile)
        dialog.fileSelected.connect(guarded(self.export_file if writing else self.import_file))
        dialog.open()


class Page(TablePage):
    """The table of a library of the user's own, with buttons that save and revert it."""

    def look(self) -> None:
        """Show what is wrong, and what can be done."""
        super().look()
        self.save_button.setEnabled(self.draft.is_changed and not self.model.problems)
        self.revert_button.setEnabled(self.draft.is_changed)

    def save(self) -> None:
        """Write the user's own file."""
        try:
            path = self.draft.save()
        except (CNCStepperError, OSError) as error:
            messages.error(error)
            return
        self._show_rows()
        messages.note(tr("{0} was written").format(path))

    def revert(self) -> None:
        """Show what the file holds."""
        self.draft.begin()
        self._show_rows()

    def _add_buttons(self) -> None:
        super()._add_buttons()
        self.revert_button = self.button("revert", tr("Revert"), tr("Show what is saved"), self.revert)
        self.save_button = self.button("save", tr("Save"), tr("Keep the table as your own"), self.save)
