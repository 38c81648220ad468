# SPDX-License-Identifier: LGPL-2.1-or-later
"""Restart a program, take up a job that did not end, and one sentence where the last job of this machine did not."""

from __future__ import annotations

from collections.abc import Callable

from PySide import QtGui

from CNCStepper.workbench.dock import parts
from CNCStepper.workbench.dock.state import WAITING, Moment
from CNCStepper.workbench.dock.unfinished import why_not_now
from CNCStepper.workbench.words import later, tr

DOES = {
    "Restart": later("Go on with the program from a line, an operation, a contour or a place in the picture."),
    "Unfinished": later("Say how far the last job came that was not cut to its end, and restart it there."),
}


class RecoveryView(QtGui.QWidget):
    """Two buttons, and above them the offer, "" for none."""

    def __init__(self, restart: Callable[[], None], unfinished: Callable[[], None]):
        super().__init__()
        self.offer = parts.wrapped("Offer")
        ground, letters = parts.TONES[WAITING]
        self.offer.setStyleSheet(f"background: {ground}; color: {letters}; border-radius: 4px; padding: 6px;")
        self.buttons = {
            "Restart": parts.button("Restart", tr("Restart…"), restart),
            "Unfinished": parts.button("Unfinished", tr("Unfinished job…"), unfinished),
        }
        layout = parts.column(self)
        layout.addWidget(self.offer)
        layout.addLayout(parts.row(*self.buttons.values()))
        self.show_offer("")

    def show_offer(self, text: str) -> None:
        """Show the offer, or none."""
        self.offer.setText(text)
        self.offer.setVisible(bool(text))

    def lock(self, moment: Moment) -> None:
        """Enable the buttons while nothing is cut."""
        for name, button in self.buttons.items():
            parts.lock(button, why_not_now(moment), DOES[name])
        if moment.job_runs:
            self.show_offer("")
