# SPDX-License-Identifier: LGPL-2.1-or-later
"""The serial ports of this computer, as a person chooses among them."""

from __future__ import annotations

from dataclasses import dataclass

from CNCStepper.control.transport.link import port_names


@dataclass(frozen=True)
class PortChoice:
    """A port: its name for `open_link`, and the text that a person recognizes it by."""

    name: str
    text: str


def port_list() -> list[PortChoice]:
    """Return the serial ports, sorted by name; raises MissingPackage without pyserial."""
    return [PortChoice(name, _text(name, description)) for name, description in port_names()]


def _text(name: str, description: str) -> str:
    known = description not in ("", "n/a", name)
    return f"{name} – {description}" if known else name
