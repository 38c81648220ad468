# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program's text beside the picture; its lines are loaded when they become visible.

It is a table of one column because Qt lays a table of equal rows out without asking for any of them.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.services.translation import tr

DISPLAY = QtCore.Qt.ItemDataRole.DisplayRole
LEAST_LINES = 7


class ProgramLines(QtCore.QAbstractTableModel):
    """The lines of a program with their numbers."""

    def __init__(self, lines: Sequence[str], parent: Any = None):
        super().__init__(parent)
        self._lines = lines

    def rowCount(self, parent: Any = None) -> int:
        """Return the number of lines; Qt asks."""
        return 0 if parent is not None and parent.isValid() else len(self._lines)

    def columnCount(self, parent: Any = None) -> int:
        """Return 1; Qt asks."""
        return 0 if parent is not None and parent.isValid() else 1

    def data(self, index: Any, role: int = DISPLAY) -> Any:
        """Return the text of one line; Qt asks for those that are seen."""
        return self._lines[index.row()] if role == DISPLAY else None

    def headerData(self, section: int, orientation: Any, role: int = DISPLAY) -> Any:
        """Return the number of one line; Qt asks for those that are seen."""
        return str(section + 1) if role == DISPLAY and orientation == QtCore.Qt.Orientation.Vertical else None


class Numbers(QtGui.QHeaderView):
    """The numbers beside the lines, as wide as they are told: Qt would ask thousands of them how wide they are."""

    def __init__(self, parent: Any):
        super().__init__(QtCore.Qt.Orientation.Vertical, parent)
        self._width_px = 0

    def set_width(self, width_px: int) -> None:
        """Set the width."""
        self._width_px = width_px
        self.setFixedWidth(width_px)

    def sizeHint(self) -> Any:
        """Return that width; Qt asks."""
        return QtCore.QSize(self._width_px, 0)


class ProgramList(QtGui.QTableView):
    """A list of the program's lines with the one under way marked; `chosen` sends the line that a person goes to."""

    chosen = QtCore.Signal(int)

    def __init__(self, parent: Any = None):
        super().__init__(parent)
        self.setObjectName("CNCStepper_Simulation_program")
        self.setAccessibleName(tr("Program"))
        self.setFont(QtGui.QFontDatabase.systemFont(QtGui.QFontDatabase.SystemFont.FixedFont))
        self.setShowGrid(False)
        self.setWordWrap(False)
        self.setSelectionBehavior(QtGui.QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QtGui.QAbstractItemView.SelectionMode.SingleSelection)
        line_px = self.fontMetrics().height() + 2
        self.setMinimumHeight(LEAST_LINES * line_px)
        self._set_up_headers(line_px)
        self._following = False
        self.clicked.connect(self._choose)

    def _set_up_headers(self, line_px: int) -> None:
        fixed = QtGui.QHeaderView.ResizeMode.Fixed
        numbers, across = Numbers(self), self.horizontalHeader()
        self.setVerticalHeader(numbers)
        numbers.setMinimumSectionSize(1)
        numbers.setDefaultSectionSize(line_px)
        numbers.setSectionResizeMode(fixed)
        numbers.setDefaultAlignment(QtCore.Qt.AlignmentFlag.AlignRight | QtCore.Qt.AlignmentFlag.AlignVCenter)
        numbers.setSectionsClickable(False)
        numbers.setHighlightSections(False)
        across.hide()
        across.setStretchLastSection(True)

    def show_program(self, lines: Sequence[str]) -> None:
        """Show these lines."""
        digits = max(len(str(len(lines))), 3)
        letter_px = self.fontMetrics().boundingRect("0" * 100).width() / 100
        self.verticalHeader().set_width(round(letter_px * (digits + 2)))
        self.horizontalHeader().setMinimumSectionSize(round(letter_px * (max(map(len, lines), default=0) + 2)))
        self.setModel(ProgramLines(lines, self))
        self.selectionModel().currentChanged.connect(self._choose)

    def follow(self, line: int) -> None:
        """Mark a line and let it be seen, in the middle; one that is marked already stays where it is."""
        model = self.model()
        if model is None or not 0 < line <= model.rowCount() or line - 1 == self.currentIndex().row():
            return
        self._following = True
        index = model.index(line - 1, 0)
        self.setCurrentIndex(index)
        self.scrollTo(index, QtGui.QAbstractItemView.ScrollHint.PositionAtCenter)
        self._following = False

    def _choose(self, index: Any, *_: Any) -> None:
        if not self._following and index.isValid():
            self.chosen.emit(index.row() + 1)
