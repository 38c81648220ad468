# SPDX-License-Identifier: LGPL-2.1-or-later
"""The controller families: how a profile's machine is driven.

    controller                        family     what drives it
    grbl, grblhal, fluidnc            grbl       a controller with a firmware of its own, on a serial port or socket
    thesis-a                          parport    this computer: step pulses on a parallel port
    usb-board                         board      this computer: coil bytes to a USB board without a clock
    mini-lathe                        lathe      the lathe's own controller, which answers nothing
    linuxcnc, mach, marlin, iso ...   ""         nothing of ours: programs are files

The sender's process reads this table too, so that no package is imported here.
"""

from __future__ import annotations

from typing import Literal, Protocol

Family = Literal["grbl", "parport", "board", "lathe", ""]
FAMILIES: dict[str, Family] = {
    "grbl": "grbl",
    "grblhal": "grbl",
    "fluidnc": "grbl",
    "thesis-a": "parport",
    "usb-board": "board",
    "mini-lathe": "lathe",
}
OWN: tuple[Family, ...] = ("parport", "board", "lathe")  # a process on this computer is their controller
PULSES: tuple[Family, ...] = ("parport", "board")  # of these, those whose single pulses it makes
BAUD = 115_200  # of a serial link to a controller of grbl's family, where nobody chooses another rate
WIRE_LANGUAGE = "grbl"  # of lines to a CNCStepper controller that makes pulses
LANGUAGES = {"usb-board": WIRE_LANGUAGE}  # of programs, where the controller's name is that of no dialect


class Driven(Protocol):
    """The part of a machine profile that selects its controller."""

    @property
    def controller(self) -> str:
        """The name of its controller, perhaps with settings of its language: "mini-lathe:thread_start=index"."""


def family_of(machine: Driven | None) -> Family:
    """Return the family of a profile's controller; "" where nothing drives it, or where there is no profile."""
    return FAMILIES.get(machine.controller.partition(":")[0], "") if machine else ""


def makes_pulses(machine: Driven | None) -> bool:
    """Return whether this computer makes the machine's pulses, so that outputs are its pins."""
    return family_of(machine) in PULSES
