# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of moves of a lathe, and tools, for tests."""

from __future__ import annotations

from collections.abc import Iterable

from CNCStepper.machine.tools.turning_tool import TurningTool
from CNCStepper.simulation.turning.half_section import HalfSection
from CNCStepper.simulation.turning.swept_outline import moves_of
from CNCStepper.simulation.turning.tool_section import ToolSection
from CNCStepper.simulation.turning.turned_part import TurnedPart, turned_part
from CNCStepper.state import Start, State
from CNCStepper.toolpath import ARC_CCW, ARC_CW, ZX, TableBuilder, Toolpath

START_Z, START_R = 5.0, 40.0


def cnmg(**more: float) -> ToolSection:
    """Return a right-hand CNMG 120408 at 95 degrees: nose 0.8 mm, edges at 85 and 5 degrees."""
    return ToolSection.of(TurningTool(number=1, insert="CNMG 120408", **more))


def lathe_path(moves: Iterable[tuple], tool: int = 1, rpm: float = 1000.0) -> Toolpath:
    """Return the table of moves from (5, 40) on: ("rapid", z, r), ("feed", z, r), ("cw" or "ccw", z, r, zc, rc).

    The line of each is its number from 1. The sense of an arc is that of G18: clockwise as seen from -Y.
    """
    state = State(tool=tool, spindle_rpm=rpm, spindle="cw", plane="ZX")
    table = TableBuilder(Start((START_R, 0.0, START_Z), zero_known=True), state)
    for line, (kind, z, r, *centre) in enumerate(moves, 1):
        end = (r, 0.0, z)
        if kind == "rapid":
            table.rapid(end, line)
        elif kind == "feed":
            table.feed(end, 200.0, line)
        else:
            way = ARC_CW if kind == "cw" else ARC_CCW
            table.arc(way, end, (centre[1], 0.0, centre[0]), 200.0, ZX, 1, line)
    return table.toolpath()


def cut(moves: Iterable[tuple], stock: HalfSection, tool: ToolSection) -> TurnedPart:
    """Return the part that one tool's moves leave."""
    return turned_part(moves_of(lathe_path(moves)), stock, {1: tool})
