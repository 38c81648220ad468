# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds and replaces in the text of the editor."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr

if TYPE_CHECKING:
    from CNCStepper.workbench.editor.text_edit import ProgramEdit

NAME = "CNCStepper_Editor_"
BACK = QtGui.QTextDocument.FindFlag.FindBackward


class FindBar(QtGui.QWidget):
    """A bar below the text; the signal `said` has its results."""

    said = QtCore.Signal(str)

    def __init__(self, edit: ProgramEdit, parent: Any = None):
        super().__init__(parent)
        self._edit = edit
        self._find = QtGui.QLineEdit()
        self._find.setObjectName(NAME + "find")
        self._find.setPlaceholderText(tr("Find"))
        self._find.setAccessibleName(tr("Find"))
        self._find.returnPressed.connect(guarded(self.next))
        self._new = QtGui.QLineEdit()
        self._new.setObjectName(NAME + "replace")
        self._new.setPlaceholderText(tr("Replace with"))
        self._new.setAccessibleName(tr("Replace with"))
        layout = QtGui.QGridLayout(self)
        layout.setContentsMargins(2, 2, 2, 2)
        layout.addWidget(self._find, 0, 0)
        layout.addWidget(self._new, 1, 0)
        for row, column, name, text, act in (
            (0, 1, "find_before", tr("Previous"), self.before),
            (0, 2, "find_next", tr("Next"), self.next),
            (1, 1, "replace_one", tr("Replace"), self.replace),
            (1, 2, "replace_all", tr("All"), self.replace_all),
        ):
            button = QtGui.QPushButton(text)
            button.setObjectName(NAME + name)
            button.clicked.connect(guarded(act))
            layout.addWidget(button, row, column)
        self.hide()

    def begin(self) -> None:
        """Show the bar with what is selected."""
        selected = self._edit.textCursor().selectedText()
        if selected and "\u2029" not in selected:
            self._find.setText(selected)
        self.show()
        self._find.setFocus()
        self._find.selectAll()

    def next(self) -> bool:
        """Go to the next place; from the begin, when there is none before the end."""
        return self._go(back=False)

    def before(self) -> bool:
        """Go to the place before."""
        return self._go(back=True)

    def replace(self) -> None:
        """Replace what was found, and go to the next place."""
        cursor = self._edit.textCursor()
        if cursor.hasSelection() and cursor.selectedText().lower() == self._find.text().lower():
            cursor.insertText(self._new.text())
        self.next()

    def replace_all(self) -> None:
        """Replace all places, as one step that can be undone."""
        wanted, new = self._find.text(), self._new.text()
        if not wanted:
            return
        search = re.compile(re.escape(wanted), re.IGNORECASE)
        text, count = search.subn(lambda _: new, self._edit.toPlainText())
        if count:
            self._edit.replace_all(text)
        self.said.emit(tr("{0} replaced").format(count))

    def keyPressEvent(self, event: Any) -> None:
        """Close with Esc."""
        if event.key() == QtCore.Qt.Key.Key_Escape:
            self.hide()
            self._edit.setFocus()
        else:
            super().keyPressEvent(event)

    def _go(self, back: bool) -> bool:
        wanted = self._find.text()
        if not wanted or self._found(wanted, back):
            return bool(wanted)
        here, other_end = self._edit.textCursor(), self._edit.textCursor()
        move = QtGui.QTextCursor.MoveOperation
        other_end.movePosition(move.End if back else move.Start)
        self._edit.setTextCursor(other_end)
        if self._found(wanted, back):
            return True
        self._edit.setTextCursor(here)
        self.said.emit(tr("'{0}' is not in the program").format(wanted))
        return False

    def _found(self, wanted: str, back: bool) -> bool:
        """Go on to the next place or the one before, if there is one."""
        return bool(self._edit.find(wanted, BACK) if back else self._edit.find(wanted))
