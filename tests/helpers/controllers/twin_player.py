# SPDX-License-Identifier: LGPL-2.1-or-later
"""A board of ours whose pulses the true player plays, on a clock of their own, and the virtual machines for them."""

from __future__ import annotations

import pytest

from CNCStepper.controllers.pulse_board import PulseBoard
from CNCStepper.machine.controller_family import family_of
from CNCStepper.machine.profile import Machine
from CNCStepper.virtual.board.machine import Board
from CNCStepper.virtual.motors.rotor import limits_of
from CNCStepper.virtual.parport.machine import Parport
from helpers.control.virtual_player import VirtualPlayer

TICK_S = 0.001
UNUSED = "unused"


class TwinPlayer:
    """The board of a machine; the published null pulse of a USB board takes coils away, so that rotors may slip."""

    def __init__(self, patch: pytest.MonkeyPatch, machine: Machine):
        self.machine = machine.model_copy(update={"signals": machine.signals.model_copy(update={"null_motor": UNUSED})})
        self.player = VirtualPlayer(patch, self.machine)
        self.board = PulseBoard(self.machine, self.player.output)
        self.board.take_output()

    @property
    def time_s(self) -> float:
        """The time on the clock."""
        return self.player.clock.ns / 1e9

    def pass_time(self, seconds: float) -> bytes:
        """Let time pass; return the board's output."""
        end_s = self.time_s + seconds
        while self.time_s < end_s:
            self.player.run_for(TICK_S)
            self.board.advance(TICK_S)
        return self.board.take_output()

    def send(self, line: str) -> None:
        """Send a line and wait for its ok."""
        self.board.receive(f"{line}\n".encode("ascii"))
        said = b""
        while b"ok" not in said:
            said += self.pass_time(TICK_S)
            assert b"error" not in said, said

    def run_to_rest(self) -> None:
        """Let everything be played."""
        while not self.board.quiet:
            self.pass_time(0.05)
        self.pass_time(0.2)

    def writes(self) -> list[tuple[float, bytes]]:
        """Return what was written, and when."""
        rows = self.player.port.rows
        as_bytes = (first if isinstance(first, bytes) else bytes((first, second)) for _, first, second, _ in rows)
        return [(ns / 1e9, data) for (ns, *_), data in zip(rows, as_bytes, strict=True)]


def twin_of(machine: Machine, real: bool = False) -> Parport | Board:
    """Return a virtual machine with ideal motors, or real ones that can lose steps."""
    axes = [machine.axes["xyz".index(motor[-1])] for motor in machine.signals.motors]
    limits = [limits_of(axis) if real else None for axis in axes]
    return (Parport if family_of(machine) == "parport" else Board)(machine, limits)
