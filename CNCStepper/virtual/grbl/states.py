# SPDX-License-Identifier: LGPL-2.1-or-later
"""The states of the machine, by the word that the status report has for them.

State of a hold until the resume; suspend.py has the actions during it.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class State(Enum):
    """State of the machine; Hold and Door have a digit in the report."""

    IDLE = "Idle"
    RUN = "Run"
    HOLD = "Hold"
    JOG = "Jog"
    HOME = "Home"
    ALARM = "Alarm"
    CHECK = "Check"
    DOOR = "Door"
    SLEEP = "Sleep"
    TOOL = "Tool"


MOVING = (State.RUN, State.JOG, State.HOME)
BUSY = (*MOVING, State.HOLD, State.DOOR)
AT_REST = (State.IDLE, State.ALARM, State.TOOL)


DOOR_READY, DOOR_AJAR, DOOR_STOPPING, DOOR_RESTORING = 0, 1, 2, 3


@dataclass
class SuspendState:
    """The program stands still while `active`; the axes still slow down until `stopped`."""

    active: bool = False
    stopped: bool = False
    cancels_jog: bool = False
    door: bool = False
    spindle_stopped: bool = False  # by override 0x9E, comes back on resume
    restoring_s: float | None = None

    def door_phase(self, ajar: bool) -> int:
        """Return the digit of the Door state."""
        if self.restoring_s is not None:
            return DOOR_RESTORING
        if not self.stopped:
            return DOOR_STOPPING
        return DOOR_AJAR if ajar else DOOR_READY
