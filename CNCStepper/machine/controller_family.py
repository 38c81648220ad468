# SPDX-License-Identifier: LGPL-2.1-or-later
"""The controller families: by which way a profile's machine is driven.

    controller                        family     what drives it
    grbl, grblhal, fluidnc            grbl       a controller with a firmware of its own, on a serial port or socket
    thesis-a                          parport    this computer: step pulses on a parallel port
    usb-board                         board      this computer: coil bytes to a USB board without a clock
    mini-lathe                        lathe      the lathe's own controller, which answers nothing
    linuxcnc, mach, marlin, iso ...   ""         nothing of ours: programs are files

The sender's process reads this table too, so that no package is imported here.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    from CNCStepper.machine.profile import Machine

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


def family_of(machine: Machine | None) -> Family:
    """Return the family of a profile's controller; "" where nothing drives it, or where there is no profile."""
    return FAMILIES.get(machine.controller, "") if machine else ""


def wire_language(machine: Machine | None) -> str:
    """Return the language in which its lines are sent where that is not the program's own, else ""."""
    return "grbl" if family_of(machine) in PULSES else ""
