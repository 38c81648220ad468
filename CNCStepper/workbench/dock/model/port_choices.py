# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a job can be cut: the virtual grbl, the serial ports found, and an address that is typed."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from CNCStepper.workbench.services.plain_words import plain, port_of_address
from CNCStepper.workbench.services.translation import later

VIRTUAL = "virtual"
VIRTUAL_TEXT = later("Virtual grbl (no machine)")
BAUDS = (9600, 19200, 38400, 57600, 115200, 230400, 250000, 460800, 921600, 1000000)
SPEEDS = (1, 10)


@dataclass(frozen=True)
class Choice:
    """One entry of the port list; `port` is opened, `VIRTUAL` starts the virtual machine."""

    port: str
    text: str

    @property
    def virtual(self) -> bool:
        """Whether it is the virtual grbl."""
        return self.port == VIRTUAL


def choices(found: Iterable[tuple[str, str]], virtual_text: str, last: str = "") -> list[Choice]:
    """Return the port list: the virtual grbl first, then the ports found, then the last one used if it is none of them.

    found: name of each serial port, and the text that people know it by. last: what was opened last, "" for nothing.
    """
    listed = [Choice(VIRTUAL, virtual_text)]
    listed += [Choice(name, text) for name, text in found]
    if last and last not in {choice.port for choice in listed}:
        listed.append(Choice(last, plain(last)))
    return listed


def port_of(typed: str, listed: Iterable[Choice]) -> str:
    """Return the port that a text in the field means: that of the entry with this text, or the address or device."""
    typed = typed.strip()
    return next((choice.port for choice in listed if choice.text == typed), port_of_address(typed))


def needs_baud(port: str) -> bool:
    """Return whether a port has a baud rate: a serial one, neither the virtual grbl nor a URL."""
    return port != VIRTUAL and "://" not in port
