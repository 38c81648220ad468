# SPDX-License-Identifier: LGPL-2.1-or-later
"""The level of each pin of a parallel port, from the status reports of the machine.

Status reports do not have the motors' lines, which change thousands of times a second. The sign of a change of position
gives the direction line; the step line has pulses while the position changes.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from CNCStepper.control.operator.machine_test_lines import is_on
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.machine.profile import AXIS_NAMES, Machine
from CNCStepper.machine.wiring import DEVICES, INPUT_PINS
from CNCStepper.workbench.machines.labels import choice_label, signal_label

AT_REST = ("idle", "alarm")  # phases in which no pulse comes


def pins_of(machine: Machine) -> tuple[dict[int, str], set[int]]:
    """Return the names of what is wired to each pin, and the pins that are active low."""
    wired = machine.signals.wired
    relays: dict[str, str] = {relay.device: relay.name for relay in machine.relay}
    names = {abs(pin): relays.get(name) or signal_label(name) for name, pin in wired.items()}
    names |= {entry.pin: choice_label(("act",), entry.act) for entry in machine.input if isinstance(entry.pin, int)}
    return names, {abs(pin) for pin in wired.values() if pin < 0}


def levels_of(machine: Machine, status: SenderStatus | None) -> dict[int, bool]:
    """Return the pins whose level a status has: outputs of devices, and all inputs where it has them."""
    if status is None:
        return {}
    wired, told = machine.signals.wired, status.port_outputs
    if told is None:
        known = {pin: is_on(device, status.outputs) for device, pin in wired.items() if device in DEVICES}
    else:
        known = {pin: device in told for device, pin in wired.items() if device in DEVICES}
    levels = {abs(pin): on != (pin < 0) for pin, on in known.items() if on is not None}
    high = status.port_inputs
    return levels | ({pin: pin in high for pin in INPUT_PINS} if high is not None else {})


@dataclass
class MotorLines:
    """The motors' lines of a port, from the positions of one status report after the other.

    levels: of the direction lines, high where the axis went backwards last (low where the line is active low).
    pulsing: the step pins of the axes that move now.
    """

    levels: dict[int, bool] = field(default_factory=dict)
    pulsing: frozenset[int] = frozenset()
    _last: SenderStatus | None = None

    def take(self, machine: Machine, status: SenderStatus | None) -> None:
        """Take a status; the same one again changes nothing, and none forgets all lines."""
        if status is None or status.mpos_mm is None:
            self.levels, self.pulsing, self._last = {}, frozenset(), None
            return
        before, self._last = self._last, status
        if before is None or before.mpos_mm is None or before is status:
            return
        signals, pulsing = machine.signals, set[int]()
        for motor, turning in zip(signals.motor_names, signals.motors, strict=True):
            axis = AXIS_NAMES.index(turning[-1])
            moved_mm = status.mpos_mm[axis] - before.mpos_mm[axis]
            step, direction = (signals.wired.get(f"{motor}_{what}", 0) for what in ("step", "direction"))
            if moved_mm and step and direction:
                pulsing.add(abs(step))
                is_back = (moved_mm < 0) != turning.startswith("-")
                self.levels[abs(direction)] = is_back != (direction < 0)
        self.pulsing = frozenset() if status.phase in AT_REST else frozenset(pulsing)
