# SPDX-License-Identifier: LGPL-2.1-or-later
"""The probe: a plate at a set height closes its circuit for every tool at or below it."""

from __future__ import annotations

from math import floor
from typing import TYPE_CHECKING

from CNCStepper.virtual.grbl import report
from CNCStepper.virtual.grbl.error_codes import ALARM_PROBE_NO_CONTACT, ALARM_PROBE_START
from CNCStepper.virtual.grbl.gcode_block import PROBE_AWAY, PROBE_AWAY_QUIET, PROBE_TOWARD_QUIET, Block, Z

if TYPE_CHECKING:
    from CNCStepper.virtual.grbl.axes import Axes
    from CNCStepper.virtual.grbl.machine import Grbl, Waiting

QUIET = (PROBE_TOWARD_QUIET, PROBE_AWAY_QUIET)  # G38.3 and G38.5 raise no alarm
AWAY = (PROBE_AWAY, PROBE_AWAY_QUIET)


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

    def run(self, machine: Grbl, block: Block) -> Waiting:
        """Make a probing move (G38.2 to G38.5) and print its result."""
        yield from machine.wait_for_stop()
        self.found = False
        self._away = block.modal.motion in AWAY
        if self.touches(machine.axes) != self._away:
            machine.alarm(ALARM_PROBE_START)
            return
        self.searching = True
        self._before = machine.axes.position_steps
        machine.override_motion()
        yield from machine.queue(block.target, block.feed)
        machine.start_cycle()
        while not machine.axes.stopped:
            yield
        self._finish(machine, block)

    def _finish(self, machine: Grbl, block: Block) -> None:
        if not self.found and block.modal.motion in QUIET:
            self.contact_steps = machine.axes.position_steps
        self.searching = False
        machine.axes.reset()
        machine.finish_cycle()
        if not self.found and block.modal.motion not in QUIET:
            machine.alarm(ALARM_PROBE_NO_CONTACT)
        settings = machine.memory.settings
        machine.send(report.probe_result(machine.axes.mm_of(self.contact_steps), self.found, settings))
        if self.found:
            block.target = machine.axes.position_mm
