# SPDX-License-Identifier: LGPL-2.1-or-later
"""What moves become: pulses on a planned clock, and what takes them away to play them.

moves ──► MoveSource ──make──► PlannedPulses ──append──► PulseOutput ──► port
          planned clock        tick, step, speed          real clock: hold, resume and a lower share stretch the
                                                          planned times, by the speed and acceleration of each pulse
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from CNCStepper.control.pulses.pacing import Jitter
from CNCStepper.errors import MachineRefusal
from CNCStepper.motion.planner.machine_limits import Limits


@dataclass(frozen=True)
class PlannedPulses:
    """Consecutive pulses, an entry a pulse.

    ticks: int64, of the planned clock at TICKS_PER_S, strictly rising. step, back: uint8, bit n for axis n, back only
    where step is. speed_mm_s: float32, along the path over the time that ends with the pulse. acceleration_mm_s2:
    float32, the most that the axes allow along the path there. is_rapid: bool. move: int64, the number of the move that
    a pulse is of.
    """

    ticks: np.ndarray
    step: np.ndarray
    back: np.ndarray
    speed_mm_s: np.ndarray
    acceleration_mm_s2: np.ndarray
    is_rapid: np.ndarray
    move: np.ndarray

    def __len__(self) -> int:
        return len(self.ticks)

    @property
    def columns(self) -> tuple[np.ndarray, ...]:
        """The columns that an output takes, in its order."""
        return (self.ticks, self.step, self.back, self.speed_mm_s, self.acceleration_mm_s2, self.is_rapid)

    def cut(self, first: int, last: int) -> PlannedPulses:
        """Return the pulses from `first` up to, without, `last`."""
        return PlannedPulses(*(column[first:last] for column in (*self.columns, self.move)))


class PulseOutput(Protocol):
    """What plays pulses: `control.pulses.pulse_output.PulseOutput`. Its methods return at once."""

    @property
    def room(self) -> int:
        """Pulses that may be appended now."""

    @property
    def queued_s(self) -> float:
        """Planned time that is appended and not yet played."""

    @property
    def sent(self) -> int:
        """How many pulses were played."""

    @property
    def position_steps(self) -> tuple[int, ...]:
        """Where the axes are, by the pulses that were played."""

    @property
    def rate_mm_min(self) -> float:
        """The speed along the path now."""

    @property
    def state(self) -> str:
        """One of "idle" (nothing queued), "run", "hold" (braking), "held", "failed"."""

    def append(self, ticks, step, back, speed_mm_s, acceleration_mm_s2, is_rapid) -> None:
        """Take the columns of `PlannedPulses`; there must be room."""

    def declare(self, axis: int, steps: int) -> None:
        """Say where an axis is; it does not move."""

    def hold(self) -> None:
        """Brake along the path."""

    def resume(self) -> None:
        """Go on after a hold."""

    def share(self, feed: float, rapid: float) -> None:
        """Play feeds and rapids at these shares of their planned speeds, 1 at most."""

    def drop(self) -> None:
        """At rest: forget what is appended and not played."""

    def stop_at_once(self) -> None:
        """Stop without a ramp, outputs off; steps may be lost."""

    def switch(self, device: str, on: bool) -> None:
        """Switch a relay by its name."""

    def inputs(self) -> frozenset[int]:
        """Return the status pins that are high."""

    def trial(self, pulses_per_s: float) -> Jitter:
        """Try a rate at rest; raises MachineRefusal where it cannot be kept."""

    def check(self) -> None:
        """Raise the error that ended the pulses, if one did."""

    def close(self) -> None:
        """Switch outputs off and end."""


class EndedOutput:
    """Takes the place of an output that has ended: nothing moves any more."""

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
        """Nothing goes on."""

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


class MoveSource(ABC):
    """Makes pulses of moves; its axes are ahead of those of the machine, where its pulses are played later.

    Its planned clock goes on only while it makes pulses, and never back, also where moves are forgotten.
    last_move: the number of the newest move; one that is shorter than a step has none.
    """

    last_move = 0

    @property
    @abstractmethod
    def room(self) -> int:
        """Moves that may be queued now."""

    @property
    @abstractmethod
    def idle(self) -> bool:
        """Whether the pulses of every move have been made."""

    @property
    @abstractmethod
    def end_steps(self) -> tuple[int, ...]:
        """Where the axes are once every move has been made; to be asked when idle."""

    @abstractmethod
    def line(self, target_mm: Sequence[float], feed_mm_min: float, rapid: bool) -> None:
        """Queue a straight move to a machine position; there must be room."""

    @abstractmethod
    def make(self, seconds: float) -> list[PlannedPulses]:
        """Let about so much planned time pass and return the pulses in it."""

    @abstractmethod
    def quicken(self, feed: float) -> None:
        """Plan what is not made yet at this factor, 1 or more, of its feed."""

    @abstractmethod
    def stand_at(self, steps: Sequence[int], limits: Limits) -> None:
        """Forget all moves, and go on from a place under limits that may be others."""
