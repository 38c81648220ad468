# SPDX-License-Identifier: LGPL-2.1-or-later
"""A client that moves a held job back along its cut, forward again, and resumes it.

Moves the tool of a session along its cut when the machine's own buttons request it.

A client that jogs a held job: the controller gives its lines up first, and the job's next way leads back to the cut.

At a pause, or while the tool is changed, nothing is given up, and the zero can be set.

held ---a leg that goes nowhere---> retreated, idle ---jogs---> beside the cut ---back, forward, rest---> ...
"""

from __future__ import annotations

import tempfile
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from CNCStepper.control.protocol.grbl.capabilities import check_can
from CNCStepper.control.protocol.grbl.firmware import TOOL
from CNCStepper.control.service.connection_session import ConnectionSession, attach
from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.job_phase import LEG_BEGINS
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.control.stream.retract_handover import read_held, write_leg
from CNCStepper.errors import CNCStepperError, LinkError, MachineRefusal, Text
from CNCStepper.machine.profile import Machine
from CNCStepper.recovery.retract.path_retract import HeldProgram, held_program

LOOK_EVERY_S = 0.05
DOOR = "door"
ANSWER_LIMIT_S = 60.0  # a long program is found in seconds


class RetractClient:
    """A client of one session or service; its refusals are raised as its error."""

    def __init__(self, client: SessionClient | ConnectionSession, machine: Machine | None = None):
        self._client = client
        self._machine = machine
        self._client.status()  # past the events of before

    def hold(self) -> SenderStatus:
        """Hold the machine, if it moves, and return its status then.

        Raises MachineRefusal where the machine cannot be held, or cannot go back along its cut.
        """
        status = self._client.status()
        if not status.total:
            raise MachineRefusal("not-held", "no job runs", advice="go back along the cut while a job runs")
        check_can("want_back", status.cannot)
        if status.phase not in (*LEG_BEGINS, DOOR):
            status = self._held(status)
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
        return self._until(lambda status: status.phase in LEG_BEGINS)

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

    def _held(self, status: SenderStatus) -> SenderStatus:
        """Hold a machine that moves, and return its status at standstill; raises why that is refused."""
        self._client.hold()
        while status.phase not in (*LEG_BEGINS, DOOR):
            for event in self._client.poll(LOOK_EVERY_S):
                if event["event"] == "refused" and event.get("command") == "hold":
                    raise event["error"]
                if event["event"] == "status":
                    status = SenderStatus.from_json(event["status"])
            self._check_runs()
        return status

    def _until(self, reached: Callable[[SenderStatus], bool]) -> SenderStatus:
        while not reached(status := self._client.status()):
            self._check_runs()
            time.sleep(LOOK_EVERY_S)
        return status

    def _check_runs(self) -> None:
        if self._client.outcome is not None:
            what = Text("the job has ended: {outcome}", outcome=self._client.outcome.text)
            raise MachineRefusal("session-ended", what, advice="nothing is held any more")


BUTTONS_EVERY_S = 0.1


class ButtonClient(threading.Thread):
    """A client of its own, until the session ends; tell: called with refusals, on this thread."""

    def __init__(self, session_file: Path, tell: Callable[[str], None]):
        super().__init__(name="leader", daemon=True)
        self._file = session_file
        self._tell = tell

    def run(self) -> None:
        """Read the session's request, and execute it."""
        try:
            with attach(self._file) as client:
                while client.outcome is None:
                    self._look(client)
                    time.sleep(BUTTONS_EVERY_S)
        except LinkError as error:
            self._tell(Text("the machine's buttons lead nothing back any more: {error}", error=error))

    def _look(self, client: SessionClient | ConnectionSession) -> None:
        try:
            lead(client, client.status())
        except LinkError:
            raise
        except CNCStepperError as error:
            if client.outcome is None:
                self._tell(error.text)


def lead(client: SessionClient | ConnectionSession, status: SenderStatus) -> None:
    """Begin the move that a status requests; raises the refusals of proof and session."""
    if status.phase not in LEG_BEGINS or (status.wanted_back_mm is None and not status.wanted_rest):
        return
    back = RetractClient(client)
    held = back.held()
    back.go(held.rest() if status.wanted_back_mm is None else held.along(held.back_by(status.wanted_back_mm)))


AT_REST = ("Idle", TOOL)
BEGUN_S = 0.5  # within which a jog shows in the status


def step_aside(client: SessionClient | ConnectionSession) -> None:
    """Make a held machine idle, where it is not; raises MachineRefusal for one that moves, JobError, ProgramError."""
    status = client.status()
    if status.phase not in LEG_BEGINS:
        check_can("hold", status.cannot)
        what = "a job runs, and the machine is not at standstill"
        raise MachineRefusal("not-held", what, value=status.phase, advice="hold it first: Ctrl-C at `cncstepper send`")
    if status.machine_state.startswith("Hold"):
        back = RetractClient(client)
        back.go(back.held().aside())
        back.wait_for_leg()


def jog(client: SessionClient | ConnectionSession, way: dict[str, float]) -> SenderStatus:
    """Jog a machine that is idle, or waits for a new tool, and return its status then; raises refusals.

    way: x_mm, y_mm, z_mm and feed_mm_min.
    """
    client.ask("jog", **way)
    begin_s, state = time.monotonic(), ""
    while (time.monotonic() - begin_s < BEGUN_S or state not in AT_REST) and client.outcome is None:
        for event in client.poll(LOOK_EVERY_S):
            if event["event"] == "refused" and event.get("command") == "jog":
                raise event["error"]
            if event["event"] == "status":
                state = event["status"]["machine_state"]
    return client.status()


def set_zero(client: SessionClient | ConnectionSession, axes: str) -> SenderStatus:
    """Set the zero of axes at a machine paused between two lines; raises refusals."""
    client.status()  # past the events of before
    client.ask("set_zero", axes=axes)
    while client.outcome is None:
        for event in client.poll(LOOK_EVERY_S):
            if event["event"] == "refused" and event.get("command") == "set_zero":
                raise event["error"]
            if event["event"] == "message" and event["text"].startswith("zero of"):
                return client.status()
    what = Text("the job has ended: {outcome}", outcome=client.outcome.text)
    raise MachineRefusal("session-ended", what, advice="set the zero again")
