# SPDX-License-Identifier: LGPL-2.1-or-later
"""The spindle's output: direction and the speed that override and limits leave of the programmed one."""

from __future__ import annotations

from CNCStepper.virtual.grbl.overrides import Overrides
from CNCStepper.virtual.grbl.settings import MAX_RPM, MIN_RPM, Settings

OFF = 5  # the M number; 3 is clockwise, 4 counter-clockwise


class Spindle:
    """State of the spindle output; `direction` is the M number in force."""

    def __init__(self, settings: Settings, overrides: Overrides):
        self._settings = settings
        self._overrides = overrides
        self.direction = OFF
        self._programmed_rpm = 0.0

    def switch(self, direction: int, rpm: float) -> None:
        """Set direction and programmed speed."""
        self.direction = direction
        self._programmed_rpm = rpm

    @property
    def rpm(self) -> float:
        """The speed on the output."""
        if self.direction == OFF or self._programmed_rpm == 0:
            return 0.0
        wanted = self._programmed_rpm * self._overrides.spindle / 100
        return min(max(wanted, self._settings[MIN_RPM]), self._settings[MAX_RPM])
