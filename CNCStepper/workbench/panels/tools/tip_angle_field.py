# SPDX-License-Identifier: LGPL-2.1-or-later
"""The angle of a pointed cutter's tip: asked for while it is missing, with the usual ones as buttons."""

from __future__ import annotations

from functools import partial
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.machine.tools.tool_shapes import POINTED
from CNCStepper.workbench.features.base import value_of
from CNCStepper.workbench.panels.fields import NAME, WARNING_COLOUR, NumberField, bring_into_view, note_label
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr

USUAL_DEG = (30, 60, 90)
SETTLED_MS = 50


class TipAngleField(NumberField):
    """The angle between the two sides of a V-bit or engraver."""

    def make(self) -> list[Any]:
        """Add the line, and below it the question with its buttons."""
        editors = super().make()
        self.question = QtGui.QWidget(self.widget)
        hint = note_label(f"{NAME}_tip_angle_question", WARNING_COLOUR, self.question)
        hint.setText(tr("Without its angle it counts as flat. Between its sides:"))
        hint.show()
        column = QtGui.QVBoxLayout(self.question)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(hint)
        row = QtGui.QHBoxLayout()
        row.setSpacing(3)
        column.addLayout(row)
        for angle_deg in USUAL_DEG:
            row.addWidget(self._button(angle_deg))
        self._column.addWidget(self.question)
        self._scroll = QtCore.QTimer(self.question)  # when the new rows have their places
        self._scroll.setSingleShot(True)
        self._scroll.setInterval(SETTLED_MS)
        self._scroll.timeout.connect(guarded(self._bring_into_view))
        return editors

    def asks(self) -> bool:
        """Return whether the angle is missing."""
        return self.obj.ToolShape in POINTED and not value_of(self.obj, self.entry)

    def refresh(self) -> None:
        """Show the object's angle, and ask for one that is missing."""
        super().refresh()
        begins = self.asks() and self.question.isHidden()
        self.question.setVisible(self.asks())
        if begins:
            self._scroll.start()

    def _bring_into_view(self) -> None:
        bring_into_view(self.question)

    def _button(self, angle_deg: int) -> Any:
        button = QtGui.QPushButton(f"{angle_deg}°", self.question)
        button.setObjectName(f"{NAME}_tip_angle_{angle_deg}")
        button.setToolTip(tr("Take {0}° for the angle between its sides").format(angle_deg))
        button.setAutoDefault(False)
        button.setMinimumWidth(1)
        button.clicked.connect(guarded(partial(self._take, angle_deg)))
        return button

    def _take(self, angle_deg: int) -> None:
        self.editors[0].setText(f"{angle_deg}°")
        self.touched()
