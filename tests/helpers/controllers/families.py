# SPDX-License-Identifier: LGPL-2.1-or-later
"""A board of each family that answers grbl's protocol, for tests that run over all of them."""

from __future__ import annotations

from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.virtual.grbl.machine import Grbl
from helpers.controllers.simulated_board import SimulatedBoard

FAMILIES = ("grbl", "parport", "parport-dda", "board")


def machine_of(family: str) -> Machine:
    """Return the machine of a family."""
    if family == "grbl":
        return load_machine("table-a")
    table = load_machine("thesis-table")
    changes = {"parport": {}, "parport-dda": {"interpolation": "dda"}, "board": {"controller": "usb-board"}}
    return table.model_copy(update=changes[family])


def board_of(family: str) -> Grbl:
    """Return a new board of that machine."""
    machine = machine_of(family)
    return Grbl(machine) if family == "grbl" else SimulatedBoard(machine)
