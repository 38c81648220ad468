# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields that a status report carries only now and then, because the line is slow: offsets and overrides."""

from __future__ import annotations

OFFSET_EVERY_BUSY, OFFSET_EVERY_IDLE = 30, 10  # reports between two WCO fields
OVERRIDES_EVERY_BUSY, OVERRIDES_EVERY_IDLE = 20, 10


class OccasionalFields:
    """Counts the reports until the work offset and the overrides are due again."""

    def __init__(self) -> None:
        self._reports_to_offset = 0
        self._reports_to_overrides = 0

    def offset_changed(self) -> None:
        """Let the next report carry WCO."""
        self._reports_to_offset = 0

    def overrides_changed(self) -> None:
        """Let the next report carry Ov."""
        self._reports_to_overrides = 0

    def offset_is_due(self, busy: bool) -> bool:
        """Count a report; return whether it carries WCO. Then the overrides wait for the next one."""
        if self._reports_to_offset:
            self._reports_to_offset -= 1
            return False
        self._reports_to_offset = (OFFSET_EVERY_BUSY if busy else OFFSET_EVERY_IDLE) - 1
        self._reports_to_overrides = self._reports_to_overrides or 1
        return True

    def overrides_are_due(self, busy: bool) -> bool:
        """Count a report, after `offset_is_due`; return whether it carries Ov."""
        if self._reports_to_overrides:
            self._reports_to_overrides -= 1
            return False
        self._reports_to_overrides = (OVERRIDES_EVERY_BUSY if busy else OVERRIDES_EVERY_IDLE) - 1
        return True
