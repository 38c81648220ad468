# SPDX-License-Identifier: LGPL-2.1-or-later
"""The grbl parser, part two: a block is held against the machine's state and gets its target.

The order of the tests is the firmware's. Products and sums are rounded to 32-bit floats where the
result decides something, because an arc can pass in 64 bits and fail on the board.
"""

from __future__ import annotations

from math import sqrt

from CNCStepper.units import MM_PER_INCH
from CNCStepper.virtual.grbl.alarms_and_errors import refused
from CNCStepper.virtual.grbl.gcode import canned_cycles
from CNCStepper.virtual.grbl.gcode.block import (
    ARC_CW,
    ARCS,
    AXES,
    CANCELLED,
    CENTRES,
    CYCLES,
    DWELL,
    FEED,
    FIRST_SYSTEM,
    GO_HOME,
    MACHINE_MOVE,
    PLANES,
    PROBES,
    RAPID,
    SET_DATA,
    SET_OFFSET,
    AxisCommand,
    Block,
    Parser,
    Z,
)
from CNCStepper.virtual.grbl.gcode.words import f32

LARGEST_LINE_NUMBER = 10_000_000
JOG_GROUPS = {"G distance", "G units", "G action"}


def complete(block: Block, parser: Parser, places: dict[int, list[float]], outputs: int = 0) -> None:
    """Check a block against the state and fill in its feed, target, centre and radius.

    `places` are the stored work systems and homes, `outputs` the number of digital outputs. Raises MachineRefusal; the
    state is not touched.
    """
    if block.axis_words and block.axis_command is AxisCommand.NONE:
        block.axis_command = AxisCommand.MOTION
    if block.words.get("N", 0) > LARGEST_LINE_NUMBER:
        raise refused(27)
    block.feed = _feed(block, parser)
    block.rpm = block.words.get("S", parser.rpm)
    if block.action == DWELL:
        _use(block, "P", missing=28)
    if block.switches is not None:
        _check_output(block, outputs)
    _convert(block, AXES)
    if block.axis_command is AxisCommand.TOOL_LENGTH and block.modal.tool_length == 43 and block.axis_words != (Z,):
        raise refused(37)
    _check_action(block, parser, places)
    _check_motion(block, parser, places)
    _check_unused(block)
    if block.jog:
        _check_jog(block)


def _check_output(block: Block, outputs: int) -> None:
    number = _use(block, "P", missing=28)
    if number != int(number):
        raise refused(23)
    if number >= outputs:
        raise refused(39)


def _use(block: Block, letter: str, missing: int) -> float:
    """Return the value of a word that a command takes; raises error `missing` where there is none."""
    if letter not in block.words:
        raise refused(missing)
    block.unused.discard(letter)
    return block.words[letter]


def _mm(block: Block, value: float) -> float:
    return f32(value * MM_PER_INCH) if block.modal.units == 20 else value


def _convert(block: Block, letters: str) -> None:
    for letter in letters:
        if letter in block.words:
            block.words[letter] = _mm(block, block.words[letter])


def _feed(block: Block, parser: Parser) -> float:
    """Return the block's feed, mm/min or, in G93, moves a minute; 0 where none is known."""
    if block.jog:
        return _mm(block, _use(block, "F", missing=22))
    given = block.words.get("F", 0.0)
    if block.modal.feed_mode == 93:
        cuts = block.axis_command is AxisCommand.MOTION and block.modal.motion not in (CANCELLED, RAPID)
        if cuts and "F" not in block.words:
            raise refused(22)
        return given
    if parser.modal.feed_mode == 93:  # back from inverse time: nothing is known but what the block says
        return given
    return _mm(block, given) if "F" in block.words else parser.feed


def _check_action(block: Block, parser: Parser, places: dict[int, list[float]]) -> None:
    if block.action == SET_DATA:
        _check_set_data(block, parser, places)
    elif block.action == SET_OFFSET:
        if not block.axis_words:
            raise refused(26)
        block.target = list(parser.g92)
        for axis in block.axis_words:
            here = f32(parser.position[axis] - _system_offset(block, parser, places)[axis])
            block.target[axis] = _less_tool(f32(here - block.words[AXES[axis]]), axis, parser)
    else:
        if block.axis_command is not AxisCommand.TOOL_LENGTH:
            _set_target(block, parser, _system_offset(block, parser, places))
        if block.action in GO_HOME:
            _check_go_home(block, parser, places)
        if block.action == MACHINE_MOVE and block.modal.motion not in (RAPID, FEED):
            raise refused(30)


def _system_offset(block: Block, parser: Parser, places: dict[int, list[float]]) -> list[float]:
    changed = block.modal.system != parser.modal.system
    return places[block.modal.system] if changed else parser.system_offset


def _less_tool(value: float, axis: int, parser: Parser) -> float:
    return f32(value - parser.tool_length) if axis == Z else value


def _check_set_data(block: Block, parser: Parser, places: dict[int, list[float]]) -> None:
    """G10 L2 and L20. Without P the system in force is meant; only when P and L both lack is that an error."""
    if not block.axis_words:
        raise refused(26)
    if "P" not in block.words and "L" not in block.words:
        raise refused(28)
    number = int(block.words.get("P", 0))
    if number and FIRST_SYSTEM - 1 + number not in places:
        raise refused(29)
    kind = int(block.words.get("L", 0))
    if kind not in (2, 20) or (kind == 2 and "R" in block.words):
        raise refused(20)
    block.unused -= {"P", "L"}
    block.system = FIRST_SYSTEM - 1 + number if number else block.modal.system
    block.centre = list(places[block.system])
    for axis in block.axis_words:
        value = block.words[AXES[axis]]
        if kind == 20:
            value = _less_tool(f32(f32(parser.position[axis] - parser.g92[axis]) - value), axis, parser)
        block.centre[axis] = value


