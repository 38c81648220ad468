# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job that runs in the connection service at its port, watched as a session's is; the connection stays open."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from CNCStepper.control.program.send_job import SendJob, write_job
from CNCStepper.control.service.connection_client import START_LIMIT_S, ConnectionClient
from CNCStepper.control.service.connection_session import ConnectionSession
from CNCStepper.control.session.client import LOOK_EVERY_S, SessionClient
from CNCStepper.control.session.files import service_at
from CNCStepper.control.session.status import Outcome, SenderStatus
from CNCStepper.errors import LinkError


class ServiceJob(ConnectionSession):
    """One job in the service of its port, with the part of a `SessionClient` that a terminal uses.

    When it closes, the job keeps running, and the service stays for the quiet time. Not for several threads.
    """

    def __init__(self, client: ConnectionClient, folder: tempfile.TemporaryDirectory[str]):
        self._folder = folder
        super().__init__(client, START_LIMIT_S)

    @classmethod
    def start(cls, job: SendJob, keep_s: float, folder: Path | None = None) -> ServiceJob:
        """Ask the service at the job's port to run it, and start one where there is none.

        keep_s: for how long the connection stays open afterwards. Raises what `ConnectionClient` ends with.
        """
        client = ConnectionClient.launch(job.port, job.baud, folder, job.profile, keep_s)
        session = cls(client, tempfile.TemporaryDirectory())
        file = Path(session._folder.name) / "job.zip"
        write_job(file, job)
        client.send(file, job.zero_confirmed, job.allow_differences)
        return session

    def poll(self, wait_s: float) -> list[dict[str, Any]]:
        """Return new events, after `wait_s` if there are none; raises why the job is refused, or the service ended."""
        try:
            events = super().poll(wait_s)
        except LinkError:
            if self.outcome is None:
                raise
            return []  # it has reported the job's end before
        for event in events:
            if event["event"] == "refused" and event.get("command") == "send" and event["error"]:
                raise event["error"]
        return events if self._client.started_service else [event for event in events if not event.get("past")]

    def wait(self, on_status: Callable[[SenderStatus], None] = lambda status: None) -> Outcome:
        """Wait for the job's end and return its outcome."""
        while self.outcome is None:
            self.poll(LOOK_EVERY_S)
        on_status(self.outcome.status)
        return self.outcome

    @property
    def is_open(self) -> bool:
        """Whether the service is still there."""
        return self._client.phase != "gone"

    def close(self) -> None:
        """Detach; a job keeps running."""
        self._client.leave()
        self._folder.cleanup()


def start_job(job: SendJob, keep_s: float) -> SessionClient | ServiceJob:
    """Start a job in the service at its port, or in one that stays `keep_s`; where that is 0 and none lives, alone."""
    if keep_s or service_at(job.port):
        return ServiceJob.start(job, keep_s)
    return SessionClient.start(job)
