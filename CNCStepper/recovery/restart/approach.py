# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a path is entered: from what height, with what spindle and how long a wait, at what feed downwards.

What the caller of a restart decides; all the rest follows from the program.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from CNCStepper.errors import Text
from CNCStepper.gcode.interpreter.state.interpreter_state import Model
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_shapes import BEAMS
from CNCStepper.recovery.restart.entry_point import EntryPoint
from CNCStepper.recovery.restart.interrupted_program import Program
from CNCStepper.recovery.tool_power_on import own_wait_s, pierce_height_mm
from CNCStepper.state import State
from CNCStepper.tolerances import SAME_MM


@dataclass(frozen=True)
class Options:
    """How a path is entered.

    overlap_mm: how much of the path before the place is cut again. height_mm: to which the tool rises first, above the
    stock's work zero; None is the highest at which the program's own rapids cross. spin_up_s: of the spindle. laser:
    the spindle is a laser. tools: by number, or one for every number. run_up_mm: how far behind the place a torch
    pierces again at least, in its own kerf. is_wire: the machine cuts with a hot wire alone.
    """

    overlap_mm: float = 0.0
    height_mm: float | None = None
    spin_up_s: float = 0.0
    laser: bool = False
    tools: Mapping[int, Tool] | Tool | None = None
    run_up_mm: float = 0.0
    is_wire: bool = False

    def tool(self, number: int) -> Tool | None:
        """Return the tool with a number, None where it is not known."""
        if isinstance(self.tools, Tool):
            return self.tools
        return self.tools.get(number) if self.tools else None

    def is_beam(self, number: int) -> bool:
        """Whether a tool is a beam or a jet, which is on only where it cuts."""
        tool = self.tool(number)
        is_known = tool is not None and tool.shape in BEAMS
        return self.laser or self.is_wire or self.run_up_mm > 0 or is_known

    def comes_from_edge(self, number: int) -> bool:
        """Whether a tool is a wire, which comes into the sheet from its edge only."""
        tool = self.tool(number)
        return self.is_wire or (tool is not None and tool.shape == "wire")


@dataclass(frozen=True)
class Approach:
    """The way to the entrance: up, over, down; heights and places in machine coordinates, mm, NaN where unknown.

    at_mm: the entrance. safe_mm: the height at which the tool goes there. plunge_mm_min: the feed downwards, 0 where
    nothing goes down. dwell_s: the wait once the spindle or the beam is on. is_beam: it is switched on only down there.
    state: the modes there. pierce_mm: the height at which a beam is switched on, before it goes down to the cut.
    """

    at_mm: tuple[float, float, float]
    safe_mm: float
    plunge_mm_min: float
    dwell_s: float
    is_beam: bool
    state: State
    pierce_mm: float


def approach_to(program: Program, entrance: EntryPoint, model: Model, options: Options) -> Approach:
    """Return the approach to an entrance; raises ProgramError where no safe height or no feed is known."""
    row, state = entrance.row, model.state
    x, y, z = (program.at(row, entrance.share) if entrance.share else program.begins[row]).tolist()
    safe_mm = _safe_mm(program, row, state, z, options)
    falls = safe_mm > z
    return Approach(
        (x, y, z),
        safe_mm,
        _plunge_mm_min(program, row, state, options) if falls else 0.0,
        _dwell_s(program, row, state, options),
        options.is_beam(state.tool),
        state,
        max(z, pierce_height_mm(program.path, row)) if options.is_beam(state.tool) else z,
    )


def _safe_mm(program: Program, row: int, state: State, z_mm: float, options: Options) -> float:
    """Return the height in machine coordinates at which the tool goes over the work; NaN for a table without Z."""
    if np.isnan(z_mm) or not program.dialect.has_z:
        return float("nan")
    own_mm = program.frame_mm[2] + state.tool_length_mm
    if options.height_mm is not None:
        safe_mm = own_mm + options.height_mm
        if safe_mm < z_mm:
            value, limit = f"{options.height_mm:g} mm", Text("at least {z_mm:g} mm", z_mm=z_mm - own_mm)
            what = "the path is entered above the height that is given"
            raise program.refusal("restart-height", what, row, value=value, limit=limit, advice="give a greater height")
        return safe_mm
    heights = program.table.end[:, 2] - program.lengths_mm
    ways = np.abs(program.table.end[:, :2] - program.begins[:, :2])
    crossing = ~program.feeds & ~(ways <= SAME_MM).all(axis=1) & np.isfinite(heights)
    if not crossing.any():
        what = "no rapid of the program says at what height the tool may cross the work"
        raise program.refusal("restart-height", what, row, advice="give the height")
    return max(float(heights[crossing].max()) + state.tool_length_mm, z_mm)


def _plunge_mm_min(program: Program, row: int, state: State, options: Options) -> float:
    """Return the feed downwards: that of the tool, else of the program's last plunge with it, else of the cut."""
    tool = options.tool(state.tool)
    if tool is not None and tool.plunge_mm_min:
        return tool.plunge_mm_min
    table, ways = program.table, program.table.end[:, :3] - program.begins
    first = np.isnan(program.begins[:, 2]) & np.isfinite(table.end[:, 2])  # from a height that is not known
    upright = program.feeds & ((ways[:, 2] < -SAME_MM) | first) & (np.abs(ways[:, :2]) <= SAME_MM).all(axis=1)
    numbers = np.array([one.tool for one in program.path.states], int)[table.state]
    plunges = np.flatnonzero(upright & (numbers == state.tool))
    if len(plunges):
        return float(table.feed[plunges[max(int(np.searchsorted(plunges, row, side="right")) - 1, 0)]])
    return float(table.feed[row:][program.feeds[row:]][0])


def _dwell_s(program: Program, row: int, state: State, options: Options) -> float:
    """Return how long to wait once the spindle, or the beam, is on: as long as the program itself has, at least."""
    if not state.spindle_turns:
        return 0.0
    own_s = own_wait_s(program.path, row)
    return own_s if options.is_beam(state.tool) else max(own_s, options.spin_up_s)
