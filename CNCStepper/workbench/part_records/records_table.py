# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of measured parts: four columns to type or paste into, and what is worked out of them beside.

A row is added by typing into the empty one at the end, until there are MOST_PARTS.
"""

from __future__ import annotations

from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.machine.part_record_table import (
    DECIMALS,
    FIGURES,
    MEASURED,
    MOST_PARTS,
    Judged,
    figures_of,
    judged,
    require_few,
    rows_of_text,
)
from CNCStepper.workbench.panels.fields import ERROR_COLOUR
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import guarded, polled
from CNCStepper.workbench.services.theme_colours import letters
from CNCStepper.workbench.services.translation import later, tr

ROLE = QtCore.Qt.ItemDataRole
NO_PARENT = QtCore.QModelIndex()
HEADINGS = {
    "height_mm": later("Height"),
    "d1_mm": later("d1"),
    "d2_mm": later("d2"),
    "d3_mm": later("d3"),
    "mean_mm": later("Mean"),
    "deviation_mm": later("Deviation"),
    "diameter_ratio": later("Ratio of\nthe diameter"),
    "height_ratio": later("Ratio of\nthe height"),
}
TIPS = {
    "height_mm": later("As measured, in mm"),
    "d1_mm": later("Diameter as measured, in mm; of a cone that of its base"),
    "mean_mm": later("Of the three diameters, in mm"),
    "deviation_mm": later("Standard deviation of the three diameters, in mm"),
    "diameter_ratio": later("Mean diameter by the nominal one"),
    "height_ratio": later("Height by the nominal one"),
} | dict.fromkeys(("d2_mm", "d3_mm"), later("Diameter as measured, in mm; of a cone that of its base"))
COLUMNS = (*MEASURED, *FIGURES)


def local(value: float, decimals: int) -> str:
    """Return a number with its decimals, with the decimal sign of the window's language."""
    return f"{value:.{decimals}f}".replace(".", str(QtCore.QLocale().decimalPoint()))


class RecordsModel(QtCore.QAbstractTableModel):
    """The rows as they are typed; `typed` is sent after each change. nominal: height and diameter, mm."""

    typed = QtCore.Signal()

    def __init__(self, parent: Any):
        super().__init__(parent)
        self.rows: list[list[str]] = [_empty()]
        self.nominal = (0.0, 0.0)
        self.judged = Judged()

    def show_rows(self, rows: list[list[str]], nominal: tuple[float, float]) -> None:
        """Show other rows."""
        self.rows, self.nominal = [list(row) for row in rows], nominal
        self._renew()

    def measure_by(self, nominal: tuple[float, float]) -> None:
        """Judge the rows by another nominal height and diameter."""
        self.nominal = nominal
        self._renew()

    def paste(self, text: str, row: int, column: int) -> None:
        """Put the cells of a text in place of those from (row, column) on; raises JobError for too many."""
        pasted = rows_of_text(text)
        require_few(row + len(pasted))
        for place, cells in enumerate(pasted, start=row):
            while len(self.rows) <= place:
                self.rows.append(_empty())
            for at, cell in enumerate(cells[: len(MEASURED) - column], start=column):
                self.rows[place][at] = cell
        self._renew()

    def clear(self, places: set[tuple[int, int]]) -> None:
        """Empty cells; rows that hold nothing then go."""
        for row, column in places:
            if column < len(MEASURED):
                self.rows[row][column] = ""
        self._renew()

    def filled(self) -> list[list[str]]:
        """Return the rows without the empty one at the end."""
        return self.rows if any(self.rows[-1]) else self.rows[:-1]

    def first_problem(self) -> str:
        """Return the first cell that is wrong with its sentence, or the first row that is not whole, or ""."""
        if self.judged.problems:
            (row, column), sentence = min(self.judged.problems.items())
            return f"{row + 1}, {tr(HEADINGS[COLUMNS[column]])}: {translated(sentence)}"
        for row, record in enumerate(self.judged.records[: len(self.filled())]):
            if record is None:
                return tr("{0}: type a height and three diameters").format(row + 1)
        return ""

    def _renew(self) -> None:
        self.beginResetModel()
        self.rows = [row for row in self.rows if any(row)] + [_empty()]
        del self.rows[MOST_PARTS:]
        self.judged = judged(self.rows, *self.nominal)
        self.endResetModel()
        self.typed.emit()

    # --- what Qt asks -------------------------------------------------------------------------------

    def rowCount(self, parent: Any = NO_PARENT) -> int:
        """Return how many rows there are, with the empty one."""
        return 0 if parent.isValid() else len(self.rows)

    def columnCount(self, parent: Any = NO_PARENT) -> int:
        """Return how many columns there are."""
        return 0 if parent.isValid() else len(COLUMNS)

    @polled
    def headerData(self, section: int, orientation: Any, role: int = ROLE.DisplayRole) -> Any:
        """Return a column's heading and hint, and a part's number."""
        if orientation == QtCore.Qt.Orientation.Vertical:
            return section + 1 if role == ROLE.DisplayRole else None
        if role == ROLE.DisplayRole:
            return tr(HEADINGS[COLUMNS[section]])
        return tr(TIPS[COLUMNS[section]]) if role == ROLE.ToolTipRole else None

    @polled
    def data(self, index: Any, role: int = ROLE.DisplayRole) -> Any:
        """Return what a cell shows, holds or says."""
        row, column = index.row(), index.column()
        if role in (ROLE.DisplayRole, ROLE.EditRole):
            return self.rows[row][column] if column < len(MEASURED) else self._figure(row, COLUMNS[column])
        problem = self.judged.problems.get((row, column))
        if role == ROLE.ToolTipRole:
            return translated(problem) if problem else None
        return QtGui.QBrush(QtGui.QColor(letters(ERROR_COLOUR))) if role == ROLE.ForegroundRole and problem else None

    def _figure(self, row: int, key: str) -> str:
        record = self.judged.records[row]
        return "" if record is None else local(figures_of(record, *self.nominal)[key], DECIMALS[key])

    @polled
    def setData(self, index: Any, value: Any, role: int = ROLE.EditRole) -> bool:
        """Put what was typed into its row; a row that was empty gets another empty one below it."""
        self.rows[index.row()][index.column()] = str(value).strip()
        if any(self.rows[-1]) and len(self.rows) < MOST_PARTS:
            self.beginInsertRows(NO_PARENT, len(self.rows), len(self.rows))
            self.rows.append(_empty())
            self.endInsertRows()
        self.judged = judged(self.rows, *self.nominal)
        self.dataChanged.emit(self.index(0, 0), self.index(len(self.rows) - 1, len(COLUMNS) - 1))
        self.typed.emit()
        return True

    def flags(self, index: Any) -> Any:
        """Let what is measured be typed into."""
        flags = super().flags(index)
        return flags | QtCore.Qt.ItemFlag.ItemIsEditable if index.column() < len(MEASURED) else flags


