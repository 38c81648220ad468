# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the pages of the assistant are built of: a page with its title, buttons, and the choice of a file."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide import QtGui

from CNCStepper.workbench.assistant.machine_setup import MachineSetup
from CNCStepper.workbench.machines.machine_test_connection import Bench
from CNCStepper.workbench.panels.fields import ERROR_COLOUR, note_label
from CNCStepper.workbench.services.messages import guarded

NAME = "CNCStepper_Assistant"


class Page(QtGui.QWidget):
    """One step: its title, an explanation, what it holds, and a note of what is wrong.

    entered: called when it is shown. refresh: called after every report of the machine. why_not: why the next step
    cannot be taken, "" when it can.
    """

    title = ""

    def __init__(self, setup: MachineSetup, bench: Bench, words: str):
        super().__init__()
        self.setup, self.bench = setup, bench
        self.column = QtGui.QVBoxLayout(self)
        self.column.addWidget(label(f"{type(self).__name__}_words", words))
        self.note = note_label(f"{NAME}_{type(self).__name__}_error", ERROR_COLOUR, self)

    def entered(self) -> None:
        """Show the present state."""
        self.refresh()

    def refresh(self) -> None:
        """Show the present moment."""

    def why_not(self) -> str:
        """Return why the next step cannot be taken."""
        return ""

    def say_wrong(self, words: str) -> None:
        """Show what is wrong, or nothing."""
        self.note.setText(words)
        self.note.setVisible(bool(words))

    def button(self, name: str, text: str, clicked: Callable[[], object]) -> Any:
        """Return a new button."""
        made = QtGui.QPushButton(text, self)
        made.setObjectName(f"{NAME}_{name}")
        made.setAutoDefault(False)
        made.clicked.connect(guarded(lambda: clicked()))
        return made


def label(name: str, text: str = "") -> Any:
    """Return a text that may have several lines."""
    made = QtGui.QLabel(text)
    made.setObjectName(f"{NAME}_{name}")
    made.setWordWrap(True)
    return made


def row(*widgets: Any) -> Any:
    """Return widgets beside each other, at the left."""
    line = QtGui.QHBoxLayout()
    for widget in widgets:
        line.addWidget(widget)
    line.addStretch(1)
    return line


def combo(name: str, spoken: str, entries: list[tuple[str, str]], chosen: Callable[[], object]) -> Any:
    """Return a list of choices, each a text and what it stands for; spoken: what a screen reader says of it."""
    made = QtGui.QComboBox()
    made.setObjectName(f"{NAME}_{name}")
    made.setAccessibleName(spoken)
    for text, data in entries:
        made.addItem(text, data)
    made.activated.connect(guarded(lambda: chosen()))
    return made


def number(name: str, spoken: str, value: float, most: float, suffix: str) -> Any:
    """Return a field for a length or a feed; spoken: what a screen reader says of it."""
    made = QtGui.QDoubleSpinBox()
    made.setObjectName(f"{NAME}_{name}")
    made.setAccessibleName(spoken)
    made.setDecimals(3)
    made.setRange(0.001, most)
    made.setValue(value)
    made.setSuffix(suffix)
    return made


def choose_file(parent: Any, title: str, pattern: str, suffix: str = "", proposed: str = "") -> Path | None:
    """Ask for a file to read, or with a suffix for one to write; None when the user cancels."""
    dialog = QtGui.QFileDialog(parent, title, str(Path.home()))
    dialog.setObjectName(f"{NAME}_file")
    dialog.setOption(QtGui.QFileDialog.Option.DontUseNativeDialog)
    dialog.setNameFilter(pattern)
    if suffix:
        dialog.setAcceptMode(QtGui.QFileDialog.AcceptMode.AcceptSave)
        dialog.setFileMode(QtGui.QFileDialog.FileMode.AnyFile)
        dialog.setDefaultSuffix(suffix)
        dialog.selectFile(proposed)
    else:
        dialog.setFileMode(QtGui.QFileDialog.FileMode.ExistingFile)
    chosen = Path(dialog.selectedFiles()[0]) if getattr(dialog, "exec", dialog.exec_)() else None
    dialog.deleteLater()
    return chosen
