# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sender and the virtual grbl in one process, in one simulated time, with the fault proxy between them."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from math import inf
from pathlib import Path

from CNCStepper.control.journal.writer import MENDED, Journal
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.protocol.grbl.settings import expected_settings
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.control.service.position_trust_file import PositionTrustFile
from CNCStepper.control.service.sender import Sender
from CNCStepper.control.session.command import Command
from CNCStepper.control.session.status import REFUSED, Outcome
from CNCStepper.errors import CNCStepperError, LinkError
from CNCStepper.machine.profile import load_machine
from CNCStepper.virtual.faults.plan import Fault, FaultPlan
from CNCStepper.virtual.grbl.machine import Grbl
from CNCStepper.virtual.server.fault_proxy import FaultyLink
from CNCStepper.virtual.server.serial_line import Link
from helpers.control.fault_disk import AtOnce, Disk
from helpers.control.fault_judge import Claim, MachineTrace, Reference, Run
from helpers.control.limit_switches import HOMED, LOCKED, NONE, board_of, homed_board

STEP_S, QUIET_STEP_S = 0.01, 0.02
LIMIT_S = 240.0  # no run of these tests takes so long; a sender that waits for ever does
AFTERWARDS_S = 12.0  # what the buffers hold is cut after the sender has gone
QUESTIONS, HOMING_QUESTIONS = 5, 2  # of a sender at the begin; each is answered
FILE = "part.nc"
TIMING = Timing(homing_s=60.0)  # of these machines; a person gives a longer one its time
STANDING = ("held", "paused", "door")  # phases in which somebody must resume
LOOKS_S = 1.5  # whoever finds it held


class NeverEnds(Exception):
    """A run that goes on far beyond its time."""


class Killed(BaseException):
    """The end of the sender's process: nothing that it does from now on reaches anything."""


class SimulatedLink:
    """A `transport.Link` to a board in memory; time passes while it is read."""

    name = "simulated"
    machine = ""
    queue_bytes = 40
    filling_bytes = 30

    def __init__(self, line: FaultyLink):
        self.line = line
        self.heard: list[tuple[float, bytes]] = []
        self.sent = bytearray()
        self.at_read: Callable[[float], None] = lambda now_s: None
        self._to_send = bytearray()
        self._broken = self._rung = False
        self.woken = False
        self.killed = False

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
            self._clear_wake_up()
            if data or self.woken or self.clock() >= end_s:
                return data

    def rest(self, wait_s: float) -> None:
        end_s = self.clock() + wait_s
        self.woken = False
        while not self.woken and self.clock() < end_s:
            self._check()
            self.pass_time()
            self._clear_wake_up()

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

    def _clear_wake_up(self) -> None:
        self.woken, self._rung = self._rung, False

    def close(self) -> None:
        if not self.killed:  # else the system still sends what it was given
            self._to_send.clear()

    def pass_time(self) -> None:
        if room := min(self.line.room, len(self._to_send)):
            self.line.send(bytes(self._to_send[:room]))
            del self._to_send[:room]
        self.line.advance(QUIET_STEP_S if self.line.quiet else STEP_S)

    def _check(self) -> None:
        if self.killed:
            raise Killed
        self._broken = self._broken or self.line.take_cut()
        if self._broken:
            raise LinkError("link-lost", "the link to simulated broke", advice="check the cable")
        if self.clock() > LIMIT_S:
            raise NeverEnds


@cache
def reference_of(lines: tuple[str, ...], switches: str = NONE) -> Reference:
    """Return the path of a program on a board that gets each line when the one before it is cut.

    It begins at the work zero, on a machine that is locked at first where its homing ends.
    """
    top_steps = MachineTrace(board_of(HOMED if switches else NONE)).rows[0].place[2]
    board = homed_board() if switches == LOCKED else board_of(switches)
    board.take_output()
    trace = MachineTrace(board)
    ends = []
    for line in lines:
        board.receive(line.encode("ascii") + b"\n")
        said = b""
        while b"ok" not in said or not board.quiet:
            board.advance(STEP_S)
            said += board.take_output()
            assert b"error" not in said and b"ALARM" not in said, (line, said)
            if board.suspension.active:
                board.receive(b"~")
        ends.append(len(trace.rows) - 1)
    return Reference(tuple(trace.rows), tuple(ends), top_steps)


def claim_of(outcome: Outcome) -> Claim:
    """Return what an outcome says, in plain values."""
    code = outcome.error.code if outcome.error else ""
    mpos_mm = outcome.status.mpos_mm
    return Claim(outcome.done, outcome.kind == REFUSED, outcome.position_known, mpos_mm, code)


