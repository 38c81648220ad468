# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs of a torch table, written by hand a cut at a time, so that a test can spoil exactly one thing of one cut."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import shapely

from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.machine.cut_data import CutData
from CNCStepper.machine.processes import PROCESSES, Process
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.checks.check_program import check
from CNCStepper.simulation.finding import Finding
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.tip_segments import tips_mm
from CNCStepper.state import Start
from CNCStepper.toolpath import LINE, RAPID, Toolpath

KERF_MM = 1.5
DATA = CutData(
    process="plasma",
    material="mild-steel",
    thickness_mm=3,
    feed_mm_min=3000,
    kerf_mm=KERF_MM,
    pierce_height_mm=3.8,
    pierce_delay_s=0.4,
    cut_height_mm=1.5,
    lead_in_mm=2.0,
)
SHEET = Stock((200, 150, 3), "top-left-front")
START = Start.with_work_zero((-380.0, -380.0, -40.0))
_TABLE = load_machine("table-a")
_SPINDLE = {"min_rpm": 0.0, "max_rpm": 1000.0, "spin_up_s": 0.0}
TABLE: Machine = _TABLE.model_copy(update={"spindle": _TABLE.spindle.model_copy(update=_SPINDLE)})
LASER: Machine = TABLE.model_copy(update={"spindle": TABLE.spindle.model_copy(update={"laser": True})})


def beam(process: Process = PROCESSES["plasma"], kerf_mm: float = KERF_MM) -> Tool:
    """Return the jet or wire of a process."""
    return Tool(number=1, shape=process.shapes[0], diameter_mm=kerf_mm)


@dataclass(frozen=True)
class Cut:
    """One cut from M3 to M5, as blocks of G1, G2 and G3 behind its pierce; what is empty is not written."""

    pierce_mm: tuple[float, float]
    blocks: list[str]
    on: str = "M3 S1000"
    delay: str = "G4 P0.4"
    off: str = "M5"
    travel_mm: float = 10.0
    pierce_height_mm: float = 3.8
    cut_height_mm: float = 1.5
    feed_mm_min: float = 3000.0

    def lines(self) -> list[str]:
        """Return the cut's lines, with the rapids to its pierce and up again."""
        x, y = self.pierce_mm
        lines = [f"G0 X{x:.4f} Y{y:.4f}", f"G0 Z{self.pierce_height_mm:g}", self.on, self.delay]
        lines += [f"G1 Z{self.cut_height_mm:g} F500", f"F{self.feed_mm_min:g}", *self.blocks, self.off]
        return [line for line in (*lines, f"G0 Z{self.travel_mm:g}") if line]


def text_of(cuts: Sequence[Cut]) -> str:
    """Return the whole program."""
    return "\n".join(["G21 G90 G54", "G0 Z10", *(line for cut in cuts for line in cut.lines()), "M5", "M2", ""])


def cuts_of(path: Toolpath) -> list[Cut]:
    """Return the cuts of a program that was read back, each block with all its words; heights stay the usual ones."""
    table, (begin, end) = path.table(), tips_mm(path)
    centre = table.centre - (table.end[:, :3] - end)
    found: list[Cut] = []
    was_on = False
    for row, (kind, state) in enumerate(zip(table.kind.tolist(), table.state.tolist(), strict=True)):
        is_on = path.states[state].spindle_turns and kind != RAPID
        if is_on and not was_on:
            found.append(Cut(tuple(begin[row, :2].tolist()), []))
        was_on = is_on
        if is_on and (kind != LINE or np.hypot(*(end - begin)[row, :2]) > 1e-9):
            words = f"G{kind} X{end[row, 0]:.4f} Y{end[row, 1]:.4f}"
            way = centre[row] - begin[row]
            found[-1].blocks.append(words if kind == LINE else f"{words} I{way[0]:.4f} J{way[1]:.4f}")
    return found


def hole(x: float, y: float, radius_mm: float, **changes) -> Cut:
    """Return the cut of a round hole: pierced in its middle, led in along a radius."""
    path = radius_mm - KERF_MM / 2
    blocks = [f"G1 X{x + path:.4f} Y{y:.4f}", f"G3 X{x + path:.4f} Y{y:.4f} I{-path:.4f} J0"]
    return replace(Cut((x, y), blocks), **changes)


def square(x: float, y: float, side_mm: float, lead_mm: float = 4.0, **changes) -> Cut:
    """Return the cut round a square with its low corner at (x, y): led in and out below the middle of its low side."""
    low_x, low_y = x - KERF_MM / 2, y - KERF_MM / 2
    high_x, high_y, middle = x + side_mm + KERF_MM / 2, y + side_mm + KERF_MM / 2, x + side_mm / 2
    corners = [(low_x, low_y), (low_x, high_y), (high_x, high_y), (high_x, low_y), (middle, low_y)]
    blocks = [f"G1 X{middle:.4f} Y{low_y:.4f}", *(f"G1 X{a:.4f} Y{b:.4f}" for a, b in corners)]
    blocks.append(f"G1 X{middle + lead_mm / 2:.4f} Y{low_y - lead_mm / 2:.4f}")
    return replace(Cut((middle, low_y - lead_mm), blocks), **changes)


def square_part(
    x: float, y: float, side_mm: float, holes: Sequence[tuple[float, float, float]] = ()
) -> shapely.Polygon:
    """Return the part that is left: a square with round holes (x, y, radius)."""
    part = shapely.box(x, y, x + side_mm, y + side_mm)
    return part.difference(shapely.union_all([shapely.Point(a, b).buffer(r, quad_segs=256) for a, b, r in holes]))


@dataclass(frozen=True)
class Plate:
    """What a program is checked against."""

    process: Process = PROCESSES["plasma"]
    parts: Sequence[shapely.Polygon] = ()
    machine: Machine = TABLE
    data: CutData | None = DATA
    stock: Stock | None = SHEET
    start: Start = START
    tool: Tool | None = None
    language: str = "grbl"

    def findings(self, text: str) -> list[Finding]:
        """Return what the check finds in a program's text."""
        toolpath = interpret(text, self.start, self.language)
        return check(
            toolpath,
            self.machine,
            file="p.nc",
            stock=self.stock,
            tools=self.tool or beam(self.process),
            process=self.process,
            cut_data=self.data,
            parts=self.parts,
        )

    def codes(self, text: str, severity: str = "error") -> set[str]:
        """Return the codes of the findings of one severity."""
        return {one.code for one in self.findings(text) if one.severity == severity}

    def lines_of(self, text: str, code: str) -> list[str]:
        """Return the program's lines at which something is found."""
        lines = text.splitlines()
        return [lines[one.place.line - 1] for one in self.findings(text) if one.code == code]
