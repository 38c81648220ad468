# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of all refusals: its rows are asked for when they are seen, however many there are."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.translation import tr

if TYPE_CHECKING:
    from CNCStepper.workbench.editor.model.error_marks import Mark

ROLE = QtCore.Qt.ItemDataRole
LEAST_LINES = 4


class RefusalRows(QtCore.QAbstractListModel):
    """One row for each refusal."""

    def __init__(self, parent: Any = None):
        super().__init__(parent)
        self._marks: Sequence[Mark] = ()

    def show(self, marks: Sequence[Mark]) -> None:
        """Show these."""
        self.beginResetModel()
        self._marks = marks
        self.endResetModel()

    def mark(self, row: int) -> Mark:
        """Return the refusal of a row."""
        return self._marks[row]

    def rowCount(self, parent: Any = None) -> int:
        """Return the number of rows; Qt asks."""
        return 0 if parent is not None and parent.isValid() else len(self._marks)

    def data(self, index: Any, role: int = ROLE.DisplayRole) -> Any:
        """Return a row's text; Qt asks for those that are seen."""
        if role not in (ROLE.DisplayRole, ROLE.ToolTipRole):
            return None
        mark = self._marks[index.row()]
        return tr("Line {0}: {1}").format(mark.line, translated(mark.error.sentence))


class RefusalList(QtGui.QListView):
    """The list; `chosen` sends the Mark of the row that is clicked or reached by key. An empty one is not seen."""

    chosen = QtCore.Signal(object)

    def __init__(self, parent: Any = None):
        super().__init__(parent)
        self.setObjectName("CNCStepper_Editor_refusals")
        self.setUniformItemSizes(True)
        self.setWordWrap(False)
        self.setEditTriggers(QtGui.QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setMinimumHeight(LEAST_LINES * (self.fontMetrics().height() + 4))
        self._rows = RefusalRows(self)
        self.setModel(self._rows)
        self.clicked.connect(self._choose)
        self.activated.connect(self._choose)
        self.hide()

    def sizeHint(self) -> Any:
        """Return room for a few lines: the text is worth more."""
        return QtCore.QSize(super().sizeHint().width(), self.minimumHeight())

    def show_marks(self, marks: Sequence[Mark]) -> None:
        """Show these refusals."""
        self._rows.show(list(marks))
        self.setVisible(bool(marks))

    def _choose(self, index: Any) -> None:
        if index.isValid():
            self.chosen.emit(self._rows.mark(index.row()))
