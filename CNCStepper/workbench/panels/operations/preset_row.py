# SPDX-License-Identifier: LGPL-2.1-or-later
"""The row of an operation's panel that saves how it cuts under a name, and gives that to another operation.

The tool, the drawings and the shape that is cut are no part of a preset.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import Any, Protocol

from PySide import QtCore, QtGui

from CNCStepper.cycles.parameter import GROUPS
from CNCStepper.cycles.sheet_cutting.sheet_parameters import RULES
from CNCStepper.cycles.turning.turning_parameters import FEEDS
from CNCStepper.errors import CNCStepperError
from CNCStepper.machine.libraries.operation_presets import (
    LONGEST,
    Value,
    Values,
    delete_preset,
    presets_of,
    save_preset,
)
from CNCStepper.workbench.features.base import BOOL, ENUMERATION, INTEGER, NUMBERS, Property, values
from CNCStepper.workbench.panels.fields import NAME, named_button
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr

MATCHED = QtCore.Qt.MatchFlag.MatchExactly | QtCore.Qt.MatchFlag.MatchCaseSensitive
HOW_IT_CUTS = (*GROUPS, RULES, FEEDS)
HELD = (*NUMBERS, INTEGER, BOOL, ENUMERATION)  # types of properties


def preset_entries(obj: Any) -> list[Property]:
    """Return the properties of an operation that a preset holds: those of the groups that say how it cuts."""
    return [
        entry
        for entry in obj.Proxy.PROPERTIES
        if entry.group in HOW_IT_CUTS and entry.type in HELD and not entry.output
    ]


def preset_values(obj: Any) -> Values:
    """Return the values of an operation for a preset, by key; those that do not count are left out."""
    found = values(obj)
    return {entry.key: found[entry.key] for entry in preset_entries(obj) if obj.Proxy.counts(entry, found)}


def fitting(entries: Iterable[Property], preset: Values) -> Values:
    """Return those values of a preset that these properties can hold; the file is written by hand as well."""
    return {
        entry.key: preset[entry.key] for entry in entries if entry.key in preset and _holds(entry, preset[entry.key])
    }


def _holds(entry: Property, value: Value) -> bool:
    if entry.type == ENUMERATION:
        return value in entry.choices
    if entry.type == BOOL or isinstance(value, bool):
        return entry.type == BOOL and isinstance(value, bool)
    if entry.type == INTEGER:
        return isinstance(value, int)
    return isinstance(value, int | float) and math.isfinite(value)


class OperationEditor(Protocol):
    """The editor of an operation, as far as its presets need it; see `object_form.Editor`."""

    obj: Any
    form: Any
    waiting: bool
    then: Callable[[], Any] | None

    def take(self, changes: dict[str, Any]) -> None:
        """Write values in place of what is typed in their fields."""

    def flush(self) -> bool:
        """Apply what was typed last; return whether all is good."""


class PresetRow(QtGui.QWidget):
    """A list of the presets of the operation's cycle, whose line takes a new name, with *Save* and *Delete* below."""

    def __init__(self, editor: OperationEditor, parent: Any):
        super().__init__(parent)
        self._editor, self._cycle = editor, editor.obj.Proxy.CYCLE
        self.names = _name_list(self)
        self.names.activated.connect(guarded(lambda *_: self.take()))
        self.names.editTextChanged.connect(guarded(lambda *_: self._show_what_works()))
        tip = tr("Save how this operation cuts under the name in the line")
        self.save_button = named_button(f"{NAME}_preset_save", tr("Save"), tip, self.save, self)
        tip = tr("Delete the preset of this name")
        self.delete_button = named_button(f"{NAME}_preset_delete", tr("Delete"), tip, self.delete, self)
        grid = QtGui.QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.addWidget(self.names, 0, 0, 1, 2)
        grid.addWidget(self.save_button, 1, 0)
        grid.addWidget(self.delete_button, 1, 1)
        self._fill("")

    def take(self) -> None:
        """Give the operation the values of the chosen preset."""
        preset = presets_of(self._cycle).get(self.names.currentText(), {})
        shown = [entry for entry in preset_entries(self._editor.obj) if entry.key in self._editor.form.fields]
        self._editor.take(fitting(shown, preset))

    def save(self) -> None:
        """Save the operation's values under the name in the line, when what was typed last has been applied."""
        if self._editor.flush():
            self._fill(save_preset(self._cycle, self.names.currentText(), preset_values(self._editor.obj)))
        elif self._editor.waiting:
            self._editor.then = self.save
        else:
            messages.note(tr("Correct the marked values first"))

    def delete(self) -> None:
        """Delete the preset whose name is in the line."""
        delete_preset(self._cycle, self.names.currentText().strip())
        self._fill("")

    def _fill(self, name: str) -> None:
        """List the presets of the file, and put a name into the line."""
        self.names.clear()
        try:
            self.names.addItems(list(presets_of(self._cycle)))
        except CNCStepperError as error:  # a panel opens all the same
            messages.note(messages.sentence(error))
        self.names.setCurrentIndex(self.names.findText(name))
        self.names.setEditText(name)
        self._show_what_works()

    def _show_what_works(self) -> None:
        name = self.names.currentText().strip()
        self.save_button.setEnabled(bool(name))
        self.delete_button.setEnabled(self.names.findText(name, MATCHED) >= 0)


def _name_list(parent: Any) -> Any:
    """Return the list of names, which is no wider than the panel and takes a new name."""
    names = QtGui.QComboBox(parent)
    names.setObjectName(f"{NAME}_preset")
    names.setEditable(True)
    names.setCompleter(None)  # a new name may begin as another one
    names.setInsertPolicy(QtGui.QComboBox.InsertPolicy.NoInsert)
    names.setMinimumContentsLength(1)
    names.setSizeAdjustPolicy(QtGui.QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
    names.setAccessibleName(tr("Preset"))
    names.setToolTip(tr("Choose values that were saved before, or type a name to save the present ones"))
    names.lineEdit().setMaxLength(LONGEST)
    names.lineEdit().setPlaceholderText(tr("Preset"))
    return names
