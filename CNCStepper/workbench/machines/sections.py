# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tabs of a machine's page: rows in forms, axes side by side, pins with their picture, lists of tables."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.machine.profile import AXIS_NAMES
from CNCStepper.workbench.machines.declaration import PINS, WHOLE, Path, Row
from CNCStepper.workbench.machines.draft import ROWS, TABLES, Draft
from CNCStepper.workbench.machines.fields import Field, ListEditor
from CNCStepper.workbench.machines.labels import GROUPS, hint_of, label_with_unit, signal_label
from CNCStepper.workbench.machines.port_picture import PortPicture
from CNCStepper.workbench.panels.fields import ERROR_COLOUR, note_label
from CNCStepper.workbench.services.translation import tr

INPUTS, RELAYS = "input", "relay"
Typed = Callable[[Path, str], None]
SIGNAL_COLUMNS = 3


class Section(QtGui.QWidget):
    """Fields by their paths; `typed` gets the path and the text of every change."""

    def __init__(self, typed: Typed):
        super().__init__()
        self.fields: dict[Path, Field] = {}
        self.lists: dict[str, ListEditor] = {}
        self._typed = typed

    def show_draft(self, draft: Draft) -> None:
        """Show the texts of a draft."""
        for path, field in self.fields.items():
            field.show_text(draft.texts[path])
        for key, editor in self.lists.items():
            editor.show_entries(draft.lists.setdefault(key, []))

    def mark(self, problems: Mapping[Path, str]) -> list[Path]:
        """Show what is wrong beside its field, and return the paths that have one here."""
        for path, field in self.fields.items():
            field.mark(problems.get(path, ""))
        for key, editor in self.lists.items():
            editor.mark([(path, words) for path, words in problems.items() if path[:1] == (key,)])
        return [path for path in problems if path in self.fields or (path[0:1] and path[0] in self.lists)]

    def field(self, row: Row) -> Field:
        """Return a new field for a row."""
        self.fields[row.path] = Field(row, partial(self._typed, row.path))
        return self.fields[row.path]


class FormSection(Section):
    """Rows one below the other, a list of tables below them."""

    def __init__(self, rows: Sequence[Row], typed: Typed, listed: Iterable[str], changed: Callable[[], object]):
        super().__init__(typed)
        column = QtGui.QVBoxLayout(self)
        form = QtGui.QFormLayout()
        form.setFieldGrowthPolicy(QtGui.QFormLayout.FieldGrowthPolicy.ExpandingFieldsGrow)
        column.addLayout(form)
        group = ""
        for row in rows:
            table = row.path[-2] if len(row.path) > 1 else ""
            if table != group and table in GROUPS:
                form.addRow(_caption(tr(GROUPS[table])))
            group = table
            form.addRow(_label(row), self.field(row))
        for key in listed:
            self.lists[key] = ListEditor(TABLES[key], changed)
            column.addWidget(self.lists[key], 1)
        if not self.lists:
            column.addStretch(1)


class AxesSection(Section):
    """The axes side by side: a line for each value, a column for each axis."""

    def __init__(self, rows: Sequence[Row], typed: Typed):
        super().__init__(typed)
        column = QtGui.QVBoxLayout(self)
        grid = QtGui.QGridLayout()
        column.addLayout(grid)
        column.addStretch(1)
        for place, axis in enumerate(AXIS_NAMES, 1):
            grid.addWidget(_caption(axis.upper()), 0, place)
            grid.setColumnStretch(place, 1)
        lines: dict[Path, int] = {}
        groups = set[str]()
        for row in rows:
            below = row.path[2:]
            if len(below) > 1 and below[0] in GROUPS.keys() - groups:
                groups.add(below[0])
                grid.addWidget(_caption(tr(GROUPS[below[0]])), grid.rowCount(), 0, 1, 4)
            if below not in lines:
                lines[below] = grid.rowCount()
                grid.addWidget(_label(row), lines[below], 0)
            grid.addWidget(self.field(row), lines[below], 1 + AXIS_NAMES.index(row.path[1]))


