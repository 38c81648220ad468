# SPDX-License-Identifier: LGPL-2.1-or-later
"""The status pins of a parallel port, polled by a thread; or a file in place of a port.

base + 1   status    bits 3 to 7   pins 15 13 12 10 11; the port turns 11 round: a 1 is low
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from pathlib import Path
from typing import Protocol

from CNCStepper.control.pulses.ports import CLAIM, RELEASE, is_parallel_port, no_port
from CNCStepper.errors import LinkError, Text

READ_STATUS = 0x80017081  # of Linux's ppdev.h
BITS = {15: 3, 13: 4, 12: 5, 10: 6, 11: 7}
INVERTED = (11,)
LOOK_EVERY_S = 0.005
CLOSE_LIMIT_S = 1.0  # another program may have claimed the port

Pins = frozenset[int]


class StatusPins(Protocol):
    """Inputs of one port."""

    def high(self) -> Pins:
        """Return the pins that are high now; raises LinkError where they cannot be read."""


class ParallelStatus:
    """The status pins of a parallel port by its device file, which others may use between two looks."""

    def __init__(self, path: Path):
        self._path = path
        self.high()

    def high(self) -> Pins:
        """Return the pins that are high now."""
        from fcntl import ioctl

        try:
            with self._path.open("rb", buffering=0) as port:
                ioctl(port, CLAIM)
                register = ioctl(port, READ_STATUS, b"\0")
                ioctl(port, RELEASE)
        except OSError as error:
            raise no_port(self._path, error) from error
        return high_pins(register[0])


class FilePins:
    """A text file with the numbers of the pins that are high: a port for trials."""

    def __init__(self, path: Path):
        self._path = path
        self.high()

    def high(self) -> Pins:
        """Return the pins that are high now."""
        try:
            return frozenset(map(int, self._path.read_text("utf-8").split()))
        except (OSError, ValueError) as error:
            advice = "name a parallel port (/dev/parport0), or a text file with the numbers of the pins that are high"
            raise LinkError(
                "input-port", Text("{path} has no pins to read: {error}", path=self._path, error=error), advice=advice
            ) from error


def high_pins(register: int) -> Pins:
    """Return the pins that are high for the value of the status register."""
    return frozenset(pin for pin, bit in BITS.items() if bool(register >> bit & 1) != (pin in INVERTED))


def open_pins(port: str) -> StatusPins:
    """Return the pins of a port's device file, or those of a text file; raises LinkError where they cannot be read."""
    path = Path(port)
    return ParallelStatus(path) if is_parallel_port(path) else FilePins(path)


class PinWatch:
    """Looks at the pins of one port again and again, on a thread of its own, until `close`.

    look: gets the pins that are high. lost: hears why they cannot be read any more; nothing is looked at then.
    """

    def __init__(self, pins: StatusPins, look: Callable[[Pins], None], lost: Callable[[LinkError], None]):
        self._pins = pins
        self._look = look
        self._lost = lost
        self._closed = threading.Event()
        self._thread = threading.Thread(target=self._run, name="pins", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Look no more."""
        self._closed.set()
        self._thread.join(CLOSE_LIMIT_S)

    def _run(self) -> None:
        try:
            while not self._closed.wait(LOOK_EVERY_S):
                self._look(self._pins.high())
        except LinkError as error:
            self._lost(error)
