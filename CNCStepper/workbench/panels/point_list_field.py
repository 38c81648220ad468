# SPDX-License-Identifier: LGPL-2.1-or-later
"""The field of a list of places: one place a line."""

from __future__ import annotations

from typing import Any

from PySide import QtGui

from CNCStepper.workbench.features.base import value_of
from CNCStepper.workbench.panels.fields import Field
from CNCStepper.workbench.panels.number_input import Refused, shortened
from CNCStepper.workbench.panels.unit_values import measure_of, text_of, value_of_text
from CNCStepper.workbench.services.translation import later, tr

ROWS = 4  # that are seen at once
SEPARATOR = ";"  # a comma may be the decimal sign


class PointsField(Field):
    """Places in the plane, X; Y in each line."""

    def make(self) -> list[Any]:
        """Add the lines to type into."""
        lines = self.add(QtGui.QPlainTextEdit(self.widget))
        lines.setFixedHeight(ROWS * lines.fontMetrics().lineSpacing() + 2 * lines.frameWidth() + 8)
        lines.setTabChangesFocus(True)
        lines.setPlaceholderText(tr("X; Y in {0}, one hole a line").format(measure_of(self.entry).unit))
        lines.textChanged.connect(self._typed)
        return [lines]

    def _typed(self) -> None:
        if self.has_focus():
            self.touched()

    def read(self) -> list[tuple[float, ...]]:
        """Return the places; raises Refused for a line that is none."""
        rows = [row for row in self.editors[0].toPlainText().splitlines() if row.strip()]
        if not rows:
            raise Refused(later("A value is missing here"))
        return [self._place(row) for row in rows]

    def write(self) -> None:
        """Show the object's places."""
        rows = [f"{SEPARATOR} ".join(map(self._number, place)) for place in value_of(self.obj, self.entry)]
        self.editors[0].setPlainText("\n".join(rows))

    def _place(self, row: str) -> tuple[float, ...]:
        numbers = row.split(SEPARATOR)
        if len(numbers) != 2:
            raise Refused(later("'{0}' is no place; write X; Y"), shortened(row))
        return tuple(value_of_text(number, self.entry, self.obj) for number in numbers)

    def _number(self, length: float) -> str:
        return text_of(length, self.entry, with_unit=False)
