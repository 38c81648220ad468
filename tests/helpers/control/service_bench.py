# SPDX-License-Identifier: LGPL-2.1-or-later
"""A service at a virtual grbl, both in one thread and in simulated time, and a person who waits and asks."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from unittest.mock import patch

from CNCStepper.control.journal import writer
from CNCStepper.control.program.send_job import SendJob, write_job
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.control.service.connection_service import ConnectionService
from CNCStepper.control.service.position_trust_file import PositionTrustFile
from CNCStepper.control.session.command import Command
from CNCStepper.control.session.status import Outcome
from CNCStepper.errors import CNCStepperError, LinkError
from CNCStepper.machine.profile import load_machine
from CNCStepper.virtual.grbl.firmware import GRBL, Firmware
from CNCStepper.virtual.grbl.machine import Grbl
from CNCStepper.virtual.server.serial_line import Link
from helpers.control.fake_controller import FakeClock, Unqueued
from helpers.control.fault_disk import AtOnce

STEP_S, LONG_STEP_S = 0.002, 0.01
LIMIT_S = 60.0

Person = Iterator[Callable[[], bool] | float]


class Table(Unqueued):
    """A virtual board behind its serial line, as a link for the service; reading lets time pass and the person act.

    written: (time, bytes) that reached the port. cut: the cable is out. board: one that has run already, without a
    greeting; a new one when None.
    """

    name = "table"

    def __init__(
        self,
        homing: bool = False,
        settings: dict[int, float] | None = None,
        firmware: Firmware = GRBL,
        board: Grbl | None = None,
    ):
        self.clock = FakeClock()
        self.board = board or Grbl(load_machine("table-a"), homing=homing, firmware=firmware)
        self.board.memory.settings.values.update(settings or {})
        self.written: list[tuple[float, bytes]] = []
        self.cut = False
        self.on_write: Callable[[bytes], object] = lambda data: None
        self.person: Person = iter(())
        self.closed = False
        self._wire = Link(self.board)
        self._next: Callable[[], bool] = lambda: True
        self._woken = False
        self._end_s = self.clock() + LIMIT_S

    def read(self, wait_s: float) -> bytes:
        end_s = self.clock.now_s + wait_s
        while True:
            data = self.pass_time(min(wait_s, LONG_STEP_S) if self._wire.quiet else STEP_S)
            if data or self._woken or self.clock.now_s >= end_s:
                self.woken, self._woken = self._woken, False
                return data

    def write(self, data: bytes) -> None:
        if self.cut:
            raise LinkError("link-lost", "the cable is out")
        self.on_write(data)
        self.written.append((self.clock.now_s, data))
        self._wire.send(data)

    def wake(self) -> None:
        self._woken = True

    def close(self) -> None:
        self.closed = True

    def pass_time(self, seconds: float) -> bytes:
        if self.cut:
            raise LinkError("link-lost", "the cable is out")
        self.clock.now_s += seconds
        self._wire.advance(seconds)
        assert self.clock.now_s < self._end_s, "the test takes too long"
        while self._next():
            awaited = next(self.person, lambda: False)
            self._next = awaited if callable(awaited) else self._after(awaited)
        return self._wire.receive()

    def x_mm(self) -> float:
        """Where the table's X axis really is."""
        return self.board.axes.position_mm[0]

    def sent(self, byte: bytes) -> list[float]:
        """Return when a real-time byte was written."""
        return [time_s for time_s, data in self.written if data == byte]

    def _after(self, seconds: float) -> Callable[[], bool]:
        end_s = self.clock.now_s + seconds
        return lambda: self.clock.now_s >= end_s


class Visit:
    """One service from its first to its last moment, with all that it told."""

    def __init__(
        self,
        tmp_path: Path,
        *,
        timing: Timing | None = None,
        journals: Path | None = None,
        kept: PositionTrustFile | None = None,
        **table,
    ):
        self.table = Table(**table)
        self.told: list[tuple[str, str]] = []
        self.refused: list[tuple[str, CNCStepperError]] = []
        self.outcomes: list[Outcome] = []
        self.alone_s = 0.0
        self._file = tmp_path / "a job ç.json"
        self.service = ConnectionService(
            "table",
            job_file=tmp_path / "service ç.wire",
            opener=lambda name, baud: self.table,
            timing=timing,
            clock=self.table.clock,
            tell=lambda kind, text: self.told.append((kind, text)),
            refuse=lambda command, error: self.refused.append((command.name, error)),
            ended=self.outcomes.append,
            alone_s=lambda: self.alone_s,
            journals=journals,
            kept=kept,
        )

    def receive(self, person: Callable[[], Person]) -> None:
        """Let a person come who, at the end, tells the service to end.

        The journal is written in this thread: a real disk takes its own time, in which simulated minutes pass.
        """

        def visit() -> Person:
            yield lambda: self.phase != "connecting"
            yield from person()
            self.service.stop()

        self.table.person = visit()
        with patch.object(writer, "ThreadPoolExecutor", lambda *_: AtOnce()):
            self.service.run()

    def ask(self, name: str, **values) -> None:
        if name == "jog":
            values = dict.fromkeys(("x_mm", "y_mm", "z_mm"), 0.0) | {"feed_mm_min": 3000.0} | values
        self.service.ask(Command(name, values))

    def job(self, *lines: str, zeroed: bool = True, command: str = "run", **job) -> None:
        """Ask for a job of these lines, as the window leaves it in a file: without a port.

        zeroed: where the position is unknown, this place is made the zero first. command: "send" asks as a terminal.
        """
        if zeroed and self.phase == "idle" and self.service.status().position_known is False:
            self.ask("set_zero", axes="XYZ")
        write_job(self._file, SendJob("nowhere", lines, file="part.nc", **job))
        self.ask(command, file=str(self._file), zero_confirmed=True, allow_differences=False)

    def at(self, *phases: str) -> Callable[[], bool]:
        """Return what to wait for: the service is in one of these phases."""
        return lambda: self.phase in phases

    def ended(self, jobs: int = 1) -> Callable[[], bool]:
        return lambda: len(self.outcomes) == jobs and self.phase in ("idle", "alarm")

    @property
    def phase(self) -> str:
        return self.service.status().phase

    def refusals(self) -> list[str]:
        return [error.code for _, error in self.refused]
