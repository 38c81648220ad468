# SPDX-License-Identifier: LGPL-2.1-or-later
"""On which line of the file each operation of a program begins, and each tool is used first."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from CNCStepper.toolpath import Span, Toolpath


class FirstLines:
    """Those of a program that may come in parts, each a whole table of consecutive rows."""

    def __init__(self) -> None:
        self._rows = 0
        self._of_mark: dict[int, int] = {}
        self.of_tool: dict[int, int] = {}

    @classmethod
    def of(cls, toolpath: Toolpath) -> FirstLines:
        """Return those of a whole program."""
        lines = cls()
        lines.see(toolpath, [span.first for span in toolpath.spans])
        return lines

    def see(self, toolpath: Toolpath, marks: Iterable[int]) -> None:
        """Take the next part; marks: rows of the whole program at which operations begin or end."""
        table = toolpath.table()
        first, self._rows = self._rows, self._rows + len(table)
        for mark in marks:
            if first <= mark < self._rows:
                self._of_mark[mark] = int(table.line[mark - first])
        states, rows = np.unique(table.state, return_index=True)
        for state, row in sorted(zip(states.tolist(), rows.tolist(), strict=True), key=lambda pair: pair[1]):
            self.of_tool.setdefault(toolpath.states[state].tool, int(table.line[row]))

    def of_operations(self, spans: Iterable[Span]) -> list[int]:
        """Return the first line of each operation among spans; 1 for one that moves nothing at the program's end."""
        return [self._of_mark.get(span.first, 1) for span in spans if span.kind == "operation"]
