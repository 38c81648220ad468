# SPDX-License-Identifier: LGPL-2.1-or-later
"""M6 of grblHAL while no tool changer is set up ($341=0): the machine waits in the state Tool for a person.

M6 ──► ok, Tool: no line is read ──0xA3──► jogs, and lines without motion ──~──► Idle: what waited at 0xA3 is read

A cycle start ends it without 0xA3, too. Spindle and coolant stay as the program has left them.
"""

from __future__ import annotations

from CNCStepper.virtual.grbl.serial_buffer import RxRing


class ToolChange:
    """Whether a tool change is pending, and the bytes that came before it was acknowledged."""

    def __init__(self) -> None:
        self.pending = False
        self._aside: bytes | None = None

    @property
    def stops_reading(self) -> bool:
        """Whether lines wait until the sender has acknowledged."""
        return self.pending and self._aside is None

    def begin(self) -> None:
        """Wait for a person."""
        self.pending, self._aside = True, None

    def acknowledge(self, ring: RxRing) -> None:
        """Set what waits aside, once, and read what comes from now on."""
        if self.stops_reading:
            self._aside = ring.swap(b"")

    def end(self, ring: RxRing) -> None:
        """Go on with what was set aside; what was not read since is lost."""
        if self._aside is not None:
            ring.swap(self._aside)
        self.pending, self._aside = False, None
