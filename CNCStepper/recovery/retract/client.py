# SPDX-License-Identifier: LGPL-2.1-or-later
"""A client that moves a held job back along its cut, forward again, and resumes it."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from CNCStepper.control.service.connection_session import ConnectionSession
from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.control.stream.path_retract import STANDS, read_held, write_leg
from CNCStepper.errors import LinkError, MachineRefusal, Text
from CNCStepper.machine.profile import Machine
from CNCStepper.recovery.retract.prove import HeldProgram, held_program

LOOK_EVERY_S = 0.05
DOOR = "door"
ANSWER_LIMIT_S = 60.0  # a long program is told in seconds


class RetractClient:
    """A client of one session or service; its refusals are raised as its error."""

    def __init__(self, client: SessionClient | ConnectionSession, machine: Machine | None = None):
        self._client = client
        self._machine = machine
        self._client.status()  # past the events of before

    def hold(self) -> SenderStatus:
        """Hold the machine, if it moves, and return its status then; raises MachineRefusal where it cannot be held."""
        status = self._client.status()
        if not status.total:
            raise MachineRefusal("not-held", "no job runs", advice="go back along the cut while a job runs")
        if status.phase not in (*STANDS, DOOR):
            self._client.hold()
            status = self._until(lambda status: status.phase in (*STANDS, DOOR))
        if status.phase == DOOR:
            raise MachineRefusal("door-open", "the safety door is open", advice="close it and resume, then go back")
        return status

    def held(self) -> HeldProgram:
        """Return where on its way the tool is; raises ProgramError or JobError where no way leads back."""
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "place.zip"
            self._client.ask("tell_place", file=str(file))
            self._await("tell_place", "place", str(file))
            return held_program(read_held(file), self._machine)

    def go(self, leg: dict[str, Any]) -> None:
        """Let the session begin a leg, as `HeldProgram` makes it."""
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "leg.zip"
            write_leg(file, leg)
            self._client.ask("retrace", file=str(file))
            self._await("retrace", "phase", "running")

    def wait_for_leg(self) -> SenderStatus:
        """Wait for the end of the leg or a hold on it, and return the status."""
        return self._until(lambda status: status.phase in STANDS)

    def _await(self, command: str, kind: str, text: str) -> None:
        """Wait for the event that a command leads to; raises why it is refused instead."""
        end_s = time.monotonic() + ANSWER_LIMIT_S
        while time.monotonic() < end_s:
            for event in self._client.poll(LOOK_EVERY_S):
                if event["event"] == "refused" and event.get("command") == command:
                    raise event["error"]
                if event["event"] == kind and event["text"] == text:
                    return
            self._check_runs()
        raise LinkError("sender-silent", "the session does not answer", advice="see its log, and the machine")

    def _until(self, reached: Callable[[SenderStatus], bool]) -> SenderStatus:
        while not reached(status := self._client.status()):
            self._check_runs()
            time.sleep(LOOK_EVERY_S)
        return status

    def _check_runs(self) -> None:
        if self._client.outcome is not None:
            what = Text("the job has ended: {outcome}", outcome=self._client.outcome.text)
            raise MachineRefusal("session-ended", what, advice="nothing is held any more")
