# SPDX-License-Identifier: LGPL-2.1-or-later
"""The moves that are taken as done when a program is restarted: those before the entrance, and a lift.

Wherever the tool stands when the restart begins, its first move leads straight up from there; here it leads up from
the entrance, so that what follows is seen to begin above the work.
"""

from __future__ import annotations

from dataclasses import replace
from math import isnan

import numpy as np

from CNCStepper.recovery.restart.approach import Approach
from CNCStepper.recovery.restart.entry_point import EntryPoint
from CNCStepper.recovery.restart.program import Program
from CNCStepper.toolpath import COLUMNS, RAPID, XY, Chunk, Toolpath


def cut_before(program: Program, entrance: EntryPoint, approach: Approach) -> Toolpath:
    """Return the program's moves up to the entrance, and the lift to the height at which it is crossed."""
    row, table = entrance.row, program.table
    rows = [_rows(table, 0, row)]
    if entrance.share:
        part = _rows(table, row, row + 1)
        rows.append(replace(part, end=np.array([approach.at_mm])))
    if not isnan(approach.safe_mm):
        rows.append(_lift(table, row, approach))
    chunk = Chunk(0, *(np.concatenate([getattr(one, name) for one in rows]) for name in COLUMNS))
    events = [event for event in program.path.events if event.index < row]
    spans = [replace(span, last=min(span.last, row)) for span in program.path.spans if span.first < row]
    return Toolpath(program.path.start, [chunk], program.path.states, events, spans)


def _rows(table: Chunk, first: int, last: int) -> Chunk:
    rows = slice(first, last)
    return Chunk(first, *(getattr(table, name)[rows] for name in COLUMNS))


def _lift(table: Chunk, row: int, approach: Approach) -> Chunk:
    x, y, _ = approach.at_mm
    one = _rows(table, max(row - 1, 0), max(row, 1))
    nothing = np.zeros(1)
    return replace(
        one,
        kind=np.array([RAPID], np.uint8),
        end=np.array([[x, y, approach.safe_mm]]),
        centre=np.zeros((1, 3)),
        plane=np.array([XY], np.uint8),
        turns=np.zeros(1, np.uint16),
        feed=nothing,
    )
