# SPDX-License-Identifier: LGPL-2.1-or-later
"""The phases of a session and of a connection without a job, and the sets of them that senders and clients use."""

from __future__ import annotations

from enum import StrEnum


class Phase(StrEnum):
    """Where a session is, as its status reports it; after the last one comes the kind of its outcome."""

    CONNECTING = "connecting"
    RUNNING = "running"
    HOLDING = "holding"  # slows down
    HELD = "held"
    PAUSED = "paused"  # by the program: M0, or a tool change
    DOOR = "door"
    RETREATED = "retreated"  # between two legs along the cut: idle, after a reset
    FINISHING = "finishing"  # all lines are sent
    STOPPING = "stopping"
    IDLE = "idle"  # from here on: of a connection without a job
    ALARM = "alarm"
    JOGGING = "jogging"
    HOMING = "homing"
    BUSY = "busy"


FEEDING: frozenset[str] = frozenset({Phase.RUNNING, Phase.FINISHING})  # lines may go out
STANDING: frozenset[str] = frozenset({Phase.HELD, Phase.PAUSED, Phase.DOOR})  # the controller itself holds the program
WAITING: frozenset[str] = STANDING | {Phase.RETREATED}  # a person must resume
LEG_BEGINS: frozenset[str] = frozenset({Phase.HELD, Phase.PAUSED, Phase.RETREATED})  # a leg along the cut may begin
JOB_RUNS: frozenset[str] = FEEDING | WAITING | {Phase.HOLDING, Phase.STOPPING}
CONNECTED: frozenset[str] = JOB_RUNS | {Phase.IDLE, Phase.ALARM, Phase.JOGGING, Phase.HOMING, Phase.BUSY}
