# SPDX-License-Identifier: LGPL-2.1-or-later
"""A table of what is placed: a row each with its name, cells to type into or to choose from, and how many lie there."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.panels.fields import ERROR_COLOUR, NAME
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.theme_colours import letters
from CNCStepper.workbench.services.translation import tr

FEWEST_ROWS, MOST_ROWS = 3, 8  # that are seen at once
NAME_PX = 60
PLACED, FIRST_CELL = 1, 2  # columns behind that of the name


@dataclass(frozen=True)
class Column:
    """A column of cells.

    title, tip: texts for a person. choices: value and words; () for a number of bounds, whole ones of whole bounds.
    """

    key: str
    title: str
    tip: str
    choices: tuple[tuple[str, str], ...] = ()
    bounds: tuple[int, int] | tuple[float, float] = (0, 0)


class PartTable(QtGui.QTableWidget):
    """The rows; `edited` is sent when a person has changed a cell."""

    edited = QtCore.Signal()

    def __init__(self, columns: Sequence[Column], parent: Any):
        super().__init__(0, len(columns) + 2, parent)
        self.columns = tuple(columns)
        self.setObjectName(f"{NAME}_parts")
        self.setAccessibleName(tr("Parts"))
        self.setHorizontalHeaderLabels([tr("Name"), tr("Placed"), *(column.title for column in columns)])
        for number, column in enumerate(columns, start=FIRST_CELL):
            self.horizontalHeaderItem(number).setToolTip(column.tip)
        self.verticalHeader().hide()
        self.setAutoScroll(False)  # the names stay in sight when a cell is typed into
        self.setSelectionBehavior(QtGui.QAbstractItemView.SelectionBehavior.SelectRows)
        self.setEditTriggers(QtGui.QAbstractItemView.EditTrigger.NoEditTriggers)
        self._cells: list[list[Any]] = []

    def fill(self, names: Sequence[str], rows: Sequence[dict[str, Any]]) -> None:
        """Show these rows in place of those of before."""
        self._cells = []
        self.setRowCount(len(names))
        for number, (name, row) in enumerate(zip(names, rows, strict=True)):
            self.setItem(number, 0, QtGui.QTableWidgetItem(name))
            self.setItem(number, PLACED, QtGui.QTableWidgetItem(""))
            cells = [self._cell(column, row[column.key], number) for column in self.columns]
            for place, cell in enumerate(cells, start=FIRST_CELL):
                self.setCellWidget(number, place, cell)
            self._cells.append(cells)
        self.resizeColumnsToContents()
        self.setColumnWidth(0, max(NAME_PX, self.columnWidth(0)))
        rows_px = self.rowHeight(0) if names else self.fontMetrics().height() + 8
        seen = min(max(len(names), FEWEST_ROWS), MOST_ROWS)
        self.setFixedHeight(self.horizontalHeader().sizeHint().height() + seen * rows_px + 4)

    def rows(self) -> list[dict[str, Any]]:
        """Return what stands in the rows; a number that is none is its least."""
        return [
            {column.key: _value(column, cell) for column, cell in zip(self.columns, cells, strict=True)}
            for cells in self._cells
        ]

    def show_counts(self, counts: Sequence[tuple[int, int]]) -> None:
        """Show how many of each row lie there and are wanted; too few are red."""
        for number, (lie, wanted) in enumerate(counts[: self.rowCount()]):
            item = self.item(number, PLACED)
            item.setText(f"{lie} / {wanted}")
            item.setForeground(QtGui.QColor(letters(ERROR_COLOUR)) if lie < wanted else self.palette().text())
        self.resizeColumnToContents(PLACED)

    def set_cell(self, row: int, key: str, value: int) -> None:
        """Show another number in a cell."""
        place = next(number for number, column in enumerate(self.columns) if column.key == key)
        self._cells[row][place].setText(str(value))

    def _cell(self, column: Column, value: Any, row: int) -> Any:
        if column.choices:
            cell = QtGui.QComboBox(self)
            for choice, words in column.choices:
                cell.addItem(words, choice)
            cell.setCurrentIndex([choice for choice, _ in column.choices].index(value))
            cell.activated.connect(guarded(lambda *_: self.edited.emit()))
        else:
            cell = QtGui.QLineEdit(f"{value:g}", self)
            if isinstance(column.bounds[0], int):
                cell.setValidator(QtGui.QIntValidator(*column.bounds, cell))
            cell.setFixedWidth(cell.fontMetrics().averageCharWidth() * 6)
            cell.editingFinished.connect(guarded(lambda *_: self.edited.emit()))
        cell.setObjectName(f"{NAME}_{column.key}_{row}")
        cell.setAccessibleName(f"{column.title} {row + 1}")
        cell.setToolTip(column.tip)
        return cell


def _value(column: Column, cell: Any) -> Any:
    if column.choices:
        return cell.currentData()
    least, most = column.bounds
    try:
        number = type(least)(cell.text().replace(",", "."))
    except ValueError:
        return least
    return min(max(number, least), most) if math.isfinite(number) else least


def choose_objects(found: Sequence[Any], title: str, take: Callable[[list[Any]], None], at: Any) -> None:
    """Open a menu of objects below a widget; the one that is chosen is taken, or all of them."""
    menu = QtGui.QMenu(title, at)
    menu.setObjectName(f"{NAME}_objects")
    for each in found:
        _add(menu, "object", each.Label).triggered.connect(guarded(lambda *_, each=each: take([each])))
    if len(found) > 1:
        menu.addSeparator()
        _add(menu, "all", tr("All of them")).triggered.connect(guarded(lambda *_: take(list(found))))
    if not found:
        menu.addAction(tr("There is nothing that fits")).setEnabled(False)
    menu.popup(at.mapToGlobal(at.rect().bottomLeft()))


def _add(menu: Any, name: str, text: str) -> Any:
    entry = menu.addAction(text)
    entry.setObjectName(name)
    return entry
