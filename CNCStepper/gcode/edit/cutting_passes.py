# SPDX-License-Identifier: LGPL-2.1-or-later
"""The passes of a program: where it cuts along a way at one height, and the rapid that leads there.

G0 X0 Y0          travel: the last rapid in XY before the pass, None where the pass before ends there
G1 Z-1 F200       (entry: plunges and outputs stay where they are)
G1 X10 F800       \\  pass: rows first .. last - 1, feeds that move in XY at one height, nothing
G2 X20 I5         /  but comments between them
G0 Z5
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.edit.line_states import Source
from CNCStepper.state import State
from CNCStepper.tolerances import SAME_SUM_MM
from CNCStepper.toolpath import LINE, RAPID


@dataclass(frozen=True)
class Pass:
    """Rows [first, last); travel: the row of the rapid that leads to it, or None."""

    first: int
    last: int
    travel: int | None


class Rows:
    """The table of a program in work coordinates: begins, ends and centres, float64[n, 3]; line: of each row."""

    def __init__(self, source: Source):
        self.source = source
        self.table = source.toolpath.table()
        offsets = source.toolpath.offsets_mm()[:, :3]
        self.begin = source.toolpath.begins()[:, :3] - offsets
        self.end = self.table.end[:, :3] - offsets
        self.centre = self.table.centre[:, :3] - offsets
        self.line = self.table.line.tolist()
        self.rapid = self.table.kind == RAPID
        moved = ~(np.abs(self.end - self.begin) <= SAME_SUM_MM)  # an unknown place counts as moved
        self.flat = moved[:, :2].any(axis=1) | (self.table.kind > LINE)  # a whole circle ends where it begins
        self.steep = moved[:, 2] & ~(np.isnan(self.begin[:, 2]) & np.isnan(self.end[:, 2]))
        standing = np.flatnonzero(self.rapid & ~moved.any(axis=1)).tolist()
        self.flat[[row for row in standing if self._names_place(row)]] = True

    def _names_place(self, row: int) -> bool:
        """Whether a rapid that moves nothing names X or Y: it leads to a way that begins where the one before ended."""
        tokens = self.source.tokens(self.line[row]) if self.source.firsts else []
        return any(token.letter in "XY" for token in tokens)

    def state(self, row: int) -> State:
        """Return the state of a row."""
        return self.source.toolpath.states[int(self.table.state[row])]

    def refusal(self, row: int, code: str, what: str, advice: str) -> ProgramError:
        """Return the error that names a row's line."""
        number = self.line[row]
        text = self.source.lines.lines[number - 1].strip()
        return self.source.refusal(number, code, what, value=text[:40], advice=advice)


def passes_of(rows: Rows) -> list[Pass]:
    """Return the passes in their order; raises ProgramError where a way leads down while it cuts."""
    breaks = _breaks(rows)
    passes: list[Pass] = []
    travel: int | None = None
    row, count = 0, len(rows.line)
    while row < count:
        if not rows.flat[row]:
            row += 1
        elif rows.rapid[row]:
            travel, row = row, row + 1
        else:
            last = row + 1
            while last < count and _goes_on(rows, last, breaks):
                last += 1
            _check_level(rows, row, last)
            passes.append(Pass(row, last, travel))
            travel, row = None, last
    return passes


def _goes_on(rows: Rows, row: int, breaks: set[int]) -> bool:
    return bool(rows.flat[row] and not rows.rapid[row] and row not in breaks)


def _breaks(rows: Rows) -> set[int]:
    """Return the rows before which more happens than a comment, or more changes than feed and plane."""
    states = [_steady(state) for state in rows.source.toolpath.states]
    numbers = rows.table.state.tolist()
    changes = {row for row in range(1, len(numbers)) if states[numbers[row]] != states[numbers[row - 1]]}
    return changes | {event.index for event in rows.source.toolpath.events if event.kind != "comment"}


def _steady(state: State) -> State:
    return replace(state, feed_mm_min=0.0, plane="XY")


def _check_level(rows: Rows, first: int, last: int) -> None:
    steep = np.flatnonzero(rows.steep[first:last])
    if len(steep):
        what = "the tool goes up or down while it cuts: backwards it would enter at the full depth"
        raise rows.refusal(first + int(steep[0]), "reverse-ramp", what, "let it plunge at the start of the contour")
