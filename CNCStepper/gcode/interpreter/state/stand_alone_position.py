# SPDX-License-Identifier: LGPL-2.1-or-later
"""The real machine position, and the position of LinuxCNC's stand-alone interpreter, which has no machine.

After a tool change LinuxCNC asks its machine for the position: a compensation that has ended leaves the tool beside the
place where the text goes on. The bare interpreter only has an idea of a machine, which knows nothing of tool lengths
and whose probe never trips, but backs off a little; that matters where our calls are compared with its own.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from CNCStepper.gcode.interpreter.state.interpreter_state import Model, Point

BACK_OFF = {"mm": 0.254, "inch": 0.01}  # of the probe, in the unit of the text


def offset_changes(model: Model, offset: tuple[float, ...]) -> None:
    """Note that a tool offset moves the coordinates, which the stand-alone interpreter's position does not follow."""
    if model.bare:
        x, y, z = (
            here + offset[axis] - model.tool_offset[axis] for axis, here in enumerate(machine_position_at(model))
        )
        model.stands = (x, y, z)
        model.look()


def units_change(model: Model, scale: float) -> None:
    """Keep the number of the tool offset while the unit that it counts changes from `scale` mm.

    LinuxCNC asks its machine for the offset in the new unit, and a real machine answers in it; the bare interpreter's
    idea of one answers with the old number. The text goes on where it was.
    """
    if not model.bare:
        return
    work, stands, number = model.work(model.position), model.work(machine_position_at(model)), model.scale / scale
    model.tool_offset = (*(value * number for value in model.tool_offset[:3]), *model.tool_offset[3:])
    model.change_offset()
    model.position, model.stands = model.machine(work), model.machine(stands)
    model.look()


def use_system(model: Model, name: str) -> None:
    """Take a work system; the bare interpreter's idea of the place is shifted by the origins, but never turned."""
    work, origin, turn = model.work(machine_position_at(model)), model.origin, model.turn
    model.use_system(name)
    if model.bare and (turn or model.turn):
        x, y, z = (here + origin[axis] - model.origin[axis] for axis, here in enumerate(work))
        model.stands = model.machine((x, y, z))
        model.look()


def machine_position_at(model: Model) -> Point:
    """Return the machine's real position."""
    return model.stands or model.position


def continue_at(model: Model, position: Point) -> None:
    """Let the text continue at a position that is not the machine's."""
    model.stands, model.position = machine_position_at(model), position
    model.look()


def moved(model: Model, end: Point) -> None:
    """Note that the machine is at the text's position, at the end of a move."""
    model.position, model.stands = end, None
    model.look()


def spline_made(model: Model, stood: Point) -> None:
    """Note that the bare interpreter's idea of a machine makes no splines: its position does not change."""
    if model.bare:
        model.stands = stood
        model.look()


def ask_position(model: Model) -> None:
    """Take the position of the machine."""
    moved(model, machine_position_at(model))


def backed_off(model: Model, begin: Point) -> Point:
    """Return where the tool is after probing from `begin` to the model's position."""
    way = [here - there for here, there in zip(begin, model.position, strict=True)]
    length = sum(part * part for part in way) ** 0.5
    back = BACK_OFF[model.state.units] * model.scale / length if length else 0.0
    x, y, z = (there + back * part for there, part in zip(model.position, way, strict=True))
    return x, y, z
