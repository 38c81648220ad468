# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table at a parallel port: registers in, one status register out, motors and relays in between.

two bytes a write ──► pins.py ──► drives.py ──► rotor.py ──► places of the axes
data, control            │
                         └──► relays by name               inputs ──► one byte, the status register, when it changes
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

import numpy as np

from CNCStepper.machine.profile import AXIS_NAMES, Machine
from CNCStepper.virtual.faults.plan import Fault
from CNCStepper.virtual.motors.arrivals import Arrivals, Records
from CNCStepper.virtual.motors.rotor import MotorLimits, Rotor
from CNCStepper.virtual.parport.drives import GOOD, VERDICTS, Drives, Pulses
from CNCStepper.virtual.parport.pins import InputPins, PinFaults, pin_levels

WRITE_BYTES = 2
CARRIED_S = 0.02  # by a socket or a terminal of a computer that is busy
ROOM_BYTES = 65_536  # a port has no buffer: it takes what comes
QUIET_S = 0.05  # without a write


class Parport:
    """The machine of a profile at its port; see `CNCStepper.virtual.server.twin_faults.Twin` for how it is driven.

    motors: what each motor of the profile's signals can follow, None for one that follows everything. carried_s: how
    much later than another a write may arrive, by what carries it.
    lost: pulses that moved nothing, by motor and reason. switched: relays, as (time in s, name, whether on).
    """

    columns: tuple[str, ...] = AXIS_NAMES

    def __init__(self, machine: Machine, motors: Sequence[MotorLimits | None] = (), carried_s: float = 0.0):
        self.time_s = 0.0
        self.lost: Counter[tuple[str, str]] = Counter()
        self.switched: list[tuple[float, str, bool]] = []
        self.inputs = InputPins(_active_low(machine))
        self.pin_names = self.inputs.pin_names
        signals = machine.signals
        self._names, self._pins = signals.motor_names, signals.wired
        self._steps_per_mm = [axis.steps_per_mm for axis in machine.axes]
        self._motor_of = {turning[-1]: n for n, turning in reversed(list(enumerate(signals.motors)))}
        self._rotors = [Rotor(limits) for limits in motors] or [Rotor() for _ in self._names]
        self._fields = np.zeros(len(self._rotors))
        self._drives, self._wrong = Drives(signals), PinFaults()
        self._arrivals = Arrivals(WRITE_BYTES)
        self._relays = dict.fromkeys((name for name in self._pins if _is_relay(name)), False)
        self._levels = int(pin_levels(*np.zeros((2, 1), np.uint8))[0])
        self._carried_s = carried_s
        self._dead_until_s: dict[int, float] = {}  # motors that stall or have no supply
        self._output, self._path, self._notes = bytearray(), list[np.ndarray](), list[tuple[float, str]]()
        self._last_write_s = self._last_row_s = -QUIET_S

    # -- the outside ---------------------------------------------------------------------------------

    @property
    def room(self) -> int:
        """How many bytes it takes now."""
        return ROOM_BYTES

    @property
    def quiet(self) -> bool:
        """Whether no write has come for a while."""
        return self.time_s - self._last_write_s >= QUIET_S and not self._arrivals.waiting

    @property
    def places_mm(self) -> tuple[float, ...]:
        """Where x, y and z are, from where they began."""
        return tuple(
            self._rotors[self._motor_of[name]].place / steps if name in self._motor_of else 0.0
            for name, steps in zip(AXIS_NAMES, self._steps_per_mm, strict=True)
        )

    @property
    def motor_places(self) -> dict[str, float]:
        """Where each motor's rotor is, in pulses, forwards as its axis counts."""
        return {name: rotor.place for name, rotor in zip(self._names, self._rotors, strict=True)}

    @property
    def relays(self) -> dict[str, bool]:
        """Which relays are on."""
        return dict(self._relays)

    def open(self) -> None:
        """Let a client come: its first byte is a data register, and it is sent the status register."""
        self._arrivals.clear()
        self._output[:] = (self.inputs.register,)

    def receive(self, data: bytes, since_s: float, now_s: float) -> None:
        """Take bytes that came after `since_s` and not after `now_s`."""
        self._arrivals.add(data, since_s, now_s)
        self._last_write_s = now_s

    def advance(self, now_s: float) -> None:
        """Let time pass up to `now_s`."""
        records = self._arrivals.take()
        if not records.is_empty:
            self._write(records._replace(earliest_s=records.earliest_s - self._carried_s))
        self._move(self._drives.settle(now_s))
        for rotor in self._rotors:
            rotor.settle(now_s)
        self.time_s = now_s

    def take_output(self) -> bytes:
        """Return the status registers to send since the last call."""
        output = bytes(self._output)
        self._output.clear()
        return output

    def take_path(self) -> list[np.ndarray]:
        """Return the places since the last call, float64[k, 4]: t_s, x_mm, y_mm, z_mm."""
        path, self._path = self._path, []
        return path

    def take_notes(self) -> list[tuple[float, str]]:
        """Return what happened since the last call: time in s and a sentence."""
        notes, self._notes = self._notes, []
        return notes

    # -- what happens to it --------------------------------------------------------------------------

    def press(self, pin: str) -> None:
        """Press a switch on a status pin; raises MachineRefusal where it is no input."""
        self._set_input(pin, True)

    def release(self, pin: str) -> None:
        """Let a switch go."""
        self._set_input(pin, False)

    def pins(self) -> str:
        """Return the pins that are pressed."""
        return self.inputs.text()

    def inject(self, fault: Fault) -> None:
        """Let a motor stall, the drives' supply fail, or a pin be wired wrongly."""
        if fault.kind == "power":
            self._dead_until_s = dict.fromkeys(range(len(self._rotors)), self.time_s + fault.for_s)
        elif fault.kind == "stall" and fault.motor in self._names:
            self._dead_until_s[self._names.index(fault.motor)] = self.time_s + fault.for_s
        elif fault.kind == "dead_pin":
            self._wrong.kill(fault.pin, self._levels)
        elif fault.kind == "swapped_pins":
            self._wrong.swap(fault.pin, fault.other_pin)

    # -- inside --------------------------------------------------------------------------------------

    def _set_input(self, pin: str, pressed: bool) -> None:
        before = self.inputs.register
        self.inputs.set(pin, pressed)
        if self.inputs.register != before:
            self._output.append(self.inputs.register)

    def _write(self, records: Records) -> None:
        """Carry out some writes."""
        levels = self._wrong.seen(pin_levels(records.bytes[:, 0], records.bytes[:, 1]))
        self._switch_relays(levels, records.at_s)
        self._move(self._drives.take(levels, records))
        self._levels = int(levels[-1])

    def _switch_relays(self, levels: np.ndarray, at_s: np.ndarray) -> None:
        for name, was_on in self._relays.items():
            pin = self._pins[name]
            on = (levels >> np.uint32(abs(pin)) & np.uint32(1)).astype(bool) != (pin < 0)
            for row in np.flatnonzero(np.diff(on, prepend=was_on)):
                self.switched.append((float(at_s[row]), name, bool(on[row])))
                self._notes.append((float(at_s[row]), f"{name} {'on' if on[row] else 'off'}"))
            self._relays[name] = bool(on[-1])

    def _move(self, pulses: Pulses) -> None:
        good = (pulses.verdict == GOOD) & ~self._is_dead(pulses)
        if not good.all():
            self._lose(pulses, good)
        at_s, motor, sign = (column[good] for column in pulses[:3])
        if not len(at_s):
            return
        at_s = np.maximum(at_s, self._last_row_s)
        places = np.stack([self._turn(n, motor == n, at_s, sign) for n in range(len(self._rotors))], axis=1)
        rows = np.zeros((len(at_s), 1 + len(AXIS_NAMES)))
        rows[:, 0] = at_s
        for column, (name, steps) in enumerate(zip(AXIS_NAMES, self._steps_per_mm, strict=True), 1):
            if name in self._motor_of:
                rows[:, column] = places[:, self._motor_of[name]] / steps
        self._path.append(rows)
        self._last_row_s = float(at_s[-1])

    def _turn(self, n: int, mine: np.ndarray, at_s: np.ndarray, sign: np.ndarray) -> np.ndarray:
        """Turn one motor by its pulses; return its place at every row, float64[k]."""
        begin = self._rotors[n].place
        fields = self._fields[n] + np.cumsum(sign[mine])
        places = self._rotors[n].turn(at_s[mine], fields, np.ones(len(fields), bool))
        self._fields[n] = fields[-1] if len(fields) else self._fields[n]
        return np.concatenate(([begin], places))[np.cumsum(mine)]

    def _is_dead(self, pulses: Pulses) -> np.ndarray:
        dead = np.zeros(len(pulses.at_s), bool)
        for motor, until_s in self._dead_until_s.items():
            dead |= (pulses.motor == motor) & (pulses.at_s < until_s)
        return dead

    def _lose(self, pulses: Pulses, good: np.ndarray) -> None:
        """Count and note the pulses that are not good."""
        for row in np.flatnonzero(~good):
            name, verdict = self._names[pulses.motor[row]], int(pulses.verdict[row])
            reason = VERDICTS.get(verdict, "the motor does not turn")
            self.lost[name, reason] += 1
            self._notes.append((float(pulses.at_s[row]), f"motor {name} loses a pulse: {reason}"))


def _is_relay(signal: str) -> bool:
    return signal != "enable" and not signal.endswith(("_step", "_direction"))


def _active_low(machine: Machine) -> dict[int, bool]:
    """Return for each status pin of the profile's inputs whether it is low while pressed."""
    return {entry.pin: entry.level == "low" for entry in machine.input if isinstance(entry.pin, int)}
