# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many acknowledged moves a controller still holds, from its own reports."""

from __future__ import annotations

from collections.abc import Iterable

from CNCStepper.control.protocol.grbl.driver import PLANNER_BLOCKS, Received
from CNCStepper.control.protocol.grbl.report import Feedback, Status
from CNCStepper.control.protocol.grbl.report_numbers import sizes
from CNCStepper.control.stream.executed_lines import SEGMENTS


class Capacity:
    """`moves` is the largest number reported."""

    def __init__(self) -> None:
        self._blocks = 0

    @property
    def moves(self) -> int:
        """Moves in the planner and behind it."""
        return (self._blocks or PLANNER_BLOCKS) + SEGMENTS

    def on_message(self, received: Iterable[Received]) -> None:
        """Take `[OPT:letters,blocks,bytes]`, and the free blocks of a status."""
        for report in received:
            if isinstance(report, Status) and report.buffer:
                self._blocks = max(self._blocks, report.buffer[0])
            elif isinstance(report, Feedback) and report.tag == "OPT":
                self._blocks = max(self._blocks, sizes(report.text)[0])
