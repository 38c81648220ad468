# SPDX-License-Identifier: LGPL-2.1-or-later
"""The board between a hold and its resume: feed hold, jog cancel, safety door, sleep.

hold asked ──► slowing down (Hold:1, Door:2) ──► stopped (Hold:0, Door:0) ──► ~ ──► going on
                                                      │ door: outputs off       └ Door:3 while they return
                                                      └ jog cancel: moves forgotten, Idle at once
"""

from __future__ import annotations

from CNCStepper.virtual.grbl.board import Board
from CNCStepper.virtual.grbl.input_pins import DOOR
from CNCStepper.virtual.grbl.settings import LASER
from CNCStepper.virtual.grbl.spindle_control import OFF
from CNCStepper.virtual.grbl.states import State, SuspendState

SPINDLE_RETURNS_S, COOLANT_RETURNS_S = 4.0, 1.0  # waits after the outputs are on again


def hold(machine: Board) -> None:
    """Slow down to a stop; moves of a jog are given up."""
    suspension = machine.suspension
    if not suspension.active and machine.state in (State.RUN, State.JOG):
        machine.axes.hold()
        suspension.cancels_jog = machine.state is State.JOG
    elif not suspension.active:
        suspension.stopped = True
        _stop_laser(machine)
    suspension.active = True


def pause(machine: Board) -> None:
    """Hold until cycle start, as `!` does."""
    hold(machine)
    machine.state = State.HOLD


def sleep(machine: Board) -> None:
    """Switch everything off; only a reset wakes the machine, and it is locked then."""
    hold(machine)
    switch_off(machine)
    machine.state = State.SLEEP
    machine.send("[MSG:Sleeping]")


def advance(machine: Board, dt_s: float) -> None:
    """Let time pass while suspended."""
    suspension = machine.suspension
    if not suspension.stopped and machine.axes.stopped:
        _stop(machine)
    elif suspension.restoring_s is not None:
        suspension.restoring_s -= dt_s
        if suspension.restoring_s <= 0:
            _go_on(machine)


def resume(machine: Board) -> None:
    """Go on, once stopped; after a door the outputs come back first."""
    suspension = machine.suspension
    if not suspension.stopped or machine.state is State.SLEEP or suspension.restoring_s is not None:
        return
    if machine.state is State.DOOR and DOOR in machine.inputs.held:
        return
    if machine.state is State.DOOR:
        suspension.restoring_s = _switch_on(machine)
        return
    if suspension.spindle_stopped:
        toggle_spindle(machine)
    _go_on(machine)


def toggle_spindle(machine: Board) -> None:
    """Stop the spindle of a held machine, or start it again."""
    modal = machine.parser.modal
    if machine.suspension.spindle_stopped:
        machine.send("[MSG:Restoring spindle]")
        machine.spindle.switch(modal.spindle, machine.parser.rpm)
        machine.suspension.spindle_stopped = False
    elif modal.spindle != OFF:
        machine.spindle.switch(OFF, 0.0)
        machine.suspension.spindle_stopped = True
    machine.status.overrides_changed()


def switch_off(machine: Board) -> None:
    """Switch the outputs off, as for an open door or sleep."""
    machine.spindle.switch(OFF, 0.0)
    machine.flood = machine.mist = False
    machine.suspension.spindle_stopped = False
    machine.status.overrides_changed()


def _stop(machine: Board) -> None:
    suspension = machine.suspension
    suspension.stopped = True
    if suspension.cancels_jog:
        machine.axes.reset()
        machine.sync_position()
        suspension.cancels_jog = False
        if not suspension.door and machine.state is not State.SLEEP:
            _go_on(machine)
            return
    if suspension.door or machine.state is State.SLEEP:
        switch_off(machine)
    else:
        _stop_laser(machine)
    if suspension.door:
        machine.state = State.DOOR


def _stop_laser(machine: Board) -> None:
    """Switch a laser off while it is held, as grbl is built to where nobody changes that."""
    if machine.memory.settings.on(LASER) and not machine.suspension.spindle_stopped:
        toggle_spindle(machine)


def _switch_on(machine: Board) -> float:
    modal, wait_s = machine.parser.modal, 0.0
    if modal.spindle != OFF:
        machine.spindle.switch(modal.spindle, machine.parser.rpm)
        wait_s += SPINDLE_RETURNS_S
    if modal.flood or modal.mist:
        machine.flood, machine.mist = modal.flood, modal.mist
        wait_s += COOLANT_RETURNS_S
    machine.status.overrides_changed()
    return wait_s


def _go_on(machine: Board) -> None:
    machine.suspension = SuspendState()
    machine.state = machine.state_at_rest
    machine.override_motion()
    machine.axes.resume()
    if not machine.axes.idle:
        machine.state = State.RUN
