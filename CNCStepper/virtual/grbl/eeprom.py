# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the board keeps without power: settings, work systems, start-up lines, build text.

The virtual board's memory lives as long as its process; a soft reset leaves it alone, as it should.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from CNCStepper.virtual.grbl.firmware import GRBL, Firmware
from CNCStepper.virtual.grbl.gcode.block import FIRST_SYSTEM
from CNCStepper.virtual.grbl.settings import Settings


def no_places(firmware: Firmware = GRBL) -> dict[int, list[float]]:
    """Return the places of a board on which nothing was stored."""
    systems = range(FIRST_SYSTEM, FIRST_SYSTEM + firmware.systems)
    return {place: [0.0, 0.0, 0.0] for place in (*systems, 28, 30)}


@dataclass
class Eeprom:
    """The board's EEPROM; `places` are G54 to G59 (G59.1 is 60), G28 and G30 by number, mm in machine coordinates."""

    settings: Settings
    firmware: Firmware = GRBL
    places: dict[int, list[float]] = field(default_factory=dict)
    startup_lines: list[str] = field(default_factory=lambda: ["", ""])
    build_text: str = ""

    def __post_init__(self) -> None:
        self.clear_places()

    def clear_places(self) -> None:
        """Forget every stored position (`$RST=#`)."""
        self.places = no_places(self.firmware)

    def clear_all(self) -> None:
        """Forget everything but what the machine profile says (`$RST=*`)."""
        self.settings.restore()
        self.clear_places()
        self.startup_lines = ["", ""]
        self.build_text = ""
