# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the caller of the writer decides; all the rest follows from the table and the dialect."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal


@dataclass(frozen=True)
class WriteOptions:
    """How a program is written.

    clearance_mm: height in work coordinates to which Z goes first, before tool changes and at the end.
    spin_up_s: dwell after the spindle starts. tool_change: "pause" (M5, message, M0), "m6", or "split"
    (`write_split`, one program a tool). coolant: switched on with the spindle, beside what the table says.
    tools: description by number. flat_mm: an arc flatter than this is written as a line (0: half a last digit).
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
