# SPDX-License-Identifier: LGPL-2.1-or-later
"""A virtual machine without an answer protocol, and the faults on its way: bytes spoiled, cable pulled, motors stalled.

client ── FaultyDirection "in"  ──► Twin      power, stall, dead_pin, swapped_pins: `inject`
       ◄─ FaultyDirection "out" ◄──           close: `take_cut`      kill: `outside`
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from random import Random
from typing import Protocol

import numpy as np

from CNCStepper.virtual.faults.link_faults import FaultyDirection, is_due
from CNCStepper.virtual.faults.plan import IN, OUT, SENDER_KINDS, WIRE_KINDS, Fault, FaultPlan

TWIN_KINDS = (*WIRE_KINDS, "power", "close", "kill", "stall")
PARPORT_KINDS = (*TWIN_KINDS, "dead_pin", "swapped_pins")


class Twin(Protocol):
    """A machine behind a port; its time passes only in `advance`.

    columns: names of the axes of its path.
    """

    columns: tuple[str, ...]
    time_s: float

    @property
    def room(self) -> int:
        """How many bytes it takes now."""

    @property
    def quiet(self) -> bool:
        """Whether it rests, and nothing that came waits."""

    @property
    def places_mm(self) -> tuple[float, ...]:
        """Where its axes are, from where they began."""

    def open(self) -> None:
        """Let a client come."""

    def receive(self, data: bytes, since_s: float, now_s: float) -> None:
        """Take bytes that came after `since_s` and not after `now_s`: no more than there is room."""

    def advance(self, now_s: float) -> None:
        """Let time pass up to `now_s`."""

    def take_output(self) -> bytes:
        """Return what it has sent since the last call."""

    def take_path(self) -> list[np.ndarray]:
        """Return the places since the last call, blocks float64[k, 1 + axes]: t_s and mm."""

    def take_notes(self) -> list[tuple[float, str]]:
        """Return what happened since the last call: time in s and a sentence."""

    def inject(self, fault: Fault) -> None:
        """Carry out a fault of the machine itself."""


class FaultyTwin:
    """A proxy of a `Twin` that corrupts its traffic by a plan.

    outside: carries out what is no fault of the machine ("kill"). fired: how often each kind has happened.
    """

    def __init__(self, twin: Twin, plan: FaultPlan, *, outside: Callable[[Fault], None] = lambda fault: None):
        self.columns, self.time_s = twin.columns, twin.time_s
        self.fired: Counter[str] = Counter()
        self.twin = twin
        self._outside = outside
        self._cut = False
        self._now_s = twin.time_s
        self._notes: list[tuple[float, str]] = []
        random = Random(plan.seed)
        wire = [fault for fault in plan.fault if fault.kind in WIRE_KINDS]
        self._ways = {
            way: FaultyDirection([fault for fault in wire if fault.way == way], Random(random.random()), self._fire)
            for way in (IN, OUT)
        }
        self._others = [fault for fault in plan.fault if fault.kind not in WIRE_KINDS]

    @property
    def room(self) -> int:
        """How many bytes it takes now."""
        return max(self.twin.room - self._ways[IN].holds, 0)

    @property
    def quiet(self) -> bool:
        """Whether the machine rests and no byte is delayed."""
        return self.twin.quiet and not any(way.holds for way in self._ways.values())

    @property
    def places_mm(self) -> tuple[float, ...]:
        """Where the machine's axes are."""
        return self.twin.places_mm

    def open(self) -> None:
        """Let a client come."""
        self.twin.open()

    def receive(self, data: bytes, since_s: float, now_s: float) -> None:
        """Take bytes; those that are delayed reach the machine later."""
        self._now_s = now_s
        self._ways[IN].take(data, now_s)
        self._pass_on(since_s, now_s)

    def advance(self, now_s: float) -> None:
        """Let time pass up to `now_s`, and let happen what is due."""
        self._pass_on(now_s, now_s)
        self.twin.advance(now_s)
        self.time_s = self._now_s = now_s
        for fault in [fault for fault in self._others if is_due(fault, self._ways[fault.way].passed, now_s)]:
            self._others.remove(fault)
            self._begin(fault)

    def take_output(self) -> bytes:
        """Return what the machine has sent, as it arrives."""
        self._ways[OUT].take(self.twin.take_output(), self.time_s)
        return self._ways[OUT].give(self.time_s)

    def take_path(self) -> list[np.ndarray]:
        """Return the places since the last call."""
        return self.twin.take_path()

    def take_notes(self) -> list[tuple[float, str]]:
        """Return what happened since the last call, faults too."""
        notes, self._notes = self._notes, []
        return notes + self.twin.take_notes()

    def inject(self, fault: Fault) -> None:
        """Carry out a fault of the machine itself."""
        self.twin.inject(fault)

    def take_cut(self) -> bool:
        """Return whether the port was closed since this was last asked."""
        cut, self._cut = self._cut, False
        return cut

    def _pass_on(self, since_s: float, now_s: float) -> None:
        if data := self._ways[IN].give(now_s):
            self.twin.receive(data, since_s, now_s)

    def _begin(self, fault: Fault) -> None:
        self._fire(fault)
        if fault.kind in SENDER_KINDS:
            self._outside(fault)
        elif fault.kind == "close":
            self._cut = True
            for way in self._ways.values():
                way.cut()
        else:
            self.twin.inject(fault)

    def _fire(self, fault: Fault) -> None:
        self.fired[fault.kind] += 1
        self._notes.append((self._now_s, str(fault)))
