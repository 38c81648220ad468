# SPDX-License-Identifier: LGPL-2.1-or-later
"""The homing cycle: Z first, then X and Y; to the switches, back, slowly to them again, back."""

from __future__ import annotations

from math import sqrt

from CNCStepper.virtual.grbl.board import Board, Waiting
from CNCStepper.virtual.grbl.gcode.block import X, Y, Z
from CNCStepper.virtual.grbl.settings import DEBOUNCE_MS, HOMING_FEED, HOMING_SEEK, HOMING_SIDES, PULL_OFF, TRAVEL
from CNCStepper.virtual.grbl.states import State

CYCLES = ((Z,), (X, Y))


def run(machine: Board) -> Waiting:
    """Home all axes; afterwards the machine is idle and its position is true."""
    machine.state = State.HOME
    machine.override_motion()
    for axes in CYCLES:
        yield from _home(machine, axes)
    machine.sync_position()
    machine.finish_cycle()


def _home(machine: Board, axes: tuple[int, ...]) -> Waiting:
    settings = machine.memory.settings
    for rate in (settings[HOMING_SEEK], settings[HOMING_FEED]):
        yield from _approach(machine, axes, rate)
        yield from _pull_off(machine, axes)
    for axis in axes:
        place = -settings[TRAVEL + axis] + settings[PULL_OFF] if _is_low(machine, axis) else -settings[PULL_OFF]
        machine.axes.set_position(axis, place)


def _is_low(machine: Board, axis: int) -> bool:
    return bool(int(machine.memory.settings[HOMING_SIDES]) & (1 << axis))


def _approach(machine: Board, axes: tuple[int, ...], rate_mm_min: float) -> Waiting:
    """Move all axes together until the nearest switch closes, then the others, until all stand on theirs."""
    while ways := {axis: way for axis in axes if (way := machine.axes.to_switch_mm(axis, _is_low(machine, axis)))}:
        nearest = min(abs(way) for way in ways.values())
        step = {axis: nearest if way > 0 else -nearest for axis, way in ways.items()}
        yield from _move(machine, step, rate_mm_min)
        if all(abs(way) < machine.axes.step_mm(axis) for axis, way in ways.items()):
            break
    yield from machine.wait(machine.memory.settings[DEBOUNCE_MS] / 1000)


def _pull_off(machine: Board, axes: tuple[int, ...]) -> Waiting:
    settings = machine.memory.settings
    way = settings[PULL_OFF]
    yield from _move(machine, {axis: way if _is_low(machine, axis) else -way for axis in axes}, settings[HOMING_SEEK])
    yield from machine.wait(settings[DEBOUNCE_MS] / 1000)


def _move(machine: Board, ways_mm: dict[int, float], rate_mm_min: float) -> Waiting:
    """Move each axis by its own way; the rate is that of a single axis."""
    target = machine.axes.position_mm
    for axis, way in ways_mm.items():
        target[axis] += way
    machine.axes.line(target, rate_mm_min * sqrt(len(ways_mm)), rapid=False)
    while not machine.axes.idle:
        yield
