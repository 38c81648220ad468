# SPDX-License-Identifier: LGPL-2.1-or-later
"""The input pins of the board, as a person's finger holds them: what the firmware does at the press, and what it tells.

    P probe   X Y Z limit switches   D door   R reset   H feed hold   S cycle start

D is a pin of its own only in a firmware built for it; it is here, so that a door can be tried.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from CNCStepper.errors import MachineRefusal

if TYPE_CHECKING:
    from CNCStepper.virtual.grbl.machine import Grbl

PROBE, LIMITS, DOOR = "P", "XYZ", "D"
PINS = f"{PROBE}{LIMITS}{DOOR}RHS"  # in the order of `Pn:`
ACTING = {DOOR: b"\x84", "R": b"\x18", "H": b"!", "S": b"~"}  # as these bytes of the link


class InputPins:
    """Which pins are held on; letters as in `Pn:`."""

    def __init__(self) -> None:
        self.held: set[str] = set()

    def press(self, machine: Grbl, pin: str) -> None:
        """Switch a pin on; raises MachineRefusal where there is none of that name."""
        if pin not in tuple(PINS):
            raise MachineRefusal("no-pin", f"there is no pin '{pin[:20]}'", advice=f"pins are {', '.join(PINS)}")
        if pin in self.held:
            return
        self.held.add(pin)
        machine.probe.held = PROBE in self.held
        if pin in ACTING:
            machine.receive(ACTING[pin])
        elif pin in LIMITS:
            machine.reach_limit()

    def release(self, machine: Grbl, pin: str) -> None:
        """Switch a pin off."""
        self.held.discard(pin)
        machine.probe.held = PROBE in self.held

    def letters(self, on: set[str]) -> str:
        """Return all pins that are held or `on`, as the status report names them."""
        return "".join(pin for pin in PINS if pin in self.held | on)
