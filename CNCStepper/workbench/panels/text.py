# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panels of texts and shapes; the fields of a text: a box of several lines, and the fonts that there are."""

from __future__ import annotations

from concurrent.futures import Future
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.control.processes.background_thread import in_background
from CNCStepper.workbench.features.base import value_of
from CNCStepper.workbench.features.drawings.text import single_line_fonts
from CNCStepper.workbench.panels.fields import Field
from CNCStepper.workbench.panels.object_form import Editor
from CNCStepper.workbench.panels.task_panel import Panel
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr
from CNCStepper.workbench.services.view_fit import show_all

LINES_SEEN = 3
LOOK_MS = 50


class OutlinePanel(Panel):
    """Edits what is made of its values alone; what is new is brought into view when it is made."""

    def __init__(self, obj: Any, editor: Editor, is_new: bool):
        super().__init__(obj, editor)
        self._obj, self._is_new = obj, is_new
        editor.applied.connect(guarded(self._show_new))
        QtCore.QTimer.singleShot(0, guarded(self._show_new))

    def _show_new(self) -> None:
        if self._is_new and self._document() is not None and not self._obj.Shape.isNull():
            self._is_new = False
            show_all()


class LinesField(Field):
    """A text of several lines."""

    def make(self) -> list[Any]:
        """Add the box."""
        box = self.add(QtGui.QPlainTextEdit(self.widget))
        box.setTabChangesFocus(True)
        box.setFixedHeight((LINES_SEEN + 1) * box.fontMetrics().lineSpacing())
        box.textChanged.connect(self._typed)
        return [box]

    def read(self) -> str:
        """Return the text."""
        return str(self.editors[0].toPlainText())

    def write(self) -> None:
        """Show the object's text."""
        if self.read() != value_of(self.obj, self.entry):
            self.editors[0].setPlainText(value_of(self.obj, self.entry))

    def _typed(self) -> None:
        if self.read() != value_of(self.obj, self.entry) or self.edited:
            self.touched()


class FontField(Field):
    """A font by its name; the list has the single-line fonts first, and the system's when they are found."""

    def make(self) -> list[Any]:
        """Add the box to choose from or type into."""
        box = self.add(QtGui.QComboBox(self.widget))
        box.setEditable(True)
        box.setInsertPolicy(QtGui.QComboBox.InsertPolicy.NoInsert)
        box.setSizeAdjustPolicy(QtGui.QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        box.setMinimumContentsLength(8)
        box.setSizePolicy(QtGui.QSizePolicy.Policy.Expanding, QtGui.QSizePolicy.Policy.Fixed)
        for name in single_line_fonts():
            box.addItem(tr("{0} (single lines)").format(name), name)
        box.activated.connect(guarded(self._chosen))
        box.lineEdit().textEdited.connect(lambda _: self.touched())
        self._families: Future[tuple[str, ...]] | None = in_background(_families)
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(LOOK_MS)
        self._timer.timeout.connect(guarded(self._fill))
        self._timer.start()
        return [box]

    def read(self) -> str:
        """Return the name."""
        box = self.editors[0]
        index = box.findText(box.currentText())
        return str((box.itemData(index) if index >= 0 else None) or box.currentText().strip())

    def write(self) -> None:
        """Show the object's font."""
        box, value = self.editors[0], value_of(self.obj, self.entry)
        index = box.findData(value)
        box.setEditText(box.itemText(index) if index >= 0 else value)

    def _chosen(self) -> None:
        self.touched()

    def _fill(self) -> None:
        """Add the system's fonts when they are found."""
        if self._families is None or not self._families.done():
            return
        self._timer.stop()
        families, self._families = self._families.result(), None
        box, shown = self.editors[0], self.editors[0].currentText()
        for name in families:
            box.addItem(name, name)
        box.setEditText(shown)


def _families() -> tuple[str, ...]:
    from CNCStepper.drawing.text.font_files import families

    return families()
