# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of the writer's caller; all the rest follows from the table and the dialect.

What a writer had to write differently, because the dialect lacks it: how often, and where first.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from CNCStepper.machine.cut_data import CutData


@dataclass(frozen=True)
class WriteOptions:
    """How a program is written.

    clearance_mm: height in work coordinates to which Z goes first, before tool changes and at the end.
    spin_up_s: dwell after the spindle starts. tool_change: "pause" (M5, message, M0), "m6", or "split"
    (`write_split`, one program a tool). coolant: switched on with the spindle, beside what the table says.
    tools: description by number. flat_mm: an arc flatter than this is written as a line (0: half a last digit).
    tool_length: "touch_off" (the operator is told to set the Z zero with each new tool), "table" (each tool's length
    offset is selected: G43 H, or G43.1 Z where the controller has no table) or "none" (all tools are equally long).
    tool_lengths_mm: length offsets by number, where they are known. Lengths that the table itself has are kept by words
    where the dialect has them, else in the coordinates; with "touch_off" they are left out.
    retract: Z goes to clearance first, before tool changes and at the end; without it the program holds the table's
    moves only. leave_out: what may be missing where the dialect lacks it: "spindle", "coolant", "dwell", "pause" and
    "tool" (it is refused otherwise). chord_mm: how far lines may be from an arc that the dialect lacks. rapid_mm_min:
    the F of rapids where they heed it (0: the last one). An empty work_offset is the table's own. cut_data: the
    material of a controller that knows such. x_is: of a lathe's program, whose plane is ZX: how it gives X; "" is no
    lathe. incremental: all moves are given from where the tool is; steps_per_mm: of X, Y and Z, where the
    machine rounds each increment to whole steps for itself (0: unknown). turning_cycles: threads are written as G76 and
    profiles as G70 to G72 where the dialect has them.
    """

    units: Literal["mm", "inch"] = "mm"
    work_offset: str = "G54"
    clearance_mm: float = 10.0
    spin_up_s: float = 0.0
    tool_change: Literal["pause", "split", "m6"] = "pause"
    coolant: Literal["none", "mist", "flood"] = "none"
    title: str = ""
    comments: tuple[str, ...] = ()
    tools: dict[int, str] = field(default_factory=dict)
    flat_mm: float = 0.0
    tool_length: Literal["touch_off", "table", "none"] = "none"
    tool_lengths_mm: dict[int, float] = field(default_factory=dict)
    retract: bool = True
    leave_out: tuple[str, ...] = ()
    chord_mm: float = 0.002
    rapid_mm_min: float = 0.0
    cut_data: CutData | None = None
    x_is: Literal["", "radius", "diameter"] = ""
    incremental: bool = False
    steps_per_mm: tuple[float, float, float] = (0.0, 0.0, 0.0)
    turning_cycles: bool = False


@dataclass
class Note:
    """what: a sentence without full stop. times: how often. line: of the table's source, 0 where there is none."""

    what: str
    times: int = 0
    line: int = 0

    def __str__(self) -> str:
        if self.times == 1:
            return self.what + f" (line {self.line})" * bool(self.line)
        return f"{self.what} ({self.times} times" + f", first at line {self.line}" * bool(self.line) + ")"


class Notes:
    """The notes of one program in the order in which they came up."""

    def __init__(self) -> None:
        self._notes: dict[str, Note] = {}

    def add(self, what: str, line: int = 0) -> None:
        """Note that `what` was done once more."""
        note = self._notes.setdefault(what, Note(what, line=line))
        note.times += 1

    def once(self, what: str) -> None:
        """Set a condition; repeated calls have no effect."""
        self._notes.setdefault(what, Note(what, 1))

    def __iter__(self):
        return iter(self._notes.values())

    def __len__(self) -> int:
        return len(self._notes)
