# SPDX-License-Identifier: LGPL-2.1-or-later
"""A table of moves that is still being read, cut into tables that are checked one after the other.

chunks   |  0  |  1  |  2  |  3  |  4  |  5  | ...
parts    |           0           |    1  ...        PART_ROWS rows or a little more
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import inf

import numpy as np

from CNCStepper.state import Start, State
from CNCStepper.toolpath import CHUNK_ROWS, Chunk, Event, Toolpath, distinct

PART_ROWS = 2 * CHUNK_ROWS


class TableParts:
    """Makes the parts: each begins where the one before ends, and holds only the states that it names.

    events: those that have come and belong to no part yet; they are taken out as their part is made.
    """

    def __init__(self, start: Start, states: Sequence[State]):
        self._start, self._states = start, states
        self._frame: State | None = None
        self.events: list[Event] = []

    def part(self, chunks: Sequence[Chunk], is_last: bool = False) -> Toolpath:
        """Return the next chunks, none of them empty unless there is no row at all, as a table of its own."""
        first = chunks[0].first
        events = self._events_before(inf if is_last else chunks[-1].first + len(chunks[-1]))
        named = [*(chunk.state for chunk in chunks), np.array([event.state for event in events], np.int64)]
        used = distinct(np.concatenate([distinct(states) for states in named]))
        own = [
            replace(chunk, first=chunk.first - first, state=np.searchsorted(used, chunk.state).astype(np.int32))
            for chunk in chunks
        ]
        events = [
            replace(event, index=event.index - first, state=int(np.searchsorted(used, event.state))) for event in events
        ]
        states = [self._states[index] for index in used.tolist()] or [self._states[0]]
        if self._frame is None and len(chunks[0]):
            self._frame = self._states[int(chunks[0].state[0])]
        part = Toolpath(self._start, own, states, events, frame=self._frame)
        if len(chunks[-1]):
            self._start = replace(self._start, position_mm=tuple(chunks[-1].end[-1].tolist()))
        return part

    def _events_before(self, end: float) -> list[Event]:
        """Take out the events of the rows before `end`."""
        found = [event for event in self.events if event.index < end]
        self.events = self.events[len(found) :]
        return found