class FaultBench:
    """One run of `lines` under a plan; hold_s: when a person holds it. Whoever finds it held looks, and lets it go on.

    folder: of the journal; None keeps none. switches: of a new machine, as `fault_switches` has them. board: a machine
    that has run already instead. fired_standing: how many faults happened while it was held or paused.
    """

    def __init__(
        self,
        lines: tuple[str, ...],
        plan: FaultPlan,
        *,
        hold_s: float = 0.0,
        folder: Path | None = None,
        switches: str = NONE,
        board: Grbl | None = None,
        job: SendJob | None = None,
    ):
        self.lines, self.folder = lines, folder
        self.job = job or job_of(lines, home_first=switches == LOCKED)
        self.board = board or board_of(switches)
        self.switches, self.plan = switches, plan
        self.line = FaultyLink(Link(self.board), plan, outside=self._suffer, told=self._count)
        self.trace = MachineTrace(self.board)
        self.link = SimulatedLink(self.line)
        self.link.at_read = self._person
        self.disk = Disk(self.link.clock)
        self.told: list[tuple[str, str]] = []
        self._hold_s = hold_s
        self._stands = self._waits = False  # waits: for room on the disk
        self._resume_s = inf
        self.fired_standing = 0
        self.journal = Journal(folder, executor=AtOnce(), clock=self.link.clock) if folder else None
        self.kept = PositionTrustFile.of_port(folder, self.link.name) if folder else PositionTrustFile(None)
        self.sender = Sender(
            self.job,
            opener=lambda name, baud: self.link,
            timing=TIMING,
            clock=self.link.clock,
            tell=self._on_message,
            refuse=self._wait,
            journal=self.journal,
            kept=self.kept,
        )

    def run(self) -> Run:
        """Let the sender run, and the machine after it; return all that a judge may know."""
        with self.disk.in_use():
            claim = self._claim()
        claim_s = self.board.time_s
        end_s = self.board.time_s + AFTERWARDS_S
        while not self.board.quiet and self.board.time_s < end_s:
            self.link.pass_time()
        program = reference_of(self.lines, self.switches)
        greets = self.switches != HOMED
        return Run(program, self._answers(), self.trace, self.line, claim, self.link.heard, claim_s, greets)

    def _answers(self) -> int:
        """Return how often the controller answers where nothing goes wrong; at an M0 the sender stands by itself."""
        lines = sum(line != "M0" for line in self.lines)
        return QUESTIONS + HOMING_QUESTIONS * self.job.home_first + lines

    def _claim(self) -> Claim:
        """Return what the sender says at its end; of one that was killed its client says that nothing is known."""
        try:
            self.outcome = self.sender.run()
        except NeverEnds:
            return Claim(False, False, True, None, "never ends")
        except Killed:
            return Claim(False, False, False, None, "session-lost")
        return claim_of(self.outcome)

    def _suffer(self, fault: Fault) -> None:
        if fault.kind == "kill":
            self.link.killed = True
        else:
            self.disk.fill(fault.for_s)

    def _count(self, fault: Fault, time_s: float) -> None:
        self.fired_standing += self._stands

    def _person(self, now_s: float) -> None:
        if now_s > self._resume_s:
            self._resume_s = inf
            self._go_on()
        if self._hold_s and now_s > self._hold_s:
            self._hold_s = 0.0
            if not self._stands:  # else it would be one's own resume that is taken back
                self.sender.ask(Command("hold"))

    def _on_message(self, kind: str, text: str) -> None:
        self.told.append((kind, text))
        if kind == "phase":
            self._stands = text.startswith(STANDING)
            self._resume_s = self.link.clock() + LOOKS_S if self._stands else inf
        if text == MENDED and self._waits:
            self._go_on()

    def _go_on(self) -> None:
        """Resume; stop where there will never be room on the disk."""
        self._waits = False
        self.sender.ask(Command("stop" if self.disk.is_full_for_good else "resume"))

    def _wait(self, command: Command, error: CNCStepperError) -> None:
        """Wait for room on the disk, for which a resume was refused."""
        self._waits = command.name == "resume"


def job_of(lines: tuple[str, ...], *, home_first: bool = False) -> SendJob:
    """Return the job of sending a program to the simulated machine."""
    expected = expected_settings(load_machine("table-a"))
    return SendJob("simulated", lines, file=FILE, zero_confirmed=True, expected=expected, home_first=home_first)
