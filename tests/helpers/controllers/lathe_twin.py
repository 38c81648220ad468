# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mini-lathe's controller with a virtual lathe at its port, both on one clock."""

from __future__ import annotations

from typing import Any

from CNCStepper.controllers.lathe.board import LatheBoard
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.virtual.lathe.machine import Lathe

LIMIT_S = 7200.0


class LatheAtTwin:
    """A board whose port is a virtual lathe; step_s: how often both are looked at, twin: options of the lathe."""

    note = ""

    def __init__(self, machine: Machine | None = None, step_s: float = 0.0015, **twin: Any) -> None:
        machine = machine or load_machine("mini-lathe")
        self.twin = Lathe(machine, **twin)
        self.time_s, self.sent, self.said = 0.0, b"", ""
        self._waiting, self._step_s = b"", step_s
        self.board = LatheBoard(machine, self)

    def write(self, data: bytes) -> None:
        self.sent += data
        self._waiting += data
        self._pass_on()

    def check(self) -> None:
        """Nothing breaks here."""

    def close(self) -> None:
        """Nothing to give back."""

    def wait(self, seconds: float) -> None:
        end_s = self.time_s + seconds
        while self.time_s < end_s:
            self.time_s += self._step_s
            self.twin.advance(self.time_s)
            self._pass_on()
            self.board.advance(self._step_s)
        self.said += self.board.take_output().decode("ascii")

    def send(self, text: str, seconds: float = 0.01) -> None:
        self.board.receive(text.encode("ascii"))
        self.wait(seconds)

    def finish(self, limit_s: float = 500.0) -> None:
        self.wait(0.1)
        while self.board.state != "Idle":
            self.wait(0.1)
            assert self.time_s < limit_s

    def run(self, lines: list[str]) -> None:
        """Send lines as a sender that waits for each `ok`, and wait for the end of the motion."""
        for number, line in enumerate(lines, start=1):
            self.send(f"{line}\n", self._step_s)
            while self.said.count("ok\r\n") < number:
                assert "error" not in self.said and self.time_s < LIMIT_S, self.said[-500:]
                self.wait(self._step_s)
        self.finish(LIMIT_S)

    def _pass_on(self) -> None:
        count = self.twin.room
        self.twin.receive(self._waiting[:count], self.time_s, self.time_s)
        self._waiting = self._waiting[count:]
