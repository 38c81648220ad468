# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every check is given: the table, the tip's positions, and how a row becomes a finding."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from CNCStepper.errors import Place
from CNCStepper.machine.cut_data import CutData
from CNCStepper.machine.processes import MILLING, Process
from CNCStepper.machine.profile import Machine
from CNCStepper.motion.planner.plan import top_speeds_mm_s
from CNCStepper.simulation.arc_chords import extremes
from CNCStepper.simulation.finding import Finding, Severity
from CNCStepper.simulation.tip_segments import tips_mm
from CNCStepper.toolpath import RAPID, Chunk, Toolpath

if TYPE_CHECKING:  # shapely is loaded only for a stock
    from shapely.geometry.base import BaseGeometry


@dataclass(frozen=True)
class Cutting:
    """How a program cuts, where that is known: the process, the row of the cut chart, the parts that are to be left.

    parts: shapely polygons with their holes, in work coordinates; empty where the job is not known.
    """

    process: Process = MILLING
    cut_data: CutData | None = None
    parts: Sequence[BaseGeometry] = ()

    @property
    def is_through_sheet(self) -> bool:
        """Whether a beam or wire cuts through the whole sheet, so that pieces come free of it."""
        return self.process.cuts_through


@dataclass(frozen=True)
class CheckContext:
    """A program under check, or one part of it after the other; begin, end: the tip in work coordinates, float64[n, 3].

    known_speeds_mm_s: the greatest speed of each axis on every row, float64[n, axes]; None: not planned yet.
    """

    toolpath: Toolpath
    machine: Machine
    file: str
    table: Chunk
    begin: np.ndarray
    end: np.ndarray
    known_speeds_mm_s: np.ndarray | None = None

    @classmethod
    def of(cls, toolpath: Toolpath, machine: Machine, file: str, speeds_mm_s: np.ndarray | None = None) -> CheckContext:
        """Return the program, or a part of it, ready for the checks."""
        return cls(toolpath, machine, file, toolpath.table(), *tips_mm(toolpath), speeds_mm_s)

    @property
    def is_feed(self) -> np.ndarray:
        """Which rows cut, bool[n]."""
        return self.table.kind != RAPID

    @cached_property
    def low_mm(self) -> np.ndarray:
        """The lowest height of each row, that of an arc of G18 and G19 on its way too, float64[n]."""
        low, _ = extremes(self.table, self.toolpath.begins()[:, :3])
        return low[:, 2] - (self.table.end[:, 2] - self.end[:, 2])

    @property
    def spindle_on(self) -> np.ndarray:
        """Whether the spindle turns, or the beam is on, on each row, bool[n]."""
        return np.array([state.spindle_turns for state in self.toolpath.states], bool)[self.table.state]

    @property
    def tool_numbers(self) -> np.ndarray:
        """The number of each row's tool, int[n]."""
        return np.array([state.tool for state in self.toolpath.states], int)[self.table.state]

    @property
    def speeds_mm_s(self) -> np.ndarray:
        """The greatest speed of each axis on every row, float64[n, axes]."""
        if self.known_speeds_mm_s is None:
            return top_speeds_mm_s(self.toolpath, self.machine)
        return self.known_speeds_mm_s

    def finding(self, row: int, severity: Severity, code: str, text: str, **more: Any) -> Finding:
        """Return a finding at a row of the table, or at the start of the file where there is none (-1)."""
        if "place_mm" not in more and 0 <= row < len(self.table) and np.isfinite(self.end[row]).all():
            more["place_mm"] = tuple(self.end[row].tolist())
        return self.finding_at(self.line(row), severity, code, text, **more)

    def line(self, row: int) -> int:
        """Return the file's line of a row of the table, and 1 where there is none (-1)."""
        return int(self.table.line[row]) if 0 <= row < len(self.table) else 1

    def finding_at(self, line: int, severity: Severity, code: str, text: str, **more: Any) -> Finding:
        """Return a finding at a line of the file."""
        return Finding(severity, code, Place(self.file, line, 1), text, **more)

    def first_rows_of_states(self) -> list[tuple[int, int]]:
        """Return (state, first row that names it), in the order of the rows."""
        states, rows = np.unique(self.table.state, return_index=True)
        return sorted(zip(states.tolist(), rows.tolist(), strict=True), key=lambda pair: pair[1])


class PartCheck:
    """A check that accumulates results over the parts of a program."""

    def __call__(self, subject: CheckContext) -> Iterator[Finding]:
        """Yield the findings in the next part."""
        raise NotImplementedError

    def end(self, last: CheckContext) -> Iterator[Finding]:
        """Yield the findings that need the last part."""
        yield from ()
