# SPDX-License-Identifier: LGPL-2.1-or-later
"""The row of buttons above the text: save, find, change, on which machine, and how many lines are refused."""

from __future__ import annotations

from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.services.theme_colours import ERROR, GOOD, letters
from CNCStepper.workbench.services.translation import tr

NAME = "CNCStepper_Editor_"
FIRST_MACHINE = "table-a"
COUNT = "QLabel {{ color: {}; font-weight: {} }}"


class EditorBar(QtGui.QWidget):
    """Buttons with a signal for each action."""

    save = QtCore.Signal()
    save_as = QtCore.Signal()
    find = QtCore.Signal()
    machine_changed = QtCore.Signal()

    def __init__(self, verbs: Any, parent: Any = None):
        super().__init__(parent)
        layout = QtGui.QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(2)
        for name, text, tip, wanted in (
            (
                "save",
                tr("Save"),
                tr("Keeps the text where it came from (Ctrl+S); a job's is kept beside it"),
                self.save,
            ),
            ("save_as", tr("Save as…"), tr("Writes the text into a file"), self.save_as),
            ("find_begin", tr("Find"), tr("Finds and replaces (Ctrl+F)"), self.find),
        ):
            button = self._button(name, text, tip)
            button.clicked.connect(wanted)
            layout.addWidget(button)
        change = self._button("change", tr("Change"), tr("Moves, scales, turns or rewrites the whole program"))
        change.setPopupMode(QtGui.QToolButton.ToolButtonPopupMode.InstantPopup)
        change.setMenu(verbs)
        layout.addWidget(change)
        self._machines = QtGui.QComboBox()
        self._machines.setObjectName(NAME + "machine")
        self._machines.setAccessibleName(tr("Machine"))
        self._machines.setToolTip(tr("The machine with the dialect in which the program is read"))
        self._machines.activated.connect(lambda _: self.machine_changed.emit())
        layout.addWidget(self._machines)
        self._count = QtGui.QLabel()
        self._count.setSizePolicy(QtGui.QSizePolicy.Policy.Ignored, QtGui.QSizePolicy.Policy.Preferred)
        self._count.setAlignment(QtCore.Qt.AlignmentFlag.AlignRight | QtCore.Qt.AlignmentFlag.AlignVCenter)
        self._count.setMinimumWidth(self._count.fontMetrics().boundingRect("0" * 12).width())
        self._count.setObjectName(NAME + "count")
        layout.addWidget(self._count, 1)

    @property
    def machine(self) -> str:
        """The name of the machine that is chosen."""
        return str(self._machines.currentText())

    def choose_machine(self, source: Any) -> None:
        """Offer the machines for a file; an object's machine is its job's."""
        from CNCStepper.machine.profile import profile_names

        self._machines.setVisible(source.obj is None)
        if not self._machines.count():
            self._machines.addItems(profile_names())
            self._machines.setCurrentText(FIRST_MACHINE)

    def show_count(self, count: int) -> None:
        """Show how many lines are refused."""
        self._count.setText(tr("{0} errors").format(count) if count else tr("no errors"))
        colour, weight = (ERROR, "bold") if count else (GOOD, "normal")
        self._count.setStyleSheet(COUNT.format(letters(colour), weight))

    def _button(self, name: str, text: str, tip: str) -> Any:
        button = QtGui.QToolButton()
        button.setObjectName(NAME + name)
        button.setText(text)
        button.setToolTip(tip)
        button.setAutoRaise(True)
        return button
