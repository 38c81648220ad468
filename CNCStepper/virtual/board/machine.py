# SPDX-License-Identifier: LGPL-2.1-or-later
"""The USB board with its motors: bytes in, nothing out; the time between two bytes is the time between two pulses.

a byte ──► latches.py: FIFO, clock edge ──► coil_motor.py: field, rotor ──► places of the axes, by the profile's motors
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from CNCStepper.errors import MachineRefusal, Text
from CNCStepper.machine.profile import AXIS_NAMES, Machine
from CNCStepper.virtual.board.coil_motor import CoilMotor
from CNCStepper.virtual.board.latches import FIFO_BYTES, MOTORS, Fifo, Latches
from CNCStepper.virtual.faults.plan import Fault
from CNCStepper.virtual.motors.arrivals import Arrivals
from CNCStepper.virtual.motors.rotor import MotorLimits

QUIET_S = 0.05  # without a byte


class Board:
    """The board on the machine of a profile; see `CNCStepper.virtual.server.twin_faults.Twin` for how it is driven.

    motors: what the motor of each of the profile's signals can follow, None for one that follows everything. Motor n of
    the board is the n-th of the profile, "-x" turning its axis the other way. received: bytes so far.
    Raises MachineRefusal where the profile has more than four motors.
    """

    columns: tuple[str, ...] = AXIS_NAMES

    def __init__(self, machine: Machine, motors: Sequence[MotorLimits | None] = (), fifo_bytes: int = FIFO_BYTES):
        turning = machine.signals.motors
        if len(turning) > MOTORS:
            value = Text("{count} motors", count=len(turning))
            what, advice = "the board has no such motors", "name fewer motors in the machine's profile"
            raise MachineRefusal("board-motors", what, value=value, limit="4 motors", advice=advice)
        self.time_s = 0.0
        self.received = 0
        self.latches = Latches()
        self.motors = [CoilMotor(limits) for limits in motors or [None] * len(turning)]
        self._names = machine.signals.motor_names
        self._steps_per_mm = [axis.steps_per_mm for axis in machine.axes]
        self._motor_of = {name[-1]: n for n, name in reversed(list(enumerate(turning)))}
        self._sense = [-1.0 if name.startswith("-") else 1.0 for name in turning]
        self._fifo = Fifo(fifo_bytes)
        self._arrivals = Arrivals()
        self._path, self._notes = list[tuple[float, ...]](), list[tuple[float, str]]()
        self._dead_until_s: dict[int, float] = {}  # motors that stall
        self._last_byte_s = -QUIET_S

    # -- the outside ---------------------------------------------------------------------------------

    @property
    def room(self) -> int:
        """How many bytes it takes now."""
        return self._fifo.room - self._arrivals.waiting

    @property
    def quiet(self) -> bool:
        """Whether no byte has come for a while, and none waits."""
        return self._fifo.empty and not self._arrivals.waiting and self.time_s - self._last_byte_s >= QUIET_S

    @property
    def places_mm(self) -> tuple[float, ...]:
        """Where x, y and z are, from where they began."""
        return tuple(
            self._sense[n] * self.motors[n].steps / steps if (n := self._motor_of.get(name, -1)) >= 0 else 0.0
            for name, steps in zip(AXIS_NAMES, self._steps_per_mm, strict=True)
        )

    def open(self) -> None:
        """Let a client come: the board does not notice."""

    def receive(self, data: bytes, since_s: float, now_s: float) -> None:
        """Take bytes that came after `since_s` and not after `now_s`: no more than there is room."""
        self._arrivals.add(data, since_s, now_s)
        self.received += len(data)
        self._last_byte_s = now_s

    def advance(self, now_s: float) -> None:
        """Let time pass up to `now_s`."""
        records = self._arrivals.take()
        for at_s, byte in zip(records.at_s.tolist(), records.bytes.ravel().tolist(), strict=True):
            self._fifo.put(at_s, byte)
        for at_s, byte in self._fifo.read(now_s):
            self._clock(at_s, byte)
        for motor in self.motors:
            motor.settle(now_s)
        self.time_s = now_s

    def take_output(self) -> bytes:
        """Return nothing: the board never says anything."""
        return b""

    def take_path(self) -> list[np.ndarray]:
        """Return the places since the last call, float64[k, 4]: t_s, x_mm, y_mm, z_mm."""
        path, self._path = self._path, []
        return [np.array(path)] if path else []

    def take_notes(self) -> list[tuple[float, str]]:
        """Return what happened since the last call: time in s and a sentence."""
        notes, self._notes = self._notes, []
        return notes

    def inject(self, fault: Fault) -> None:
        """Let a motor stall, or the supply fail: the FIFO is not read then."""
        until_s = self.time_s + fault.for_s
        if fault.kind == "power":
            self._fifo.wait(until_s)
        elif fault.kind == "stall" and fault.motor in self._names:
            self._dead_until_s[self._names.index(fault.motor)] = until_s

    # -- inside --------------------------------------------------------------------------------------

    def _clock(self, at_s: float, byte: int) -> None:
        unclocked = self.latches.unclocked
        motor = self.latches.clock(byte)
        if self.latches.unclocked > unclocked:
            self._notes.append((at_s, f"byte {byte:02X}: motor {byte >> 4} is selected already, nothing moves"))
        if motor is None or motor >= len(self.motors) or at_s < self._dead_until_s.get(motor, 0.0):
            return
        turned = self.motors[motor]
        steps, stuck = turned.steps, turned.stuck
        if turned.set_coils(at_s, byte & 0x0F) != steps:
            self._path.append((at_s, *self.places_mm))
        if turned.stuck > stuck:
            self._notes.append((at_s, f"byte {byte:02X}: the field of motor {motor} pulls neither way"))
