# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sender and the virtual grbl in one process, in one simulated time, with the fault proxy between them."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

from fault_judge import Claim, MachineTrace, Row, Run

from CNCStepper.control.command import Command
from CNCStepper.control.outcome import REFUSED, Outcome
from CNCStepper.control.readiness import expected_settings
from CNCStepper.control.send_job import SendJob
from CNCStepper.control.sender import Sender
from CNCStepper.errors import LinkError
from CNCStepper.machine.profile import load_machine
from CNCStepper.virtual.faults import FaultPlan
from CNCStepper.virtual.faults_link import FaultyLink
from CNCStepper.virtual.grbl.link import Link
from CNCStepper.virtual.grbl.machine import Grbl

STEP_S, QUIET_STEP_S = 0.004, 0.02
LIMIT_S = 240.0  # no run of these tests takes so long; a sender that waits for ever does
AFTERWARDS_S = 8.0  # what the buffers hold is cut after the sender has gone


class NeverEnds(Exception):
    """A run that goes on far beyond its time."""


class SimulatedLink:
    """A `transport.Link` to a board in memory; time passes while it is read."""

    name = "simulated"

    def __init__(self, line: FaultyLink):
        self.line = line
        self.heard: list[tuple[float, bytes]] = []
        self.sent = bytearray()
        self.at_read: Callable[[float], None] = lambda now_s: None
        self._to_send = bytearray()
        self._broken = self._rung = False
        self.woken = False

    def clock(self) -> float:
        return self.line.board.time_s

    def read(self, wait_s: float) -> bytes:
        end_s = self.clock() + wait_s
        self.woken = False
        while True:
            self._check()
            self.at_read(self.clock())
            self.pass_time()
            data = self.line.receive()
            if data:
                self.heard.append((self.clock(), data))
            self._hear_bell()
            if data or self.woken or self.clock() >= end_s:
                return data

    def rest(self, wait_s: float) -> None:
        end_s = self.clock() + wait_s
        self.woken = False
        while not self.woken and self.clock() < end_s:
            self._check()
            self.pass_time()
            self._hear_bell()

    def waiting_bytes(self) -> int:
        return len(self._to_send)

    def leaving_s(self, count: int) -> float:
        return count * 10 / 115_200

    def write(self, data: bytes) -> None:
        self._check()
        self.sent += data
        self._to_send += data

    def wake(self) -> None:
        self._rung = True

    def _hear_bell(self) -> None:
        self.woken, self._rung = self._rung, False

    def close(self) -> None:
        self._to_send.clear()

    def pass_time(self) -> None:
        if room := min(self.line.room, len(self._to_send)):
            self.line.send(bytes(self._to_send[:room]))
            del self._to_send[:room]
        self.line.advance(QUIET_STEP_S if self.line.quiet else STEP_S)

    def _check(self) -> None:
        self._broken = self._broken or self.line.take_cut()
        if self._broken:
            raise LinkError("link-lost", "the link to simulated broke", advice="check the cable")
        if self.clock() > LIMIT_S:
            raise NeverEnds


@cache
def reference_of(lines: tuple[str, ...]) -> tuple[tuple[Row, ...], int]:
    """Return the path of a program, and how many answers a sender hears, on a board that gets it line by line."""
    board = Grbl(load_machine("table-a"))
    trace = MachineTrace(board)
    for line in lines:
        board.receive(line.encode("ascii") + b"\n")
        while b"ok" not in (said := board.take_output()):
            assert b"error" not in said and b"ALARM" not in said, (line, said)
            board.advance(STEP_S)
            if board.suspension.active:
                board.receive(b"~")
    while not board.quiet:
        board.advance(STEP_S)
    return tuple(trace.rows), len(lines)


def claim_of(outcome: Outcome) -> Claim:
    """Return what an outcome says, in plain values."""
    code = outcome.error.code if outcome.error else ""
    mpos_mm = outcome.status.mpos_mm
    return Claim(outcome.done, outcome.kind == REFUSED, outcome.position_known, mpos_mm, code)


class FaultBench:
    """One run of `lines` under a plan; hold_s: when a person holds it. Whoever finds it held lets it go on."""

    def __init__(self, lines: tuple[str, ...], plan: FaultPlan, *, hold_s: float = 0.0, sender=Sender, **options):
        self.lines = lines
        self.board = Grbl(load_machine("table-a"))
        self.line = FaultyLink(Link(self.board), plan, **options)
        self.trace = MachineTrace(self.board)
        self.link = SimulatedLink(self.line)
        self.link.at_read = self._person
        self.told: list[tuple[str, str]] = []
        self._hold_s = hold_s
        expected = expected_settings(load_machine("table-a"))
        self.sender = sender(
            SendJob("simulated", lines, zero_confirmed=True, expected=expected),
            opener=lambda name, baud: self.link,
            clock=self.link.clock,
            tell=self._hear,
        )

    def run(self) -> Run:
        """Let the sender run, and the machine after it; return all that a judge may know."""
        try:
            self.outcome = self.sender.run()
            claim = claim_of(self.outcome)
        except NeverEnds:
            claim = Claim(False, False, True, None, "never ends")
        end_s = self.board.time_s + AFTERWARDS_S
        while not self.board.quiet and self.board.time_s < end_s:
            self.line.advance(STEP_S)
        rows, answers = reference_of(self.lines)
        return Run(list(rows), answers + 5, self.trace, self.line, claim, self.link.heard)

    def _person(self, now_s: float) -> None:
        if self._hold_s and now_s > self._hold_s:
            self._hold_s = 0.0
            self.sender.ask(Command("hold"))

    def _hear(self, kind: str, text: str) -> None:
        self.told.append((kind, text))
        if kind == "phase" and text.startswith(("held", "paused", "door")):
            self.sender.ask(Command("resume"))
