# SPDX-License-Identifier: LGPL-2.1-or-later
"""The state of cutter compensation between blocks: its radius and side, and the moves that wait."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from CNCStepper.state import State
from CNCStepper.toolpath import ARC_CCW, ARC_CW

Path3 = tuple[float, float, float]  # first and second axis of the plane, then its normal
ARCS = (ARC_CW, ARC_CCW)


class QueuedMove(NamedTuple):
    """A move to `end`; direction: of the programmed line, 0 where it does not matter; sweep: of the programmed arc."""

    motion: int
    end: Path3
    direction: complex
    feed: float
    centre: complex = 0j
    turns: int = 0
    sweep: float = 0.0
    line: int = 0
    state: State | None = None
    further: tuple[float, ...] = ()
    note: tuple[Callable, tuple] | None = None  # something else that waits

    @property
    def is_arc(self) -> bool:
        """Whether it is an arc."""
        return self.note is None and self.motion in ARCS


class Compensation(NamedTuple):
    """What is in force: radius in mm, never negative; orientation of a lathe tool; `entered`: a move was made."""

    left: bool
    radius: float
    orientation: int
    plane: str
    entered: bool = False
    programmed: Path3 = (0.0, 0.0, 0.0)
    current: Path3 = (0.0, 0.0, 0.0)
    programmed_work: tuple[float, float, float] = (0.0, 0.0, 0.0)
    held: tuple[QueuedMove, ...] = ()
    endpoint: complex | None = None  # where the first held move begins
