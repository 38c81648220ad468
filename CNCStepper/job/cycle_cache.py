# SPDX-License-Identifier: LGPL-2.1-or-later
"""Caches a cut cycle by its setup: its operation for the figures, its job for the program.

An operation's proxy keeps the one it cut last. It holds the moves of that cut; whoever asks again gets a copy
of them in his own table.
"""

from __future__ import annotations

import math
from typing import Any

from CNCStepper.cycles.cycle import Answer, Cycle, Setup
from CNCStepper.machine.profile import Machine
from CNCStepper.state import Start
from CNCStepper.toolpath import TableBuilder, Toolpath


class CycleCache:
    """A cycle, and the moves and the answer of its cut with one setup."""

    def __init__(self, cycle: Cycle, setup: Setup):
        table = TableBuilder(Start())
        self.model = cycle
        self.cycle, self.tool = cycle.cycle, cycle.tool
        self.setup = setup
        self.answer: Answer = cycle.cut(setup, table)
        self._moves: Toolpath = table.toolpath()

    def __getattr__(self, name: str) -> Any:
        """Return a parameter of the cycle, for a job that compares its operations."""
        if name.startswith("_") or name == "model":  # while it is copied it has none yet
            raise AttributeError(name)
        return getattr(self.model, name)

    def fits(self, cycle: Any, setup: Setup) -> bool:
        """Return whether this is the cut of `cycle` with `setup`."""
        return (self.model, self.setup) == (cycle, setup)

    def time_s(self, machine: Machine) -> float:
        """Return the planned time of the moves alone, s: without the way to them and the tool change."""
        from CNCStepper.motion.planner.plan import begun, duration_s  # its kernels load late

        return duration_s(begun(self._moves), machine)

    def cut(self, setup: Setup, table: TableBuilder) -> Answer:
        """Append the moves to `table` and return the answer, as the cycle itself would.

        Without a Z the way to the cut lies in the plane and depends on where the table stands: it is cut anew.
        """
        stands = not setup.has_z and math.isfinite(table.position_mm[0])
        if setup != self.setup or stands:
            return self.model.cut(setup, table)
        table.append(self._moves)
        return self.answer