class _Numbers(QtGui.QStyledItemDelegate):
    """Cells with their numbers to the right."""

    def initStyleOption(self, option: Any, index: Any) -> None:
        """Put a cell's text to the right; Qt calls this."""
        super().initStyleOption(option, index)
        option.displayAlignment = QtCore.Qt.AlignmentFlag.AlignRight | QtCore.Qt.AlignmentFlag.AlignVCenter


class RecordsTable(QtGui.QTableView):
    """The table with the keys of a spreadsheet: paste, copy, delete; Enter goes on to the next cell."""

    def __init__(self, name: str, model: RecordsModel, parent: Any):
        super().__init__(parent)
        self.setObjectName(name)
        self.setModel(model)
        self.setItemDelegate(_Numbers(self))
        self.setAlternatingRowColors(True)
        self.horizontalHeader().setSectionResizeMode(QtGui.QHeaderView.ResizeMode.Stretch)

    def paste(self) -> None:
        """Put the clipboard's cells from the current one on; raises JobError for more than the table takes."""
        here = self.currentIndex()
        row, column = (here.row(), here.column()) if here.isValid() else (self.model().rowCount() - 1, 0)
        if column < len(MEASURED):
            self.model().paste(QtGui.QApplication.clipboard().text(), row, column)
            self.setCurrentIndex(self.model().index(row, column))

    def copy(self) -> None:
        """Put the marked cells onto the clipboard, as spreadsheets take them."""
        lines: dict[int, list[str]] = {}
        for index in sorted(self.selectedIndexes(), key=lambda index: (index.row(), index.column())):
            lines.setdefault(index.row(), []).append(str(index.data()))
        QtGui.QApplication.clipboard().setText("\n".join(map("\t".join, lines.values())))

    @polled
    def keyPressEvent(self, event: Any) -> None:
        """Take the keys of a spreadsheet; Qt calls this."""
        if event.matches(QtGui.QKeySequence.StandardKey.Paste):
            guarded(self.paste)()
        elif event.matches(QtGui.QKeySequence.StandardKey.Copy):
            self.copy()
        elif event.matches(QtGui.QKeySequence.StandardKey.Delete):
            self.model().clear({(index.row(), index.column()) for index in self.selectedIndexes()})
        else:
            super().keyPressEvent(event)


def _empty() -> list[str]:
    return [""] * len(MEASURED)
