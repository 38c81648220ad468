# SPDX-License-Identifier: LGPL-2.1-or-later
"""A board of ours on the mill of the fault bench, so that the judge of grbl's fault runs judges it too."""

from __future__ import annotations

from CNCStepper.machine.profile import load_machine
from CNCStepper.virtual.grbl.machine import Grbl
from CNCStepper.virtual.grbl.planner import COASTING_STEPS
from helpers.controllers.simulated_board import SimulatedBoard


class FaultBoard(SimulatedBoard):
    """It has the axes and settings of grbl's; motors that turn coast on where they are stopped dead."""

    def __init__(self, controller: str = "thesis-a") -> None:
        mill = load_machine("table-a")
        pins = {"x_step": 2, "x_direction": 3, "y_step": 4, "y_direction": 5, "z_step": 6, "z_direction": 7}
        signals = mill.signals.model_copy(update={"pins": pins | {"spindle_cw": 14}})
        super().__init__(mill.model_copy(update={"controller": controller, "signals": signals}), wired=("spindle_cw",))
        self.axes.lost_steps = list(Grbl(mill).axes.lost_steps)
        self._stops_dead = self.output.stop_at_once
        self.output.stop_at_once = self._coast

    def _coast(self) -> None:
        if self.output.rate_mm_min > 0:
            self.axes.lost_steps = [lost + COASTING_STEPS for lost in self.axes.lost_steps]
        self._stops_dead()
