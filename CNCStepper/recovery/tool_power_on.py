# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a program switches its tool on: how long it waits then, at what height, and where the cut under power begins.

M3 G4 P0.5       ......... pierce height
G1 Z1.5                  |
G1 X10 ...               `----- the cut under power -----  M5
"""

from __future__ import annotations

import numpy as np

from CNCStepper.toolpath import RAPID, Toolpath


def powered_rows(path: Toolpath) -> np.ndarray:
    """Return on which rows the spindle turns, or the beam is on, bool[n]."""
    return np.array([state.spindle_turns for state in path.states], bool)[path.table().state]


def own_wait_s(path: Toolpath, row: int) -> float:
    """Return how long the program last waits, up to a row, for what it has just switched on; 0 for not at all."""
    on, wait_s = powered_rows(path), 0.0
    for event in path.events:
        fresh = event.index == 0 or event.index >= len(on) or not on[event.index - 1]
        if event.kind == "dwell" and event.index <= row and fresh and path.states[event.state].spindle_turns:
            wait_s = event.value
    return wait_s


def cut_begin(path: Toolpath, row: int) -> int:
    """Return the first of the rows up to `row` that are run under the same power, without a rapid between them."""
    cuts = powered_rows(path) & (path.table().kind != RAPID)
    if not cuts[row]:
        return row
    before = np.flatnonzero(~cuts[: row + 1])
    return int(before[-1]) + 1 if len(before) else 0


def pierce_height_mm(path: Toolpath, row: int) -> float:
    """Return the machine height at which the cut under power of a row begins."""
    return float(path.begins()[cut_begin(path, row), 2])
