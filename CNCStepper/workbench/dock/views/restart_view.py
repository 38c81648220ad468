# SPDX-License-Identifier: LGPL-2.1-or-later
"""Restart a program, take up a job that did not end, and one sentence where the last job of this machine did not."""

from __future__ import annotations

from collections.abc import Callable

from PySide import QtGui

from CNCStepper.workbench.dock.model.controller_state import WAITING, ControllerSnapshot
from CNCStepper.workbench.dock.model.unfinished_job import why_not_now
from CNCStepper.workbench.dock.views import widgets
from CNCStepper.workbench.services.translation import later, tr

DOES = {
    "Restart": later("Go on with the program from a line, an operation, a contour or a place in the picture."),
    "Unfinished": later("Say how far the last job came that was not cut to its end, and restart it there."),
}


class RestartOfferView(QtGui.QWidget):
    """Two buttons, and above them the offer, "" for none."""

    def __init__(self, restart: Callable[[], None], unfinished: Callable[[], None]):
        super().__init__()
        self.offer = widgets.wrapped("Offer")
        ground, letters = widgets.TONES[WAITING]
        self.offer.setStyleSheet(f"background: {ground}; color: {letters}; border-radius: 4px; padding: 6px;")
        self.buttons = {
            "Restart": widgets.button("Restart", tr("Restart…"), restart),
            "Unfinished": widgets.button("Unfinished", tr("Unfinished job…"), unfinished),
        }
        layout = widgets.column(self)
        layout.addWidget(self.offer)
        layout.addLayout(widgets.row(*self.buttons.values()))
        self.show_offer("")

    def show_offer(self, text: str) -> None:
        """Show the offer, or none."""
        self.offer.setText(text)
        self.offer.setVisible(bool(text))

    def lock(self, moment: ControllerSnapshot) -> None:
        """Enable the buttons while nothing is cut."""
        for name, button in self.buttons.items():
            widgets.lock(button, why_not_now(moment), DOES[name])
        if moment.job_runs:
            self.show_offer("")
