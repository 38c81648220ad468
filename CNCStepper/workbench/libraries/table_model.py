# SPDX-License-Identifier: LGPL-2.1-or-later
"""Qt's model of a library's draft: its cells, the found rows, and what is wrong at each cell."""

from __future__ import annotations

from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.machine.libraries.table_draft import Column, Problems, TableDraft
from CNCStepper.workbench.libraries.labels import heading_of, hint_of
from CNCStepper.workbench.panels.fields import ERROR_COLOUR
from CNCStepper.workbench.services.choice_labels import words_of
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import polled
from CNCStepper.workbench.services.theme_colours import letters

ROLE = QtCore.Qt.ItemDataRole
NO_PARENT = QtCore.QModelIndex()


class TableModel(QtCore.QAbstractTableModel):
    """The rows of a draft that the search has found; `typed` is sent after each change of a cell."""

    typed = QtCore.Signal()

    def __init__(self, draft: TableDraft, parent: Any):
        super().__init__(parent)
        self.draft, self.words = draft, ""
        self.shown = draft.found("")
        self.problems = Problems()
        self.judge()

    # --- what the page asks -------------------------------------------------------------------------

    def search(self, words: str) -> None:
        """Show the rows whose cells hold the words."""
        self.words = words
        self.look()

    def look(self) -> None:
        """Show the draft's rows anew."""
        self.beginResetModel()
        self.shown = self.draft.found(self.words)
        self.judge()
        self.endResetModel()

    def judge(self) -> None:
        """Look anew what is wrong."""
        self.problems = self.draft.judged()[1]

    def first_problem(self) -> str:
        """Return the first cell that is wrong with its sentence, "" for none."""
        if not self.problems:
            return ""
        (row, key), sentence = min(self.problems.items(), key=lambda found: found[0][0])
        column = next(column for column in self.draft.library.columns if column.key == key)
        heading = heading_of(column).partition("\n")[0]
        return f"{row + 1}, {heading}: {translated(sentence)}"

    def texts_of(self, column: int) -> set[str]:
        """Return the different texts that a column shows."""
        of = self.draft.library.columns[column]
        return {_shown_text(of, text) for text in {self.draft.table[row].texts[of.key] for row in self.shown}}

    # --- what Qt asks -------------------------------------------------------------------------------

    def rowCount(self, parent: Any = NO_PARENT) -> int:
        """Return how many rows were found."""
        return 0 if parent.isValid() else len(self.shown)

    def columnCount(self, parent: Any = NO_PARENT) -> int:
        """Return how many columns the library has."""
        return 0 if parent.isValid() else len(self.draft.library.columns)

    @polled
    def headerData(self, section: int, orientation: Any, role: int = ROLE.DisplayRole) -> Any:
        """Return a column's heading and hint, and a row's number."""
        if orientation == QtCore.Qt.Orientation.Vertical:
            return self.shown[section] + 1 if role == ROLE.DisplayRole else None
        column = self.draft.library.columns[section]
        if role == ROLE.DisplayRole:
            return heading_of(column)
        return hint_of(column) if role == ROLE.ToolTipRole else None

    @polled
    def data(self, index: Any, role: int = ROLE.DisplayRole) -> Any:
        """Return what a cell shows, holds or says."""
        row, column = self.shown[index.row()], self._column(index)
        text = self.draft.table[row].texts[column.key]
        problem = self.problems.get((row, column.key))
        if role == ROLE.EditRole:
            return text
        if role == ROLE.DisplayRole:
            return _shown_text(column, text)
        if role == ROLE.ToolTipRole:
            return translated(problem) if problem else None
        if role == ROLE.ForegroundRole and problem:
            return QtGui.QBrush(QtGui.QColor(letters(ERROR_COLOUR)))
        return None

    @polled
    def setData(self, index: Any, value: Any, role: int = ROLE.EditRole) -> bool:
        """Put what was typed into the draft."""
        self.draft.table[self.shown[index.row()]].texts[self._column(index).key] = str(value)
        self.judge()
        self.dataChanged.emit(self.index(0, 0), self.index(len(self.shown) - 1, self.columnCount() - 1))
        self.typed.emit()
        return True

    def flags(self, index: Any) -> Any:
        """Let every cell be typed into."""
        return super().flags(index) | QtCore.Qt.ItemFlag.ItemIsEditable

    def _column(self, index: Any) -> Column:
        return self.draft.library.columns[index.column()]


def _shown_text(column: Column, text: str) -> str:
    """Return a cell's text as it is shown: the words of a choice."""
    return words_of(text) if column.kind == "choice" and text in column.choices else text


class ChoiceDelegate(QtGui.QStyledItemDelegate):
    """Edits a cell of choices with a list of them, and every other cell with a line."""

    def createEditor(self, parent: Any, option: Any, index: Any) -> Any:
        """Return the editor of a cell."""
        column = index.model().draft.library.columns[index.column()]
        if column.kind != "choice":
            return super().createEditor(parent, option, index)
        box = QtGui.QComboBox(parent)
        for choice in column.choices:
            box.addItem(words_of(choice), choice)
        return box

    def setEditorData(self, editor: Any, index: Any) -> None:
        """Show a cell's text in its editor."""
        if isinstance(editor, QtGui.QComboBox):
            editor.setCurrentIndex(editor.findData(index.data(ROLE.EditRole)))
        else:
            super().setEditorData(editor, index)

    def setModelData(self, editor: Any, model: Any, index: Any) -> None:
        """Put what was chosen or typed into the model."""
        if isinstance(editor, QtGui.QComboBox):
            model.setData(index, editor.itemData(editor.currentIndex()))
        else:
            super().setModelData(editor, model, index)
