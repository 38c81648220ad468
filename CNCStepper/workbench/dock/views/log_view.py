# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the controller and the sender said, the last hundred sentences."""

from __future__ import annotations

import time

from PySide import QtGui

from CNCStepper.workbench.dock.views import widgets
from CNCStepper.workbench.services.translation import later, tr

KEPT = 100
LINES_SHOWN = 5
KINDS = {"warning": later("Warning"), "refused": later("Refused")}


class LogView(QtGui.QPlainTextEdit):
    """A bounded list of sentences, the newest below."""

    def __init__(self) -> None:
        super().__init__()
        widgets.named(self, "Messages")
        self.setReadOnly(True)
        self.setMaximumBlockCount(KEPT)
        self.setPlaceholderText(tr("No messages yet"))
        self.setAccessibleName(tr("Messages"))
        self.setMinimumHeight(self.fontMetrics().lineSpacing() * LINES_SHOWN)

    def say(self, kind: str, text: str) -> None:
        """Add a sentence with the time of day; warnings are marked."""
        sentence = tr("{0}: {1}").format(tr(KINDS[kind]), text) if kind in KINDS else text
        self.appendPlainText(f"{time.strftime('%H:%M:%S')}  {sentence}")