def _set_target(block: Block, parser: Parser, system_offset: list[float]) -> None:
    """Target in machine coordinates; an axis without a word stays where it is."""
    block.target = list(parser.position)
    for axis in block.axis_words:
        value = block.words[AXES[axis]]
        if block.action != MACHINE_MOVE:
            if block.modal.distance == 91:
                value = f32(value + parser.position[axis])
            else:
                value = f32(value + f32(system_offset[axis] + parser.g92[axis]))
                value = f32(value + parser.tool_length) if axis == Z else value
        block.target[axis] = value


def _check_go_home(block: Block, parser: Parser, places: dict[int, list[float]]) -> None:
    block.centre = list(places[block.action // 10])
    if not block.axis_words:
        block.axis_command = AxisCommand.NONE  # no way over an intermediate point
        return
    for axis in set(range(3)) - set(block.axis_words):
        block.centre[axis] = parser.position[axis]


def _check_motion(block: Block, parser: Parser, places: dict[int, list[float]]) -> None:
    if block.modal.motion == CANCELLED:
        if block.axis_words:
            raise refused(31)
        return
    if block.axis_command is not AxisCommand.MOTION:
        return
    if block.modal.motion != RAPID and block.feed == 0:
        raise refused(22)
    if block.modal.motion in (RAPID, FEED):
        if not block.axis_words:
            block.axis_command = AxisCommand.NONE
        return
    if not block.axis_words:
        raise refused(26)
    if block.modal.motion in ARCS:
        _check_arc(block, parser)
    elif block.modal.motion in CYCLES:
        _check_drilling(block, parser, places)
    elif block.modal.motion in PROBES and block.target == parser.position:
        raise refused(33)


def _check_drilling(block: Block, parser: Parser, places: dict[int, list[float]]) -> None:
    axis = PLANES[block.modal.plane][2]
    zero_mm = _system_offset(block, parser, places)[axis] + parser.g92[axis]
    canned_cycles.complete(block, parser, zero_mm + (parser.tool_length if axis == Z else 0.0), _mm(block, 1.0))


def _check_arc(block: Block, parser: Parser) -> None:
    first, second, _ = PLANES[block.modal.plane]
    if not {first, second} & set(block.axis_words):
        raise refused(32)
    x = f32(block.target[first] - parser.position[first])
    y = f32(block.target[second] - parser.position[second])
    if "R" in block.words:
        _centre_from_radius(block, parser, x, y)
    else:
        _radius_from_centre(block, x, y)


def _centre_from_radius(block: Block, parser: Parser, x: float, y: float) -> None:
    """Find the centre from R: half the chord away from its middle, on the side that the sense and the sign say.

    With d the chord and h the distance of the centre from it:  h^2 = r^2 - (d/2)^2.
    """
    radius = _mm(block, _use(block, "R", missing=35))
    if block.target == parser.position:
        raise refused(33)
    four_h_squared = f32(f32(f32(f32(4 * radius) * radius) - f32(x * x)) - f32(y * y))
    if four_h_squared < 0:
        raise refused(34)
    two_h_by_d = f32(sqrt(four_h_squared)) / _length(x, y)
    if (block.modal.motion == ARC_CW) != (radius < 0):  # a negative R asks for the arc over half a turn
        two_h_by_d = -two_h_by_d
    first, second, _ = PLANES[block.modal.plane]
    block.centre[first] = f32(0.5 * (x - y * two_h_by_d))
    block.centre[second] = f32(0.5 * (y + x * two_h_by_d))
    block.radius = abs(radius)


def _radius_from_centre(block: Block, x: float, y: float) -> None:
    """Check I J K: both ends must lie on one circle, within 0.005 mm or, if larger, 0.1 % but never 0.5 mm."""
    first, second, _ = PLANES[block.modal.plane]
    if not {CENTRES[first], CENTRES[second]} & set(block.words):
        raise refused(35)
    block.unused -= set(CENTRES)
    _convert(block, CENTRES)
    block.centre = [block.words.get(letter, 0.0) for letter in CENTRES]
    end_radius = _length(f32(x - block.centre[first]), f32(y - block.centre[second]))
    block.radius = _length(block.centre[first], block.centre[second])
    apart = abs(f32(end_radius - block.radius))
    if apart > f32(0.005) and (apart > 0.5 or apart > f32(f32(0.001) * block.radius)):
        raise refused(33)


def _length(x: float, y: float) -> float:
    return f32(sqrt(f32(f32(x * x) + f32(y * y))))


def _check_unused(block: Block) -> None:
    block.unused -= set("NF") if block.jog else set("NFST")
    if block.axis_command is not AxisCommand.NONE:
        block.unused -= set(AXES)
    if block.unused:
        raise refused(36)


def _check_jog(block: Block) -> None:
    if block.groups - JOG_GROUPS or block.action not in (0, MACHINE_MOVE):
        raise refused(16)
    if not block.axis_words:
        raise refused(26)
