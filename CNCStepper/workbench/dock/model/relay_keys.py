# SPDX-License-Identifier: LGPL-2.1-or-later
"""The relays' keys of the dock: the lines that wait, and which sound a moment makes; no Qt, no FreeCAD."""

from __future__ import annotations

from collections.abc import Sequence

from CNCStepper.control.session.job_phase import Phase
from CNCStepper.workbench.dock.model.button_states import ControllerSnapshot
from CNCStepper.workbench.services.sounds import ALARM, PAUSE


class Lines:
    """Lines that go to the controller one by one, each when the one before is answered."""

    def __init__(self) -> None:
        self._waiting: list[str] = []
        self._is_out = False

    def put(self, lines: Sequence[str]) -> None:
        """Leave lines; what waits already comes first."""
        self._waiting += lines

    def due(self) -> str:
        """Return the line that may go out now, "" for none."""
        if self._is_out or not self._waiting:
            return ""
        self._is_out = True
        return self._waiting.pop(0)

    def answered(self, ok: bool) -> None:
        """Take the answer to the line that is out; after a refusal the rest is not sent."""
        self._is_out = False
        if not ok:
            self._waiting = []

    def forget(self) -> None:
        """Send nothing more: there is no controller."""
        self._waiting, self._is_out = [], False

    @property
    def is_out(self) -> bool:
        """Whether an answer is awaited."""
        return self._is_out


def sound_between(before: ControllerSnapshot, now: ControllerSnapshot) -> str:
    """Return the sound of a change of the machine's state, "" for none."""
    if before.phase == now.phase or not before.connected:
        return ""
    if now.phase == Phase.ALARM:
        return ALARM
    return PAUSE if now.phase == "paused" else ""
