# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the axes come to rest between the moves of a table, and for how long."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from CNCStepper.motion.planner.buffers import TICKS_PER_S
from CNCStepper.state import State
from CNCStepper.toolpath import Chunk, Event

DWELL_STEP_S = 0.05
RUNNING_EVENTS = ("message", "comment", "tool_select", "optional_pause")  # the rest stop the motion


class Stops:
    """Where the firmware lets the axes come to rest: dwells, pauses and changes of spindle, coolant or offset.

    A change of spindle state always waits for the motion to end, in laser mode too; a change of speed alone
    does so unless it is a laser. A change of the work offset waits as well (grbl's
    FORCE_BUFFER_SYNC_DURING_WCO_CHANGE, on as delivered).
    """

    def __init__(self, states: Sequence[State], events: list[Event], laser: bool, forgets: bool = False):
        """forgets: events that are passed; `events` is emptied as it is read, so the pass cannot go back."""
        self.states = states
        self.laser = laser
        self.state = 0
        self.events: list[Event] = []  # that stop the motion, of those that are known so far
        self._all, self._seen, self._forgets = events, 0, forgets
        self.next_event = 0

    @property
    def place(self) -> tuple[int, int]:
        """How far it has come: the last state and the next event."""
        return self.state, self.next_event

    @place.setter
    def place(self, place: tuple[int, int]) -> None:
        self.state, self.next_event = place

    def before(self, chunk: Chunk) -> np.ndarray:
        """Return the ticks of standstill before each row, int64[n]; -1 where the motion continues."""
        self._see_events()
        dwell = np.full(len(chunk), -1, np.int64)
        changes = np.flatnonzero(np.diff(chunk.state, prepend=self.state))
        for change in changes:
            if self._stops(self.state, int(chunk.state[change])):
                dwell[change] = 0
            self.state = int(chunk.state[change])
        while self.next_event < len(self.events) and self.events[self.next_event].index < chunk.first + len(chunk):
            event = self.events[self.next_event]
            row = event.index - chunk.first
            dwell[row] = max(0, dwell[row]) + dwell_ticks(event)
            self.next_event += 1
        return dwell

    def stop_before(self, follows: Chunk) -> bool:
        """Return whether the motion stops before the chunk that follows what it has come to."""
        events = self.events[self.next_event : self.next_event + 1]
        return any(event.index <= follows.first for event in events) or self._stops(self.state, int(follows.state[0]))

    def last(self) -> list[int]:
        """Return the ticks of the standstills after the last row."""
        self._see_events()
        return [dwell_ticks(event) for event in self.events[self.next_event :] if event.kind == "dwell"]

    def _see_events(self) -> None:
        """Take up the events that have come since, as those of a table that is still being read do."""
        coming = self._all[self._seen :]
        self._seen += len(coming)
        if self._forgets:
            self.events, self.next_event, self._seen = self.events[self.next_event :], 0, 0
            self._all.clear()
        self.events += [event for event in coming if event.kind not in RUNNING_EVENTS]

    def _stops(self, before: int, after: int) -> bool:
        """Return whether any change of state from `before` to `after` stops the motion."""
        passed = self.states[before : after + 1] if before < after else [self.states[before], self.states[after]]
        return any(self._differ(one, other) for one, other in pairwise(passed))

    def _differ(self, one: State, other: State) -> bool:
        kept = ("spindle", "mist", "flood", "offset_mm")
        if any(getattr(one, name) != getattr(other, name) for name in kept):
            return True
        return one.spindle_rpm != other.spindle_rpm and other.spindle != "off" and not self.laser


@dataclass(frozen=True)
class EventsAsOne(Event):
    """Events of one kind before one row, on one state: how many, and how long the firmware waits at all of them.

    value: the sum of dwells in s, else that of the first. line: of the first.
    """

    count: int = 1
    ticks: int = 0

    def __add__(self, event: Event) -> EventsAsOne:
        value = self.value + event.value if self.kind == "dwell" else self.value
        return replace(self, value=value, count=self.count + 1, ticks=self.ticks + dwell_ticks(event))


class StopEvents(list[Event]):
    """The events of a program that stop the motion; of many before one row, few are stored.

    Dwells are summed up. Of others each is kept until `most` of them stand there; the rest are one event that counts.
    """

    def __init__(self, most: int):
        super().__init__()
        self._most = most
        self._last: dict[tuple[str, int], tuple[int, int]] = {}  # by kind and state: the row of the last, how many

    def append(self, event: Event) -> None:
        """Take the next event."""
        if event.kind in RUNNING_EVENTS:
            return
        key = event.kind, event.state
        place, count = self._last.get(key, (0, 0))
        last = self[place] if count and place < len(self) else None
        if last is None or (last.index, last.kind, last.state) != (event.index, *key):
            if not self:
                self._last.clear()
            count = 0
        elif event.kind == "dwell" or count > self._most:
            one = last if isinstance(last, EventsAsOne) else EventsAsOne(**vars(last), ticks=dwell_ticks(last))
            self[place] = one + event
            return
        self._last[key] = len(self), count + 1
        super().append(event)


def dwell_ticks(event: Event) -> int:
    """Return how long the firmware waits: a dwell in whole steps of 50 ms, rounded up in 32-bit floats."""
    if isinstance(event, EventsAsOne):
        return event.ticks
    if event.kind != "dwell":
        return 0
    steps = math.ceil(np.float32(1.0 / DWELL_STEP_S) * np.float32(event.value))
    return round(steps * DWELL_STEP_S * TICKS_PER_S)
