# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mini-lathe's controller and its judge as a board of every bench that lets one's time pass."""

from __future__ import annotations

from types import SimpleNamespace

from CNCStepper.machine.profile import Machine
from helpers.controllers.lathe_judge import LatheBench


class SimulatedLathe:
    """As a virtual board: `axes.position_mm` is where the judge's lathe stands once it has done all that it has."""

    def __init__(self, machine: Machine):
        self.bench = LatheBench(machine)
        self.memory = SimpleNamespace(settings=SimpleNamespace(values={}))
        self._output = self.bench.said.encode("ascii")

    @property
    def axes(self) -> SimpleNamespace:
        """Where X, Y and Z are."""
        x_mm, z_mm = self.bench.judge.mm
        return SimpleNamespace(position_mm=[x_mm, 0.0, z_mm])

    @property
    def quiet(self) -> bool:
        """Whether it only waits for bytes."""
        return self.bench.board.quiet

    def receive(self, data: bytes) -> None:
        """Take bytes from the sender."""
        self.bench.board.receive(data)

    def advance(self, dt_s: float) -> None:
        """Let time pass at the lathe and at its controller."""
        self.bench.time_s += dt_s
        self.bench.board.advance(dt_s)

    def take_output(self) -> bytes:
        """Return the bytes that the controller has sent since the last call."""
        output = self._output + self.bench.board.take_output()
        self._output = b""
        return output
