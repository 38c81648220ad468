# SPDX-License-Identifier: LGPL-2.1-or-later
"""Switching of a program: spindle or beam, coolant and outputs, set between the pulses of its moves.

last move ──┐             ┌── move of row r            Between two rows the changes and the dwells stand in the
            M3 ─ G4 P3 ───┤                            text's order; a change comes before the move by the dwells
            │◄── lead ───►│                            that follow it.

A laser's controller puts the beam out on rapids, and with M4 wherever the machine stands; there is none here, so it is
done here. After a rapid the beam is dark until the next feed begins.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from CNCStepper.motion.planner.standstills import dwell_ticks
from CNCStepper.state import State
from CNCStepper.toolpath import RAPID, Chunk, Event

SPINDLES = {"cw": "spindle_cw", "ccw": "spindle_ccw"}
DIGITAL_OUTPUTS = ("M62", "M63", "M64", "M65")


class Switch(NamedTuple):
    """A device that is switched on or off between two pulses.

    row: of the chunk of pulses; it happens before that row (behind the last where it is the chunk's length).
    device: "spindle_cw", "spindle_ccw", "mist", "flood" or "output_n"; a beam is the spindle that the program calls, a
    laser's always "spindle_cw".
    rpm: the spindle's speed or the beam's power while it is on.
    """

    row: int
    tick: int
    device: str
    on: bool
    rpm: float = 0.0


class Change(NamedTuple):
    """A device that goes on or off `lead_ticks` before the first pulse of row `row` of a table, or of a later one."""

    row: int
    lead_ticks: int
    device: str
    on: bool
    rpm: float = 0.0


class Changes:
    """What a table switches, chunk by chunk as it grows; before the first row everything is off.

    laser: the spindle is one, whose beam rapids put out.
    """

    def __init__(self, states: Sequence[State], events: Sequence[Event], laser: bool = False):
        self._states, self._events, self._laser = states, events, laser
        self._state, self._event = -1, 0  # that are done
        self._dark = laser  # a laser's beam, independent of the state
        self._end = 0  # execution index behind the last row

    def of(self, chunk: Chunk) -> list[Change]:
        """Return the changes before the rows of the next chunk; all its states and events are in the table."""
        self._end = chunk.first + len(chunk)
        dark = (chunk.kind == RAPID) & self._laser
        changing = (np.diff(chunk.state, prepend=self._state) != 0) | np.diff(dark, prepend=self._dark)
        stops = [event.index for event in self._coming(self._end - 1)]
        return [
            change
            for row in sorted({*(np.flatnonzero(changing) + chunk.first).tolist(), *stops})
            for change in self._at_row(row, int(chunk.state[row - chunk.first]), bool(dark[row - chunk.first]))
        ]

    def last(self) -> list[Change]:
        """Return the changes behind the last row."""
        return self._at_row(self._end, len(self._states) - 1, self._dark)

    def _coming(self, row: int) -> list[Event]:
        """Return the events that are not done, up to a row."""
        behind = self._event
        while behind < len(self._events) and self._events[behind].index <= row:
            behind += 1
        return list(self._events[self._event : behind])

    def _at_row(self, row: int, then: int, dark: bool) -> list[Change]:
        """Return what happens before a row, in whose course the state becomes `then` and the beam dark or not."""
        made: list[tuple[int, Change]] = []  # with the ticks that have passed before each
        passed = 0
        if dark:
            made += [(0, change) for change in self._shade(True, row)]
        for event in self._coming(row):
            self._event += 1
            made += [(passed, change) for change in self._until(max(self._state, event.state), row)]
            if event.kind == "dwell" and self._state >= 0 and self._states[self._state].spindle == "ccw":
                made += [(passed, change) for change in self._shade(self._laser, row)]
            made += [(passed, change) for change in _output(event, row)]
            passed += dwell_ticks(event)
        made += [(passed, change) for change in self._until(then, row)]
        made += [(passed, change) for change in self._shade(dark, row)]
        return [change._replace(lead_ticks=passed - at) for at, change in made]

    def _until(self, then: int, row: int) -> Iterator[Change]:
        """Yield the differences of devices along the states up to `then`, which is in force afterwards."""
        now, self._state = self._state, then
        before = self._seen(now)
        for number in range(now + 1, then + 1) if then > now else [then] * (then < now):
            after = self._seen(number)
            yield from _differences(before, after, row)
            before = after

    def _shade(self, dark: bool, row: int) -> Iterator[Change]:
        """Yield the switching of a laser's beam; nothing where it is so already."""
        before = self._seen(self._state)
        self._dark = dark
        yield from _differences(before, self._seen(self._state), row)

    def _seen(self, number: int) -> State:
        """Return a state as the devices show it; -1: before the first."""
        state = self._states[number] if number >= 0 else State()
        if not self._laser or not state.spindle_turns:
            return state
        return replace(state, spindle="off" if self._dark else "cw")


def _differences(before: State, after: State, row: int) -> Iterator[Change]:
    """Yield the devices that go off and then those that go on between two states."""
    turned, turns = (SPINDLES[one.spindle] if one.spindle_turns else "" for one in (before, after))
    if turned and turned != turns:
        yield Change(row, 0, turned, False)
    if turns and (turned, before.spindle_rpm) != (turns, after.spindle_rpm):
        yield Change(row, 0, turns, True, after.spindle_rpm)
    for device in ("mist", "flood"):
        if getattr(before, device) != getattr(after, device):
            yield Change(row, 0, device, getattr(after, device))


def _output(event: Event, row: int) -> Iterator[Change]:
    """Yield the change of a digital output, M62 to M65."""
    code, _, number = event.text.partition(" P")
    if event.kind == "output" and code in DIGITAL_OUTPUTS:
        yield Change(row, 0, f"output_{number}", bool(event.value))
