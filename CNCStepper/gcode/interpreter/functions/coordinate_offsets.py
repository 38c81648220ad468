# SPDX-License-Identifier: LGPL-2.1-or-later
"""The codes that move coordinates or go to stored positions: G10 L2 L20, G28, G30, G52, G54 to G59.3, G92.

Each function is one act of `codes.Code`; it changes the block's copy of the model only. Offsets have nine axes, mm and
degrees, and live in the parameters, as those of LinuxCNC do:

    machine = origin + tool + turn (work + G92)      origin, turn: of the work system;  G92: turns with it
"""

from __future__ import annotations

from collections.abc import Callable
from math import isnan

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects.codes import Code
from CNCStepper.gcode.interpreter.block import Block
from CNCStepper.gcode.interpreter.functions.tools import set_tool
from CNCStepper.gcode.interpreter.motion.end_points import end_point, further_end
from CNCStepper.gcode.interpreter.state.interpreter_state import Model, Point, saved_g92
from CNCStepper.gcode.interpreter.state.parameters import (
    FIRST_G92,
    G92_IN_FORCE,
    ROTATION,
    WORK_SYSTEM,
    offset_number,
    store_point,
    stored_point,
)
from CNCStepper.gcode.interpreter.state.stand_alone_position import continue_at, use_system
from CNCStepper.state import UNKNOWN, WORK_SYSTEMS, ZERO9

HOMES = {"G28": 5161, "G30": 5181}  # first parameter of each stored position (machine coordinates)
SIX = "{}, {}, {}, {}, {}, {}"
SET_G92 = f"SET_G92_OFFSET({SIX})"
SET_WORK = f"SET_G5X_OFFSET(%d, {SIX})"


def work_system(block: Block, code: Code) -> None:
    """G54 to G59.3: the work system that is in force from now on."""
    block.uncompensated("coordinate systems may not be changed", code.name)
    if code.name == block.model.state.work_system:
        block.call('COMMENT("interpreter: continuing to use same coordinate system")')
        return
    model = block.model
    model.parameters.set(WORK_SYSTEM, WORK_SYSTEMS.index(code.name) + 1.0)
    use_system(model, code.name)
    emit_work_offset(block)
    block.point(SET_G92, model.g92)
    emit_rotation(block)


def emit_work_offset(block: Block) -> None:
    """Emit the canonical call of the work system in force."""
    number = WORK_SYSTEMS.index(block.model.state.work_system) + 1
    block.point(SET_WORK % number, block.model.origin)


def emit_rotation(block: Block) -> None:
    """Emit the canonical call of its turn about Z."""
    block.call(f"SET_XY_ROTATION({block.model.state.rotation_deg:.4f})")


def set_table(block: Block, code: Code) -> None:
    """G10: L2 and L20 set an offset, L1, L10 and L11 a tool."""
    kind = block.whole("L", 0, 20)
    if kind in (0, 1, 10, 11):
        set_tool(block, kind)
        return
    if kind not in (2, 20):
        what = "G10 is read with L1, L2, L10, L11 and L20 only"
        raise ProgramError("not-supported", what, value="L", advice="correct L")
    others = "".join(code.takes for code in block.plan.codes if code.name != "G10")
    for letter in "IJQ" if kind == 2 else "IJQR":
        if letter in block.plan.slots and letter not in others:
            raise ProgramError(
                "unused-word",
                Text("{letter} has no meaning with G10 L{kind}", letter=letter, kind=kind),
                value=letter,
                advice="drop it",
            )
    block.must_have("P", "G10")
    number = block.whole("P", 0, block.dialect.work_systems, "work-system")
    _set_system(block, WORK_SYSTEMS[number - 1] if number else block.model.state.work_system, kind)


def _set_system(block: Block, name: str, kind: int) -> None:
    """G10 L2: the offset itself; G10 L20: the offset at which the position has the given coordinates."""
    model = block.model
    in_force = name == model.state.work_system
    if in_force:
        block.uncompensated("the coordinate system in force may not be changed", "G10")
    words = block.axis_words()
    first = offset_number(name)
    if "R" in block.plan.slots:
        model.parameters.set(first + ROTATION, block.value("R"))
    if kind == 20:
        words = _origin_for(block, name, words)
    store_point(model.parameters, first, [words.get(axis, 0.0) for axis in range(9)], model.unit_mm, words)
    if in_force:
        _turn_in_force(model, name)
        emit_work_offset(block)
        emit_rotation(block)
    else:
        block.call('COMMENT("interpreter: setting coordinate system origin")')


def _turn_in_force(model: Model, name: str) -> None:
    """Set the new origin and rotation; as in LinuxCNC, G92 does not turn with them."""
    x, y, z = model.work(model.position)
    before = complex(x, y) * (model.turn or 1.0) + complex(*model.origin[:2])
    z += model.origin[2]
    use_system(model, name)
    if any(model.g92[:2]) and not isnan(before.real):
        flat = (before - complex(*model.origin[:2])) / (model.turn or 1.0)
        continue_at(model, model.machine((flat.real, flat.imag, z - model.origin[2])))


