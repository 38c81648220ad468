# SPDX-License-Identifier: LGPL-2.1-or-later
"""One machine and several operators, who connect to it in turn."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.service.position_trust_file import PositionTrustFile
from CNCStepper.control.service.sender import Sender
from CNCStepper.control.session.status import Outcome
from CNCStepper.machine.profile import load_machine
from CNCStepper.virtual.grbl.machine import Grbl
from helpers.control.service_bench import Person, Table, Visit

LINES = ("G21G90G54", "G1X-4Y-3F1000", "G1X-8", "G1X-4")


class Workshop:
    """One machine, and the people who connect to it one after another: each is a process of its own."""

    def __init__(self, folder: Path, homing: bool = False):
        self.folder = folder
        self.board = Grbl(load_machine("table-a"), homing=homing)

    @property
    def kept(self) -> PositionTrustFile:
        """What the next one finds."""
        return PositionTrustFile.of_port(self.folder, "table")

    def visit(self, person: Callable[[Visit], Person]) -> Visit:
        """Let a person come to a service of their own."""
        visit = Visit(self.folder, kept=self.kept, board=self.board)
        visit.receive(lambda: person(visit))
        return visit

    def send(self, person: Callable[[Table], Person] = lambda table: iter(()), **job) -> Outcome:
        """Send a job whose zero is confirmed."""
        table = Table(board=self.board)
        table.person = person(table)
        self.sender = Sender(
            SendJob("table", job.pop("lines", LINES), zero_confirmed=True, **job),
            opener=lambda name, baud: table,
            clock=table.clock,
            kept=self.kept,
        )
        return self.sender.run()

    def greet_nobody(self) -> None:
        """Let the greeting of the start pass unheard."""
        self.board.advance(0.1)
        self.board.take_output()
