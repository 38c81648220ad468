# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the interpreter remembers from line to line; a block changes a copy, which replaces it when all went well."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.state import Start, State
from CNCStepper.units import MM_PER_INCH

Point = tuple[float, float, float]
ZERO: Point = (0.0, 0.0, 0.0)
HOMES = {"G28": 5161, "G30": 5181}  # first parameter of each stored position (machine mm)


class Model:
    """The modal state, the position in machine coordinates (NaN where unknown) and the offsets.

    scale: mm per unit of the text. offset: machine = work + offset, mm. absolute: G90.
    plain: feeds are per minute, so that a line without F cannot change the state.
    """

    __slots__ = (
        "absolute",
        "ended",
        "g92_kept",
        "homes",
        "motion",
        "offset",
        "operations",
        "plain",
        "position",
        "scale",
        "selected_tool",
        "state",
        "tool_lengths",
        "work_offsets",
        "zero_known",
    )

    state: State
    motion: int
    position: Point
    work_offsets: dict[str, Point]
    g92_kept: Point
    homes: dict[int, float]
    tool_lengths: dict[int, float]
    selected_tool: int
    operations: tuple[str, ...]
    ended: bool
    zero_known: bool
    scale: float
    offset: Point
    absolute: bool
    plain: bool

    def copy(self) -> Model:
        """Return a copy; what it holds is never changed in place."""
        other = Model.__new__(Model)
        for name in Model.__slots__:
            setattr(other, name, getattr(self, name))
        return other

    def change(self, **fields: Any) -> None:
        """Change fields of the modal state."""
        self.state = state = replace(self.state, **fields)
        self.scale = MM_PER_INCH if state.units == "inch" else 1.0
        self.absolute = state.distance == "absolute"
        self.plain = state.feed_mode == "per_minute"
        self.offset = state.offset_mm  # type: ignore[assignment]

    def change_offset(self, **fields: Any) -> None:
        """Change work system, G92 or tool length, and with them the offset in force."""
        self.change(**fields)
        work, g92 = self.work_offset(), self.state.g92_mm
        x, y, z = (work[axis] + g92[axis] for axis in range(3))
        self.change(offset_mm=(x, y, z + self.state.tool_length_mm))

    def work_offset(self) -> Point:
        """Return the offset of the work system in force."""
        return self.work_offsets.get(self.state.work_system, ZERO)


def model_at(start: Start, dialect: Dialect) -> Model:
    """Return the model of a machine that stands at `start`; raises ProgramError when it has not three axes."""
    if len(start.position_mm) != 3:
        raise ProgramError(
            "axes",
            "programs are read for machines with three axes",
            value=f"{len(start.position_mm)} axes",
            advice="give a start position of X, Y and Z",
        )
    model = Model()
    model.state = State(
        work_system=start.work_system,
        g92_mm=_three(start.g92_mm),
        tool=start.tool,
        spindle_rpm=start.spindle_rpm,
        arc_centres=dialect.arc_centres,
        feed_mm_min=dialect.default_feed_mm_min,
    )
    model.motion = dialect.first_motion
    model.work_offsets = {name: _three(offset) for name, offset in start.work_offsets_mm.items()}
    model.g92_kept = _three(start.g92_mm)
    model.homes = dict(start.parameters)
    model.tool_lengths = dict(start.tool_lengths_mm)
    model.selected_tool = start.tool
    model.operations = ()
    model.ended = False
    model.zero_known = start.zero_known
    model.change_offset()
    model.position = _first_position(start, model.offset, dialect)
    return model


def _first_position(start: Start, offset: Point, dialect: Dialect) -> Point:
    x, y, z = start.position_mm
    if dialect.starts_at_work_zero:
        x, y, z = (zero if value != value else value for value, zero in zip((x, y, z), offset, strict=True))
    return float(x), float(y), float(z)


def _three(values: tuple[float, ...]) -> Point:
    """Return the first three values, missing ones as 0."""
    x, y, z = (*values, 0.0, 0.0, 0.0)[:3]
    return float(x), float(y), float(z)
