# SPDX-License-Identifier: LGPL-2.1-or-later
"""The widgets of a machine's page: one for each kind of value, with its error below."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from PySide import QtGui

from CNCStepper.gcode.dialects import dialect_names
from CNCStepper.workbench.help.f1_key import set_key
from CNCStepper.workbench.machines.declaration import CHECK, CHOICE, SET, Path, Row, Table, key_of_row
from CNCStepper.workbench.machines.draft import TRUE, text_of
from CNCStepper.workbench.machines.labels import choice_label, hint_of, label_of, label_with_unit
from CNCStepper.workbench.panels.fields import ERROR_COLOUR, FRAME, note_label
from CNCStepper.workbench.panels.number_input import Refused
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import later, tr

NAME = "CNCStepper_Machine"
CONTROLLER = ("controller",)
NARROWEST_PX, NARROWEST_COLUMN_PX = 60, 110
SET_COLUMNS = 4
Changed = Callable[[str], None]


class Field(QtGui.QWidget):
    """One value with a note below it; `changed` gets the text of every change."""

    def __init__(self, row: Row, changed: Changed):
        super().__init__()
        self.row = row
        self.setObjectName(f"{NAME}_{'_'.join(row.path)}_field")
        self.note = note_label(f"{NAME}_{'_'.join(row.path)}_error", ERROR_COLOUR, self)
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(1)
        self.editor = self._made(changed)
        self.editor.setToolTip(hint_of(row.path))
        self.editor.setAccessibleName(label_of(row.path))
        set_key(self, key_of_row(row.path))
        column.addWidget(self.editor)
        column.addWidget(self.note)

    def mark(self, sentence: str) -> None:
        """Say below the field what is wrong; "" takes it back."""
        self.note.setText(sentence)
        self.note.setVisible(bool(sentence))
        self.editor.setStyleSheet(f"#{self.editor.objectName()} {{ {FRAME} }}" if sentence else "")

    def show_text(self, text: str) -> None:
        """Show a value."""
        if isinstance(self.editor, Editor):
            self.editor.show_text(text)

    def _made(self, changed: Changed) -> Any:
        kinds: dict[str, type[Any]] = {CHECK: CheckEditor, CHOICE: ChoiceEditor, SET: SetEditor}
        made = kinds.get(self.row.kind, LineEditor)(self.row, changed)
        made.setObjectName(f"{NAME}_{'_'.join(self.row.path)}")
        return made


class Editor:
    """A widget that shows a text and reports a change."""

    def show_text(self, text: str) -> None:
        """Show a value."""
        raise NotImplementedError


class LineEditor(QtGui.QLineEdit, Editor):
    """A line edit; without text it shows the value in force."""

    def __init__(self, row: Row, changed: Changed):
        super().__init__()
        self.setMinimumWidth(NARROWEST_PX)
        self.setPlaceholderText(text_of(row.default, row))
        if row.path == CONTROLLER:
            self.setCompleter(QtGui.QCompleter(dialect_names(), self))
        self.textEdited.connect(guarded(changed))

    def show_text(self, text: str) -> None:
        """Show a text, unless it stands there."""
        if text != self.text():
            self.setText(text)
            self.setCursorPosition(0)


class CheckEditor(QtGui.QCheckBox, Editor):
    """Yes or no."""

    def __init__(self, row: Row, changed: Changed):
        super().__init__()
        self.clicked.connect(guarded(lambda: changed(TRUE if self.isChecked() else "")))

    def show_text(self, text: str) -> None:
        """Show yes or no."""
        self.setChecked(text == TRUE)


class ChoiceEditor(QtGui.QComboBox, Editor):
    """One of several; the first is the default of a profile without this key."""

    def __init__(self, row: Row, changed: Changed):
        super().__init__()
        self.setSizeAdjustPolicy(QtGui.QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(8)
        self.setSizePolicy(QtGui.QSizePolicy.Policy.Expanding, QtGui.QSizePolicy.Policy.Fixed)
        usual = choice_label(row.path, str(row.default)) if row.default else ""
        if not row.required:
            self.addItem(tr("usual: {0}").format(usual) if usual else tr("usual"), "")
        for choice in row.choices:
            self.addItem(choice_label(row.path, choice), choice)
        self.activated.connect(guarded(lambda place: changed(str(self.itemData(place)))))

    def show_text(self, text: str) -> None:
        """Show a choice; one that is none stays to be seen."""
        place = self.findData(text)
        if place < 0 and text:
            self.addItem(text, text)
            place = self.count() - 1
        self.setCurrentIndex(place)


class SetEditor(QtGui.QWidget, Editor):
    """A box to check for each of several choices."""

    def __init__(self, row: Row, changed: Changed):
        super().__init__()
        grid = QtGui.QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        self.boxes = {choice: QtGui.QCheckBox(choice_label(row.path, choice)) for choice in row.choices}
        self._others: list[str] = []
        for place, (choice, box) in enumerate(self.boxes.items()):
            box.setObjectName(f"{NAME}_{'_'.join(row.path)}_{choice}")
            box.clicked.connect(guarded(lambda: changed(self._text())))
            grid.addWidget(box, place // SET_COLUMNS, place % SET_COLUMNS)

    def show_text(self, text: str) -> None:
        """Check the choices of a text; words that are none are kept."""
        words = text.replace(",", " ").split()
        self._others = [word for word in words if word not in self.boxes]
        for choice, box in self.boxes.items():
            box.setChecked(choice in words)

    def _text(self) -> str:
        return " ".join([*(choice for choice, box in self.boxes.items() if box.isChecked()), *self._others])


LISTS = {"input": later("Inputs"), "relay": later("Relays")}


class ListEditor(QtGui.QWidget):
    """A list of tables, a line each: `entries` are changed in place, and `changed` is called."""

    def __init__(self, table: Table, changed: Callable[[], object]):
        super().__init__()
        self.table, self._changed = table, changed
        self.entries: list[dict[str, str]] = []
        self.grid = QtGui.QTableWidget(0, len(table.columns))
        self.grid.setObjectName(f"{NAME}_{table.key}")
        self.grid.setAccessibleName(tr(LISTS[table.key]))
        self.grid.setHorizontalHeaderLabels([label_with_unit(row) for row in table.columns])
        self.grid.horizontalHeader().setMinimumSectionSize(NARROWEST_COLUMN_PX)
        self.grid.verticalHeader().setVisible(True)
        self.grid.horizontalHeader().setStretchLastSection(True)
        self.grid.itemChanged.connect(guarded(self._typed))
        self.note = note_label(f"{NAME}_{table.key}_error", ERROR_COLOUR, self)
        add, remove = QtGui.QPushButton(tr("Add"), self), QtGui.QPushButton(tr("Remove"), self)
        add.setObjectName(f"{NAME}_{table.key}_add")
        remove.setObjectName(f"{NAME}_{table.key}_remove")
        add.clicked.connect(guarded(self._add))
        remove.clicked.connect(guarded(self._remove))
        buttons = QtGui.QHBoxLayout()
        buttons.addWidget(add)
        buttons.addWidget(remove)
        buttons.addStretch(1)
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.grid, 1)
        column.addWidget(self.note)
        column.addLayout(buttons)

    def show_entries(self, entries: list[dict[str, str]]) -> None:
        """Show the entries of a draft, which are changed here from now on."""
        self.entries = entries
        self.grid.blockSignals(True)
        self.grid.setRowCount(0)
        self.grid.setRowCount(len(entries))
        for line, entry in enumerate(entries):
            for place, row in enumerate(self.table.columns):
                self._fill(line, place, row, entry)
        self.grid.resizeColumnsToContents()
        self.grid.blockSignals(False)

    def mark(self, problems: Iterable[tuple[Path, str]]) -> None:
        """Say below the list what is wrong in which line of it."""
        words = [
            tr("Line {0}, {1}: {2}").format(int(path[1]) + 1, label_of((self.table.key, path[-1])), sentence)
            if len(path) > 2
            else sentence
            for path, sentence in problems
        ]
        self.note.setText("\n".join(words))
        self.note.setVisible(bool(words))

    def _fill(self, line: int, place: int, row: Row, entry: dict[str, str]) -> None:
        key = row.path[-1]
        if row.kind != CHOICE:
            self.grid.setItem(line, place, QtGui.QTableWidgetItem(entry.get(key, "")))
            return

        def chosen(text: str) -> None:
            entry[key] = text
            self._changed()

        box = ChoiceEditor(Row((self.table.key, key), CHOICE, row.choices, default=row.default, required=row.required),
                           chosen)  # fmt: skip
        box.setObjectName(f"{NAME}_{self.table.key}_{line}_{key}")
        box.setAccessibleName(f"{label_with_unit(row)} {line + 1}")
        box.show_text(entry.get(key, ""))
        self.grid.setCellWidget(line, place, box)

    def _typed(self, item: Any) -> None:
        self.entries[item.row()][self.table.columns[item.column()].path[-1]] = item.text().strip()
        self._changed()

    def _add(self) -> None:
        self.entries.append({row.path[-1]: "" for row in self.table.columns})
        self.show_entries(self.entries)
        self._changed()

    def _remove(self) -> None:
        line = self.grid.currentRow()
        if 0 <= line < len(self.entries):
            del self.entries[line]
            self.show_entries(self.entries)
            self._changed()


def words_of(refused: Refused) -> str:
    """Return what is wrong in the user's language."""
    return str(tr(refused.sentence)).format(*map(translated, refused.values))
