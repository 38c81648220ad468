# SPDX-License-Identifier: LGPL-2.1-or-later
"""A desk spoken to as a session is: every call waits for its answer; for processes that have nothing else to do."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

from CNCStepper.control.desk_client import DeskClient
from CNCStepper.control.outcome import Outcome, SenderStatus
from CNCStepper.control.session import ANSWER_LIMIT_S, LOOK_EVERY_S, SessionClient
from CNCStepper.control.session_file import DESK, running_desks, sessions
from CNCStepper.errors import LinkError


class DeskSession:
    """One more client of a desk, as a `SessionClient` is one of a session; the desk goes on when it closes."""

    def __init__(self, client: DeskClient):
        self._client = client
        while client.phase != "connected":
            self.poll(LOOK_EVERY_S)

    @classmethod
    def attach(cls, session_file: Path) -> DeskSession:
        """Attach to a desk that runs; raises LinkError when it has ended."""
        return cls(DeskClient.attach(session_file))

    @property
    def outcome(self) -> Outcome | None:
        """How the desk's last job ended; None while one runs, and before the first."""
        return self._client.outcome

    def status(self) -> SenderStatus:
        """Return this moment of the desk."""
        self._client.ask("status")
        end_s = time.monotonic() + ANSWER_LIMIT_S
        while all(event["event"] != "status" for event in self.poll(LOOK_EVERY_S)):
            if time.monotonic() > end_s:
                raise LinkError("sender-silent", "the desk does not answer", advice="look at the machine")
        return self._client.status

    def hold(self) -> None:
        """Ask for a feed hold."""
        self._client.hold()

    def stop(self) -> None:
        """Ask to end the job safely."""
        self._client.stop()

    def ask(self, command: str, **values: Any) -> None:
        """Ask for any command of the desk; what is refused comes as an event "refused" with its error."""
        self._client.ask(command, **values)

    def poll(self, wait_s: float) -> list[dict[str, Any]]:
        """Return the events that came, after `wait_s` where none has; raises the error that ended the desk."""
        events = self._client.poll()
        if self._client.phase == "gone":
            raise self._client.error or LinkError("desk-gone", "the desk has ended", advice="connect again")
        if not events:
            time.sleep(wait_s)
        return events

    def close(self) -> None:
        """Detach; the desk goes on."""
        self._client.detach()

    def __enter__(self) -> DeskSession:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()


def attach(file: Path) -> SessionClient | DeskSession:
    """Attach to the session or to the desk of a file; raises LinkError when it has ended."""
    return DeskSession.attach(file) if file.suffix == DESK else SessionClient.attach(file)


def jobs_running(folder: Path | None = None) -> list[Path]:
    """Return the files of the sessions, and of the desks in which a job runs, oldest first."""
    return sorted([*sessions(folder), *filter(_runs_a_job, running_desks(folder))], key=lambda path: path.name)


def _runs_a_job(desk: Path) -> bool:
    try:
        with DeskSession.attach(desk) as session:
            return session.status().total > 0
    except LinkError:  # it has ended meanwhile
        return False
