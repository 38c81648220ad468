# SPDX-License-Identifier: LGPL-2.1-or-later
"""The probe: a plate at a set height closes its circuit for every tool at or below it."""

from __future__ import annotations

from math import floor

from CNCStepper.virtual.grbl.gcode.block import Z
from CNCStepper.virtual.grbl.planner import Axes


class Probe:
    """The probe's pin and the result of the last probing move; `height_mm` None means no plate."""

    def __init__(self, height_mm: float | None):
        self.height_mm = height_mm
        self.held = False  # by hand
        self.begin()

    def begin(self) -> None:
        """Forget the last result, as a reset does."""
        self.contact_steps: tuple[int, ...] = (0, 0, 0)
        self.found = False
        self.searching = False
        self._away = False
        self._before: tuple[int, ...] = (0, 0, 0)

    def touches(self, axes: Axes) -> bool:
        """Return whether the pin is closed."""
        return self.held or (self.height_mm is not None and axes.position_mm[Z] <= self.height_mm)

    def await_change(self, axes: Axes, away: bool) -> bool:
        """Begin to look for the change of the pin; return False where it is already as the move is to make it."""
        self.found = False
        self._away = away
        if self.touches(axes) != away:
            return False
        self.searching = True
        self._before = axes.position_steps
        return True

    def watch(self, axes: Axes) -> None:
        """Note the place where the pin changes, and bring the move to its stop there."""
        if self.touches(axes) != self._away:
            self.contact_steps = self._contact(axes)
            self.found = True
            self.searching = False
            axes.hold()
        self._before = axes.position_steps

    def _contact(self, axes: Axes) -> tuple[int, ...]:
        """Return the first step at which the pin has changed, between the last look and now."""
        before, now = self._before, axes.position_steps
        plate = floor((self.height_mm or 0.0) / axes.step_mm(Z) + 1e-6)
        first = plate + 1 if self._away else plate
        part = (first - before[Z]) / (now[Z] - before[Z])
        return tuple(round(b + (n - b) * part) for b, n in zip(before, now, strict=True))
