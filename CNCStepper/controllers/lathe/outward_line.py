# SPDX-License-Identifier: LGPL-2.1-or-later
"""The line to the lathe: each byte takes its time, and a timed byte goes out at its time."""

from __future__ import annotations

from CNCStepper.control.protocol.lathe.serial_port import BYTE_S, LathePort


class OutwardLine:
    """Writes bytes to a port, and computes when the lathe has them; times in s on the board's clock."""

    def __init__(self, port: LathePort):
        self._port = port
        self._free_s = 0.0

    def send(self, data: bytes, now_s: float) -> float:
        """Send bytes; return when the last of them is at the lathe. Raises LinkError where the port is lost."""
        self._port.write(data)
        self._free_s = max(self._free_s, now_s) + len(data) * BYTE_S
        return self._free_s

    def arrival_s(self, count: int, now_s: float) -> float:
        """Return when the last of so many bytes would be at the lathe if they were sent now."""
        return max(self._free_s, now_s) + count * BYTE_S

    def is_empty(self, now_s: float) -> bool:
        """Return whether all that was sent is at the lathe."""
        return now_s >= self._free_s

    def check(self) -> None:
        """Raise LinkError where the port is lost."""
        self._port.check()

    def close(self) -> None:
        """Give the port back."""
        self._port.close()