def _origin_for(block: Block, name: str, words: dict[int, float]) -> dict[int, float]:
    """Return the origin at which the position has the coordinates `words`, for their axes (X and Y turn together)."""
    system = block.model.copy()
    for axis in range(2) if system.parameters.get(offset_number(name) + ROTATION) else words:
        block.known(axis)
    system.use_system(name)
    origin, turn = list(system.origin), system.turn or 1.0
    here = (*system.work(system.position), *system.further_work())
    shift = [here[axis] - words.get(axis, here[axis]) for axis in range(9)]
    if set(words) & {0, 1}:
        flat = complex(*shift[:2]) * turn
        shift[:2] = flat.real, flat.imag
        words = {0: 0.0, 1: 0.0} | words
    return {axis: origin[axis] + (0.0 if isnan(shift[axis]) else shift[axis]) for axis in words}


def set_g92(block: Block, code: Code) -> None:
    """G92: today's work position gets the given coordinates; what G92 shifts already comes on top."""
    block.uncompensated("axis offsets may not be changed", code.name)
    model = block.model
    g92 = list(model.g92)
    words = block.axis_words()
    for axis in range(2) if model.turn and words else words:
        block.known(axis)
    here = (*model.work(model.position), *model.further_work())
    for axis, value in words.items():
        g92[axis] += here[axis] - value
    _keep_g92(block, g92)


def set_g52(block: Block, code: Code) -> None:
    """G52: the G92 offset itself."""
    block.uncompensated("axis offsets may not be changed", code.name)
    g92 = list(block.model.g92)
    for axis, value in block.axis_words().items():
        g92[axis] = value
    _keep_g92(block, g92)


def _keep_g92(block: Block, g92: list[float]) -> None:
    model = block.model
    store_point(model.parameters, FIRST_G92, g92, model.unit_mm, range(9))
    _use_g92(block, tuple(g92), 1.0)


def clear_g92(block: Block, code: Code) -> None:
    """G92.1: no shift, and none kept."""
    block.uncompensated("axis offsets may not be changed", code.name)
    store_point(block.model.parameters, FIRST_G92, ZERO9, 1.0, range(9))
    _use_g92(block, ZERO9, 0.0)


def suspend_g92(block: Block, code: Code) -> None:
    """G92.2: no shift, but it is kept."""
    block.uncompensated("axis offsets may not be changed", code.name)
    _use_g92(block, ZERO9, 0.0)


def restore_g92(block: Block, code: Code) -> None:
    """G92.3: the shift that is kept."""
    block.uncompensated("axis offsets may not be changed", code.name)
    _use_g92(block, saved_g92(block.model), 1.0)


def _use_g92(block: Block, g92: tuple[float, ...], in_force: float) -> None:
    block.model.parameters.set(G92_IN_FORCE, in_force)
    block.model.g92 = g92
    block.model.change_offset()
    block.point(SET_G92, g92)


def keep_home(block: Block, code: Code) -> None:
    """G28.1, G30.1: store the position."""
    block.uncompensated("no position may be stored", code.name)
    model = block.model
    point = [block.known(axis) for axis in range(3)] + list(model.further or (0.0,) * 6)
    store_point(model.parameters, HOMES[code.name[:3]], point, model.unit_mm, range(9))


def go_home(block: Block, code: Code) -> None:
    """G28, G30: first to the point given, then the named axes (or all) to the stored position."""
    block.uncompensated("G28 and G30 may not be used", code.name)
    model = block.model
    named = list(block.axis_words())
    further = further_end(model, block.plan, block.values)
    block.rapid(end_point(model, block.plan, block.values), further, row=bool(named))
    home = _home(model, code)
    end = _towards_home(model, home, named)
    if not block.dialect.has_z:
        end = (end[0], end[1], model.position[2])
    if further or any(home[3:]):
        more = model.further or (0.0,) * 6
        further = tuple(home[axis] if axis in named or not named else more[axis - 3] for axis in range(3, 9))
    block.rapid(end, further)


def _towards_home(model: Model, home: tuple[float, ...], named: list[int]) -> Point:
    """Return where the named axes of a work system, or all, are at home; in a turned one they are not the machine's."""
    if model.turn is None:
        x, y, z = (home[axis] if axis in named or not named else here for axis, here in enumerate(model.position))
        return x, y, z
    there, here = model.work((home[0], home[1], home[2])), model.work(model.position)
    x, y, z = (there[axis] if axis in named or not named else here[axis] for axis in range(3))
    return model.machine((x, y, z))


def _home(model: Model, code: Code) -> tuple[float, ...]:
    first = HOMES[code.name]
    if first not in model.parameters:
        what = Text("the position stored for {code} is not known", code=code.name)
        advice = Text(
            "give parameters {first} to {first2} with the start state, or use G53", first=first, first2=first + 2
        )
        raise ProgramError("unknown-position", what, value=code.name, advice=advice)
    # a machine position has no place in a table whose work zero is not known
    return stored_point(model.parameters, first, model.unit_mm) if model.zero_known else (UNKNOWN,) * 3 + ZERO9[3:]


OFFSET_ACTS: dict[str, Callable[[Block, Code], None]] = {
    act.__name__: act
    for act in (
        work_system,
        set_table,
        set_g92,
        set_g52,
        clear_g92,
        suspend_g92,
        restore_g92,
        keep_home,
        go_home,
    )
}
