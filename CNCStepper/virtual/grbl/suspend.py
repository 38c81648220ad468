# SPDX-License-Identifier: LGPL-2.1-or-later
"""What happens between a hold and the going on: feed hold, jog cancel, safety door, sleep.

hold asked ──► slowing down (Hold:1, Door:2) ──► stopped (Hold:0, Door:0) ──► ~ ──► going on
                                                      │ door: outputs off       └ Door:3 while they return
                                                      └ jog cancel: moves forgotten, Idle at once
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from CNCStepper.virtual.grbl.input_pins import DOOR
from CNCStepper.virtual.grbl.settings import LASER
from CNCStepper.virtual.grbl.spindle_control import OFF
from CNCStepper.virtual.grbl.states import State

if TYPE_CHECKING:
    from CNCStepper.virtual.grbl.machine import Grbl

SPINDLE_RETURNS_S, COOLANT_RETURNS_S = 4.0, 1.0  # waits after the outputs are on again
DOOR_READY, DOOR_AJAR, DOOR_STOPPING, DOOR_RESTORING = 0, 1, 2, 3


@dataclass
class Suspension:
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

    def hold(self, machine: Grbl) -> None:
        """Slow down to a stop; moves of a jog are given up."""
        if not self.active and machine.state in (State.RUN, State.JOG):
            machine.axes.hold()
            self.cancels_jog = machine.state is State.JOG
        elif not self.active:
            self.stopped = True
            self._stop_laser(machine)
        self.active = True

    def advance(self, machine: Grbl, dt_s: float) -> None:
        """Let time pass while suspended."""
        if not self.stopped and machine.axes.stopped:
            self._stop(machine)
        elif self.restoring_s is not None:
            self.restoring_s -= dt_s
            if self.restoring_s <= 0:
                self._go_on(machine)

    def resume(self, machine: Grbl) -> None:
        """Go on, once stopped; after a door the outputs come back first."""
        if not self.stopped or machine.state is State.SLEEP or self.restoring_s is not None:
            return
        if machine.state is State.DOOR and DOOR in machine.inputs.held:
            return
        if machine.state is State.DOOR:
            self.restoring_s = self._switch_on(machine)
            return
        if self.spindle_stopped:
            self.toggle_spindle(machine)
        self._go_on(machine)

    def toggle_spindle(self, machine: Grbl) -> None:
        """Stop the spindle of a held machine, or start it again."""
        modal = machine.parser.modal
        if self.spindle_stopped:
            machine.send("[MSG:Restoring spindle]")
            machine.spindle.switch(modal.spindle, machine.parser.rpm)
            self.spindle_stopped = False
        elif modal.spindle != OFF:
            machine.spindle.switch(OFF, 0.0)
            self.spindle_stopped = True
        machine.status.overrides_changed()

    def switch_off(self, machine: Grbl) -> None:
        """Switch the outputs off, as for an open door or sleep."""
        machine.spindle.switch(OFF, 0.0)
        machine.flood = False
        self.spindle_stopped = False
        machine.status.overrides_changed()

    def _stop(self, machine: Grbl) -> None:
        self.stopped = True
        if self.cancels_jog:
            machine.axes.reset()
            machine.sync_position()
            self.cancels_jog = False
            if not self.door and machine.state is not State.SLEEP:
                self._go_on(machine)
                return
        if self.door or machine.state is State.SLEEP:
            self.switch_off(machine)
        else:
            self._stop_laser(machine)
        if self.door:
            machine.state = State.DOOR

    def _stop_laser(self, machine: Grbl) -> None:
        """Switch a laser off while it is held, as grbl is built to where nobody changes that."""
        if machine.memory.settings.on(LASER) and not self.spindle_stopped:
            self.toggle_spindle(machine)

    def _switch_on(self, machine: Grbl) -> float:
        modal, wait_s = machine.parser.modal, 0.0
        if modal.spindle != OFF:
            machine.spindle.switch(modal.spindle, machine.parser.rpm)
            wait_s += SPINDLE_RETURNS_S
        if modal.flood:
            machine.flood = True
            wait_s += COOLANT_RETURNS_S
        machine.status.overrides_changed()
        return wait_s

    def _go_on(self, machine: Grbl) -> None:
        machine.suspension = Suspension()
        machine.state = machine.state_at_rest
        machine.override_motion()
        machine.axes.resume()
        if not machine.axes.idle:
            machine.state = State.RUN
