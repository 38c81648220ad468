# SPDX-License-Identifier: LGPL-2.1-or-later
"""Messages, and a console: lines typed to the controller, its answers, and the lines before with the arrow keys.

What may be typed, and when, says the controller's process (`control/operator/console.py`).
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.dock.model.button_states import RULES, ControllerSnapshot, why_not
from CNCStepper.workbench.dock.model.command_history import History
from CNCStepper.workbench.dock.views import widgets
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import later, tr

KEPT, LINES_SHOWN = 1000, 6
KEY = QtCore.Qt.Key
PROMPT = "> "
MESSAGES = 100
MESSAGE_LINES = 5
KINDS = {"warning": later("Warning"), "refused": later("Refused")}


class TypedLine(QtGui.QLineEdit):
    """One line; Up and Down bring back those that were typed before."""

    def __init__(self) -> None:
        super().__init__()
        self.history = History()

    def keyPressEvent(self, event: Any) -> None:
        """Take the arrow keys, leave the others to Qt."""
        if event.key() == KEY.Key_Up:
            self.setText(self.history.older(self.text()))
        elif event.key() == KEY.Key_Down:
            self.setText(self.history.newer(self.text()))
        else:
            super().keyPressEvent(event)


class ConsoleView(QtGui.QWidget):
    """The messages, and below them the line to type; `send` gets each line."""

    def __init__(self, send: Callable[[str], None]):
        super().__init__()
        self._send = send
        self.said = widgets.named(QtGui.QPlainTextEdit(), "ConsoleSaid")
        self.said.setReadOnly(True)
        self.said.setMaximumBlockCount(KEPT)
        self.said.setAccessibleName(tr("Console"))
        self.line = widgets.named(TypedLine(), "ConsoleLine")
        self.line.setPlaceholderText(tr("Type a line: $$, $#, G0 X10"))
        self.line.setAccessibleName(tr("Type a line: $$, $#, G0 X10"))
        fixed = QtGui.QFontDatabase.systemFont(QtGui.QFontDatabase.SystemFont.FixedFont)
        for widget in (self.said, self.line):
            widget.setFont(fixed)
        self.said.setMinimumHeight(self.said.fontMetrics().lineSpacing() * LINES_SHOWN)
        self.line.returnPressed.connect(guarded(self._typed))
        layout = widgets.column(self)
        layout.addWidget(self.said)
        layout.addWidget(self.line)

    def lock(self, moment: ControllerSnapshot) -> None:
        """Let lines be typed while no job runs."""
        widgets.lock(self.line, why_not("console", moment), RULES["console"].does)

    def on_message(self, text: str) -> None:
        """Show a message of the controller, or why a line was not sent."""
        self.said.appendPlainText(text)

    def _typed(self) -> None:
        line = self.line.text().strip()
        if line:
            self.line.history.add(line)
            self.line.clear()
            self.on_message(f"{PROMPT}{line}")
            self._send(line)


class LogView(QtGui.QPlainTextEdit):
    """A bounded list of sentences, the newest below."""

    def __init__(self) -> None:
        super().__init__()
        widgets.named(self, "Messages")
        self.setReadOnly(True)
        self.setMaximumBlockCount(MESSAGES)
        self.setPlaceholderText(tr("No messages yet"))
        self.setAccessibleName(tr("Messages"))
        self.setMinimumHeight(self.fontMetrics().lineSpacing() * MESSAGE_LINES)

    def say(self, kind: str, text: str) -> None:
        """Add a sentence with the time of day; a warning says that it is one."""
        sentence = tr("{0}: {1}").format(tr(KINDS[kind]), text) if kind in KINDS else text
        self.appendPlainText(f"{time.strftime('%H:%M:%S')}  {sentence}")
