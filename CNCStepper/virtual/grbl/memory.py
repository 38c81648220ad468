# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the board keeps without power: settings, work systems, start-up lines, build text.

The virtual board's memory lives as long as its process; a soft reset leaves it alone, as it should.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from CNCStepper.virtual.grbl.block import SYSTEMS
from CNCStepper.virtual.grbl.settings import Settings

PLACES = (*range(54, 54 + SYSTEMS), 28, 30)


def _zeros() -> dict[int, list[float]]:
    return {place: [0.0, 0.0, 0.0] for place in PLACES}


@dataclass
class Memory:
    """The board's EEPROM; `places` are G54 to G59, G28 and G30 by number, mm in machine coordinates."""

    settings: Settings
    places: dict[int, list[float]] = field(default_factory=_zeros)
    startup_lines: list[str] = field(default_factory=lambda: ["", ""])
    build_text: str = ""

    def clear_places(self) -> None:
        """Forget every stored position (`$RST=#`)."""
        self.places = _zeros()

    def clear_all(self) -> None:
        """Forget everything but what the machine profile says (`$RST=*`)."""
        self.settings.restore()
        self.clear_places()
        self.startup_lines = ["", ""]
        self.build_text = ""
