# SPDX-License-Identifier: LGPL-2.1-or-later
"""A blocking client of a connection service, used as a session client is."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, Self

from CNCStepper.control.processes.process_file import is_alive
from CNCStepper.control.service.connection_client import ConnectionClient
from CNCStepper.control.session.client import ANSWER_LIMIT_S, LOOK_EVERY_S, SessionClient
from CNCStepper.control.session.files import SERVICE, running_services, service_at, session_at, sessions
from CNCStepper.control.session.status import Outcome, SenderStatus
from CNCStepper.control.session.unreachable import silent
from CNCStepper.errors import LinkError

LOOK_LIMIT_S = 3.0  # whether a job runs in a service


class ConnectionSession:
    """A blocking client of a connection service, like `SessionClient`; the service outlives it."""

    def __init__(self, client: ConnectionClient, limit_s: float = ANSWER_LIMIT_S):
        self._client = client
        try:
            self._until(lambda events: client.is_caught_up, limit_s)
        except LinkError:
            client.detach()
            raise

    @classmethod
    def attach(cls, session_file: Path, limit_s: float = ANSWER_LIMIT_S) -> ConnectionSession:
        """Attach to a service that runs; raises LinkError when it has ended, or does not answer within `limit_s`."""
        return cls(ConnectionClient.attach(session_file), limit_s)

    @property
    def port(self) -> str:
        """The port of the machine, as it was named when it was opened."""
        return self._client.port

    @property
    def session_file(self) -> Path:
        """The service's file."""
        return self._client.session_file or Path()

    @property
    def outcome(self) -> Outcome | None:
        """How the service's last job ended; None while one runs, and before the first."""
        return self._client.outcome

    def status(self) -> SenderStatus:
        """Return the service's present status."""
        self._client.ask("status")
        self._until(lambda events: any(event["event"] == "status" for event in events), ANSWER_LIMIT_S)
        return self._client.status

    def hold(self) -> None:
        """Ask for a feed hold."""
        self._client.hold()

    def resume(self, stand: int | None = None) -> None:
        """Resume from the pause with that id in `SenderStatus`; None: from any."""
        self._client.resume(stand)

    def stop(self) -> None:
        """Ask to end the job safely."""
        self._client.stop()

    def ask(self, command: str, **values: Any) -> None:
        """Send a command of the service; a refusal is an event "refused" with its error."""
        self._client.ask(command, **values)

    def poll(self, wait_s: float) -> list[dict[str, Any]]:
        """Return new events, after `wait_s` if there are none; raises the error that ended the service."""
        events = self._client.poll()
        if self._client.phase == "gone":
            what = "the connection service has ended"
            raise self._client.error or LinkError("service-gone", what, advice="connect again")
        if not events:
            time.sleep(wait_s)
        return events

    def _until(self, reached: Callable[[list[dict[str, Any]]], bool], limit_s: float) -> None:
        """Look at the service until its events reach something; raises LinkError where that is not so in `limit_s`."""
        end_s = time.monotonic() + limit_s
        while not reached(self.poll(LOOK_EVERY_S)):
            if time.monotonic() > end_s:
                raise silent(self._client.session_file or Path())

    def close(self) -> None:
        """Detach; the service keeps running."""
        self._client.detach()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()


def attach(file: Path) -> SessionClient | ConnectionSession:
    """Attach to the session or to the service of a file; raises LinkError when it has ended."""
    return ConnectionSession.attach(file) if file.suffix == SERVICE else SessionClient.attach(file)


def jobs_running(folder: Path | None = None) -> list[Path]:
    """Return the files of the sessions and of the connection services that run a job, oldest first.

    Where there are none, those of the services that live and do not answer: a job may run in each.
    """
    running, silent_services = sessions(folder), []
    for service in running_services(folder):
        try:
            running += [service] if _runs_a_job(service) else []
        except LinkError:
            silent_services += [service] if is_alive(service) else []  # else it has ended meanwhile
    return sorted(running or silent_services, key=lambda path: path.name)


def job_at(port: str, folder: Path | None = None) -> Path | None:
    """Return the file of the session, or of the service, that runs a job at a port; None where none runs."""
    if session := session_at(port, folder):
        return session
    service = service_at(port, folder)
    return service if service and _runs_a_job(service) else None


def _runs_a_job(service: Path) -> bool:
    with ConnectionSession.attach(service, LOOK_LIMIT_S) as session:
        return session.status().total > 0
