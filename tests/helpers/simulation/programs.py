# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small programs for the tests of the simulation, built row by row as the interpreter would."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import shapely

from CNCStepper.cycles.cycle import Removal
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.state import UNKNOWN, Start, State
from CNCStepper.toolpath import XY, Chunk, TableBuilder, Toolpath

ZERO_MM = (-200.0, -200.0, -40.0)  # the work zero on table A
FLAT = Tool(number=1, shape="flat", diameter_mm=6)
BALL = Tool(number=1, shape="ball", diameter_mm=6)


class Program:
    """Moves in work coordinates; every row stands on its own line, counted from 1."""

    def __init__(self, zero_mm: tuple[float, float, float] = ZERO_MM, zero_known: bool = True, **state):
        start = Start.with_work_zero(zero_mm) if zero_known else Start()
        offset_mm = zero_mm if zero_known else (0.0, 0.0, 0.0)
        running = {"tool": 1, "spindle": "cw", "spindle_rpm": 10000.0} | state
        self.table = TableBuilder(start, State(offset_mm=offset_mm, **running))
        self.table.event("dwell", 3.0)
        self._chunks: list[Chunk] = []

    def set(self, **changes) -> Program:
        self.table.set_state(replace(self.table.state, **changes))
        return self

    def _machine(self, *point: float) -> tuple[float, ...]:
        return tuple(float(v) for v in np.add(point, self.table.state.offset_mm))

    @property
    def line(self) -> int:
        return self.table.index + 1

    def rapid(self, x: float, y: float, z: float) -> Program:
        self.table.rapid(self._machine(x, y, z), line=self.line)
        return self

    def up_first(self, z: float) -> Program:
        return self.rapid(UNKNOWN, UNKNOWN, z)

    def feed(self, x: float, y: float, z: float, feed_mm_min: float = 600.0) -> Program:
        self.table.feed(self._machine(x, y, z), feed_mm_min, line=self.line)
        return self

    def arc(self, kind: int, end, centre, plane: int = XY, turns: int = 1, feed_mm_min: float = 600.0) -> Program:
        self.table.arc(kind, self._machine(*end), self._machine(*centre), feed_mm_min, plane, turns, self.line)
        return self

    def toolpath(self) -> Toolpath:
        """Return what is built so far; building may go on."""
        made = self.table.toolpath()
        self._chunks += [chunk for chunk in made.chunks if len(chunk)]
        return replace(made, chunks=self._chunks or made.chunks)


def begun(**state) -> Program:
    """Return a program that stands 5 mm over the work zero."""
    return Program(**state).up_first(5).rapid(0, 0, 5)


def square_pocket(
    half_mm: float = 20.0,
    levels: tuple[float, ...] = (-2.0, -4.0),
    wall_mm: float = 0.0,
    skip: tuple[int, ...] = (),
    step_mm: float = 2.0,
) -> Program:
    """Return a square pocket cut by a 6 mm flat tool, in rings from the middle to the wall.

    wall_mm: how far the last ring lies beyond its place. skip: rings that are left out at every level.
    """
    program = begun()
    last = half_mm - FLAT.radius_mm
    rings = [*np.arange(step_mm, last, step_mm), last]
    for z in levels:
        program.feed(0, 0, z, 200)
        for number, half in enumerate(rings):
            reach = half + (wall_mm if number == len(rings) - 1 else 0.0)
            if number not in skip:
                for x, y in (
                    (reach, 0),
                    (reach, reach),
                    (-reach, reach),
                    (-reach, -reach),
                    (reach, -reach),
                    (reach, 0),
                ):
                    program.feed(x, y, z)
        program.feed(0, 0, z)
    return program.rapid(0, 0, 5)


def square_removal(half_mm: float = 20.0, depth_mm: float = 4.0) -> Removal:
    """Return what that pocket is to remove: a square with corners as round as the tool."""
    inner = half_mm - FLAT.radius_mm
    region = shapely.box(-inner, -inner, inner, inner).buffer(FLAT.radius_mm, quad_segs=128)
    return Removal(region, 0.0, -depth_mm)
