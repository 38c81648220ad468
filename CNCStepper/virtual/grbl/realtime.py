# SPDX-License-Identifier: LGPL-2.1-or-later
"""The real-time bytes: they act where they stand, also in the middle of a line or of a comment."""

from __future__ import annotations

import re
from collections.abc import Callable

from CNCStepper.virtual.grbl import report, suspend
from CNCStepper.virtual.grbl.alarms_and_errors import ALARM_HOMING_DOOR
from CNCStepper.virtual.grbl.board import Board
from CNCStepper.virtual.grbl.overrides import (
    FEED_CHANGES,
    FEED_NORMAL,
    RAPID_VALUES,
    SPINDLE_CHANGES,
    SPINDLE_NORMAL,
)
from CNCStepper.virtual.grbl.states import State

FIRST_EXTENDED = 0x80  # from here on a byte that is no command is thrown away
RESET, STATUS, START, HOLD, DOOR, JOG_CANCEL = 0x18, 0x3F, 0x7E, 0x21, 0x84, 0x85
SPINDLE_STOP, FLOOD, MIST = 0x9E, 0xA0, 0xA1
TOOL_CHANGED = 0xA3  # of grblHAL


def _reset(machine: Board, byte: int) -> None:
    machine.reset()


def _status(machine: Board, byte: int) -> None:
    machine.send(report.status(machine))


def _start(machine: Board, byte: int) -> None:
    if machine.state is State.TOOL:
        machine.end_tool_change()
    elif machine.suspension.active:
        suspend.resume(machine)
    else:
        machine.start_cycle()


def _hold(machine: Board, byte: int) -> None:
    state = machine.state
    if state in (State.IDLE, State.RUN, State.JOG):
        suspend.hold(machine)
        if state is not State.JOG:
            machine.state = State.HOLD


def _jog_cancel(machine: Board, byte: int) -> None:
    if machine.state is State.JOG:
        suspend.hold(machine)


def _door(machine: Board, byte: int) -> None:
    if machine.state is State.HOME:
        machine.break_homing(ALARM_HOMING_DOOR)
    elif machine.state not in (State.ALARM, State.CHECK, State.SLEEP):
        machine.send("[MSG:Check Door]")
        suspension = machine.suspension
        suspension.restoring_s = None
        suspension.door = True
        suspend.hold(machine)
        if machine.state is not State.JOG:
            machine.state = State.DOOR
        if suspension.stopped:
            suspend.switch_off(machine)


def _override(machine: Board, byte: int) -> None:
    if machine.overrides.apply(byte):
        machine.status.overrides_changed()
        machine.override_motion()


def _spindle_stop(machine: Board, byte: int) -> None:
    if machine.state is State.HOLD and machine.suspension.stopped:
        suspend.toggle_spindle(machine)


def _flood(machine: Board, byte: int) -> None:
    if machine.state in (State.IDLE, State.RUN, State.HOLD, State.JOG):
        machine.flood = machine.parser.modal.flood = not machine.parser.modal.flood
        machine.status.overrides_changed()


def _mist(machine: Board, byte: int) -> None:
    if machine.firmware.mist and machine.state in (State.IDLE, State.RUN, State.HOLD, State.JOG):
        machine.mist = machine.parser.modal.mist = not machine.parser.modal.mist
        machine.status.overrides_changed()


def _tool_changed(machine: Board, byte: int) -> None:
    machine.tool_change.acknowledge(machine.ring)


Command = Callable[[Board, int], None]
OVERRIDES = (FEED_NORMAL, *FEED_CHANGES, *RAPID_VALUES, SPINDLE_NORMAL, *SPINDLE_CHANGES)
COMMANDS: dict[int, Command] = {
    RESET: _reset,
    STATUS: _status,
    START: _start,
    HOLD: _hold,
    DOOR: _door,
    JOG_CANCEL: _jog_cancel,
    SPINDLE_STOP: _spindle_stop,
    FLOOD: _flood,
    MIST: _mist,
    TOOL_CHANGED: _tool_changed,
    **dict.fromkeys(OVERRIDES, _override),
}
ACTING = re.compile(b"([" + re.escape(bytes(COMMANDS)) + rb"\x80-\xff])")  # what never reaches the ring
