# SPDX-License-Identifier: LGPL-2.1-or-later
"""The codes of the spindle: S, M3, M4, M5, M19, and the ways to command its speed, G96 and G97.

A machine of this reader has one spindle, number 0; the word $ may name it, or -1 for all.
"""

from __future__ import annotations

from collections.abc import Callable

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects.codes import AXES, SPEED_LIMIT, SPINDLE, Code
from CNCStepper.gcode.interpreter.block import Block
from CNCStepper.gcode.interpreter.state.interpreter_state import NO_LIMIT, POWER_ON, rpm_at

START = {"cw": "START_SPINDLE_CLOCKWISE(0)", "ccw": "START_SPINDLE_COUNTERCLOCKWISE(0)"}
SENSES = {"M3": "cw", "M4": "ccw", "M5": "off"}
STOP = "STOP_SPINDLE_TURNING(0)"
FEET_PER_M = 1 / 0.3048


def check_spindle(block: Block) -> None:
    """Refuse a $ word that names a spindle which is not there."""
    most = block.dialect.spindles - 1
    if SPINDLE in block.plan.slots and block.value(SPINDLE) not in range(-1, most + 1):
        what = "the machine has one spindle, number 0" if not most else "the machine has no such spindle"
        limit = Text("0 to {most}, or -1", most=most) if most else "0 or -1"
        raise ProgramError("spindle-number", what, value=SPINDLE, limit=limit, advice="drop $")


def speed(block: Block, code: Code) -> None:
    """S: turns a minute, or under G96 the speed at the surface."""
    s_word = block.not_negative("S")
    check_spindle(block)
    if SPEED_LIMIT in block.plan.codes:
        return
    if block.model.state.surface_m_min:
        in_metres = s_word if block.model.state.units == "mm" else s_word / FEET_PER_M
        block.model.change(surface_m_min=in_metres)
        block.model.change(spindle_rpm=rpm_at(block.model, block.model.position))
    else:
        block.model.change(spindle_rpm=s_word)
    block.call(f"SET_SPINDLE_SPEED(0, {s_word:.4f})")


def surface_speed(block: Block, code: Code) -> None:
    """G96: S, which the line must hold, is metres (or feet) a minute at the distance X; D is the highest speed."""
    largest = abs(block.value("D")) if "D" in block.plan.slots else block.model.highest_rpm
    block.model.change(surface_m_min=NO_LIMIT, largest_rpm=largest)  # S gives it its value
    block.call(f"SET_SPINDLE_MODE(0 {largest:.4f})")


def speed_limit(block: Block, code: Code) -> None:
    """G50: S is the highest speed of the spindle under G96, from now on; it may not set the coordinates."""
    if block.plan.has(AXES):
        what = "G50 with coordinates moves the work zero"
        raise ProgramError("refused-code", what, value="G50", advice="set G54 on the machine, and write S alone")
    block.model.highest_rpm = block.not_negative("S")
    if block.model.state.surface_m_min:
        block.model.change(largest_rpm=block.model.highest_rpm)
        block.model.change(spindle_rpm=rpm_at(block.model, block.model.position))


def turning_speed(block: Block, code: Code) -> None:
    """G97: S is turns a minute from now on."""
    block.model.change(surface_m_min=0.0, largest_rpm=0.0)
    block.call("SET_SPINDLE_MODE(0 0.0000)")


def spindle(block: Block, code: Code) -> None:
    """M3, M4, M5: turn the spindle on or off."""
    check_spindle(block)
    turn(block, SENSES[code.name])


def turn(block: Block, sense: str) -> None:
    """Let the spindle turn "cw" or "ccw", or stop ("off")."""
    block.model.change(spindle=sense)
    if block.dialect.power == "switch":
        block.model.change(spindle_rpm=0.0 if sense == "off" else POWER_ON)
    block.call(START.get(sense, STOP))


def orient(block: Block, code: Code) -> None:
    """M19: stop the spindle at the angle R; Q: how long to wait for it at most, s."""
    check_spindle(block)
    slots = block.plan.slots
    angle = block.between("R", 0.0, 360.0) if "R" in slots else 0.0
    way = block.whole("P", 0, 2) if "P" in slots else 0
    block.model.change(spindle="off")
    if "R" in slots or "P" in slots:
        block.event("orient", angle)
        block.call(f"ORIENT_SPINDLE(0, {angle:.4f}, {way})")
    if "Q" in slots:
        if block.value("Q") <= 0:
            raise ProgramError("bad-value", "Q of M19 must be above 0", value="Q", advice="correct Q")
        block.call(f"SPINDLE.0.WAIT_ORIENT_COMPLETE({block.value('Q'):.4f})")


def need_turning(block: Block, name: str, sense: str = "") -> str:
    """Return the spindle's direction; raises ProgramError when it is stopped, or turns the other way."""
    turning = block.model.state.spindle
    if turning == "off" or (sense and turning != sense):
        needs = {
            "cw": Text("{name} needs the spindle to turn clockwise (M3)", name=name),
            "ccw": Text("{name} needs the spindle to turn counter-clockwise (M4)", name=name),
        }
        what = needs.get(sense, Text("{name} needs the spindle to turn", name=name))
        raise ProgramError(
            "spindle-stopped",
            what,
            value=name,
            advice=Text("write {word} before", word="M4" if sense == "ccw" else "M3"),
        )
    return turning


SPINDLE_ACTS: dict[str, Callable[[Block, Code], None]] = {
    act.__name__: act for act in (speed, speed_limit, surface_speed, turning_speed, spindle, orient)
}
