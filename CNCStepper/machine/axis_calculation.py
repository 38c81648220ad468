# SPDX-License-Identifier: LGPL-2.1-or-later
"""A worked problem of one axis: every quantity with the formula, the numbers in it, and what comes out."""

from __future__ import annotations

from typing import NamedTuple

from CNCStepper.machine.axis_drive import Drive

USUAL_RATE_HZ = 25_000.0  # what a parallel port is asked for


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
