# SPDX-License-Identifier: LGPL-2.1-or-later
"""The output of a board after its pulse output has ended by itself."""

from __future__ import annotations

from CNCStepper.control.pulses.pacing import Jitter
from CNCStepper.control.pulses.pulse_player_client import PulseOutput
from CNCStepper.errors import MachineRefusal


class EndedOutput:
    """Takes the place of a `PulseOutput` that has ended: nothing moves any more."""

    room = sent = 0
    queued_s = 0.0
    rate_mm_min = 0.0
    state = "failed"

    def __init__(self, position_steps: tuple[int, ...]):
        self.position_steps = position_steps

    def append(self, ticks, step, back, speed_mm_s, acceleration_mm_s2, is_rapid) -> None:
        """Take nothing: there is no room."""

    def declare(self, axis: int, steps: int) -> None:
        """Let an axis be said to be somewhere."""
        here = self.position_steps
        self.position_steps = (*here[:axis], steps, *here[axis + 1 :])

    def hold(self) -> None:
        """Nothing moves."""

    def resume(self) -> None:
        """Nothing continues."""

    def share(self, feed: float, rapid: float) -> None:
        """Nothing moves."""

    def drop(self) -> None:
        """Nothing is queued."""

    def stop_at_once(self) -> None:
        """Nothing moves."""

    def switch(self, device: str, on: bool) -> None:
        """Everything is off."""

    def inputs(self) -> frozenset[int]:
        """Return no pins."""
        return frozenset()

    def trial(self, pulses_per_s: float) -> Jitter:
        """Refuse: there is nothing to try."""
        raise MachineRefusal("pulse-worker", "the pulses have ended", advice="connect again")

    def check(self) -> None:
        """It is known that they have ended."""

    def close(self) -> None:
        """Nothing is open."""


Output = PulseOutput | EndedOutput
