# SPDX-License-Identifier: LGPL-2.1-or-later
"""Step and direction drives: the edges of their lines become pulses of motors, or are lost.

    direction  ______|‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾      active: backwards
    step       ___________|‾‾‾‾‾|_______|‾‾‾‾‾|__      a pulse begins where the line gets active
                     |set |width|  gap  |
                     |-up |     |       |

A pulse counts once it has been long enough. It is lost where set-up, width or gap is certainly too short, and where the
drives are switched off. "Certainly": by the earliest and latest times at which the edges can have come. Before the
first write both registers are 0, as when a computer is switched on.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from CNCStepper.kernels import njit
from CNCStepper.machine.wiring import Signals
from CNCStepper.virtual.motors.arrivals import NOTHING, Records
from CNCStepper.virtual.parport.pins import pin_levels

GOOD, SHORT_PULSE, SHORT_GAP, SHORT_SETUP, DRIVES_OFF = range(5)
VERDICTS = {
    SHORT_PULSE: "the pulse is too short",
    SHORT_GAP: "the pulses are too close",
    SHORT_SETUP: "the direction changes too late",
    DRIVES_OFF: "the drives are off",
}
ROUNDING_S = 1e-7  # of times as they are computed
STEP_PIN, STEP_LOW, DIRECTION_PIN, DIRECTION_LOW, REVERSED = range(5)  # columns of the wiring; no pin: -1
OPEN, VERDICT, SIGN = range(3)  # columns of the memory: a pulse that has begun; 2 when it counts already
STEP_ON, STEP_OFF, TURNED, BEGUN = range(4)  # columns of the times: earliest of the last edges; when a pulse began
WIDTH, GAP, SETUP = range(3)


class Pulses(NamedTuple):
    """Pulses by time: at_s float64[k]; motor, sign (1 forwards, -1 backwards), verdict int64[k]."""

    at_s: np.ndarray
    motor: np.ndarray
    sign: np.ndarray
    verdict: np.ndarray


@dataclass(frozen=True)
class Wiring:
    """Which pins the drives listen to: motors int64[m, 5], the enable pin (-1: none) and whether it is active low."""

    motors: np.ndarray
    enable: int
    enable_low: bool


def wiring_of(signals: Signals) -> Wiring:
    """Return how a profile's drives are wired."""
    pins = signals.wired
    rows = []
    for motor, turning in zip(signals.motor_names, signals.motors, strict=True):
        step, direction = (pins.get(f"{motor}_{what}", 0) for what in ("step", "direction"))
        rows.append((abs(step) or -1, step < 0, abs(direction) or -1, direction < 0, turning.startswith("-")))
    enable = pins.get("enable", 0)
    return Wiring(np.array(rows, np.int64), abs(enable) or -1, enable < 0)


class Drives:
    """The drives of all motors; `take` gives pulses whose end has come, `settle` those that are long enough by now."""

    def __init__(self, signals: Signals):
        self.wiring = wiring_of(signals)
        self._needed = np.array([signals.pulse_us, signals.gap_us, signals.direction_setup_us]) * 1e-6 - ROUNDING_S
        count = len(self.wiring.motors)
        self._memory = np.zeros((count, 3), np.int64)
        self._times = np.full((count, 4), -math.inf)
        self._levels = pin_levels(*np.zeros((2, 1), np.uint8)).astype(np.int64)  # of the pins, before
        self.take(np.empty(0, np.uint32), NOTHING)  # compiles the kernel before a client comes

    def take(self, levels: np.ndarray, records: Records) -> Pulses:
        """Return the pulses that end within some writes; levels: uint32[k] of the pins, from each write on."""
        room = len(levels) * len(self._memory) + 1
        written = (np.empty(room), *(np.empty(room, np.int64) for _ in range(3)))
        count = read_edges(
            levels.astype(np.int64),
            *records[1:],
            self.wiring.motors,
            np.array([self.wiring.enable, self.wiring.enable_low], np.int64),
            self._needed,
            self._memory,
            self._times,
            self._levels,
            *written,
        )
        order = np.argsort(written[0][:count], kind="stable")
        return Pulses(*(column[:count][order] for column in written))

    def settle(self, now_s: float) -> Pulses:
        """Return the pulses that last on, and are long enough by now."""
        long_enough = now_s - self._times[:, STEP_ON] >= self._needed[WIDTH]
        motors = np.flatnonzero((self._memory[:, OPEN] == 1) & long_enough)
        self._memory[motors, OPEN] = 2
        return Pulses(self._times[motors, BEGUN], motors, self._memory[motors, SIGN], self._memory[motors, VERDICT])


@njit
def read_edges(
    levels, earliest, latest, at, motors, enable, needed, memory, times, before, pulse_at, pulse_of, signs, verdicts
):
    """Write the pulses that end within the rows of `levels`; returns their number."""
    count = 0
    last = before[0]
    for row in range(len(levels)):
        level = levels[row]
        changed = level ^ last
        last = level
        if changed == 0:
            continue
        is_off = enable[0] >= 0 and ((level >> enable[0]) & 1) == enable[1]
        for motor in range(len(motors)):
            wires = motors[motor]
            turned = wires[DIRECTION_PIN] >= 0 and (changed >> wires[DIRECTION_PIN]) & 1
            if turned:
                times[motor, TURNED] = earliest[row]
            if wires[STEP_PIN] < 0 or not (changed >> wires[STEP_PIN]) & 1:
                continue
            if ((level >> wires[STEP_PIN]) & 1) != wires[STEP_LOW]:
                backwards = wires[DIRECTION_PIN] >= 0 and (
                    ((level >> wires[DIRECTION_PIN]) & 1) != wires[DIRECTION_LOW]
                )
                memory[motor, SIGN] = -1 if backwards != (wires[REVERSED] != 0) else 1
                memory[motor, OPEN], memory[motor, VERDICT] = 1, GOOD
                if is_off:
                    memory[motor, VERDICT] = DRIVES_OFF
                elif (turned and needed[SETUP] > 0.0) or latest[row] - times[motor, TURNED] < needed[SETUP]:
                    memory[motor, VERDICT] = SHORT_SETUP
                elif latest[row] - times[motor, STEP_OFF] < needed[GAP]:
                    memory[motor, VERDICT] = SHORT_GAP
                times[motor, STEP_ON], times[motor, BEGUN] = earliest[row], at[row]
                continue
            times[motor, STEP_OFF] = earliest[row]
            if memory[motor, OPEN] == 1:
                if memory[motor, VERDICT] == GOOD and latest[row] - times[motor, STEP_ON] < needed[WIDTH]:
                    memory[motor, VERDICT] = SHORT_PULSE
                pulse_at[count], pulse_of[count] = times[motor, BEGUN], motor
                signs[count], verdicts[count] = memory[motor, SIGN], memory[motor, VERDICT]
                count += 1
            memory[motor, OPEN] = 0
    before[0] = last
    return count