class WiringSection(Section):
    """Pulse times and motors, then the pin of each signal beside the picture of the port."""

    def __init__(self, rows: Sequence[Row], typed: Typed, pin_typed: Callable[[str, str], None]):
        super().__init__(typed)
        self._pin_typed = pin_typed
        self.picture = PortPicture()
        self.pins: dict[str, Field] = {}
        self.note = note_label("CNCStepper_Machine_pins_error", ERROR_COLOUR, self)
        column = QtGui.QVBoxLayout(self)
        form = QtGui.QGridLayout()
        for place, row in enumerate(rows):
            line, side = divmod(place, 2)
            form.addWidget(_label(row), line, 2 * side)
            form.addWidget(self.field(row), line, 2 * side + 1)
        column.addLayout(form)
        column.addWidget(_caption(tr("Pins of the parallel port; a minus sign is active low")))
        self._grid = QtGui.QGridLayout()
        column.addLayout(self._grid)
        column.addWidget(self.note)
        column.addWidget(self.picture, 0, QtCore.Qt.AlignmentFlag.AlignHCenter)
        column.addStretch(1)

    def show_draft(self, draft: Draft) -> None:
        """Show times, motors and pins."""
        super().show_draft(draft)
        if list(self.pins) != list(draft.signals):
            self._arrange(draft)
        for name, field in self.pins.items():
            field.show_text(draft.pins.get(name, ""))
            standard = draft.standard_pin(name)
            field.editor.setPlaceholderText("" if standard is None else f"{standard}")
        self._draw(draft)

    def mark(self, problems: Mapping[Path, str]) -> list[Path]:
        """Show what is wrong with a pin at the pin."""
        for name, field in self.pins.items():
            field.mark(problems.get((*PINS, name), ""))
        others = [words for path, words in problems.items() if path == PINS or path == PINS[:1]]
        self.note.setText("\n".join(others))
        self.note.setVisible(bool(others))
        here = [path for path in problems if path[:1] == PINS[:1]]
        return [*super().mark(problems), *(path for path in here if path not in self.fields)]

    def _arrange(self, draft: Draft) -> None:
        while self._grid.count():
            self._grid.takeAt(0).widget().deleteLater()
        names = draft.signals
        self.pins = {name: Field(Row((*PINS, name), WHOLE), partial(self._pin_typed, name)) for name in names}
        for place, (name, field) in enumerate(self.pins.items()):
            line, side = divmod(place, SIGNAL_COLUMNS)
            self._grid.addWidget(QtGui.QLabel(signal_label(name)), line, 2 * side)
            self._grid.addWidget(field, line, 2 * side + 1)

    def _draw(self, draft: Draft) -> None:
        """Draw the pins that are typed, or those that most boards have; what is no number has no place."""
        names, low = dict[int, str](), set[int]()
        for name in draft.signals:
            text = draft.pins.get(name, "") or str(draft.standard_pin(name) or "")
            digits = text.lstrip("-")
            if digits.isdecimal():
                names[int(digits)] = signal_label(name)
                if text.startswith("-"):
                    low.add(int(digits))
        for entry in draft.lists.get(INPUTS, []):
            if entry.get("pin", "").isdecimal():
                names[int(entry["pin"])] = entry.get("act", "")
        self.picture.show_pins(names, low)


def sections(
    typed: Typed, pin_typed: Callable[[str, str], None], changed: Callable[[], object]
) -> dict[str, Callable[[], Section]]:
    """Return what makes the tabs by their titles; every row of the model stands in one of them."""
    of: dict[str, list[Row]] = {"axis": [], "planner": [], "spindle": [], "signals": [], "": []}
    for row in ROWS:
        top = {"outputs": "spindle"}.get(row.path[0], row.path[0])
        of[top if top in of else ""].append(row)
    inputs = [key for key in TABLES if key != RELAYS]
    return {
        tr("General"): lambda: FormSection(of[""], typed, (), changed),
        tr("Axes"): lambda: AxesSection(of["axis"], typed),
        tr("Ramps"): lambda: FormSection(of["planner"], typed, (), changed),
        tr("Spindle and relays"): lambda: FormSection(of["spindle"], typed, (RELAYS,), changed),
        tr("Signals and pins"): lambda: WiringSection(of["signals"], typed, pin_typed),
        tr("Inputs"): lambda: FormSection((), typed, inputs, changed),
    }


def scrolled(content: Any) -> Any:
    """Return a widget that scrolls where it has no room."""
    area = QtGui.QScrollArea()
    area.setWidget(content)
    area.setWidgetResizable(True)
    area.setFrameShape(QtGui.QFrame.Shape.NoFrame)
    return area


def _label(row: Row) -> Any:
    label = QtGui.QLabel(label_with_unit(row))
    label.setToolTip(hint_of(row.path))
    return label


def _caption(text: str) -> Any:
    label = QtGui.QLabel(text)
    font = label.font()
    font.setBold(True)
    label.setFont(font)
    return label
