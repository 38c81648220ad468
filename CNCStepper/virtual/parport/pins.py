# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pins of a parallel port as a machine at its cable sees them: levels from registers, and inputs to one.

base + 0   data      bits 0 to 7   pins 2 to 9
base + 1   status    bits 3 to 7   pins 15 13 12 10 11; the port turns pin 11 round: a 1 means that it is low
base + 2   control   bits 0 to 3   pins 1 14 16 17; the port turns 1, 14 and 17 round: a 1 makes them low

These tables are the machine's own and not those of the sender's side, so that either can find the other wrong.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from CNCStepper.errors import MachineRefusal, Text

OUTPUT_BITS = {2: 0, 3: 1, 4: 2, 5: 3, 6: 4, 7: 5, 8: 6, 9: 7, 1: 8, 14: 9, 16: 10, 17: 11}  # of control * 256 + data
TURNED_OUTPUTS = (1, 14, 17)
STATUS_BITS = {15: 3, 13: 4, 12: 5, 10: 6, 11: 7}
TURNED_INPUTS = (11,)


def pin_levels(data: np.ndarray, control: np.ndarray) -> np.ndarray:
    """Return which output pins are high, uint32[k], bit n: pin n; data, control: uint8[k]."""
    word = data.astype(np.uint32) | control.astype(np.uint32) << np.uint32(8)
    levels = np.zeros(len(word), np.uint32)
    for pin, bit in OUTPUT_BITS.items():
        high = word >> np.uint32(bit) & np.uint32(1)
        levels |= (high ^ np.uint32(pin in TURNED_OUTPUTS)) << np.uint32(pin)
    return levels


class PinFaults:
    """Output pins that are wired wrongly: dead ones stay at the level they had, swapped ones have each other's."""

    def __init__(self) -> None:
        self._stuck = 0  # mask of pins
        self._stuck_levels = 0
        self._swapped: list[tuple[int, int]] = []

    def kill(self, pin: int, levels: int) -> None:
        """Let a pin stay as it is in `levels`."""
        self._stuck |= 1 << pin
        self._stuck_levels |= levels & 1 << pin

    def swap(self, pin: int, other: int) -> None:
        """Let two pins have each other's levels."""
        self._swapped.append((pin, other))

    def seen(self, levels: np.ndarray) -> np.ndarray:
        """Return the levels that arrive at the drives, uint32[k]."""
        for pin, other in self._swapped:
            differ = (levels >> np.uint32(pin) ^ levels >> np.uint32(other)) & np.uint32(1)
            levels = levels ^ (differ << np.uint32(pin) | differ << np.uint32(other))
        return levels & ~np.uint32(self._stuck) | np.uint32(self._stuck_levels)


class InputPins:
    """The machine's switches and buttons on the status pins.

    active_low: the pins that are low while pressed, and so high while not.
    """

    def __init__(self, active_low: Mapping[int, bool]):
        self.pin_names = tuple(str(pin) for pin in sorted(STATUS_BITS))
        self._active_low = active_low
        self._pressed: set[int] = set()

    def set(self, name: str, pressed: bool) -> None:
        """Press a switch or let it go; raises MachineRefusal where the pin is no input."""
        if name not in self.pin_names:
            raise MachineRefusal(
                "no-pin",
                Text("there is no input '{name}'", name=name[:20]),
                advice=Text("pins: {pins}", pins=self.text(all_of=True)),
            )
        (self._pressed.add if pressed else self._pressed.discard)(int(name))

    def text(self, all_of: bool = False) -> str:
        """Return the pins that are pressed, or all there are, in words."""
        return ", ".join(name for name in self.pin_names if all_of or int(name) in self._pressed)

    @property
    def register(self) -> int:
        """The status register: the bits that are no pins are 0."""
        word = 0
        for pin, bit in STATUS_BITS.items():
            high = (pin in self._pressed) != self._active_low.get(pin, False)
            word |= (high != (pin in TURNED_INPUTS)) << bit
        return word
