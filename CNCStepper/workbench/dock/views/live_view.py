# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dock's box that shows the cut under way in the 3D view, and what it starts and ends."""

from __future__ import annotations

from typing import Any

from PySide import QtGui

from CNCStepper.control.session.status import DONE
from CNCStepper.workbench.dock.job_sending import Sending
from CNCStepper.workbench.dock.model import settings
from CNCStepper.workbench.dock.views import widgets
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.translation import tr


class LiveView:
    """The box; `advance` follows after every poll: a cut is shown from its begin until its flow is closed."""

    def __init__(self, parent: Any, sending: Sending) -> None:
        self._parent, self._sending = parent, sending
        self.box = widgets.named(QtGui.QCheckBox(tr("Show the cut")), "Live")
        self.box.setToolTip(tr("The tool in the 3D view over the part as it is cut, with its path behind it"))
        self.box.setChecked(settings.live_on())
        self.box.clicked.connect(messages.guarded(lambda: settings.switch_live(self.box.isChecked())))
        self.shown: Any = None
        self._seen: Any = None  # the proof of the cut that was begun with, shown or not
        self._status: Any = None

    def advance(self, status: Any) -> None:
        """Show a cut that has begun, follow a new status, take away what has ended."""
        cut = self._sending.cut if self.box.isChecked() else None
        proof = cut[1] if cut is not None else None
        if proof is not self._seen:
            self._seen = proof
            self._begin(cut)
        if self.shown is None or not self.shown.is_shown or status is self._status:
            return
        self._status = status
        if self._sending.flow.outcome == DONE:
            self.shown.finish()
        elif status is not None:
            self.shown.follow(status)

    def _begin(self, cut: tuple[Any, Any] | None) -> None:
        """End what was shown, and begin to show another cut, None for none."""
        if self.shown is not None:
            self.shown.end()
            self.shown = None
        if cut is not None:
            from CNCStepper.workbench.simulation.live_cut import live_cut

            self.shown = live_cut(*cut, self._parent)
