# SPDX-License-Identifier: LGPL-2.1-or-later
"""The buttons below a message, each of which mends at one click what it says."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from PySide import QtGui

from CNCStepper.workbench.services.messages import guarded


@dataclass(frozen=True)
class Remedy:
    """A button: its name, its text in the person's language, and what it does."""

    name: str
    text: str
    act: Callable[[], Any]


class RemedyBar(QtGui.QWidget):
    """The buttons of remedies below each other; hidden while there is none."""

    def __init__(self, parent: Any):
        super().__init__(parent)
        self._column = QtGui.QVBoxLayout(self)
        self._column.setContentsMargins(0, 0, 0, 0)
        self._column.setSpacing(2)
        self._shown: list[tuple[str, str]] = []
        self._acts: dict[str, Callable[[], Any]] = {}
        self.hide()

    def show_remedies(self, remedies: Sequence[Remedy]) -> None:
        """Show these buttons in place of the ones before; a button that stays is not made anew under the pointer."""
        self._acts = {remedy.name: remedy.act for remedy in remedies}
        texts = [(remedy.name, remedy.text) for remedy in remedies]
        if texts != self._shown:
            self._shown = texts
            while self._column.count():
                self._column.takeAt(0).widget().deleteLater()
            for name, text in texts:
                self._column.addWidget(self._button(name, text))
        self.setVisible(bool(texts))

    def fit_width(self, width_px: int) -> None:
        """Break the texts of buttons that are wider than this into lines."""
        for place, (_, text) in enumerate(self._shown):
            button = self._column.itemAt(place).widget()
            button.setText(text)
            over_px = button.sizeHint().width() - width_px
            if over_px > 0:
                metrics = button.fontMetrics()
                button.setText(_in_lines(text, metrics, metrics.horizontalAdvance(text) - over_px))

    def _button(self, name: str, text: str) -> Any:
        button = QtGui.QPushButton(text, self)
        button.setObjectName(f"CNCStepper_Panel_remedy_{name}")
        button.setToolTip(text)
        button.setMinimumWidth(1)
        button.setAutoDefault(False)
        button.clicked.connect(guarded(lambda: self._acts[name]()))
        return button


def _in_lines(text: str, metrics: Any, width_px: int) -> str:
    """Return a text with its words in lines that are no wider, where no single word is."""
    first, *words = text.split(" ")
    lines = [first]
    for word in words:
        longer = f"{lines[-1]} {word}"
        if metrics.horizontalAdvance(longer) <= width_px:
            lines[-1] = longer
        else:
            lines.append(word)
    return "\n".join(lines)
