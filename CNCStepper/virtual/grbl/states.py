# SPDX-License-Identifier: LGPL-2.1-or-later
"""The states of the machine, by the word that the status report has for them."""

from __future__ import annotations

from enum import Enum


class State(Enum):
    """What the machine is doing; Hold and Door carry a digit in the report."""

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
