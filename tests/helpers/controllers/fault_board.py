# SPDX-License-Identifier: LGPL-2.1-or-later
"""A board of ours on the mill of the fault bench, so that the judge of grbl's fault runs judges it too."""

from __future__ import annotations

from collections.abc import Callable
from math import inf

from CNCStepper.errors import LinkError
from CNCStepper.machine.profile import load_machine
from CNCStepper.virtual.grbl.machine import Grbl
from CNCStepper.virtual.grbl.planner import COASTING_STEPS
from helpers.controllers.simulated_board import SimulatedBoard

Cable = Callable[[list[int]], list[int]]  # from the pulses of the axes to those that their motors get


def dead_pin(axis: int) -> Cable:
    """Return a cable without the step line of an axis."""
    return lambda moves: [0 if number == axis else move for number, move in enumerate(moves)]


def swapped_pins(one: int, other: int) -> Cable:
    """Return a cable that has the lines of two axes exchanged."""
    order = {one: other, other: one}
    return lambda moves: [moves[order.get(number, number)] for number in range(3)]


class FaultBoard(SimulatedBoard):
    """It has the axes and settings of grbl's; motors that turn coast on where they are stopped dead.

    late_s: when a pulse comes too late. cable_s: from when on `cable` is what the motors get.
    """

    def __init__(self, controller: str = "thesis-a") -> None:
        mill = load_machine("table-a")
        pins = {"x_step": 2, "x_direction": 3, "y_step": 4, "y_direction": 5, "z_step": 6, "z_direction": 7}
        signals = mill.signals.model_copy(update={"pins": pins | {"spindle_cw": 14}})
        super().__init__(mill.model_copy(update={"controller": controller, "signals": signals}), wired=("spindle_cw",))
        self.axes.lost_steps = list(Grbl(mill).axes.lost_steps)
        self.controller = controller
        self.late_s = self.cable_s = inf
        self.cable: Cable = list
        self._followed = 0  # pulses that the cable has carried
        self._stops_dead = self.output.stop_at_once
        self.output.stop_at_once = self._coast

    def advance(self, dt_s: float) -> None:
        """Let time pass, and happen what is due."""
        output = self.output
        if self.late_s <= output.time_s and output.rate_mm_min > 0 and not output.error:
            self._lose(COASTING_STEPS)
            output.error = LinkError("pulses-late", "a pulse came 4 ms late")
        super().advance(dt_s)
        self._carry()

    def connected_again(self) -> FaultBoard:
        """Return the board of a new connection: it counts from 0, wherever the axes are, and its cable is whole."""
        board = FaultBoard(self.controller)
        places = zip(self.axes.position_steps, self.axes.lost_steps, board.axes.position_steps, strict=True)
        board.axes.lost_steps = [here + lost - counted for here, lost, counted in places]
        return board

    def _carry(self) -> None:
        """Let the motors follow what the cable makes of the pulses."""
        for time_s, step, back, _ in self.output.played[self._followed :]:
            if time_s >= self.cable_s:
                moves = [(step >> axis & 1) - 2 * (back >> axis & 1) for axis in range(3)]
                there = self.cable(moves)
                lost = zip(self.axes.lost_steps, there, moves, strict=True)
                self.axes.lost_steps = [before + real - told for before, real, told in lost]
        self._followed = len(self.output.played)

    def _coast(self) -> None:
        if self.output.rate_mm_min > 0:
            self._lose(COASTING_STEPS)
        self._stops_dead()

    def _lose(self, steps: int) -> None:
        self.axes.lost_steps = [lost + steps for lost in self.axes.lost_steps]
