# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rotor of a stepper motor behind its field: it follows, lags, and falls out of step where that is too fast.

    torque = A sin(pi/2 (field - rotor) / m)      in pulses/s², m pulses a full step: it repeats every four full steps,
                                                  so that a rotor that falls out of step loses four of them at a time
    A falls evenly to nothing at the pull-out speed; the drive damps the rotor's swing about a field that it follows.

From rest the rotor follows a field that jumps to v0 = sqrt(8 m A / pi) at once: the start/stop speed.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from CNCStepper.kernels import njit
from CNCStepper.machine.profile import Axis

MARGIN = 1.5  # of a motor over what its axis' profile asks of it
DAMPING = 0.5
STEPWISE = 4.0  # a field that goes on in whole steps needs so many times the torque of one that turns evenly
STEPS_A_RADIAN = 20.0  # of the computation, for one radian of the rotor's own swing
SETTLE_S = 0.5  # longest computed after the last pulse; the swing has died out by then
PLACE, SPEED, TIME, FIELD, FIELD_SPEED, FIELD_TIME, POWER = range(7)  # of the kernel's memory


@dataclass(frozen=True)
class MotorLimits:
    """Limits of a motor: acceleration at standstill and pull-out speed, in pulses; microsteps a full step."""

    acceleration_pulses_s2: float
    pull_out_pulses_s: float
    microsteps: int = 1

    @property
    def start_stop_pulses_s(self) -> float:
        """The speed to which the field may jump from rest."""
        return math.sqrt(8.0 * self.microsteps * self.acceleration_pulses_s2 / math.pi)


def limits_of(axis: Axis, margin: float = MARGIN, start_stop_pulses_s: float = 0.0) -> MotorLimits:
    """Return a motor that can do `margin` times what an axis' profile asks at its greatest rate.

    start_stop_pulses_s: the least start/stop speed that it has; what the acceleration gives when it is above that.
    """
    microsteps = axis.drive.microsteps if axis.drive else 1
    pull_out = 2.0 * margin * axis.max_rate_mm_min / 60.0 * axis.steps_per_mm
    at_rest = STEPWISE * margin * axis.acceleration_mm_s2 * axis.steps_per_mm
    return MotorLimits(
        max(at_rest, start_stop_pulses_s**2 * math.pi / (8.0 * microsteps)), max(pull_out, 1.0), microsteps
    )


class Rotor:
    """One rotor, in pulses from where it began; without limits it is at once where the field pulls it.

    A field exactly two full steps away pulls nowhere: the rotor stays, as it does without current.
    """

    def __init__(self, limits: MotorLimits | None = None, microsteps: int = 1, place: float = 0.0):
        self._limits = limits
        self._microsteps = limits.microsteps if limits else microsteps
        self._memory = np.zeros(7)
        self._memory[[PLACE, FIELD]] = place
        self._memory[POWER] = 1.0
        if limits:
            self._swing(np.empty(0), np.empty(0), np.empty(0))  # compiles the kernel before a client comes

    @property
    def place(self) -> float:
        """Where the rotor is now."""
        return float(self._memory[PLACE])

    def turn(self, times_s: np.ndarray, fields: np.ndarray, powered: np.ndarray) -> np.ndarray:
        """Let the field stand at `fields` from `times_s` on, with current where `powered`; return the places there.

        times_s, fields: float64[k]; powered: bool[k]. A rotor with limits is where it was when the field moved.
        """
        if not len(times_s):
            return np.empty(0)
        if self._limits:
            return self._swing(times_s, fields, powered.astype(np.float64))
        places = self._jump(fields, powered)
        self._memory[PLACE], self._memory[TIME] = places[-1], times_s[-1]
        return places

    def settle(self, now_s: float) -> float:
        """Let time pass without a pulse, and return the place."""
        if self._limits and now_s > self._memory[TIME]:
            self._swing(np.array([now_s]), self._memory[[FIELD]], self._memory[[POWER]])
        return self.place

    def _swing(self, times_s: np.ndarray, fields: np.ndarray, powered: np.ndarray) -> np.ndarray:
        limits = self._limits
        assert limits
        constants = (limits.acceleration_pulses_s2, limits.pull_out_pulses_s, float(limits.microsteps))
        places = np.empty(len(times_s))
        follow(times_s, fields, powered, *constants, self._memory, places)
        return places

    def _jump(self, fields: np.ndarray, powered: np.ndarray) -> np.ndarray:
        full = float(self._microsteps)
        before = np.concatenate(([self._memory[PLACE]], fields[:-1]))
        if powered.all() and (np.abs(fields - before) < 2.0 * full).all():
            return fields.astype(np.float64)
        places, place = np.empty(len(fields)), float(self._memory[PLACE])
        for row, field in enumerate(fields):
            away = (field - place + 2.0 * full) % (4.0 * full) - 2.0 * full
            if powered[row] and away > -2.0 * full:
                place += away
            places[row] = place
        return places


@njit
def follow(times_s, fields, powered, acceleration, pull_out, microsteps, memory, places):
    """Compute a rotor up to each time; from there on the field stands at the row's place, with its share of current."""
    turn = math.pi / (2.0 * microsteps)
    swing = math.sqrt(acceleration * turn)
    start_stop = math.sqrt(8.0 * microsteps * acceleration / math.pi)
    damping = 2.0 * DAMPING * swing
    place, speed, now = memory[PLACE], memory[SPEED], memory[TIME]
    field, field_speed, field_time, power = memory[FIELD], memory[FIELD_SPEED], memory[FIELD_TIME], memory[POWER]
    for row in range(len(times_s)):
        end = times_s[row]
        span = min(max(end - now, 0.0), SETTLE_S)
        count = int(span * swing * STEPS_A_RADIAN) + 1
        step = span / count
        at = now
        for _ in range(count):
            at += step
            seen = field_speed
            if at - field_time > 1e-12 and abs(seen) > 1.0 / (at - field_time):
                seen = math.copysign(1.0 / (at - field_time), seen)
            torque = acceleration * max(0.0, 1.0 - abs(speed) / pull_out) * math.sin(turn * (field - place))
            slip = seen - speed
            pulled = power * (torque + (damping * slip if abs(slip) < start_stop else 0.0))
            if power == 0.0:
                pulled = -damping * speed
            speed += pulled * step
            place += speed * step
        if end - now > SETTLE_S and power > 0.0:  # the swing has died out
            place, speed = field - 4.0 * microsteps * round((field - place) / (4.0 * microsteps)), 0.0
        now = max(now, end)
        moved = fields[row] - field
        if moved != 0.0:
            field_speed = moved / max(now - field_time, 1e-9)
            field_time = now
        field, power = fields[row], powered[row]
        places[row] = place
    memory[PLACE], memory[SPEED], memory[TIME] = place, speed, now
    memory[FIELD], memory[FIELD_SPEED], memory[FIELD_TIME], memory[POWER] = field, field_speed, field_time, power
