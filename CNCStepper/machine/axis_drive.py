# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arithmetic of one axis: motor or encoder, gear, and the screw or belt that moves it (source system E).

pulses ──► motor ──gear──► screw or pulley ──► axis            open loop: a pulse is a (micro)step of the motor
           n_s · m   r_g        p a turn         x
                                └──r_ge──► encoder             closed loop: a pulse is one that the encoder gives

n_p = x · n · r / p        f_p = v · n · r / (60 · p)          n · r = n_s · m · r_g, or the encoder's n_s · r_ge
N = v / p                  N_m = N · r_g                       r: its turns for one turn of screw or pulley

A worked problem of one axis: every quantity with the formula, the numbers in it, and what comes out.
"""

from __future__ import annotations

from typing import Annotated, NamedTuple

from pydantic import BaseModel, model_validator

from CNCStepper.quantities import Bounds, Length, Ratio
from CNCStepper.units import S_PER_MIN

TURN_DEG = 360.0


class Drive(BaseModel, extra="forbid", frozen=True, allow_inf_nan=False, defer_build=True):
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


USUAL_RATE_HZ = 25_000.0  # the pulse rate of a parallel port


class Answer(NamedTuple):
    """One quantity: its name with underscores, "n_p = 250 · 240 / 6", the value in its unit."""

    quantity: str
    working: str
    value: float
    unit: str


def answers(drive: Drive, distance_mm: float, feed_mm_min: float, rate_hz: float = USUAL_RATE_HZ) -> tuple[Answer, ...]:
    """Return all that is to be said of a drive that goes a distance at a feed, and its highest feed at a pulse rate."""
    p, n = _shown(drive.travel_per_turn_mm), _shown(drive.pulses_per_turn)
    x, v, f, gear = _shown(distance_mm), _shown(feed_mm_min), _shown(rate_hz), _shown(drive.gear_ratio)
    counted = _shown(drive.encoder_pulses_per_turn or drive.steps_per_turn * drive.microsteps)
    pulses = drive.pulses(distance_mm)
    return (
        Answer("travel_per_turn", _travel(drive), drive.travel_per_turn_mm, "mm"),
        Answer("pulse_angle", f"α = 360 / {counted}", drive.step_deg, "°"),
        Answer("pulses_per_turn", _per_turn(drive), drive.pulses_per_turn, ""),
        Answer("steps_per_mm", f"{n} / {p}", drive.pulses_per_mm, "1/mm"),
        Answer("resolution", f"{p} / {n}", drive.resolution_mm, "mm"),
        Answer("pulses", f"n_p = {x} · {n} / {p}", pulses, ""),
        Answer("reached", f"{round(pulses)} · {p} / {n}", drive.distance_mm(round(pulses)), "mm"),
        Answer("motor_angle", f"A_m = {x} · 360 · {gear} / {p}", drive.motor_deg(distance_mm), "°"),
        Answer("screw_speed", f"N = {v} / {p}", drive.rpm(feed_mm_min), "rpm"),
        Answer("motor_speed", f"N_m = {v} · {gear} / {p}", drive.motor_rpm(feed_mm_min), "rpm"),
        Answer("pulse_rate", f"f_p = {v} · {n} / (60 · {p})", drive.pulse_rate_hz(feed_mm_min), "Hz"),
        Answer("highest_feed", f"v_t = 60 · {p} · {f} / {n}", drive.feed_mm_min(rate_hz), "mm/min"),
    )


def _travel(drive: Drive) -> str:
    if drive.screw_pitch_mm:
        return f"p = {_shown(drive.screw_pitch_mm)}"
    return f"p = {_shown(drive.belt_pitch_mm or 0.0)} · {drive.pulley_teeth}"


def _per_turn(drive: Drive) -> str:
    if drive.encoder_pulses_per_turn:
        return f"n = {_shown(drive.encoder_pulses_per_turn)} · {_shown(drive.encoder_gear_ratio)}"
    micro = f" · {drive.microsteps}" if drive.microsteps > 1 else ""
    return f"n = {_shown(drive.steps_per_turn)}{micro} · {_shown(drive.gear_ratio)}"


def _shown(value: float) -> str:
    return f"{value:.10g}"


def shown(value: float) -> str:
    """Return a value with at most three decimals, with six where it is below one."""
    text = f"{value:.{3 if abs(value) >= 1 else 6}f}"
    return text.rstrip("0").rstrip(".") or "0"
