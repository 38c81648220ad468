# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the machine leaves the programmed path by leave of the program itself: corners that G64 lets it cut."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from CNCStepper.simulation.check_context import CheckContext, PartCheck
from CNCStepper.simulation.finding import Finding
from CNCStepper.toolpath import LINE


class Blended(PartCheck):
    """Finds the largest corner error between straight feeds (G64 P), and corners without a limit (G64)."""

    def __init__(self) -> None:
        self._allowed_mm = -1.0  # on the last row before
        self._last: Finding | None = None  # a finding without text at that row

    def __call__(self, subject: CheckContext) -> Iterator[Finding]:
        states, table = subject.toolpath.states, subject.table
        of_state = np.array([state.blend_mm if state.path_mode == "blend" else -1.0 for state in states])
        allowed = np.append(self._allowed_mm, np.where(table.kind == LINE, of_state[table.state], -1.0))
        behind_row = np.minimum(allowed[:-1], allowed[1:])  # the corner behind each row, from the last one before on
        if len(rows := np.flatnonzero(behind_row > 0.0)):
            widest = int(rows[behind_row[rows].argmax()])
            yield self._behind(
                subject,
                widest - 1,
                "G64 P lets the machine cut corners: times and pulses do so,"
                " the simulated part shows the programmed path",
                "the part may differ from it by as much: lower P, or follow the exact path with G61",
                len(rows),
                float(behind_row[widest]),
            )
        if len(rows := np.flatnonzero(behind_row == 0.0)):
            yield self._behind(
                subject,
                int(rows[0]) - 1,
                "G64 without P does not say how far the machine may cut corners;"
                " all is worked out for the programmed path",
                "give G64 a P, or follow the exact path with G61",
                len(rows),
            )
        if len(table):
            self._allowed_mm = float(allowed[-1])
            self._last = subject.finding(len(table) - 1, "warning", "corners-cut", "")

    def _behind(
        self, subject: CheckContext, row: int, text: str, advice: str, count: int, widest_mm: float | None = None
    ) -> Finding:
        """Return the finding at the corner behind a row; -1 is the last row of the part before."""
        at = self._last if row < 0 and self._last else subject.finding(row, "warning", "corners-cut", "")
        group, rank = ("G64", 0.0) if widest_mm is None else ("G64 P", widest_mm)
        numbers: dict[str, Any] = {} if widest_mm is None else {"value": widest_mm, "unit": "mm"}
        at_first = widest_mm is None
        return replace(at, text=text, advice=advice, count=count, group=group, rank=rank, at_first=at_first, **numbers)
