# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fault proxy: a board at the end of a serial line on which a plan of faults is carried out.

sender ── FaultyDirection "in"  ──────────────────► Link ──► board      reset, power, alarm
       ◄─ FaultyDirection "out" ◄── FaultyAnswers ◄──
close: `take_cut`       kill, disk: `outside`
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from random import Random

from CNCStepper.virtual.faults.link_faults import FaultyAnswers, FaultyDirection, is_due
from CNCStepper.virtual.faults.plan import BOARD_KINDS, IN, OUT, SENDER_KINDS, WIRE_KINDS, Fault, FaultPlan
from CNCStepper.virtual.grbl.machine import Grbl
from CNCStepper.virtual.grbl.states import MOVING
from CNCStepper.virtual.server.serial_line import Link

MOMENTS: dict[str, Callable[[Grbl], bool]] = {
    "any": lambda board: True,
    "motion": lambda board: board.state in MOVING and board.axes.rate_mm_min > 0,
    "rest": lambda board: board.state not in MOVING and board.axes.stopped,
}


class FaultyLink:
    """A proxy of a `Link` that corrupts its traffic.

    outside: carries out what is no fault of link or board ("kill", "disk"). told: hears of every fault as it happens.
    fired: how often each kind has happened.
    """

    def __init__(
        self,
        link: Link,
        plan: FaultPlan,
        *,
        outside: Callable[[Fault], None] = lambda fault: None,
        told: Callable[[Fault, float], None] = lambda fault, time_s: None,
    ):
        self.board = link.board
        self.fired: Counter[str] = Counter()
        self._link = link
        self._outside = outside
        self._told = told
        self._cut = False
        random = Random(plan.seed)
        wire = [fault for fault in plan.fault if fault.kind in WIRE_KINDS]
        self.ways = {
            way: FaultyDirection([fault for fault in wire if fault.way == way], Random(random.random()), self._fire)
            for way in (IN, OUT)
        }
        self.words = FaultyAnswers(self._fire)
        self._others = [fault for fault in plan.fault if fault.kind not in WIRE_KINDS]

    @property
    def room(self) -> int:
        """How many bytes the line takes now."""
        return max(self._link.room - self.ways[IN].holds, 0)

    @property
    def quiet(self) -> bool:
        """Whether nothing is under way, as of a `Link`."""
        return self._link.quiet and not any(way.holds for way in self.ways.values())

    def send(self, data: bytes) -> None:
        """Put bytes on the line to the board."""
        self.ways[IN].take(data, self.board.time_s)
        self._pass_on()

    def receive(self) -> bytes:
        """Return the bytes that have come from the board."""
        self.ways[OUT].take(self.words.pass_on(self._link.receive()), self.board.time_s)
        return self.ways[OUT].give(self.board.time_s)

    def advance(self, dt_s: float) -> None:
        """Let time pass, and let happen what is due."""
        self._pass_on()
        self._link.advance(dt_s)
        for fault in list(self._others):
            if self._is_due(fault):  # by now: a board that has just lost its supply has no switch that could open
                self._others.remove(fault)
                self._begin(fault)

    def take_cut(self) -> bool:
        """Return whether the port was closed since this was last asked."""
        cut, self._cut = self._cut, False
        return cut

    def _pass_on(self) -> None:
        if data := self.ways[IN].give(self.board.time_s):
            self._link.send(data)

    def _is_due(self, fault: Fault) -> bool:
        if fault.kind in BOARD_KINDS and (self.board.starts_up or not MOMENTS[fault.when](self.board)):
            return False
        return is_due(fault, self.ways[fault.way].passed, self.board.time_s)

    def _begin(self, fault: Fault) -> None:
        if fault.kind in ("withhold", "flood"):
            self.words.begin(fault)
            return
        self._fire(fault)
        if fault.kind in SENDER_KINDS:
            self._outside(fault)
        elif fault.kind == "close":
            self._cut = True
            for way in self.ways.values():
                way.cut()
        else:
            inject_fault(self.board, fault)

    def _fire(self, fault: Fault) -> None:
        self.fired[fault.kind] += 1
        self._told(fault, self.board.time_s)


def inject_fault(board: Grbl, fault: Fault) -> None:
    """Do to a board what its reset button, its supply or a switch does."""
    if fault.kind == "reset":
        board.reset()
    elif fault.kind == "alarm":
        board.fail(fault.code)
    else:
        board.power_up()
