# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arithmetic of one axis: motor or encoder, gear, and the screw or belt that moves it (source system E).

pulses ──► motor ──gear──► screw or pulley ──► axis            open loop: a pulse is a (micro)step of the motor
           n_s · m   r_g        p a turn         x
                                └──r_ge──► encoder             closed loop: a pulse is one that the encoder gives

n_p = x · n · r / p        f_p = v · n · r / (60 · p)          n · r = n_s · m · r_g, or the encoder's n_s · r_ge
N = v / p                  N_m = N · r_g                       r: its turns for one turn of screw or pulley
"""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel, model_validator

from CNCStepper.quantities import Bounds, Length, Ratio
from CNCStepper.units import S_PER_MIN

TURN_DEG = 360.0


class Drive(BaseModel, extra="forbid", frozen=True, allow_inf_nan=False):
    """What turns pulses into travel; either a screw or a belt on a pulley, with an encoder where the loop is closed.

    steps_per_turn: of the motor, full steps. gear_ratio: turns of the motor for one of screw or pulley.
    screw_pitch_mm: travel a turn, of a screw with several starts its lead. encoder_pulses_per_turn: as they are
    counted, so four times the lines of an encoder that is read in quadrature. encoder_gear_ratio: turns of the
    encoder for one of screw or pulley.
    """

    steps_per_turn: Annotated[float, Bounds("steps_per_turn")] = 200.0
    microsteps: Annotated[int, Bounds("count", most=4096)] = 1
    gear_ratio: Ratio = 1.0
    screw_pitch_mm: Length | None = None
    belt_pitch_mm: Length | None = None
    pulley_teeth: Annotated[int, Bounds("count", most=10_000)] | None = None
    encoder_pulses_per_turn: Annotated[float, Bounds("steps_per_turn")] | None = None
    encoder_gear_ratio: Ratio = 1.0

    @model_validator(mode="after")
    def _moves_by_screw_or_belt(self) -> Drive:
        belt = (self.belt_pitch_mm is not None, self.pulley_teeth is not None)
        if any(belt) != all(belt):
            raise ValueError("belt_pitch_mm and pulley_teeth belong together")
        if all(belt) == (self.screw_pitch_mm is not None):
            raise ValueError("give either screw_pitch_mm, or belt_pitch_mm and pulley_teeth")
        return self

    @property
    def closed_loop(self) -> bool:
        """Whether an encoder counts the pulses."""
        return self.encoder_pulses_per_turn is not None

    @property
    def travel_per_turn_mm(self) -> float:
        """The travel of the axis for a turn of screw or pulley, p."""
        return self.screw_pitch_mm or (self.belt_pitch_mm or 0.0) * (self.pulley_teeth or 0)

    @property
    def travel_per_motor_turn_mm(self) -> float:
        """The travel of the axis for a turn of the motor."""
        return self.travel_per_turn_mm / self.gear_ratio

    @property
    def step_deg(self) -> float:
        """The angle of one pulse at the shaft that it is counted on, α."""
        return TURN_DEG / (self.encoder_pulses_per_turn or self.steps_per_turn * self.microsteps)

    @property
    def pulses_per_turn(self) -> float:
        """The pulses for a turn of screw or pulley, n · r."""
        if self.encoder_pulses_per_turn is not None:
            return self.encoder_pulses_per_turn * self.encoder_gear_ratio
        return self.steps_per_turn * self.microsteps * self.gear_ratio

    @property
    def pulses_per_mm(self) -> float:
        """The pulses for one mm of travel: `steps_per_mm` of an axis."""
        return self.pulses_per_turn / self.travel_per_turn_mm

    @property
    def resolution_mm(self) -> float:
        """The travel of one pulse."""
        return self.travel_per_turn_mm / self.pulses_per_turn

    def pulses(self, distance_mm: float) -> float:
        """Return the pulses of a distance, n_p; a machine can send whole ones only."""
        return distance_mm * self.pulses_per_turn / self.travel_per_turn_mm

    def distance_mm(self, pulses: float) -> float:
        """Return the travel of so many pulses, x."""
        return pulses * self.travel_per_turn_mm / self.pulses_per_turn

    def turn_deg(self, distance_mm: float) -> float:
        """Return the angle of screw or pulley for a distance, A."""
        return distance_mm * TURN_DEG / self.travel_per_turn_mm

    def motor_deg(self, distance_mm: float) -> float:
        """Return the motor's angle for a distance, A_m."""
        return self.turn_deg(distance_mm) * self.gear_ratio

    def rpm(self, feed_mm_min: float) -> float:
        """Return how fast screw or pulley turns at a feed, N."""
        return feed_mm_min / self.travel_per_turn_mm

    def motor_rpm(self, feed_mm_min: float) -> float:
        """Return how fast the motor turns at a feed, N_m."""
        return feed_mm_min * self.gear_ratio / self.travel_per_turn_mm

    def pulse_rate_hz(self, feed_mm_min: float) -> float:
        """Return the pulses a second at a feed, f_p."""
        return feed_mm_min * self.pulses_per_turn / (S_PER_MIN * self.travel_per_turn_mm)

    def feed_mm_min(self, pulse_rate_hz: float) -> float:
        """Return the feed at so many pulses a second, v_t: the highest one where more pulses cannot be made."""
        return S_PER_MIN * self.travel_per_turn_mm * pulse_rate_hz / self.pulses_per_turn
