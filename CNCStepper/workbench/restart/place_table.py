# SPDX-License-Identifier: LGPL-2.1-or-later
"""The operations and contours of a program as a table, whose rows are asked for when they are seen."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from operator import attrgetter
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.restart.restart_places import OPERATION, Row
from CNCStepper.workbench.services.translation import later, tr

ROLE, ALIGN = QtCore.Qt.ItemDataRole, QtCore.Qt.AlignmentFlag
DISPLAY = ROLE.DisplayRole
HEADS = (later("Place"), later("Line"), later("Length"), later("Begins at"))
PLACE, LINE, LENGTH, BEGINS = range(len(HEADS))
_RIGHT = ALIGN.AlignRight | ALIGN.AlignVCenter
NUMBERS = int(getattr(_RIGHT, "value", _RIGHT))  # as Qt 6 and Qt 5 take it
LEAST_ROWS, MOST_ROWS = 2, 8  # that are seen without scrolling
ROOM_PX = 5  # beside the letters of a cell


class PlaceRows(QtCore.QAbstractTableModel):
    """The rows of the list."""

    def __init__(self, rows: Sequence[Row], parent: Any = None):
        super().__init__(parent)
        self._rows = rows

    def rowCount(self, parent: Any = None) -> int:
        """Return the number of rows; Qt asks."""
        return 0 if parent is not None and parent.isValid() else len(self._rows)

    def columnCount(self, parent: Any = None) -> int:
        """Return the number of columns; Qt asks."""
        return 0 if parent is not None and parent.isValid() else len(HEADS)

    def data(self, index: Any, role: int = DISPLAY) -> Any:
        """Return what a cell shows; Qt asks for those that are seen."""
        row, column = self._rows[index.row()], index.column()
        if role == DISPLAY:
            return _texts(row)[column]
        if role == ROLE.FontRole and row.kind == OPERATION:
            return _bold()
        if role == ROLE.TextAlignmentRole and column in (LINE, LENGTH):
            return NUMBERS
        return None

    def headerData(self, section: int, orientation: Any, role: int = DISPLAY) -> Any:
        """Return the name of a column; Qt asks."""
        across = orientation == QtCore.Qt.Orientation.Horizontal
        return tr(HEADS[section]) if role == DISPLAY and across else None


class PlaceList(QtGui.QTableView):
    """The table; `chosen` sends the Row that a person clicks or reaches by key."""

    chosen = QtCore.Signal(object)

    def __init__(self, parent: Any = None):
        super().__init__(parent)
        self.setObjectName("CNCStepper_Restart_places")
        self.setSelectionBehavior(QtGui.QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QtGui.QAbstractItemView.SelectionMode.SingleSelection)
        self.setShowGrid(False)
        self.setWordWrap(False)
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 4)
        self.rows: list[Row] = []
        self._marking = False

    def sizeHint(self) -> Any:
        """Return the room of the rows that there are, with the head and a scroll bar; Qt asks."""
        seen = min(max(len(self.rows), LEAST_ROWS), MOST_ROWS)
        bars_px = self.horizontalHeader().sizeHint().height() + self.horizontalScrollBar().sizeHint().height()
        rows_px = seen * self.verticalHeader().defaultSectionSize()
        return QtCore.QSize(super().sizeHint().width(), rows_px + bars_px + 2 * self.frameWidth())

    def minimumSizeHint(self) -> Any:
        """Return a room no lower than that; Qt asks."""
        return QtCore.QSize(super().minimumSizeHint().width(), self.sizeHint().height())

    def show_rows(self, rows: list[Row]) -> None:
        """Show these rows instead of those before."""
        self.rows = rows
        self.setModel(PlaceRows(rows, self))
        self.selectionModel().currentRowChanged.connect(self._choose)
        self.clicked.connect(self._choose)
        header = self.horizontalHeader()
        header.setStretchLastSection(True)
        for column, text in enumerate(_widest(rows)):
            width_px = QtGui.QFontMetrics(_bold()).boundingRect(text).width()
            head_px = header.fontMetrics().boundingRect(tr(HEADS[column])).width()
            header.resizeSection(column, max(width_px, head_px) + 2 * ROOM_PX)
        self.updateGeometry()

    def mark(self, row: int | None) -> None:
        """Mark a row without choosing it, or none."""
        self._marking = True
        if row is None:
            self.clearSelection()
            self.setCurrentIndex(QtCore.QModelIndex())
        else:
            self.selectRow(row)
        self._marking = False

    def _choose(self, index: Any, *_: Any) -> None:
        if not self._marking and index.isValid():
            self.chosen.emit(self.rows[index.row()])


def _bold() -> Any:
    font = QtGui.QFont()
    font.setBold(True)
    return font


def _texts(row: Row) -> tuple[str, ...]:
    if row.kind == OPERATION:
        return f"{row.number}. {row.name}", str(row.line), "", ""
    length = tr("{0} mm").format(f"{row.length_mm:.1f}")
    return tr("Contour {0}").format(row.number), str(row.line), length, row.begins_at


def _widest(rows: Sequence[Row]) -> list[str]:
    """Return the longest text of each column; of thousands of rows only those that may hold it are put in words."""
    measures: tuple[Callable[[Row], Any], ...] = (
        lambda row: (row.kind == OPERATION, len(row.name)),
        attrgetter("number"),
        attrgetter("line"),
        attrgetter("length_mm"),
        lambda row: len(row.begins_at),
    )
    columns = (
        zip(*(_texts(max(rows, key=measure)) for measure in measures), strict=True) if rows else [("",)] * len(HEADS)
    )
    return [max(column, key=len) for column in columns]
