# SPDX-License-Identifier: LGPL-2.1-or-later
"""The board of a machine, by its family; the interface of a board for a controller's process."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from CNCStepper.control.pulses.pulse_player_client import PulseOutput
from CNCStepper.controllers.lathe.board import open_lathe
from CNCStepper.controllers.pulse_axes import load_kernels
from CNCStepper.controllers.pulse_board import PulseBoard
from CNCStepper.errors import MachineRefusal, Text
from CNCStepper.machine.controller_family import family_of
from CNCStepper.machine.profile import Machine


class ServedBoard(Protocol):
    """A board as the process of a controller runs it: bytes in, bytes out, and the wall clock's time."""

    @property
    def quiet(self) -> bool:
        """Whether it only waits for bytes: nothing moves, no line is in hand."""

    @property
    def at_rest(self) -> bool:
        """Whether no axis moves."""

    def receive(self, data: bytes) -> None:
        """Take bytes from the sender."""

    def advance(self, dt_s: float) -> None:
        """Take note that `dt_s` seconds have passed."""

    def take_output(self) -> bytes:
        """Return the bytes that the board has sent since the last call."""

    def come_to_rest(self) -> None:
        """Begin to brake, whatever moves, for the end of the process."""

    def close(self) -> None:
        """Switch everything off and give the port back."""


def _pulses(machine: Machine, port: str) -> ServedBoard:
    output = PulseOutput.launch(port, machine)
    try:
        load_kernels(machine)
        return PulseBoard(machine, output)
    except BaseException:  # whatever it is, the port is to be given back
        output.close()
        raise


FACTORIES: dict[str, Callable[[Machine, str], ServedBoard]] = {
    "parport": _pulses,
    "board": _pulses,
    "lathe": open_lathe,
}


def open_board(machine: Machine, port: str) -> ServedBoard:
    """Return the board that drives a machine at a port.

    Raises LinkError where the port cannot be opened, MachineRefusal where CNCStepper cannot drive this machine.
    """
    factory = FACTORIES.get(family_of(machine))
    if factory is None:
        raise MachineRefusal(
            "no-controller",
            Text("{machine} has a controller of its own", machine=machine.name),
            value=machine.controller,
            limit=", ".join(FACTORIES),
            advice="connect to its port without a machine profile",
        )
    return factory(machine, port)
