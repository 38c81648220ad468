# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moves as pulses on a planned clock, which an output plays (`control/pulses/pulse_player_client.py`).

moves ──► MoveSource ──make──► PlannedPulses ──append──► output ──► port
          planned clock        tick, step, speed          real clock: hold, resume and a lower share stretch the
                                                          planned times, by the speed and acceleration of each pulse
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

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
        """Plan the moves that are not made yet at this factor, 1 or more, of their feed."""

    @abstractmethod
    def stand_at(self, steps: Sequence[int], limits: Limits) -> None:
        """Discard all moves, and continue from a position under new limits."""
