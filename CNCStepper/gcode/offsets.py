# SPDX-License-Identifier: LGPL-2.1-or-later
"""The codes that move coordinates or go to stored positions: G10, G28, G30, G43, G49, G54 to G59.3, G92.

Each function is one act of `codes.Code`; it changes the block's copy of the model only.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.codes import Code
from CNCStepper.gcode.model import HOMES, ZERO, Point
from CNCStepper.gcode.moves import end_point
from CNCStepper.state import UNKNOWN, WORK_SYSTEMS

if TYPE_CHECKING:
    from CNCStepper.gcode.execute import Execution

SET_G92 = "SET_G92_OFFSET({}, {}, {}, 0.0000, 0.0000, 0.0000)"
SET_WORK = "SET_G5X_OFFSET(%d, {}, {}, {}, 0.0000, 0.0000, 0.0000)"
SET_TOOL_LENGTH = "USE_TOOL_LENGTH_OFFSET(0.0000 0.0000 {}, 0.0000 0.0000 0.0000, 0.0000 0.0000 0.0000)"


def tool_length(block: Execution, code: Code) -> None:
    length = 0.0
    if code.name == "G43.1":
        length = _dynamic_length(block)
    elif code.name == "G43":
        length = _table_length(block)
    block.model.change_offset(tool_length_mm=length)
    block.lengths(SET_TOOL_LENGTH, length)


def _dynamic_length(block: Execution) -> float:
    for axis in "XY":
        if axis in block.plan.slots:
            raise ProgramError("unused-word", "a tool length lies along Z only", value=axis, advice=f"drop {axis}")
    return block.value("Z") * block.model.scale if "Z" in block.plan.slots else block.model.state.tool_length_mm


def _table_length(block: Execution) -> float:
    tool = block.whole("H", 0, block.dialect.largest_tool) if "H" in block.plan.slots else block.model.state.tool
    if tool == 0:
        return 0.0
    if tool not in block.model.tool_lengths:
        what = f"the length of tool {tool} is not known"
        raise ProgramError("tool-length", what, value="G43", advice="give the tool's length with the start state")
    return block.model.tool_lengths[tool]


def work_system(block: Execution, code: Code) -> None:
    if code.name == block.model.state.work_system:
        block.call('COMMENT("interpreter: continuing to use same coordinate system")')
        return
    block.model.change_offset(work_system=code.name)
    say_work_offset(block)
    block.lengths(SET_G92, *block.model.state.g92_mm)
    block.call("SET_XY_ROTATION(0.0000)")


def say_work_offset(block: Execution) -> None:
    number = WORK_SYSTEMS.index(block.model.state.work_system) + 1
    block.lengths(SET_WORK % number, *block.model.work_offset())


def set_offset(block: Execution, code: Code) -> None:
    """G10 L2: the offset itself; G10 L20: the offset at which the position has the given coordinates."""
    kind = block.whole("L", 0, 20)
    if kind not in (2, 20):
        what = "G10 is read with L2 and L20 only"
        raise ProgramError("not-supported", what, value="L", advice="set tool tables on the machine")
    number = block.whole("P", 0, block.dialect.work_systems, "work-system")
    name = WORK_SYSTEMS[number - 1] if number else block.model.state.work_system
    offset = list(block.model.work_offsets.get(name, ZERO))
    for axis, slot in enumerate(block.plan.axes):
        if slot >= 0:
            value = block.values[slot] * block.model.scale
            offset[axis] = value if kind == 2 else _without_shifts(block, axis) - value
    block.model.work_offsets = {**block.model.work_offsets, name: (offset[0], offset[1], offset[2])}
    if name == block.model.state.work_system:
        block.model.change_offset()
        say_work_offset(block)
        block.call("SET_XY_ROTATION(0.0000)")
    else:
        block.call('COMMENT("interpreter: setting coordinate system origin")')


def _without_shifts(block: Execution, axis: int) -> float:
    """Return the position along one axis without G92 and tool length."""
    state = block.model.state
    length = state.tool_length_mm if axis == 2 else 0.0
    return block.known(axis) - state.g92_mm[axis] - length


def set_g92(block: Execution, code: Code) -> None:
    g92 = list(block.model.state.g92_mm)
    for axis, slot in enumerate(block.plan.axes):
        if slot >= 0:
            # today's work position becomes the given value; what G92 already shifts comes on top
            work = block.known(axis) - block.model.offset[axis]
            g92[axis] += work - block.values[slot] * block.model.scale
    block.model.g92_kept = (g92[0], g92[1], g92[2])
    _use_g92(block, block.model.g92_kept)


def clear_g92(block: Execution, code: Code) -> None:
    block.model.g92_kept = ZERO
    _use_g92(block, ZERO)


def suspend_g92(block: Execution, code: Code) -> None:
    _use_g92(block, ZERO)


def restore_g92(block: Execution, code: Code) -> None:
    _use_g92(block, block.model.g92_kept)


def _use_g92(block: Execution, g92: Point) -> None:
    block.model.change_offset(g92_mm=g92)
    block.lengths(SET_G92, *g92)


def keep_home(block: Execution, code: Code) -> None:
    first = HOMES[code.name[:3]]
    kept = {first + axis: block.known(axis) for axis in range(3)}
    block.model.homes = {**block.model.homes, **kept}


def go_home(block: Execution, code: Code) -> None:
    """G28, G30: first to the point given, then the named axes (or all) to the stored position."""
    first = HOMES[code.name]
    named = [axis for axis, slot in enumerate(block.plan.axes) if slot >= 0]
    home = list(end_point(block.model, block.plan, block.values))
    block.rapid((home[0], home[1], home[2]), row=bool(named))
    for axis in named or range(3):
        home[axis] = _home(block, first + axis, code)
    block.rapid((home[0], home[1], home[2]))


def _home(block: Execution, parameter: int, code: Code) -> float:
    if parameter not in block.model.homes:
        what = f"the position stored for {code.name} is not known"
        advice = f"give parameters {HOMES[code.name]} to {HOMES[code.name] + 2} with the start state, or use G53"
        raise ProgramError("unknown-position", what, value=code.name, advice=advice)
    # a machine position has no place in a table whose work zero is not known
    return block.model.homes[parameter] if block.model.zero_known else UNKNOWN


OFFSET_ACTS: dict[str, Callable[[Execution, Code], None]] = {
    act.__name__: act
    for act in (
        tool_length,
        work_system,
        set_offset,
        set_g92,
        clear_g92,
        suspend_g92,
        restore_g92,
        keep_home,
        go_home,
    )
}
