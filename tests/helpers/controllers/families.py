# SPDX-License-Identifier: LGPL-2.1-or-later
"""A board of each family that answers grbl's protocol, for tests that run over all of them, and its programs."""

from __future__ import annotations

from dataclasses import dataclass

from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.virtual.grbl.machine import Grbl
from helpers.controllers.simulated_board import SimulatedBoard
from helpers.controllers.simulated_lathe import SimulatedLathe

FAMILIES = ("grbl", "parport", "parport-dda", "board", "lathe")


@dataclass(frozen=True)
class Programs:
    """Programs in the language of a family's wire.

    square: back to its begin, some seconds long. to_3: X from 0 to 3 mm. there_and_back: X out and back, at a feed.
    """

    dialect: str
    square: tuple[str, ...]
    to_3: tuple[str, ...]
    there_and_back: tuple[str, ...]


G_CODE = Programs(
    "grbl",
    ("G21G90G94", "G1X20F1500", "G1Y20", "G1X0", "G1Y0"),
    ("G21G90G94", "G1X3Y0F1500"),
    ("G21G90G94", "G1X15F600", "G1X0"),
)
RECORDS = Programs(
    "mini-lathe",
    ("G01X-2.F1.#", "G01Z-2.F1.#", "G01X2.F1.#", "G01Z2.F1.#"),
    ("G01X3.F2.#",),
    ("G01X-2.F1.#", "G01X2.F1.#"),
)


def programs_of(family: str) -> Programs:
    """Return the programs of a family."""
    return RECORDS if family == "lathe" else G_CODE


def machine_of(family: str) -> Machine:
    """Return the machine of a family."""
    if family == "grbl":
        return load_machine("table-a")
    if family == "lathe":
        return load_machine("mini-lathe")
    table = load_machine("thesis-table")
    changes = {"parport": {}, "parport-dda": {"interpolation": "dda"}, "board": {"controller": "usb-board"}}
    return table.model_copy(update=changes[family])


def board_of(family: str) -> Grbl | SimulatedLathe:
    """Return a new board of that machine."""
    machine = machine_of(family)
    boards = {"grbl": Grbl, "lathe": SimulatedLathe}
    return boards.get(family, SimulatedBoard)(machine)
