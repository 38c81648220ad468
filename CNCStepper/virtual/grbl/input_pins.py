# SPDX-License-Identifier: LGPL-2.1-or-later
"""The input pins of the board as a person presses them: the firmware's reaction, and its report.

    P probe   X Y Z limit switches   D door   R reset   H feed hold   S cycle start

D is a pin of its own only in a firmware built for it; it is here, so that a door can be tried.
"""

from __future__ import annotations

from CNCStepper.errors import MachineRefusal, Text

PROBE, LIMITS, DOOR = "P", "XYZ", "D"
PINS = f"{PROBE}{LIMITS}{DOOR}RHS"  # in the order of `Pn:`
PIN_BYTES = {DOOR: b"\x84", "R": b"\x18", "H": b"!", "S": b"~"}  # as these bytes of the link


class InputPins:
    """Which pins are held on; letters as in `Pn:`."""

    def __init__(self) -> None:
        self.held: set[str] = set()

    def press(self, pin: str) -> bool:
        """Hold a pin on; return whether it was off. Raises MachineRefusal where there is none of that name."""
        if pin not in tuple(PINS):
            raise MachineRefusal(
                "no-pin",
                Text("there is no pin '{pin}'", pin=pin[:20]),
                advice=Text("pins are {pins}", pins=", ".join(PINS)),
            )
        was_off = pin not in self.held
        self.held.add(pin)
        return was_off

    def release(self, pin: str) -> None:
        """Hold a pin on no more."""
        self.held.discard(pin)

    def letters(self, on: set[str]) -> str:
        """Return all pins that are held or `on`, as the status report names them."""
        return "".join(pin for pin in PINS if pin in self.held | on)
