# SPDX-License-Identifier: LGPL-2.1-or-later
"""A board of ours whose pulses a fake output plays: all time passes at once in both, a millisecond at a time."""

from __future__ import annotations

from CNCStepper.controllers.pulse_board import PulseBoard
from CNCStepper.machine.profile import Machine
from helpers.controllers.fake_output import FakeOutput

TICK_S = 0.001


class SimulatedBoard(PulseBoard):
    """As a virtual board, for every bench that lets one's time pass."""

    def __init__(self, machine: Machine, **output):
        self.output = FakeOutput(tuple(axis.steps_per_mm for axis in machine.axes), **output)
        super().__init__(machine, self.output)

    def advance(self, dt_s: float) -> None:
        """Let time pass at the output and at the board."""
        for _ in range(max(1, round(dt_s / TICK_S))):
            part_s = dt_s / max(1, round(dt_s / TICK_S))
            self.output.advance(part_s)
            super().advance(part_s)
